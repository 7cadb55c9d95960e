// SPDX-License-Identifier: LGPL-2.1-or-later
// What results-page looks at in report.html: the slider and the buttons show one pass after the other.
var pictures = Array.from(document.querySelectorAll('details.pass'));
var slider = document.getElementById('slider');
function shown() { return pictures.filter(function (p) { return p.getClientRects().length && p.open; }); }
function expectOnly(k, how) {
  expect(shown().length === 1 && shown()[0] === pictures[k], how + ' does not show picture ' + k + ' alone');
  expect(pictures[k].querySelector('svg path[fill]').getBoundingClientRect().width, 'picture ' + k + ' is empty');
  expect(document.getElementById('shown').textContent === pictures[k].dataset.pass, how + ': wrong number of the pass');
}
var last = pictures.length - 1;
expect(last + 1, 'there is no picture');
expectOnly(last, 'the page as it opens');
for (var k = 0; k <= last; ++k) {
  slider.value = k;
  slider.dispatchEvent(new Event('input'));
  expectOnly(k, 'the slider');
}
if (last) {
  document.getElementById('back').click();
  expectOnly(last - 1, 'the button back');
  document.getElementById('on').click();
  expectOnly(last, 'the button on');
}
return pictures.length + ' pictures';
