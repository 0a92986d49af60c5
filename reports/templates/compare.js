// The compare page: curves of the ticked series in one SVG chart, with values at a cursor.
"use strict";

const report = JSON.parse(document.getElementById("data").textContent);
const element = (id) => document.getElementById(id);
const boxes = Array.from(document.querySelectorAll("input[data-series]"));
const svgNamespace = "http://www.w3.org/2000/svg";
const view = { width: 860, height: 480, left: 64, right: 16, top: 14, bottom: 52 };
const quantities = report.plots; // what can be plotted

let curves = []; // of the ticked series, in order
let scales = null; // of the chart that is shown
let cursor = null; // {x, near}: a value on the horizontal axis, and the number of the nearest curve

// What a series' abscissae are multiplied by; null where it has no principal frequency.
function unitOf(series, abscissa, axis) {
  if (axis === "absolute") return 1;
  const spacing = Math.pow(series.points, -1 / series.dimension);
  const length = axis === "spacing" ? spacing : series.principal ? 1 / series.principal : null;
  if (length === null) return null;
  return abscissa === "frequencies" ? length : 1 / length;
}

function shownDimension() {
  return element("dimension") ? Number(element("dimension").value) : null;
}

function isOffered(series) {
  return shownDimension() === null || series.dimension === shownDimension();
}

function tickedCurves() {
  const quantity = element("quantity").value;
  const { abscissa } = quantities[quantity];
  const result = [];
  for (const box of boxes) {
    const series = report.series[Number(box.dataset.series)];
    if (!box.checked || !isOffered(series) || !series[quantity]) continue;
    const unit = unitOf(series, abscissa, element("axis").value);
    if (unit === null) continue;
    const x = report.abscissae[series[abscissa]].map((value) => value * unit);
    result.push({ series, x, y: series[quantity], slot: result.length });
  }
  return result;
}

// Steps of 1, 2 or 5 times a power of ten.
function tickStep(range, count) {
  const raw = range / count;
  const magnitude = Math.pow(10, Math.floor(Math.log10(raw)));
  return magnitude * (raw / magnitude > 5 ? 10 : raw / magnitude > 2 ? 5 : raw / magnitude > 1 ? 2 : 1);
}

function linearScale(low, high, from, to) {
  const step = tickStep(high - low, 8);
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high * (1 + 1e-9); ++i) ticks.push(Number((i * step).toPrecision(12)));
  return { low, high, ticks, at: (v) => from + ((v - low) / (high - low)) * (to - from),
    inverse: (p) => low + ((p - from) / (to - from)) * (high - low) };
}

function logScale(low, high, from, to) {
  const ticks = [];
  for (let e = Math.ceil(Math.log10(low) - 1e-9); e <= Math.log10(high) + 1e-9; ++e) ticks.push(Number(`1e${e}`));
  const share = (v) => Math.log(Math.max(v, low) / low) / Math.log(high / low);
  return { low, high, ticks, at: (v) => from + share(v) * (to - from) };
}

function verticalScale(quantity) {
  const values = curves.flatMap((curve) => curve.y.filter((v) => v !== null));
  const highest = values.reduce((a, b) => Math.max(a, b), -Infinity);
  const lowest = values.reduce((a, b) => Math.min(a, b), Infinity);
  const { most, floor } = quantities[quantity];
  const from = view.height - view.bottom;
  if (quantity === "anisotropy")
    return linearScale(5 * Math.floor(lowest / 5), Math.min(most, 5 * Math.ceil((highest + 1) / 5)), from, view.top);
  if (element("scale").value === "linear") return linearScale(0, Math.min(most, Math.max(1.5, 1.1 * highest)), from, view.top);
  const positive = values.filter((v) => v > 0).reduce((a, b) => Math.min(a, b), Infinity);
  return logScale(Math.pow(10, Math.floor(Math.log10(Math.max(floor, Math.min(positive, 0.1))))),
    Math.pow(10, Math.ceil(Math.log10(Math.max(highest, 1.5)))), from, view.top);
}

function makeScales() {
  const highest = curves.reduce((a, curve) => Math.max(a, curve.x[curve.x.length - 1]), 0);
  const end = element("axis").value === "principal" ? Math.min(highest, report.principalUnits) : highest;
  return { x: linearScale(0, end, view.left, view.width - view.right), y: verticalScale(element("quantity").value) };
}

function draw(parent, name, attributes, text) {
  const node = document.createElementNS(svgNamespace, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text !== undefined) node.textContent = text;
  parent.append(node);
  return node;
}

