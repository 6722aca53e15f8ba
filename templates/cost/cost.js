"use strict";
// The plots of a scene's costs, from the figures embedded in the page.

const costs = JSON.parse(document.getElementById("cost-data").textContent);

// What JSON has no number for stands in strings: "Infinity".
const readable = unit => unit.replace("^2", "²");
const number = v => v === null || v === undefined ? NaN : Number(v);

function markOf({ function: name, recommended: chosen }, { tier, precision, time, best, errors: [first] }) {
  const y = number(first.bound ? first.bound.worst : first.worst), unit = readable(first.unit);
  return { x: number(time.median), low: number(time.low), high: number(time.high), y, tier,
    precision, hollow: !best, variant: `${name} ${precision} ${tier}`,
    name: `${precision} ${tier}` +
      (tier === chosen.tier && precision === chosen.precision ? ", recommended" : ""),
    title: `${precision} ${tier}: ${first.bound ? "bound" : "error"} ${formatted(y)} ` +
      `${unit}, typically an error of ${formatted(number(first.typical))} ${unit}, ` +
      `${formatted(number(time.median))} ns` };
}

function figureOf(measured) {
  const unit = readable(measured.choices[0].errors[0].unit);
  const title = document.createElement("h3"), figure = document.createElement("figure");
  title.textContent = measured.function;
  figure.append(title, scatter({
    label: `Error of ${measured.function} against time`, xLabel: "ns per call in C",
    yLabel: unit === "1" ? "error" : `error, ${unit}`,
    points: measured.choices.map(choice => markOf(measured, choice)) }));
  return figure;
}

function draw() {
  document.getElementById("plots")?.replaceChildren(...costs.functions.map(figureOf));
  if (costs.run_errors) {
    document.getElementById("run")?.replaceChildren(runPlot(costs.run_errors));
  }
}

addEventListener("resize", draw);
draw();
