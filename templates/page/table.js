"use strict";
// Tables of the page: a heading sorts its table; the words in the filter choose rows of all.

const value = text => {  // numbers before words; what is missing is last
  const number = Number.parseFloat(text.replace("∞", "Infinity"));
  return text === "" || text === "–" ? [2, 0] : Number.isNaN(number) ? [1, text] : [0, number];
};
const compare = ([a, x], [b, y]) => a - b || (x < y ? -1 : x > y ? 1 : 0);

function sort(heading, column) {
  const body = heading.closest("table").tBodies[0];
  const down = heading.getAttribute("aria-sort") === "ascending";
  for (const other of heading.parentNode.cells) other.setAttribute("aria-sort", "none");
  heading.setAttribute("aria-sort", down ? "descending" : "ascending");
  const rows = [...body.rows].map(row => [value(row.cells[column].textContent), row]);
  rows.sort(([x], [y]) => (down && x[0] === y[0] ? -1 : 1) * compare(x, y));
  body.append(...rows.map(([, row]) => row));
}

for (const heading of document.querySelectorAll(".scroll thead th")) {
  const button = document.createElement("button");
  button.type = "button";
  button.append(...heading.childNodes);
  heading.append(button);
  heading.setAttribute("aria-sort", "none");
  button.addEventListener("click", () => sort(heading, heading.cellIndex));
}

const filter = document.getElementById("filter");
filter?.addEventListener("input", () => {
  const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
  for (const row of document.querySelectorAll(".filtered tbody tr")) {
    const text = row.textContent.toLowerCase();
    row.hidden = !words.every(word => text.includes(word));
  }
  const rows = [...document.querySelectorAll("#kernels details[open] tbody tr")];
  document.getElementById("shown").textContent =
    `${rows.filter(row => !row.hidden).length} of ${rows.length} kernels`;
});
filter?.dispatchEvent(new Event("input"));
