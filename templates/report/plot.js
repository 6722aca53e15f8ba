"use strict";
// Scatter plots on logarithmic axes, as SVG.  Knows marks, lines and axes, not reports.

function node(name, attributes = {}, ...children) {
  const space = name in SVG_NAMES ? "http://www.w3.org/2000/svg" : "http://www.w3.org/1999/xhtml";
  const made = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}
const SVG_NAMES = { svg: 1, line: 1, text: 1, title: 1, path: 1 };

const power = x => x.toExponential(2).replace(/\.?0*e\+?/, "e");

function formatted(x) {
  if (Number.isNaN(x)) return "–";
  if (!Number.isFinite(x)) return x > 0 ? "∞" : "-∞";
  return x !== 0 && (Math.abs(x) >= 1e5 || Math.abs(x) < 1e-3) ? power(x)
    : String(Number(x.toPrecision(3)));
}

// A logarithmic axis from and to round numbers; zeros and infinities have places of their own at
// its ends.  Its ticks have texts, all with powers of ten if one needs it.
function logAxis(values, from, to) {
  const finite = values.filter(v => v > 0 && Number.isFinite(v));
  const least = finite.length ? Math.min(...finite) : 1, most = Math.max(least, ...finite);
  const decades = Math.log10(most / least), every = Math.max(1, Math.ceil(decades / 7));
  const round = [];
  for (let e = Math.floor(Math.log10(least)); e <= Math.ceil(Math.log10(most)) + 1; e += every) {
    for (const digit of decades < 3 ? [1, 2, 5] : [1]) round.push(Number(`${digit}e${e}`));
  }
  const low = round.filter(v => v <= least).at(-1) ?? least;
  const high = round.find(v => v > most) ?? most;
  const step = (to - from) / 14, [zero, infinite] = [values.includes(0), values.includes(Infinity)];
  const start = zero ? from + step : from, end = infinite ? to - step : to;
  const at = v => v === 0 ? from : v === Infinity ? to
    : start + (end - start) * Math.log(v / low) / Math.log(high / low);
  const ticks = round.filter(v => v >= low && v <= high);
  const text = ticks.some(x => formatted(x).includes("e")) ? power : formatted;
  return { at, ticks: [...(zero ? [[from, "0"]] : []), ...ticks.map(v => [at(v), text(v)]),
                       ...(infinite ? [[to, "∞"]] : [])] };
}

// Names beside their marks, each where it covers neither a mark nor another name, if there is room.
function names(marks, left, right, bottom) {
  const taken = marks.map(({ x, y }) => [x - 6, y - 6, x + 6, y + 6]);
  const free = ({ box: [l, t, r, b] }) => l > left && r < right && b < bottom &&
    !taken.some(([x, y, z, w]) => l < z && x < r && t < w && y < b);
  return marks.filter(m => m.point.name).map(({ point: { name }, x, y }) => {
    const width = 6.8 * name.length, places = [0, 13, -13, 26, -26, 39, -39].flatMap(dy =>
      [["start", x + 10, 0], ["end", x - 10, 1], ["middle", x, .5]].map(([anchor, at, share]) => ({
        anchor, at, y: y + dy + 4,
        box: [at - share * width, y + dy - 7, at + (1 - share) * width, y + dy + 6] })));
    const place = places.find(free) ?? places[0];
    taken.push(place.box);
    const { at: x0, y: y0, anchor } = place;
    return node("text", { class: "name", x: x0, y: y0, "text-anchor": anchor }, name);
  });
}

// points: {x, y, low?, high?, name?, title, tier, precision, hollow?, variant}; lines: {points,
// class, title?}.
function scatter({ label, xLabel, yLabel, points, lines = [], small = false }) {
  const width = innerWidth < 640 ? 340 : 560, height = 350;
  const left = 52, right = width - 14, top = 26, bottom = height - 46;
  const shown = points.filter(p => !Number.isNaN(p.x) && !Number.isNaN(p.y));
  const root = node("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": label });
  const write = (x, y, anchor, text) =>
    root.append(node("text", { x, y, "text-anchor": anchor }, text));
  if (!shown.length) {
    write(width / 2, height / 2, "middle", "nothing measured here");
    return root;
  }
  const times = shown.flatMap(p => [p.x, p.low ?? p.x, p.high ?? p.x]);
  const across = logAxis(times, left + 12, right - 12);
  const up = logAxis([...shown.map(p => p.y), ...lines.flatMap(l => l.points.map(([, y]) => y))],
                     bottom - 8, top + 8);
  for (const [x, text] of across.ticks) {
    root.append(node("line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom }));
    write(x, bottom + 17, "middle", text);
  }
  for (const [y, text] of up.ticks) {
    root.append(node("line", { class: "grid", x1: left, x2: right, y1: y, y2: y }));
    write(left - 7, y + 4, "end", text);
  }
  write((left + right) / 2, height - 8, "middle", xLabel);
  write(6, 14, "start", yLabel);
  for (const { points: pairs, title = "", ...attributes } of lines) {
    const d = pairs.map(([x, y], i) => `${i ? "L" : "M"}${across.at(x)} ${up.at(y)}`).join("");
    root.append(node("path", { ...attributes, d }, node("title", {}, title)));
  }
  const marks = shown.map(point => ({ point, x: across.at(point.x), y: up.at(point.y) }));
  for (const { point, x, y } of marks) {
    const variant = { "data-variant": point.variant }, size = small ? 3 : 5;
    const { low, high, tier } = point, square = `h${2 * size}v${2 * size}h${-2 * size}z`;
    const half = `a${size} ${size} 0 1 0 `, circle = `${half}${2 * size} 0${half}${-2 * size} 0`;
    if (low !== undefined) {
      root.append(node("line", { ...variant, class: `interval ${tier}`, "data-low": low,
        "data-high": high, x1: across.at(low), x2: across.at(high), y1: y, y2: y }));
    }
    root.append(node("path", { ...variant, "data-x": point.x, "data-y": point.y,
      class: `mark ${tier}${point.hollow ? " hollow" : ""}${small ? " small" : ""}`,
      d: point.precision === "single" ? `M${x - size} ${y - size}${square}`
        : `M${x - size} ${y}${circle}` },
      node("title", {}, point.title)));
  }
  root.append(...names(marks, left, right, bottom));
  return root;
}
