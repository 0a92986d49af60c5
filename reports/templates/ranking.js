// Sorts the ranking by the column whose button is pressed: the best values first, then the other way round.
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
