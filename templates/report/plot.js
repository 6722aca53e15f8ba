"use strict";
// Scatter plots on logarithmic axes, as SVG.  Knows marks, curves and axes, not reports.

const SVG = "http://www.w3.org/2000/svg";

function svg(name, attributes = {}, ...children) {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

function formatted(x) {
  if (Number.isNaN(x)) return "–";
  if (!Number.isFinite(x)) return x > 0 ? "∞" : "-∞";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e5 || size < 1e-3) {
    return x.toExponential(2).replace(/\.?0*e\+?/, "e");
  }
  return String(Number(x.toPrecision(3)));
}

// A logarithmic axis over whole decades; zeros and infinities get a place of their own at its ends.
function logAxis(values, from, to) {
  const logs = values.filter(v => v > 0 && Number.isFinite(v)).map(Math.log10);
  const low = Math.floor(Math.min(...logs, logs.length ? Infinity : 0) + 1e-9);
  const high = Math.max(low + 1, Math.ceil(Math.max(...logs, logs.length ? -Infinity : 1) - 1e-9));
  const step = (to - from) / 14;
  const start = values.includes(0) ? from + step : from;
  const end = values.includes(Infinity) ? to - step : to;
  const at = v => v === 0 ? from : v === Infinity ? to
    : start + (end - start) * (Math.log10(v) - low) / (high - low);
  const every = Math.ceil((high - low) / 7);
  const ticks = [];
  if (start !== from) ticks.push(0);
  for (let e = low; e <= high; e += every) {
    for (const digit of high - low === 1 && e < high ? [1, 2, 5] : [1]) {
      ticks.push(digit * Number(`1e${e}`));
    }
  }
  if (end !== to) ticks.push(Infinity);
  return { at, ticks };
}

function shape(precision, x, y, attributes, size = 5.5) {
  return precision === "single"
    ? svg("rect", { x: x - size * .9, y: y - size * .9, width: size * 1.8, height: size * 1.8,
                    ...attributes })
    : svg("circle", { cx: x, cy: y, r: size, ...attributes });
}

// Labels beside their marks, moved down where they would lie on one another, left where they
// would leave the plot.
function labels(marks, right) {
  const placed = [];
  for (const { point, x, y } of [...marks].sort((a, b) => a.y - b.y)) {
    const left = x > right - 7 * point.name.length - 12;
    let at = y + 4;
    while (placed.some(p => Math.abs(p.at - at) < 13 && Math.abs(p.x - x) < 110)) at += 1;
    placed.push({ x, at, left, name: point.name });
  }
  return placed.map(({ x, at, left, name }) => svg("text", {
    class: "name", x: left ? x - 10 : x + 10, y: at, "text-anchor": left ? "end" : "start" }, name));
}

// points: {x, y, name?, title, tier, precision, hollow?, data}; curves: {of: x -> y, from, to,
// className, title}; fronts: lists of points to join.
function scatter({ label, xLabel, yLabel, points, curves = [], fronts = [], small = false }) {
  const width = 560, height = 350, left = 64, right = width - 14, top = 26, bottom = height - 46;
  const shown = points.filter(p => !Number.isNaN(p.x) && !Number.isNaN(p.y));
  const root = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": label });
  if (!shown.length) {
    root.append(svg("text", { x: width / 2, y: height / 2, "text-anchor": "middle" },
                    "nothing measured here"));
    return root;
  }
  const ends = curves.flatMap(c => [c.of(c.from), c.of(c.to)]);
  const horizontal = logAxis(shown.map(p => p.x), left + 12, right - 12);
  const vertical = logAxis([...shown.map(p => p.y), ...ends], bottom - 8, top + 8);
  for (const value of horizontal.ticks) {
    const x = horizontal.at(value);
    root.append(svg("line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom }),
                svg("text", { x, y: bottom + 17, "text-anchor": "middle" }, formatted(value)));
  }
  for (const value of vertical.ticks) {
    const y = vertical.at(value);
    root.append(svg("line", { class: "grid", x1: left, x2: right, y1: y, y2: y }),
                svg("text", { x: left - 7, y: y + 4, "text-anchor": "end" }, formatted(value)));
  }
  root.append(svg("text", { x: (left + right) / 2, y: height - 8, "text-anchor": "middle" }, xLabel),
              svg("text", { x: 6, y: 14 }, yLabel));
  const path = pairs => pairs.map(([x, y], i) =>
    `${i ? "L" : "M"}${horizontal.at(x).toFixed(1)} ${vertical.at(y).toFixed(1)}`).join("");
  for (const curve of curves) {
    const pairs = Array.from({ length: 61 }, (_, i) => {
      const x = curve.from * (curve.to / curve.from) ** (i / 60);
      return [x, curve.of(x)];
    });
    root.append(svg("path", { class: curve.className, d: path(pairs) },
                    svg("title", {}, curve.title)));
  }
  for (const front of fronts) {
    root.append(svg("path", { class: "front", d: path(front.map(p => [p.x, p.y])) }));
  }
  const marks = shown.map(point => ({ point, x: horizontal.at(point.x), y: vertical.at(point.y) }));
  for (const { point, x, y } of marks) {
    const attributes = {
      class: `mark ${point.tier}${point.hollow ? " hollow" : ""}${small ? " small" : ""}`,
      "data-x": point.x, "data-y": point.y, "data-variant": point.variant };
    const mark = shape(point.precision, x, y, attributes, small ? 3.2 : 5.5);
    mark.append(svg("title", {}, point.title));
    root.append(mark);
  }
  root.append(...labels(marks.filter(m => m.point.name), right));
  return root;
}