function drawAxes(svg) {
  const bottom = view.height - view.bottom;
  const right = view.width - view.right;
  const quantity = quantities[element("quantity").value];
  for (const tick of scales.x.ticks)
    draw(svg, "text", { x: scales.x.at(tick), y: bottom + 18, "text-anchor": "middle" }, String(tick));
  for (const tick of scales.y.ticks) {
    draw(svg, "line", { class: "grid", x1: view.left, x2: right, y1: scales.y.at(tick), y2: scales.y.at(tick) });
    draw(svg, "text", { x: view.left - 8, y: scales.y.at(tick) + 4, "text-anchor": "end" }, String(tick).replace("-", "−"));
  }
  if (quantity.reference)
    draw(svg, "line", { class: "reference", x1: view.left, x2: right, y1: scales.y.at(quantity.reference), y2: scales.y.at(quantity.reference) });
  draw(svg, "path", { class: "frame", d: `M${view.left} ${view.top}V${bottom}H${right}` });
  draw(svg, "text", { class: "title", x: (view.left + right) / 2, y: view.height - 12, "text-anchor": "middle" },
    report.axes[quantity.abscissa][element("axis").value]);
  const middle = (view.top + bottom) / 2;
  draw(svg, "text", { class: "title", x: 16, y: middle, "text-anchor": "middle", transform: `rotate(-90 16 ${middle})` }, quantity.label);
}

function pathOf(curve) {
  let path = "";
  let pen = "M";
  for (let i = 0; i < curve.x.length && curve.x[i] <= scales.x.high * (1 + 1e-9); ++i) {
    const value = curve.y[i];
    if (value === null) {
      pen = "M";
      continue;
    }
    path += `${pen}${scales.x.at(curve.x[i]).toFixed(1)} ${scales.y.at(value).toFixed(1)}`;
    pen = "L";
  }
  return path;
}

function lineStyle(slot) {
  return { style: `stroke: var(--curve-${slot % report.colors})`, "stroke-dasharray": report.dashes[Math.floor(slot / report.colors) % report.dashes.length] };
}

function drawCurves(svg) {
  const clip = draw(draw(svg, "defs", {}), "clipPath", { id: "inside" });
  draw(clip, "rect", { x: view.left, y: view.top, width: view.width - view.left - view.right, height: view.height - view.top - view.bottom });
  const group = draw(svg, "g", { "clip-path": "url(#inside)" });
  for (const curve of curves)
    curve.node = draw(group, "path", { class: "curve", d: pathOf(curve), ...lineStyle(curve.slot) });
}

function writeLegend() {
  const legend = element("legend");
  legend.replaceChildren();
  for (const curve of curves) {
    const item = document.createElement("li");
    const line = draw(item, "svg", { width: 28, height: 10, "aria-hidden": "true" });
    draw(line, "line", { class: "curve", x1: 0, x2: 28, y1: 5, y2: 5, ...lineStyle(curve.slot) });
    const link = document.createElement("a");
    link.href = curve.series.page;
    link.textContent = nameOf(curve);
    item.append(link);
    legend.append(item);
    curve.entry = item;
  }
}

// With its run where there are several.
function nameOf(curve) {
  return report.runs.length > 1 ? `${curve.series.label} – ${report.runs[curve.series.run]}` : curve.series.label;
}

function update() {
  curves = tickedCurves();
  cursor = null;
  element("readout").textContent = curves.length ? "" : "No series is ticked that has this curve.";
  const chart = element("chart");
  chart.replaceChildren();
  writeLegend();
  if (!curves.length) return;
  view.width = Math.max(360, Math.min(860, chart.clientWidth));
  view.height = Math.max(320, Math.round(0.56 * view.width));
  scales = makeScales();
  const svg = draw(chart, "svg", { viewBox: `0 0 ${view.width} ${view.height}` });
  drawAxes(svg);
  drawCurves(svg);
  draw(svg, "line", { id: "cursor", y1: view.top, y2: view.height - view.bottom, x1: -9, x2: -9 });
  draw(svg, "circle", { id: "dot", r: 4, cx: -9, cy: -9 });
}

// The place in a sorted list whose value is nearest.
function nearestIndex(values, value) {
  let low = 0;
  let high = values.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= value) low = middle;
    else high = middle;
  }
  return value - values[low] <= values[high] - value ? low : high;
}

function valueAt(curve, x) {
  const step = curve.x.length > 1 ? curve.x[1] - curve.x[0] : Infinity;
  const index = nearestIndex(curve.x, x);
  return Math.abs(curve.x[index] - x) > step ? null : curve.y[index];
}

