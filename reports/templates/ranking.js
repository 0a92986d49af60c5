// Sorts the ranking by the column whose button is pressed: the best values first, then the other way round. Long rankings
// can be filtered by run, method and number of points.
"use strict";

// A cell's sorting value: a number, a text, or null where the series has none.
function sortingValue(row, key) {
  const cell = row.querySelector(`[data-key="${key}"]`);
  const data = cell.querySelector("data");
  if (data) return Number(data.value);
  const text = cell.textContent.trim();
  return text === "–" || text === "" ? null : text;
}

function compareValues(a, b) {
  if (typeof a === "number" && typeof b === "number") return a - b;
  return String(a).localeCompare(String(b), "en", { numeric: true });
}

// Missing values come last in either direction; equal ones keep their order.
function sortRows(body, key, descending) {
  const rows = Array.from(body.rows, (row) => ({ row, value: sortingValue(row, key) }));
  rows.sort((a, b) => {
    if (a.value === null || b.value === null) return (a.value === null) - (b.value === null);
    return descending ? compareValues(b.value, a.value) : compareValues(a.value, b.value);
  });
  body.append(...rows.map((entry) => entry.row));
}

function sortBy(table, header) {
  const state = header.getAttribute("aria-sort");
  const bestFirst = header.dataset.better === "higher" ? "descending" : "ascending";
  const opposite = bestFirst === "descending" ? "ascending" : "descending";
  const direction = state === bestFirst ? opposite : bestFirst;
  for (const other of table.tHead.rows[0].cells) other.setAttribute("aria-sort", "none");
  header.setAttribute("aria-sort", direction);
  sortRows(table.tBodies[0], header.dataset.key, direction === "descending");
}

const ranking = document.getElementById("ranking");
if (ranking)
  for (const header of ranking.tHead.rows[0].cells)
    header.querySelector("button").addEventListener("click", () => sortBy(ranking, header));

// The different values of an attribute of the rows; numbers of points in their order.
function valuesOf(rows, name) {
  const values = [...new Set(rows.map((row) => row.dataset[name]))];
  return values.sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
}

// A choice of one of them, or all.
function filterFor(rows, name, words, update) {
  const label = document.createElement("label");
  const select = document.createElement("select");
  select.append(new Option("all", ""));
  for (const value of valuesOf(rows, name)) select.append(new Option(value, value));
  select.addEventListener("change", update);
  label.append(`${words} `, select);
  return { label, name, select };
}

const place = document.getElementById("ranking-filters");
if (ranking && place) {
  const rows = Array.from(ranking.tBodies[0].rows);
  const shown = document.createElement("span");
  const update = () => {
    for (const row of rows) row.hidden = filters.some((f) => f.select.value !== "" && row.dataset[f.name] !== f.select.value);
    shown.textContent = `${rows.filter((row) => !row.hidden).length} of ${rows.length} series`;
  };
  const filters = [["run", "Run"], ["method", "Method"], ["points", "Points"]]
    .filter(([name]) => valuesOf(rows, name).length > 1)
    .map(([name, words]) => filterFor(rows, name, words, update));
  place.append(...filters.map((filter) => filter.label), shown);
  place.hidden = filters.length === 0;
  update();
}
