// The compare page: curves of the ticked series laid over each other, with values at a cursor. Charts over the same
// axis move and zoom together; the page's address holds the view.
"use strict";

const report = JSON.parse(document.getElementById("data").textContent);
const element = (id) => document.getElementById(id);
const boxes = Array.from(document.querySelectorAll("input[data-series]"));
const quantities = report.plots; // what can be plotted
const seriesOf = (box) => report.series[Number(box.dataset.series)];
const choices = ["quantity", "axis", "scale", "across", "dimension"].filter(element);

let charts = []; // those that are shown
let active = null; // the one that was pointed at
let cursor = null; // {abscissa, x, series}: a value on the horizontal axis, and the series of the nearest curve
const ranges = {}; // that users have zoomed to: by what the axis says (frequencies, distances), or by quantity

// The factor of a series' abscissae; null where it has no principal frequency.
function unitOf(series, abscissa, axis) {
  if (axis === "absolute") return 1;
  const spacing = Math.pow(series.points, -1 / series.dimension);
  const length = axis === "spacing" ? spacing : series.principal ? 1 / series.principal : null;
  if (length === null) return null;
  return abscissa === "frequencies" ? length : 1 / length;
}

function isOffered(series) {
  return !element("dimension") || series.dimension === Number(element("dimension").value);
}

// The curves of a quantity; each series has its colour and dashes, whatever is plotted.
function tickedCurves(quantity) {
  const { abscissa } = quantities[quantity];
  const ticked = boxes.filter((box) => box.checked).map(seriesOf).filter(isOffered);
  const known = ticked.filter((series) => shownQuantities().some((key) => series[key]));
  const result = [];
  known.forEach((series, slot) => {
    const unit = unitOf(series, abscissa, element("axis").value);
    if (!series[quantity] || unit === null) return;
    const x = report.abscissae[series[abscissa]].map((value) => value * unit);
    result.push({ series, x, y: series[quantity], error: series[`${quantity}_error`] || null, slot });
  });
  return result;
}

function shownQuantities() {
  return element("quantity").value === "all" ? Object.keys(quantities) : [element("quantity").value];
}

function writeLegend() {
  const legend = element("legend");
  legend.replaceChildren();
  const listed = new Map(charts.flatMap((chart) => chart.curves).map((curve) => [curve.series, curve]));
  for (const [series, curve] of [...listed].sort(([, a], [, b]) => a.slot - b.slot)) {
    const item = document.createElement("li");
    const line = draw(item, "svg", { width: 28, height: 10, "aria-hidden": "true" });
    draw(line, "line", { class: "curve", x1: 0, x2: 28, y1: 5, y2: 5, ...lineStyle(curve.slot) });
    const link = document.createElement(series.page ? "a" : "span");
    if (series.page) link.href = series.page;
    link.textContent = nameOf(series);
    item.append(link);
    item.series = series;
    legend.append(item);
  }
}

// With its run where there are several.
function nameOf(series) {
  if (!series.page) return `${series.label} – gallery`;
  return report.severalRuns ? `${series.label} – ${report.runs[series.run]}` : series.label;
}

function settingsOf(quantity) {
  const { abscissa } = quantities[quantity];
  const axis = element("axis").value;
  return { isLogX: element("across").value === "log", isLogY: element("scale").value === "log",
    hasBands: element("bands").checked, isPrincipal: axis === "principal", x: ranges[abscissa] || null,
    y: ranges[quantity] || null, xLabel: report.axes[abscissa][axis] };
}

function update() {
  const parent = element("chart");
  parent.replaceChildren();
  const width = Math.max(360, Math.min(860, parent.clientWidth));
  const shown = shownQuantities();
  const height = Math.max(shown.length > 1 ? 240 : 320, Math.round((shown.length > 1 ? 0.36 : 0.56) * width));
  charts = [];
  for (const quantity of shown) {
    const curves = tickedCurves(quantity);
    if (curves.length > 0) charts.push(new Chart(parent, quantity, curves, settingsOf(quantity), { width, height }));
  }
  active = charts[0] || null;
  cursor = null;
  element("readout").textContent = charts.length ? "" : "No series is ticked that has this curve.";
  writeLegend();
}

const abscissaOf = (chart) => quantities[chart.quantity].abscissa;