function showValues() {
  const { x, near } = cursor;
  const name = quantities[element("quantity").value].abscissa === "frequencies" ? "Frequency" : "Distance";
  const shown = (v) => (v === null ? "–" : String(v).replace("-", "−"));
  const parts = curves.map((curve) => `${nameOf(curve)}: ${shown(valueAt(curve, x))}`);
  const readout = element("readout");
  readout.replaceChildren(`${name} ${Number(x.toPrecision(5))} `);
  parts.forEach((text, i) => {
    const item = document.createElement("span");
    item.textContent = text;
    item.className = i === near ? "near" : "";
    readout.append(item, " ");
  });
}

function moveCursor(x, near) {
  const curve = curves[near];
  const index = nearestIndex(curve.x, x);
  cursor = { x: curve.x[index], near };
  curves.forEach((other, i) => {
    other.node.classList.toggle("near", i === near);
    other.entry.classList.toggle("near", i === near);
  });
  const px = scales.x.at(cursor.x);
  const line = element("cursor");
  line.setAttribute("x1", px);
  line.setAttribute("x2", px);
  const value = curve.y[index];
  element("dot").setAttribute("cx", value === null ? -9 : px);
  element("dot").setAttribute("cy", value === null ? -9 : Math.max(view.top, scales.y.at(value)));
  showValues();
}

// The curve that is nearest to a place of the chart, of those that have a value there.
function nearestCurve(x, y) {
  let best = 0;
  let distance = Infinity;
  curves.forEach((curve, i) => {
    const value = valueAt(curve, x);
    const gap = value === null ? Infinity : Math.abs(scales.y.at(value) - y);
    if (gap < distance) [best, distance] = [i, gap];
  });
  return best;
}

function onPointer(event) {
  if (!curves.length) return;
  const frame = element("chart").querySelector("svg").getBoundingClientRect();
  const px = ((event.clientX - frame.left) / frame.width) * view.width;
  const py = ((event.clientY - frame.top) / frame.height) * view.height;
  const x = Math.min(scales.x.high, Math.max(scales.x.low, scales.x.inverse(px)));
  moveCursor(x, nearestCurve(x, py));
}

function onKey(event) {
  if (!curves.length) return;
  const near = cursor ? cursor.near : 0;
  const xs = curves[near].x;
  const last = nearestIndex(xs, scales.x.high);
  const index = cursor ? nearestIndex(xs, cursor.x) : -1;
  const step = event.shiftKey ? 10 : 1;
  const places = { ArrowRight: index + step, ArrowLeft: index - step, Home: 0, End: last };
  const turns = { ArrowDown: 1, ArrowUp: curves.length - 1 };
  if (event.key in places) moveCursor(xs[Math.min(last, Math.max(0, places[event.key]))], near);
  else if (event.key in turns) moveCursor(cursor ? cursor.x : xs[0], (near + turns[event.key]) % curves.length);
  else return;
  event.preventDefault();
}

// Boxes of series that the filter and the dimension leave.
function applyFilter() {
  const sought = element("filter").value.trim().toLowerCase();
  for (const box of boxes) {
    const series = report.series[Number(box.dataset.series)];
    const text = `${series.label} ${report.runs[series.run]}`.toLowerCase();
    box.parentElement.hidden = !isOffered(series) || !text.includes(sought);
  }
  for (const group of document.querySelectorAll("fieldset[data-run]"))
    group.hidden = Array.from(group.querySelectorAll("label")).every((label) => label.hidden);
}

// Ticks or clears what the filter leaves.
function setAll(checked) {
  for (const box of boxes) if (!box.parentElement.hidden) box.checked = checked;
  update();
}

// compare.html#run-3 shows the series of that run.
function startWithRun() {
  const match = /^#run-(\d+)$/.exec(location.hash);
  if (!match) return;
  const seriesOf = (box) => report.series[Number(box.dataset.series)];
  const own = boxes.filter((box) => seriesOf(box).run === Number(match[1]));
  const step = (i) => Math.floor((i * report.mostAtFirst) / own.length);
  for (const box of boxes) box.checked = false;
  own.forEach((box, i) => (box.checked = own.length <= report.mostAtFirst || step(i + 1) > step(i)));
  if (own.length && element("dimension")) element("dimension").value = String(seriesOf(own[0]).dimension);
}

element("compare").hidden = false;
for (const id of ["quantity", "axis", "scale"]) element(id).addEventListener("change", update);
if (element("dimension")) element("dimension").addEventListener("change", () => (applyFilter(), update()));
for (const box of boxes) box.addEventListener("change", update);
element("filter").addEventListener("input", applyFilter);
element("all").addEventListener("click", () => setAll(true));
element("none").addEventListener("click", () => setAll(false));
element("chart").addEventListener("pointermove", onPointer);
element("chart").addEventListener("pointerdown", onPointer);
element("chart").addEventListener("keydown", onKey);
window.addEventListener("resize", update);
startWithRun();
applyFilter();
update();
