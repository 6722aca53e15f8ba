"use strict";
// The page's plots and controls; they and the table read the one report embedded in the page.

// One mark per entry: time against worst error.
function paretoPoint(entry, name) {
  const time = timeOf(entry), found = entry[state.inputs];
  const point = { x: number(time.ns), y: number(found?.worst), name, tier: entry.tier,
    low: number(time.low), high: number(time.high),
    precision: entry.precision, hollow: time.dominated === true, variant: identity(entry) };
  point.title = `${identity(entry)}: ${formatted(point.y)} ${entry.measure}, ` +
    `${formatted(point.x)} ns (${range(point.low, point.high)})` +
    (point.hollow ? ", dominated" : "");
  return point;
}

const measureOf = entries => [...new Set(entries.map(e => e.measure))].join(" or ");

function pareto(entries, label, name) {
  const points = entries.map(e => paretoPoint(e, name(e)));
  const best = points.filter(p => !p.hollow && !isNaN(p.x) && !isNaN(p.y))
    .sort((a, b) => a.x - b.x);
  const curveOf = p => p.variant.slice(0, p.variant.lastIndexOf(" "));  // operation and precision
  const fronts = [...new Set(best.map(curveOf))].map(key => best.filter(p => curveOf(p) === key));
  return scatter({ label, points, fronts,
    xLabel: `ns per element: ${state.layout}`,
    yLabel: `worst error, ${state.inputs} inputs (${measureOf(entries)})` });
}

function drawHeadline() {
  const plots = PRECISIONS.flatMap(precision => {
    const entries = chosenEntries().filter(e =>
      e.precision === precision && report.headline.includes(e.operation));
    if (!entries.length) return [];
    const last = name => entries.filter(e => e.operation === name).at(-1);
    return [element("figure", {}, element("h3", {}, `${precision} precision`), pareto(entries,
      `Time against worst error, ${precision} precision`,
      e => last(e.operation) === e ? e.operation : ""))];
  });
  $("headline-plots").replaceChildren(...plots);
}

function drawCondition(entries) {
  const points = entries.flatMap(e => e.condition.map(([condition, found]) => ({
    x: number(condition), y: number(found), tier: e.tier, precision: e.precision,
    variant: identity(e),
    title: `${identity(e)}: ${formatted(number(found))} ${e.measure}, ` +
      `condition ${formatted(number(condition))}`,
  })));
  const curves = entries.filter(e => e.bound && boundAt(e, 1) > 0).flatMap(e => {
    const finite = e.condition.map(([x]) => number(x)).filter(x => x > 0 && Number.isFinite(x));
    return finite.length ? [{ of: x => boundAt(e, x), from: Math.min(...finite),
      to: Math.max(...finite), className: `bound ${e.tier} ${e.precision}`,
      title: `${identity(e)}, proven: at most 1 + (c1 + c2 u) S/|x|` }] : [];
  });
  $("condition-plot").replaceChildren(scatter({ points, curves, small: true,
    label: `Error of ${state.operation} against the condition of its inputs`,
    xLabel: "condition S/|x|", yLabel: `error (${measureOf(entries)}); lines: proven bound` }));
}

function drawTimes(entries) {
  const names = [...new Set(entries.flatMap(e => e.times.map(timeName)))];
  const top = element("tr", {}, element("th", { scope: "col", class: "text" }, "ns per element"),
    ...entries.map(e => element("th", { scope: "col" }, variantName(e))));
  const lines = names.map(name => element("tr", {}, element("th", { scope: "row" }, name),
    ...entries.map(e => {
      const time = e.times.find(t => timeName(t) === name);
      return element("td", {}, time ?
        `${formatted(number(time.ns))} (${range(time.low, time.high)})` : "–");
    })));
  $("times").replaceChildren(element("thead", {}, top), element("tbody", {}, ...lines));
}

function drawWitnesses(entries) {
  const items = entries.flatMap(e => ["hard", "benign"].filter(inputs => e[inputs]).map(inputs => {
    const { worst, component, witness, outputs } = e[inputs];
    return element("li", {}, `${variantName(e)}, ${inputs}: ${formatted(number(worst))} ` +
      `${e.measure} in ${component}, the worst of ${outputs.toLocaleString("en")} outputs, at `,
      element("code", { class: "witness" }, witness.join(" ")));
  }));
  const bounds = entries.filter(e => e.bound).map(e =>
    element("li", {}, `${variantName(e)}, proven: ${e.bound.text}`));
  $("witnesses").replaceChildren(...bounds, ...items);
}

function drawOperation() {
  const all = report.entries.filter(e => e.operation === state.operation);
  const entries = chosenEntries().filter(e => e.operation === state.operation);
  $("statement").textContent = all[0] ? `${all[0].statement} (${all[0].counts})` : "";
  $("pareto-plot").replaceChildren(pareto(entries, `Time against worst error of ${state.operation}`,
    e => e.tier));
  drawCondition(entries);
  drawTimes(entries);
  drawWitnesses(entries);
}

function choose(operation, scroll) {
  state.operation = $("operation").value = operation;
  for (const line of $("table-body").rows) {
    line.classList.toggle("chosen", line.dataset.variant.startsWith(`${operation} `));
  }
  drawOperation();
  if (scroll) $("operation-section").scrollIntoView();
}

const draw = () => { drawHeadline(); drawOperation(); drawTable(); };

function start() {
  const layouts = [...new Set(report.entries.flatMap(e => e.times.map(timeName)))];
  const operations = [...new Set(report.entries.map(e => e.operation))];
  state.layout = report.layout;
  $("layout").append(...layouts.map(name => new Option(name, name, false, name === state.layout)));
  $("operation").append(...operations.map(name => new Option(name, name)));
  state.operation = report.headline[0] ?? operations[0] ?? "";
  head();
  for (const name of ["layout", "inputs", "precision", "tier"]) {
    $(name).addEventListener("change", () => { state[name] = $(name).value; draw(); });
  }
  $("operation").addEventListener("change", () => choose($("operation").value, false));
  $("text").addEventListener("input", () => { state.text = $("text").value; drawTable(); });
  addEventListener("resize", () => { drawHeadline(); drawOperation(); });
  choose(state.operation, false);
  draw();
}

start();
