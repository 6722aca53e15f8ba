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

// Numbers of an axis: all with powers of ten if one needs it.
function written(ticks) {
  const powers = ticks.some(x => formatted(x).includes("e"));
  return ticks.map(x => powers && x !== 0 && Number.isFinite(x)
    ? x.toExponential(2).replace(/\.?0*e\+?/, "e") : formatted(x));
}

// A logarithmic axis from and to round numbers; zeros and infinities have places of their own at
// its ends.
function logAxis(values, from, to) {
  const finite = values.filter(v => v > 0 && Number.isFinite(v));
  const [least, most] = finite.length ? [Math.min(...finite), Math.max(...finite)] : [1, 10];
  const decades = Math.log10(most / least);
  const first = Math.floor(Math.log10(least)), last = Math.ceil(Math.log10(most)) + 1;
  const every = Math.max(1, Math.ceil(decades / 7));
  const round = [];
  for (let e = first; e <= last; e += every) {
    for (const digit of decades < 3 ? [1, 2, 5] : [1]) round.push(Number(`${digit}e${e}`));
  }
  const low = round.filter(v => v <= least).at(-1) ?? least;
  const high = round.find(v => v > most) ?? most;
  const step = (to - from) / 14;
  const start = values.includes(0) ? from + step : from;
  const end = values.includes(Infinity) ? to - step : to;
  const at = v => v === 0 ? from : v === Infinity ? to
    : start + (end - start) * Math.log(v / low) / Math.log(high / low);
  const ticks = round.filter(v => v >= low && v <= high);
  return { at, ticks: [start === from ? [] : 0, ticks, end === to ? [] : Infinity].flat() };
}

function shape(precision, x, y, attributes, size = 5.5) {
  return precision === "single"
    ? svg("rect", { x: x - size * .9, y: y - size * .9, width: size * 1.8, height: size * 1.8,
                    ...attributes })
    : svg("circle", { cx: x, cy: y, r: size, ...attributes });
}

// Names beside their marks, each where it covers neither a mark nor another name, if there is room.
function names(marks, left, right, bottom) {
  const taken = marks.map(({ x, y }) => ({ x: x - 6, y: y - 6, width: 12, height: 12 }));
  const free = box => box.x > left && box.x + box.width < right && box.y + box.height < bottom &&
    !taken.some(other => box.x < other.x + other.width && other.x < box.x + box.width &&
                         box.y < other.y + other.height && other.y < box.y + box.height);
  return marks.filter(m => m.point.name).map(({ point, x, y }) => {
    const size = { width: 6.8 * point.name.length, height: 13 };
    const places = [0, 13, -13, 26, -26, 39, -39].flatMap(dy =>
      [["start", x + 10], ["end", x - 10], ["middle", x]].map(([anchor, at]) => ({
        anchor, at, y: y + dy - 7, ...size,
        x: at - size.width * { start: 0, end: 1, middle: .5 }[anchor] })));
    const box = places.find(free) ?? places[0];
    taken.push(box);
    return svg("text", { class: "name", x: box.at, y: box.y + 11, "text-anchor": box.anchor },
               point.name);
  });
}

// points: {x, y, low?, high?, name?, title, tier, precision, hollow?, data}; curves: {of: x -> y, from, to,
// className, title}; fronts: lists of points to join.
function scatter({ label, xLabel, yLabel, points, curves = [], fronts = [], small = false }) {
  const width = innerWidth < 640 ? 340 : 560, height = 350;
  const left = 52, right = width - 14, top = 26, bottom = height - 46;
  const shown = points.filter(p => !Number.isNaN(p.x) && !Number.isNaN(p.y));
  const root = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": label });
  if (!shown.length) {
    root.append(svg("text", { x: width / 2, y: height / 2, "text-anchor": "middle" },
                    "nothing measured here"));
    return root;
  }
  const ends = curves.flatMap(c => [c.of(c.from), c.of(c.to)]);
  const across = shown.flatMap(p => [p.x, p.low ?? p.x, p.high ?? p.x]);
  const horizontal = logAxis(across, left + 12, right - 12);
  const vertical = logAxis([...shown.map(p => p.y), ...ends], bottom - 8, top + 8);
  const xTexts = written(horizontal.ticks), yTexts = written(vertical.ticks);
  for (const [n, value] of horizontal.ticks.entries()) {
    const x = horizontal.at(value);
    root.append(svg("line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom }),
                svg("text", { x, y: bottom + 17, "text-anchor": "middle" }, xTexts[n]));
  }
  for (const [n, value] of vertical.ticks.entries()) {
    const y = vertical.at(value);
    root.append(svg("line", { class: "grid", x1: left, x2: right, y1: y, y2: y }),
                svg("text", { x: left - 7, y: y + 4, "text-anchor": "end" }, yTexts[n]));
  }
  root.append(svg("text", { x: (left + right) / 2, y: height - 8, "text-anchor": "middle" },
                  xLabel),
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
    if (point.low !== undefined) {
      root.append(svg("line", { class: `interval ${point.tier}`, "data-low": point.low,
        "data-high": point.high, "data-variant": point.variant, x1: horizontal.at(point.low),
        x2: horizontal.at(point.high), y1: y, y2: y }));
    }
    root.append(mark);
  }
  root.append(...names(marks, left, right, bottom));
  return root;
}
