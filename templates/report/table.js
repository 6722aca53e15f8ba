"use strict";
// The report, what is chosen of it, and the table: sorted, filtered, one row per entry.

const $ = id => document.getElementById(id);
const report = JSON.parse($("data").textContent);
const PRECISIONS = ["double", "single"];

// What JSON has no number for stands in strings: "Infinity", "NaN"; nothing measured is null.
const number = v => v === null || v === undefined ? NaN : Number(v);
const timeName = t => [t.language, t.compiler, t.layout].filter(Boolean).join(", ");
const variantName = e => `${e.precision} ${e.tier}`;
const identity = e => `${e.operation} ${variantName(e)}`;
const unit = e => e.measure === "u" ? " u" : "";
const range = (low, high) => `${formatted(number(low))}–${formatted(number(high))}`;

const state = { layout: "", inputs: "hard", precision: "", tier: "", text: "", operation: "",
                sort: "", descending: false };

const timeOf = entry => entry.times.find(t => timeName(t) === state.layout) ?? {};

function element(name, attributes = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

// The table's columns: a value to sort by, its text, and the class of its cells.
const error = (inputs, which) => ({
  value: e => number(e[inputs]?.[which]),
  text: (v, e) => formatted(v) + (isNaN(v) ? "" : unit(e)) });

// |x̂ - x| <= u |x̂| + (c1 u + c2 u²) S with 1 ulp >= u |x|, so that in ulp, as in units of u |x|,
// the error is at most 1 + (c1 + c2 u) S/|x|; without a last rounding the 1 falls away.
const UNIT_ROUNDOFF = { double: 2 ** -53, single: 2 ** -24 };
const boundAt = (entry, condition) => (entry.bound.rounded ? 1 : 0) +
  (number(entry.bound.c1) + number(entry.bound.c2) * UNIT_ROUNDOFF[entry.precision]) * condition;

function boundText({ bound }) {
  if (!bound) return "–";
  const terms = [bound.rounded ? "u |x̂|" : "",
                 bound.c1 ? `${formatted(number(bound.c1))} u S` : "",
                 bound.c2 ? `${formatted(number(bound.c2))} u² S` : ""];
  return terms.filter(Boolean).join(" + ") || "exact";
}

const COLUMNS = [
  { id: "operation", title: "operation", group: "kernel", className: "text",
    value: e => e.operation, text: v => v },
  { id: "precision", title: "precision", group: "variant", className: "text",
    value: e => e.precision, text: v => v },
  { id: "tier", title: "tier", group: "variant", className: "text",
    value: e => report.tiers.indexOf(e.tier), text: (v, e) => e.tier },
  { id: "hard-worst", title: "worst", group: "error, hard inputs", ...error("hard", "worst") },
  { id: "hard-p999", title: "99.9 %", group: "error, hard inputs", ...error("hard", "p999") },
  { id: "hard-median", title: "median", group: "error, hard inputs", ...error("hard", "median") },
  { id: "ns", title: "ns", group: "time", value: e => number(timeOf(e).ns), text: formatted },
  { id: "interval", title: "interval", group: "time",
    value: e => number(timeOf(e).high) - number(timeOf(e).low),
    text: (v, e) => isNaN(v) ? "–" : range(timeOf(e).low, timeOf(e).high) },
  { id: "ratio", title: "to plain", group: "time", value: e => number(timeOf(e).ratio),
    text: (v, e) => isNaN(v) ? "–" :
      `${formatted(v)} × (${range(timeOf(e).ratio_low, timeOf(e).ratio_high)})` },
  { id: "pareto", title: "Pareto", group: "time", className: "text pareto",
    value: e => timeOf(e).dominated ?? NaN,
    text: v => v === true ? "○ dominated" : v === false ? "● undominated" : "–" },
  { id: "flops", title: "flops", group: "size", value: e => e.flops, text: String,
    hint: e => e.counts },
  { id: "bound", title: "bound", group: "proof", className: "text",
    value: e => e.bound ? boundAt(e, 1) : NaN, text: (v, e) => boundText(e),
    hint: e => e.bound?.text },
  { id: "ratio-to-bound", title: "error / bound", group: "proof",
    value: e => number(e.bound?.worst_ratio), text: formatted, warns: v => v > 1 },
  { id: "benign-worst", title: "worst", group: "error, benign inputs",
    ...error("benign", "worst") },
  { id: "benign-p999", title: "99.9 %", group: "error, benign inputs", ...error("benign", "p999") },
  { id: "benign-median", title: "median", group: "error, benign inputs",
    ...error("benign", "median") },
];

const chosenEntries = () => report.entries.filter(e =>
  (!state.precision || e.precision === state.precision) && (!state.tier || e.tier === state.tier));

function sorted(entries) {
  const column = COLUMNS.find(c => c.id === state.sort);
  if (!column) return entries;
  const missing = v => v === "" || Number.isNaN(v);
  const sign = state.descending ? -1 : 1;
  return entries.map(e => [column.value(e), e]).sort(([a], [b]) =>
    missing(a) || missing(b) ? missing(a) - missing(b) : a < b ? -sign : a > b ? sign : 0)
    .map(([, e]) => e);
}

const opensGroup = i => i > 0 && COLUMNS[i - 1].group !== COLUMNS[i].group;

function head() {
  const groups = element("tr"), names = element("tr");
  COLUMNS.forEach((column, i) => {
    const place = `${i ? "" : "first"} ${opensGroup(i) ? "start" : ""}`;
    if (!i || opensGroup(i)) {
      groups.append(element("th", { scope: "colgroup", class: `group ${place}`,
        colspan: COLUMNS.filter(c => c.group === column.group).length }, column.group));
    }
    const button = element("button", { type: "button" }, column.title);
    button.addEventListener("click", () => {
      state.descending = state.sort === column.id && !state.descending;
      state.sort = column.id;
      drawTable();
    });
    names.append(element("th", { scope: "col", id: `by-${column.id}`, "aria-sort": "none",
      class: `${column.className ?? ""} ${place}` }, button));
  });
  $("table-head").append(groups, names);
}

// A kernel's name may break after an underscore; where space is short its variant stands below it.
function rowHead(entry) {
  const parts = entry.operation.split(/(?<=_)/).flatMap(part => [element("wbr"), part]);
  const button = element("button", { type: "button", title: entry.statement }, ...parts);
  button.addEventListener("click", () => choose(entry.operation, true));
  return element("th", { scope: "row", "data-column": "operation" }, button,
                 element("span", { class: "also", "aria-hidden": "true" }, variantName(entry)));
}

function row(entry) {
  const line = element("tr", { "data-variant": identity(entry) }, rowHead(entry));
  COLUMNS.slice(1).forEach((column, i) => {
    const value = column.value(entry);
    line.append(element("td", {
      "data-column": column.id, "data-value": value, title: column.hint?.(entry) ?? "",
      class: `${column.className ?? ""} ${opensGroup(i + 1) ? "start" : ""} ` +
        (column.warns?.(value) ? "over" : "") }, column.text(value, entry)));
  });
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

function drawTable() {
  const words = state.text.toLowerCase().split(/\s+/).filter(Boolean);
  const rows = sorted(chosenEntries().filter(e => {
    const text = `${identity(e)} ${e.family} ${e.statement}`.toLowerCase();
    return words.every(word => text.includes(word));
  }));
  $("table-body").replaceChildren(...rows.map(rowOf));
  for (const column of COLUMNS) {
    $(`by-${column.id}`).setAttribute("aria-sort", column.id !== state.sort ? "none"
      : state.descending ? "descending" : "ascending");
  }
  $("shown").textContent = `${rows.length} of ${report.entries.length} kernels`;
}
