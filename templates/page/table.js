"use strict";
// Tables of the page: a heading sorts its table; the words in the filter choose rows of all.

const value = text => {  // numbers before words; what is missing is last
  const number = Number.parseFloat(text.replace("∞", "Infinity"));
  return text === "" || text === "–" ? [2, 0] : Number.isNaN(number) ? [1, text] : [0, number];
};
const compare = ([a, x], [b, y]) => a - b || (x < y ? -1 : x > y ? 1 : 0);

function sort(heading) {
  const down = heading.getAttribute("aria-sort") === "ascending";
  for (const other of heading.parentNode.cells) other.setAttribute("aria-sort", "none");
  heading.setAttribute("aria-sort", down ? "descending" : "ascending");
  const body = heading.closest("table").tBodies[0];
  const rows = [...body.rows].map(row => [value(row.cells[heading.cellIndex].textContent), row]);
  rows.sort(([x], [y]) => (down && x[0] === y[0] ? -1 : 1) * compare(x, y));
  body.append(...rows.map(([, row]) => row));
}

for (const heading of document.querySelectorAll("thead th")) {
  heading.innerHTML = `<button type="button">${heading.innerHTML}</button>`;
  heading.firstChild.addEventListener("click", () => sort(heading));
}

const filter = document.getElementById("filter");
filter.addEventListener("input", () => {
  const words = filter.value.toLowerCase().split(/\s+/);
  for (const row of document.querySelectorAll("details tbody tr")) {
    row.hidden = !words.every(word => row.textContent.toLowerCase().includes(word));
  }
  const rows = [...document.querySelectorAll("details[open] tbody tr")];
  document.getElementById("shown").textContent =
    `${rows.filter(row => !row.hidden).length} of ${rows.length} rows`;
});
filter.dispatchEvent(new Event("input"));
