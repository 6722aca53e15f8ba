"use strict";
// The page's plots and controls; they and the table read the one report embedded in the page.

const measureOf = entries => distinct(entries.map(e => e.measure)).join(" or ");

// Time against worst error, one mark per entry; those not dominated are joined.
function pareto(entries, label, name) {
  const points = entries.map(entry => {
    const time = timeOf(entry), [x, low, high] = [time.ns, time.low, time.high].map(number);
    const y = number(entry[state.inputs]?.worst), hollow = time.dominated === true;
    return { x, y, low, high, hollow, name: name(entry), tier: entry.tier, entry,
      precision: entry.precision, variant: identity(entry),
      title: `${identity(entry)}: ${formatted(y)} ${entry.measure}, ${formatted(x)} ns ` +
        `(${range(low, high)})${hollow ? ", dominated" : ""}` };
  });
  const best = points.filter(p => !p.hollow && !isNaN(p.x) && !isNaN(p.y))
    .sort((a, b) => a.x - b.x);
  const curveOf = ({ entry }) => `${entry.operation} ${entry.precision}`;
  const lines = distinct(best.map(curveOf)).map(curve => ({ class: "front",
    points: best.filter(p => curveOf(p) === curve).map(p => [p.x, p.y]) }));
  return scatter({ label, points, lines, xLabel: `ns per element: ${state.layout}`,
    yLabel: `worst error, ${state.inputs} inputs (${measureOf(entries)})` });
}

function drawHeadline() {
  $("headline-plots").replaceChildren(...PRECISIONS.flatMap(precision => {
    const entries = chosenEntries().filter(e =>
      e.precision === precision && report.headline.includes(e.operation));
    if (!entries.length) return [];
    const last = name => entries.findLast(e => e.operation === name);
    return [node("figure", {}, node("h3", {}, `${precision} precision`), pareto(entries,
      `Time against worst error, ${precision} precision`,
      e => last(e.operation) === e ? e.operation : ""))];
  }));
}

function condition(entries) {
  const points = entries.flatMap(e => e.condition.map(pair => pair.map(number)).map(([x, y]) => ({
    x, y, tier: e.tier, precision: e.precision, variant: identity(e),
    title: `${identity(e)}: ${formatted(y)} ${e.measure}, condition ${formatted(x)}` })));
  const lines = entries.filter(e => e.bound && boundAt(e, 1) > 0).flatMap(e => {
    const finite = e.condition.map(([x]) => number(x)).filter(x => x > 0 && Number.isFinite(x));
    const from = Math.min(...finite), to = Math.max(...finite);
    const steps = Array.from({ length: 61 }, (_, i) => from * (to / from) ** (i / 60));
    return finite.length ? [{ points: steps.map(x => [x, boundAt(e, x)]),
      class: `bound ${e.tier} ${e.precision}`,
      title: `${identity(e)}, proven: at most 1 + (c1 + c2 u) S/|x|` }] : [];
  });
  return scatter({ points, lines, small: true, xLabel: "condition S/|x|",
    label: `Error of ${state.operation} against the condition of its inputs`,
    yLabel: `error (${measureOf(entries)}); lines: proven bound` });
}

function times(entries) {
  const line = (first, cells) => node("tr", {}, first, ...cells);
  const lines = distinct(entries.flatMap(e => e.times.map(timeName))).map(name =>
    line(node("th", { scope: "row" }, name), entries.map(e => {
      const time = e.times.find(t => timeName(t) === name);
      return node("td", {}, time ? `${formatted(number(time.ns))} (${range(time.low, time.high)})`
        : "–");
    })));
  return [node("thead", {}, line(node("th", { scope: "col", class: "text" }, "ns per element"),
    entries.map(e => node("th", { scope: "col" }, variantName(e))))), node("tbody", {}, ...lines)];
}

function witnesses(entries) {
  const proven = entries.filter(e => e.bound).map(e =>
    node("li", {}, `${variantName(e)}, proven: ${e.bound.text}`));
  return proven.concat(entries.flatMap(e => ["hard", "benign"].filter(x => e[x]).map(inputs => {
    const { worst, component, witness, outputs } = e[inputs];
    return node("li", {}, `${variantName(e)}, ${inputs}: ${formatted(number(worst))} ` +
      `${e.measure} in ${component}, the worst of ${outputs.toLocaleString("en")} outputs, at `,
      node("code", { class: "witness" }, witness.join(" ")));
  })));
}

function drawOperation() {
  const all = report.entries.filter(e => e.operation === state.operation);
  const entries = chosenEntries().filter(e => e.operation === state.operation);
  $("statement").textContent = all[0] ? `${all[0].statement} (${all[0].counts})` : "";
  $("pareto-plot").replaceChildren(
    pareto(entries, `Time against worst error of ${state.operation}`, e => e.tier));
  $("condition-plot").replaceChildren(condition(entries));
  $("times").replaceChildren(...times(entries));
  $("witnesses").replaceChildren(...witnesses(entries));
}

function choose(operation, scroll) {
  state.operation = $("operation").value = operation;
  drawOperation();
  drawTable();
  if (scroll) $("operation-section").scrollIntoView();
}

const draw = () => { drawHeadline(); drawOperation(); drawTable(); };

const layouts = distinct(report.entries.flatMap(e => e.times.map(timeName)));
const operations = distinct(report.entries.map(e => e.operation));
$("layout").append(...layouts.map(name => new Option(name, name, false, name === report.layout)));
$("operation").append(...operations.map(name => new Option(name, name)));
state.layout = report.layout;
state.operation = $("operation").value = report.headline[0] ?? operations[0] ?? "";
for (const name of ["layout", "inputs", "precision", "tier"]) {
  $(name).addEventListener("change", () => { state[name] = $(name).value; draw(); });
}
$("operation").addEventListener("change", () => choose($("operation").value, false));
$("text").addEventListener("input", () => { state.text = $("text").value; drawTable(); });
addEventListener("resize", () => { drawHeadline(); drawOperation(); });
head();
draw();
