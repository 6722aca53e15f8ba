"use strict";
// The plots of a scene's costs, from the figures embedded in the page.

const costs = JSON.parse(document.getElementById("cost-data").textContent);

// What JSON has no number for stands in strings: "Infinity".
const readable = unit => unit.replace("^2", "²");
const number = v => v === null || v === undefined ? NaN : Number(v);

// The choice's mark in the function's unit with this index.
function markOf({ function: name, recommended: chosen }, { tier, precision, time, best, errors }, index) {
  const of = errors[index], unit = readable(of.unit);
  const y = number(of.bound ? of.bound.worst : of.worst);
  return { x: number(time.median), low: number(time.low), high: number(time.high), y, tier,
    precision, hollow: !best, variant: `${name} ${precision} ${tier}`,
    name: `${precision} ${tier}` +
      (tier === chosen.tier && precision === chosen.precision ? ", recommended" : ""),
    title: `${precision} ${tier}: ${of.bound ? "bound" : "error"} ${formatted(y)} ` +
      `${unit}, typically an error of ${formatted(number(of.typical))} ${unit}, ` +
      `${formatted(number(time.median))} ns` };
}

// The function's units in which any choice has an error, or the first.
function unitsOf({ choices }) {
  const units = [...choices[0].errors.keys()].filter(n =>
    choices.some(({ errors }) => number(errors[n].worst) !== 0));
  return units.length ? units : [0];
}

function figureOf(measured, index) {
  const unit = readable(measured.choices[0].errors[index].unit);
  const title = document.createElement("h3"), figure = document.createElement("figure");
  title.textContent = measured.function;
  figure.append(title, scatter({
    label: `Error of ${measured.function} against time`, xLabel: "ns per call in C",
    yLabel: unit === "1" ? "error" : `error, ${unit}`,
    points: measured.choices.map(choice => markOf(measured, choice, index)) }));
  return figure;
}

function draw() {
  document.getElementById("plots")?.replaceChildren(...costs.functions.flatMap(
    measured => unitsOf(measured).map(index => figureOf(measured, index))));
  if (costs.run_errors) {
    document.getElementById("run")?.replaceChildren(runPlot(costs.run_errors));
  }
}

addEventListener("resize", draw);
draw();
