// SPDX-License-Identifier: LGPL-2.1-or-later
// What results-page looks at in study.html: every choice of axes draws something, the legend takes lines away and back,
// the pointer finds the points.
var data = JSON.parse(document.getElementById('study-data').textContent), seen = [];
function drawn() { return new Promise(function (done) { setTimeout(done, 20); }); } // uPlot draws later
function inked(chart) { // pixels that are not of the ground
  var canvas = chart.querySelector('canvas');
  if (!canvas || !canvas.width) return 0;
  var pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data, n = 0;
  for (var i = 3; i < pixels.length; i += 4) n += pixels[i] > 0;
  return n;
}
function picture(chart) { return chart.querySelector('canvas').toDataURL(); }
function choose(box, value) {
  box.value = value;
  box.dispatchEvent(new Event('change'));
}
function pointsFound(chart, tip) {
  var over = chart.querySelector('.u-over'), box = over.getBoundingClientRect(), found = {};
  for (var x = 5; x < box.width; x += 15)
    for (var y = 5; y < box.height; y += 15) {
      over.dispatchEvent(new MouseEvent('mousemove', { clientX: box.left + x, clientY: box.top + y, bubbles: true }));
      if (tip.style.display === 'block') found[tip.textContent] = true;
    }
  return Object.keys(found).length;
}
for (const name of ['error', 'quantity']) {
  const get = function (part) { return document.getElementById(name + '-' + part); };
  if (!get('chart') || !get('chart').querySelector('canvas')) continue;
  for (const y of get('y').options)
    for (const x of get('x').options) {
      choose(get('x'), x.value);
      choose(get('y'), y.value);
      await drawn();
      expect(inked(get('chart')) > 1000, name + ': nothing is drawn for ' + y.text + ' against ' + x.text);
    }
  const before = picture(get('chart')), n = get('legend').children.length;
  expect(n, name + ': the legend is empty');
  for (var i = 0; i < n; ++i) get('legend').children[i].firstChild.click();
  await drawn();
  expect(picture(get('chart')) !== before, name + ': the legend takes nothing away');
  expect(!pointsFound(get('chart'), get('tip')), name + ': lines that are hidden have points');
  for (i = 0; i < n; ++i) get('legend').children[i].firstChild.click();
  await drawn();
  expect(picture(get('chart')) === before, name + ': the legend brings not everything back');
  const found = pointsFound(get('chart'), get('tip'));
  expect(found, name + ': the pointer finds no point');
  seen.push(name + ': ' + n + ' lines, ' + found + ' points found');
}
expect(seen.length, 'there is no diagram');
return seen.join('; ');
