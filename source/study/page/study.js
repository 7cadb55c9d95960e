// SPDX-License-Identifier: LGPL-2.1-or-later
// The diagrams of study.html: everything they show stands in the element `study-data`.
(function () {
  "use strict";
  const data = JSON.parse(document.getElementById("study-data").textContent);
  if (typeof uPlot === "undefined") return;
  document.documentElement.classList.add("js");

  const byId = id => document.getElementById(id);
  const dashes = [[], [7, 4], [2, 3]];
  const nColours = 7;

  const number = (value, digits) => Number(value.toPrecision(digits)).toString();
  const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const colour = i => css("--c" + i % nColours);
  const dash = i => dashes[Math.floor(i / nColours) % dashes.length];
  const axisOf = (axes, name) => axes.find(axis => axis.name === name);

  function element(tag, attributes, text) {
    const node = document.createElement(tag);
    for (const name in attributes) node.setAttribute(name, attributes[name]);
    if (text !== undefined) node.textContent = text;
    return node;
  }

  function swatch(line, i) {
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    svg.setAttribute("width", 30);
    svg.setAttribute("height", 10);
    svg.setAttribute("aria-hidden", "true");
    const mark = line.program ? '<rect x="12" y="2" width="6" height="6" fill="var(--ground)" '
      : '<circle cx="15" cy="5" r="3" fill="currentColor" ';
    svg.innerHTML = '<path d="M0 5h30" stroke="currentColor" stroke-width="1.5" stroke-dasharray="' +
      dash(i).join(" ") + '"/>' + mark + 'stroke="currentColor"/>';
    svg.style.color = "var(--c" + i % nColours + ")";
    return svg;
  }

  // What an axis shows: all values and some room.
  function logarithmicRange(values) {
    const positive = values.filter(value => value > 0);
    if (!positive.length) return [1, 10];
    const low = Math.log10(Math.min(...positive)), high = Math.log10(Math.max(...positive));
    const room = Math.max(.06 * (high - low), .05);
    return [Math.pow(10, low - room), Math.pow(10, high + room)];
  }

  function linearRange(values) {
    if (!values.length) return [0, 1];
    const low = Math.min(...values), high = Math.max(...values), largest = Math.max(Math.abs(low), Math.abs(high));
    const room = high - low > 1e-9 * largest ? .06 * (high - low) : .05 * largest || 1; // else it is round-off
    return [low - room, high + room];
  }

  function logarithmicSplits(scale) {
    const splits = [], decades = Math.log10(scale.max / scale.min);
    const factors = decades < 1.2 ? [1, 1.5, 2, 3, 4, 5, 7] : decades < 2.6 ? [1, 2, 5] : [1];
    for (let e = Math.floor(Math.log10(scale.min)); e <= Math.log10(scale.max); ++e)
      for (const factor of factors) {
        const value = factor * Math.pow(10, e);
        if (value >= scale.min && value <= scale.max) splits.push(value);
      }
    return splits;
  }

  // Whether a value of a logarithmic axis keeps its number where there is little room.
  function isLeading(value) {
    const leading = value / Math.pow(10, Math.floor(Math.log10(value) + 1e-9));
    return [1, 3, 5].some(kept => Math.abs(leading - kept) < 1e-6);
  }

  function tick(value) {
    const size = Math.abs(value);
    return size >= 1e4 || (size > 0 && size < 1e-3) ? Number(value.toPrecision(6)).toExponential().replace("e+", "e")
      : number(value, 6);
  }

  function axis(label, side, logarithmic) {
    const across = side === 2;
    const look = {
      side, label, labelSize: 24, size: across ? 34 : 66, stroke: css("--text"), font: "12px system-ui, sans-serif",
      labelFont: "13px system-ui, sans-serif", grid: { stroke: css("--line"), width: 1 },
      ticks: { stroke: css("--line"), width: 1, size: 5 },
      values: (u, splits) => {
        const few = logarithmic && across && u.width < 520 && splits.length > 5;
        return splits.map(value => few && !isLeading(value) ? "" : tick(value));
      }
    };
    if (logarithmic) {
      look.splits = u => logarithmicSplits(u.scales[across ? "x" : "y"]);
      look.filter = (u, splits) => splits;
    }
    return look;
  }

  // A diagram with its controls, whose elements' ids begin with its name. `linesOf(x)`: the lines against an axis.
  function diagram(name, ys, xs, linesOf, logarithmic) {
    if (!ys.length || !xs.length) return;
    const chart = byId(name + "-chart"), tip = byId(name + "-tip"), legend = byId(name + "-legend");
    const yBox = byId(name + "-y"), xBox = byId(name + "-x");
    const points = (line, y, x) => line.points.filter(point => y in point && x in point);
    let plot = null, zoom = null, lines = [], shown = [];

    // Lines and marks of one series; uPlot's own paths have marks of one kind only.
    function paths(u, series) {
      const i = series - 1, [xs, ys] = u.data[series], size = 3.5 * devicePixelRatio;
      const stroke = new Path2D(), marks = new Path2D();
      xs.forEach((x, k) => {
        const px = u.valToPos(x, "x", true), py = u.valToPos(ys[k], "y", true);
        k === 0 ? stroke.moveTo(px, py) : stroke.lineTo(px, py);
        if (lines[i].program) marks.rect(px - size, py - size, 2 * size, 2 * size);
        else { marks.moveTo(px + size, py); marks.arc(px, py, size, 0, 2 * Math.PI); }
      });
      const c = u.ctx;
      c.save();
      c.beginPath();
      c.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
      c.clip();
      c.strokeStyle = colour(i);
      c.lineWidth = 1.5 * devicePixelRatio;
      c.setLineDash(dash(i).map(length => length * devicePixelRatio));
      c.stroke(stroke);
      c.setLineDash([]);
      c.fillStyle = lines[i].program ? css("--ground") : colour(i);
      c.fill(marks);
      c.stroke(marks);
      c.restore();
      return null;
    }

    // The nearest point to the pointer, in pixels.
    function nearest(u, left, top) {
      let best = null;
      for (let series = 1; series < u.series.length; ++series) {
        if (!shown[series - 1]) continue;
        const [xs, ys] = u.data[series];
        xs.forEach((x, k) => {
          const dx = u.valToPos(x, "x") - left, dy = u.valToPos(ys[k], "y") - top, distance = Math.hypot(dx, dy);
          if (distance < 30 && (!best || distance < best.distance))
            best = { distance, line: series - 1, point: u.points[series - 1][k], left: left + dx, top: top + dy };
        });
      }
      return best;
    }

    function showTip(u) {
      const { left, top } = u.cursor, best = left >= 0 ? nearest(u, left, top) : null;
      tip.style.display = best ? "block" : "none";
      if (!best) return;
      tip.replaceChildren(element("b", {}, lines[best.line].title));
      for (const key in best.point) {
        const known = axisOf(ys, key) || axisOf(xs, key);
        tip.append(element("div", {}, (known ? known.label : key.replace("_", " ")) + ": " + number(best.point[key], 4)));
      }
      const box = u.over.getBoundingClientRect(), frame = chart.getBoundingClientRect();
      const x = best.left + box.left - frame.left, y = best.top + box.top - frame.top;
      tip.style.left = Math.max(0, x + 14 + tip.offsetWidth > frame.width ? x - 14 - tip.offsetWidth : x + 14) + "px";
      tip.style.top = Math.max(0, Math.min(y + 10, frame.height - tip.offsetHeight)) + "px";
    }

    function size() {
      const width = chart.clientWidth;
      return { width, height: Math.round(Math.min(560, Math.max(320, .5 * width))) };
    }

    function draw() {
      const y = yBox.value, x = xBox.value;
      const linePoints = lines.map(line => points(line, y, x));
      const all = key => linePoints.flatMap((list, i) => shown[i] ? list.map(p => p[key]) : []);
      const range = logarithmic ? logarithmicRange : linearRange, distr = logarithmic ? 3 : 1;
      const xRange = () => range(all(x)), yRange = () => range(all(y));
      if (plot) plot.destroy();
      tip.style.display = "none";
      plot = new uPlot({
        ...size(), mode: 2, legend: { show: false },
        cursor: { drag: { x: true, y: true }, points: { show: false } },
        scales: {
          x: { time: false, distr, range: (u, low, high) => zoomed(u, "x", low, high) || xRange() },
          y: { distr, range: (u, low, high) => zoomed(u, "y", low, high) || yRange() }
        },
        axes: [axis(axisOf(xs, x).label, 2, logarithmic), axis(axisOf(ys, y).label, 3, logarithmic)],
        series: [{}].concat(lines.map((line, i) => ({
          label: line.title, show: shown[i], stroke: colour(i), facets: [{ scale: "x", auto: true }, { scale: "y", auto: true }],
          paths, points: { show: false }
        }))),
        hooks: { setCursor: [showTip], setSelect: [select], ready: [u => u.over.addEventListener("dblclick", draw)] }
      }, [null].concat(linePoints.map(list => [list.map(p => p[x]), list.map(p => p[y])])), chart);
      plot.points = linePoints;
      fillLegend(y, x);
      document.querySelectorAll(".static[data-" + name + "]").forEach(figure =>
        figure.classList.toggle("chosen", figure.dataset[name] === y));
    }

    // What was marked with the pointer; a double click shows everything again.
    function zoomed(u, key) { return zoom && zoom.plot === u ? zoom[key] : null; }
    function select(u) {
      const box = u.select;
      if (box.width < 5 || box.height < 5) return;
      zoom = {
        plot: u, x: [u.posToVal(box.left, "x"), u.posToVal(box.left + box.width, "x")],
        y: [u.posToVal(box.top + box.height, "y"), u.posToVal(box.top, "y")]
      };
      u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
      u.setData(u.data);
    }

    function fillLegend(y, x) {
      legend.replaceChildren(...lines.map((line, i) => {
        const item = element("li", {}), order = line.order && line.order[y] && line.order[y][x];
        const button = element("button", { type: "button", "aria-pressed": String(shown[i]) });
        button.append(swatch(line, i), element("span", { class: "name" }, line.title),
          element("span", { class: "order" }, points(line, y, x).length === 0 ? "not known"
            : typeof order === "number" ? "order " + number(order, 2) : ""));
        button.addEventListener("click", () => {
          shown[i] = !shown[i];
          draw();
          legend.children[i].firstChild.focus();
        });
        item.append(button);
        return item;
      }));
    }

    function chooseX() {
      lines = linesOf(xBox.value);
      shown = lines.map(() => true);
      draw();
    }

    for (const [box, axes] of [[yBox, ys], [xBox, xs]])
      for (const { name, label } of axes) box.append(element("option", { value: name }, label));
    yBox.addEventListener("change", draw);
    xBox.addEventListener("change", () => linesOf(xBox.value) === lines ? draw() : chooseX());
    chooseX();
    new ResizeObserver(() => { if (plot.width !== chart.clientWidth) plot.setSize(size()); }).observe(chart);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  }

  diagram("quantity", data.quantities, data.sweeps, x => axisOf(data.sweeps, x).lines, false);
  diagram("error", data.errors, data.costs, () => data.lines, true);
})();
