"use strict";
// The report, what is chosen of it, and the table: sorted, filtered, one row per entry.

const $ = id => document.getElementById(id);
const report = JSON.parse($("data").textContent);
const PRECISIONS = ["double", "single"];

// What JSON has no number for stands in strings: "Infinity", "NaN"; nothing measured is null.
const number = v => v === null || v === undefined ? NaN : Number(v);
const distinct = values => [...new Set(values)];
const timeName = t => [t.language, t.compiler, t.layout].filter(Boolean).join(", ");
const variantName = e => `${e.precision} ${e.tier}`;
const identity = e => `${e.operation} ${variantName(e)}`;
const range = (low, high) => `${formatted(number(low))}–${formatted(number(high))}`;

const state = { layout: "", inputs: "hard", precision: "", tier: "", text: "", operation: "",
                sort: "", descending: false };

const timeOf = entry => entry.times.find(t => timeName(t) === state.layout) ?? {};
const chosenEntries = () => report.entries.filter(e =>
  (!state.precision || e.precision === state.precision) && (!state.tier || e.tier === state.tier));

// |x̂ - x| <= u |x̂| + (c1 u + c2 u²) S with 1 ulp >= u |x|, so that in ulp, as in units of u |x|,
// the error is at most 1 + (c1 + c2 u) S/|x|; without a last rounding the 1 falls away.
const UNIT_ROUNDOFF = { double: 2 ** -53, single: 2 ** -24 };
const boundAt = ({ bound, precision }, condition) => (bound.rounded ? 1 : 0) +
  (number(bound.c1) + number(bound.c2) * UNIT_ROUNDOFF[precision]) * condition;

function boundText({ bound }) {
  if (!bound) return "–";
  const terms = [bound.rounded ? "u |x̂|" : "",
                 bound.c1 ? `${formatted(number(bound.c1))} u S` : "",
                 bound.c2 ? `${formatted(number(bound.c2))} u² S` : ""];
  return terms.filter(Boolean).join(" + ") || "exact";
}

// The table's columns: a value to sort by, its text, and the class of its cells.
const known = text => (v, e) => Number.isNaN(v) ? "–" : text(v, e);
const words = (id, group, more = {}) =>
  ({ id, title: id, group, className: "text", value: e => e[id], text: v => v, ...more });
const errors = inputs => [["worst", "worst"], ["p999", "99.9 %"], ["median", "median"]].map(
  ([which, title]) => ({ id: `${inputs}-${which}`, title, group: `error, ${inputs} inputs`,
    value: e => number(e[inputs]?.[which]),
    text: known((v, e) => formatted(v) + (e.measure === "u" ? " u" : "")) }));
const time = (id, title, value, text, className = "") =>
  ({ id, title, group: "time", value: e => value(timeOf(e)), text: known(text), className });

const COLUMNS = [
  words("operation", "kernel"), words("precision", "variant"),
  words("tier", "variant", { value: e => report.tiers.indexOf(e.tier), text: (v, e) => e.tier }),
  ...errors("hard"),
  time("ns", "ns", t => number(t.ns), formatted),
  time("interval", "interval", t => number(t.high) - number(t.low),
       (v, e) => range(timeOf(e).low, timeOf(e).high)),
  time("ratio", "to plain", t => number(t.ratio),
       (v, e) => `${formatted(v)} × (${range(timeOf(e).ratio_low, timeOf(e).ratio_high)})`),
  time("pareto", "Pareto", t => t.dominated ?? NaN,
       v => v ? "○ dominated" : "● undominated", "text pareto"),
  { id: "flops", title: "flops", group: "size", value: e => e.flops, text: String,
    hint: e => e.counts },
  { id: "bound", title: "bound", group: "proof", className: "text", text: (v, e) => boundText(e),
    value: e => e.bound ? boundAt(e, 1) : NaN, hint: e => e.bound?.text },
  { id: "ratio-to-bound", title: "error / bound", group: "proof", text: formatted,
    value: e => number(e.bound?.worst_ratio), warns: v => v > 1 },
  ...errors("benign"),
];
COLUMNS.forEach((column, i) => {
  column.opens = i > 0 && COLUMNS[i - 1].group !== column.group ? "start" : "";
});

function head() {
  const groups = distinct(COLUMNS.map(c => c.group)).map((group, i) => {
    const of = COLUMNS.filter(c => c.group === group);
    return node("th", { scope: "colgroup", colspan: of.length,
                        class: `group ${of[0].opens} ${i ? "" : "first"}` }, group);
  });
  const names = COLUMNS.map((column, i) => {
    const button = node("button", { type: "button" }, column.title);
    button.addEventListener("click", () => {
      state.descending = state.sort === column.id && !state.descending;
      state.sort = column.id;
      drawTable();
    });
    return node("th", { scope: "col", id: `by-${column.id}`, "aria-sort": "none",
      class: `${column.className ?? ""} ${column.opens} ${i ? "" : "first"}` }, button);
  });
  $("table-head").append(node("tr", {}, ...groups), node("tr", {}, ...names));
}

// A kernel's name may break after an underscore; where space is short its variant stands below it.
function row(entry) {
  const parts = entry.operation.split(/(?<=_)/).flatMap(part => [node("wbr"), part]);
  const button = node("button", { type: "button", title: entry.statement }, ...parts);
  button.addEventListener("click", () => choose(entry.operation, true));
  const cells = COLUMNS.slice(1).map(column => {
    const value = column.value(entry);
    return node("td", { "data-column": column.id, "data-value": value,
      title: column.hint?.(entry) ?? "", class: `${column.className ?? ""} ${column.opens} ` +
        (column.warns?.(value) ? "over" : "") }, column.text(value, entry));
  });
  const line = node("tr", { "data-variant": identity(entry) },
    node("th", { scope: "row", "data-column": "operation" }, button,
         node("span", { class: "also", "aria-hidden": "true" }, variantName(entry))), ...cells);
  line.classList.toggle("dominated", timeOf(entry).dominated === true);
  return line;
}

const built = new Map();  // rows by layout and entry: sorting and filtering only move them

function rowOf(entry) {
  const key = `${state.layout} ${identity(entry)}`;
  if (!built.has(key)) built.set(key, row(entry));
  built.get(key).classList.toggle("chosen", entry.operation === state.operation);
  return built.get(key);
}

function sorted(entries) {
  const column = COLUMNS.find(c => c.id === state.sort);
  if (!column) return entries;
  const sign = state.descending ? -1 : 1;
  return entries.map(e => [column.value(e), e]).sort(([a], [b]) =>
    Number.isNaN(a) || Number.isNaN(b) ? Number.isNaN(a) - Number.isNaN(b)
      : a < b ? -sign : a > b ? sign : 0).map(([, e]) => e);
}

function drawTable() {
  const wanted = state.text.toLowerCase().split(/\s+/).filter(Boolean);
  const entries = sorted(chosenEntries().filter(e => {
    const text = `${identity(e)} ${e.family} ${e.statement}`.toLowerCase();
    return wanted.every(word => text.includes(word));
  }));
  $("table-body").replaceChildren(...entries.map(rowOf));
  for (const { id } of COLUMNS) {
    $(`by-${id}`).setAttribute("aria-sort", id !== state.sort ? "none"
      : state.descending ? "descending" : "ascending");
  }
  $("shown").textContent = `${entries.length} of ${report.entries.length} kernels`;
}