function showValues() {
  const shown = (v) => (v === null ? "–" : String(v).replace("-", "−"));
  const readout = element("readout");
  readout.replaceChildren(`${cursor.abscissa === "frequencies" ? "Frequency" : "Distance"} ${Number(cursor.x.toPrecision(5))} `);
  for (const chart of charts.filter((other) => abscissaOf(other) === cursor.abscissa))
    for (const curve of chart.curves) {
      const item = document.createElement("span");
      const title = charts.length > 1 ? `${chart.plot.label}, ` : "";
      item.textContent = `${title}${nameOf(curve.series)}: ${shown(valueAt(curve, cursor.x))}`;
      item.className = curve.series === cursor.series && chart === active ? "near" : "";
      readout.append(item, " ");
    }
}

// Puts the cursor of all charts over the active one's axis at the value of a curve that is nearest to x.
function moveCursor(x, curve) {
  cursor = { abscissa: abscissaOf(active), x: curve.x[nearestIndex(curve.x, x)], series: curve.series };
  for (const chart of charts) if (abscissaOf(chart) === cursor.abscissa) chart.showCursor(cursor.x, cursor.series);
  for (const item of element("legend").children) item.classList.toggle("near", item.series === cursor.series);
  showValues();
}

const chartOf = (event) => charts.find((chart) => chart.svg === event.target.closest("svg")) || active;

// Zooms by a factor about a value of the active chart's horizontal axis, which moves by that part of the width; 0 shows
// everything again.
function zoom(factor, about = null, by = 0) {
  if (!active) return;
  const { x, whole } = active;
  if (factor === 0) for (const key of Object.keys(ranges)) delete ranges[key];
  else {
    const scale = makeScale(active.settings.isLogX, x.low, x.high, 0, 1);
    const middle = scale.at(about === null ? (cursor ? cursor.x : scale.value(0.5)) : about);
    showRange([middle - (middle + by) / factor, middle + (1 - middle - by) / factor].map(scale.value), whole);
  }
  changed();
}

// Pans by parts of the width that is shown.
function pan(part) {
  if (!active) return;
  const { x, whole } = active;
  const ends = makeScale(active.settings.isLogX, ...whole, 0, 1);
  const [low, high] = [ends.at(x.low), ends.at(x.high)];
  const by = Math.max(-low, Math.min(1 - high, part * (high - low)));
  showRange([ends.value(low + by), ends.value(high + by)], whole);
  changed();
}

// Ranges have as many digits as the page's address holds: a link gives the same picture.
const shortRange = (range) => range.map((v) => Number(v.toPrecision(6)));

// Shows a horizontal range, within all that there is, in all charts over the same axis.
function showRange([low, high], whole) {
  const inside = shortRange([Math.max(whole[0], low), Math.min(whole[1], high)]);
  const isWhole = inside[0] <= whole[0] && inside[1] >= whole[1] * (1 - 1e-9);
  if (isWhole) delete ranges[abscissaOf(active)];
  else if (inside[1] - inside[0] > 1e-6 * whole[1]) ranges[abscissaOf(active)] = inside;
}

// Boxes of series that the filter and the dimension leave.
function applyFilter() {
  const sought = element("filter").value.trim().toLowerCase();
  for (const box of boxes) {
    const series = seriesOf(box);
    const text = `${series.label} ${report.runs[series.run]}`.toLowerCase();
    box.parentElement.hidden = !isOffered(series) || !text.includes(sought);
  }
  for (const group of document.querySelectorAll("fieldset[data-run]"))
    group.hidden = Array.from(group.querySelectorAll("label")).every((label) => label.hidden);
}

// Ticks or clears what the filter leaves.
function setAll(checked) {
  for (const box of boxes) if (!box.parentElement.hidden) box.checked = checked;
  changed();
}

// compare.html#run-3 shows the series of that run.
function showRun(run) {
  const own = boxes.filter((box) => seriesOf(box).run === run);
  const step = (i) => Math.floor((i * report.mostAtFirst) / own.length);
  for (const box of boxes) box.checked = false;
  own.forEach((box, i) => (box.checked = own.length <= report.mostAtFirst || step(i + 1) > step(i)));
  if (own.length && element("dimension")) element("dimension").value = String(seriesOf(own[0]).dimension);
}

