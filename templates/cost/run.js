"use strict";
// Errors of a run over time, as SVG: a curve for each cause, a cross where no digit is left.

function curveOf(row, index, times, at) {
  const [kind, tier = ""] = row.cause === "rounding" ? row.of.split(" ") : [""];
  const name = `${row.cause}: ${row.of}`, attributes = {
    class: `curve ${row.cause} ${tier} ${kind}`, style: `--row: ${index}`, "data-curve": name };
  const points = row.errors.map((y, n) => [times[n], number(y)])
    .filter(([, y]) => y > 0 && Number.isFinite(y)).map(([x, y]) => at(x, y));
  const d = points.map(([x, y], n) => `${n ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");
  const curve = [svg("path", { ...attributes, d, "data-points": points.length },
                     svg("title", {}, name))];
  const gone = times.indexOf(row.gone);
  if (gone >= 0 && number(row.errors[gone]) < Infinity) {
    const [x, y] = at(row.gone, number(row.errors[gone]));
    curve.push(svg("path", { ...attributes, class: `${attributes.class} cross`,
                             d: `M${x - 4} ${y - 4}l8 8m0 -8l-8 8` }));
  }
  return curve;
}

function runPlot({ integrator, step, times, rows }) {
  const width = innerWidth < 640 ? 340 : 1120, height = 350;
  const left = 52, right = width - 14, top = 26, bottom = height - 46;
  const root = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img",
    "aria-label": `Errors of the run over time: ${integrator}, step ${step} s` });
  const plainLast = (a, b) => a.of.endsWith(" plain") - b.of.endsWith(" plain");
  const sorted = [...rows].sort(plainLast);  // plain's curves are thin and may coincide with others
  const errors = rows.flatMap(row => row.errors.map(number)).filter(y => y > 0 && y < Infinity);
  const vertical = logAxis(errors, bottom - 4, top + 4), end = times.at(-1);
  const at = (x, y) => [left + (right - left) * x / end, vertical.at(y)];
  const texts = written(vertical.ticks);
  for (const [n, value] of vertical.ticks.entries()) {
    const y = vertical.at(value);
    root.append(svg("line", { class: "grid", x1: left, x2: right, y1: y, y2: y }),
                svg("text", { x: left - 7, y: y + 4, "text-anchor": "end" }, texts[n]));
  }
  for (let part = 0; part <= 4; part++) {
    const [x] = at(end * part / 4, 1), anchor = part === 4 ? "end" : "middle";
    root.append(svg("line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom }),
                svg("text", { x, y: bottom + 17, "text-anchor": anchor },
                    formatted(end * part / 4)));
  }
  root.append(svg("text", { x: (left + right) / 2, y: height - 8, "text-anchor": "middle" },
                  "t, s"),
              svg("text", { x: 6, y: 14 }, "error of a coordinate, m or rad"),
              ...sorted.flatMap(row => curveOf(row, rows.indexOf(row), times, at)));
  return root;
}