// The numbers of the ticked series, "0-3,7".
function tickedText() {
  const numbers = boxes.filter((box) => box.checked).map((box) => Number(box.dataset.series)).sort((a, b) => a - b);
  const starts = numbers.filter((n) => !numbers.includes(n - 1));
  const endOf = (n) => (numbers.includes(n + 1) ? endOf(n + 1) : n);
  return starts.map((n) => (endOf(n) > n ? `${n}-${endOf(n)}` : `${n}`)).join(",");
}

// The view as the page's address has it, and back.
function address() {
  const words = choices.map((id) => `${id}=${element(id).value}`);
  if (element("bands").checked) words.push("bands=on");
  for (const [key, range] of Object.entries(ranges)) words.push(`${key}=${range.join("~")}`);
  return `#${words.join("&")}&series=${tickedText()}`;
}

function readAddress() {
  const run = /^#run-(\d+)$/.exec(location.hash);
  if (run) showRun(Number(run[1]));
  const given = new URLSearchParams(location.hash.slice(1));
  if (!given.has("series")) return;
  for (const id of choices)
    if (Array.from(element(id).options).some((option) => option.value === given.get(id))) element(id).value = given.get(id);
  element("bands").checked = given.get("bands") === "on";
  for (const key of ["frequencies", "distances", ...Object.keys(quantities)]) {
    const range = (given.get(key) || "").split("~").map(Number);
    if (range.length === 2 && range[0] < range[1]) ranges[key] = range;
    else delete ranges[key];
  }
  const ticked = given.get("series").split(",").map((part) => part.split("-").map(Number));
  for (const box of boxes) {
    const number = Number(box.dataset.series);
    box.checked = ticked.some(([first, last = first]) => number >= first && number <= last);
  }
}

// After whatever users have changed.
function changed() {
  const near = cursor;
  update();
  history.replaceState(null, "", address());
  const chart = near && charts.find((other) => abscissaOf(other) === near.abscissa);
  const curve = chart && chart.curves.find((other) => other.series === near.series);
  if (!curve || near.x < chart.x.low || near.x > chart.x.high) return;
  active = chart;
  moveCursor(near.x, curve);
}

// The values that are shown, a line each; names are quoted.
function shownCsv() {
  const quoted = (text) => `"${text.replaceAll('"', '""')}"`;
  const lines = ["plot,series,run,x,y,standard_error"];
  for (const { quantity, curves, x } of charts)
    for (const curve of curves)
      curve.x.forEach((value, i) => {
        if (value < x.low || value > x.high * (1 + 1e-9) || curve.y[i] === null) return;
        const error = curve.error ? curve.error[i] : "";
        lines.push([quantity, quoted(curve.series.label), quoted(report.runs[curve.series.run]), Number(value.toPrecision(6)), curve.y[i], error].join(","));
      });
  return `${lines.join("\n")}\n`;
}

function saveCsv() {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([shownCsv()], { type: "text/csv" }));
  link.download = "curves.csv";
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

function copyLink() {
  history.replaceState(null, "", address());
  if (navigator.clipboard) navigator.clipboard.writeText(location.href).catch(() => {});
  element("copied").textContent = "The page's address is a link to this view.";
}

// Other units, other ranges.
function forgetRanges(id) {
  const isOfX = id === "axis" || id === "across";
  for (const key of Object.keys(ranges)) if (id === "dimension" || isOfX === ["frequencies", "distances"].includes(key)) delete ranges[key];
}

element("compare").hidden = false;
for (const id of choices)
  element(id).addEventListener("change", () => {
    if (id !== "quantity") forgetRanges(id);
    applyFilter();
    changed();
  });
element("bands").addEventListener("change", changed);
for (const box of boxes) box.addEventListener("change", changed);
element("filter").addEventListener("input", applyFilter);
element("all").addEventListener("click", () => setAll(true));
element("none").addEventListener("click", () => setAll(false));
for (const [id, action] of Object.entries({ nearer: () => zoom(1.5), farther: () => zoom(1 / 1.5), whole: () => zoom(0), left: () => pan(-0.25), right: () => pan(0.25), csv: saveCsv, copy: copyLink }))
  element(id).addEventListener("click", action);
window.addEventListener("resize", update);
window.addEventListener("hashchange", () => (readAddress(), applyFilter(), update()));
readAddress();
applyFilter();
update();
