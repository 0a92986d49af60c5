// The compare page: one chart of curves as SVG, and its scales.
"use strict";

const svgNamespace = "http://www.w3.org/2000/svg";

function draw(parent, name, attributes, text) {
  const node = document.createElementNS(svgNamespace, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text !== undefined) node.textContent = text;
  parent.append(node);
  return node;
}

// Steps of 1, 2 or 5 times a power of ten.
function tickStep(range, count) {
  const raw = range / count;
  const magnitude = Math.pow(10, Math.floor(Math.log10(raw)));
  return magnitude * (raw / magnitude > 5 ? 10 : raw / magnitude > 2 ? 5 : raw / magnitude > 1 ? 2 : 1);
}

function linearTicks(low, high) {
  const step = tickStep(high - low, 8);
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high * (1 + 1e-9); ++i) ticks.push(Number((i * step).toPrecision(12)));
  return ticks;
}

// Powers of ten; of a few of them also 2 and 5 times these, and of less than one what a linear axis has.
function logTicks(low, high) {
  const decades = Math.log10(high / low);
  if (decades < 1) return linearTicks(low, high);
  const ticks = [];
  for (let e = Math.floor(Math.log10(low)); e <= Math.log10(high) + 1e-9; ++e)
    for (const factor of decades < 2.5 ? [1, 2, 5] : [1]) ticks.push(Number(`${factor}e${e}`));
  return ticks.filter((tick) => tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9));
}

// Values from low to high as places from..to. What is below the end of a logarithmic scale lies at its end.
function makeScale(isLog, low, high, from, to) {
  const share = isLog ? (v) => Math.log(Math.max(v, low) / low) / Math.log(high / low) : (v) => (v - low) / (high - low);
  const value = isLog ? (s) => low * Math.pow(high / low, s) : (s) => low + s * (high - low);
  return { low, high, ticks: (isLog ? logTicks : linearTicks)(low, high),
    at: (v) => from + share(v) * (to - from), inverse: (place) => value((place - from) / (to - from)), value };
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

// The value of a curve at an abscissa that it has, or that is less than a step from one.
function valueAt(curve, x) {
  const step = curve.x.length > 1 ? curve.x[1] - curve.x[0] : Infinity;
  const index = nearestIndex(curve.x, x);
  return Math.abs(curve.x[index] - x) > step ? null : curve.y[index];
}

// One chart. A curve is { series, x, y, error, slot }: `error` is a list or null, `slot` decides colour and dashes.
class Chart {
  // `settings`: { isLogX, isLogY, hasBands, x, y, xLabel, label }, with the ranges that are shown, [low, high] or null;
  // null: all of x, and what suits the values that are seen.
  constructor(parent, quantity, curves, settings, size) {
    Object.assign(this, { quantity, plot: report.plots[quantity], curves, settings, size });
    this.inside = { left: 64, right: size.width - 16, top: 14, bottom: size.height - 52 };
    this.whole = this.wholeRange();
    const { left, right, top, bottom } = this.inside;
    this.x = makeScale(settings.isLogX, ...(settings.x || this.whole), left, right);
    this.y = this.verticalScale(bottom, top);
    this.svg = draw(parent, "svg", { viewBox: `0 0 ${size.width} ${size.height}`, "data-plot": quantity });
    this.drawAxes();
    this.drawCurves();
    this.cursor = draw(this.svg, "line", { class: "cursor", y1: top, y2: bottom, x1: -9, x2: -9 });
    this.dot = draw(this.svg, "circle", { class: "dot", r: 4, cx: -9, cy: -9 });
    this.frame = draw(this.svg, "rect", { class: "zoom", width: 0, height: 0 });
  }

  // Everything: from 0, or from the first value that has a logarithm, to the end of the longest curve.
  wholeRange() {
    let high = this.curves.reduce((a, { x }) => Math.max(a, x[x.length - 1]), 0);
    if (this.settings.isPrincipal) high = Math.min(high, report.principalUnits);
    if (!this.settings.isLogX) return [0, high];
    return [this.curves.reduce((a, { x }) => Math.min(a, x.find((v) => v > 0)), high / 10), high];
  }

  // The values that the horizontal range leaves.
  seenValues() {
    return this.curves.flatMap(({ x, y }) => y.filter((v, i) => v !== null && x[i] >= this.x.low && x[i] <= this.x.high * (1 + 1e-9)));
  }

  verticalScale(from, to) {
    const { isLogY, y, x } = this.settings;
    const { most, floor } = this.plot;
    const isLog = isLogY && this.quantity !== "anisotropy"; // decibels are logarithms
    if (y) return makeScale(isLog, ...y, from, to);
    const values = this.seenValues();
    const highest = values.reduce((a, b) => Math.max(a, b), -Infinity);
    const lowest = values.reduce((a, b) => Math.min(a, b), Infinity);
    if (!Number.isFinite(highest)) return makeScale(false, 0, 1, from, to);
    if (this.quantity === "anisotropy")
      return makeScale(false, 5 * Math.floor(lowest / 5), Math.min(most, 5 * Math.ceil((highest + 1) / 5)), from, to);
    const least = x ? 0 : 1.5;
    if (!isLog) return makeScale(false, 0, Math.min(most, Math.max(least, 1.1 * highest) || 1), from, to);
    const positive = values.filter((v) => v > 0).reduce((a, b) => Math.min(a, b), Infinity);
    const power = (round, v) => Math.pow(10, round(Math.log10(v)));
    return makeScale(true, power(Math.floor, Math.max(floor, Math.min(positive, 0.1))), power(Math.ceil, Math.max(highest, 1.5)), from, to);
  }

  drawAxes() {
    const { svg, x, y } = this;
    const { left, right, top, bottom } = this.inside;
    for (const tick of x.ticks) draw(svg, "text", { x: x.at(tick), y: bottom + 18, "text-anchor": "middle" }, String(tick));
    for (const tick of y.ticks) {
      draw(svg, "line", { class: "grid", x1: left, x2: right, y1: y.at(tick), y2: y.at(tick) });
      draw(svg, "text", { x: left - 8, y: y.at(tick) + 4, "text-anchor": "end" }, String(tick).replace("-", "−"));
    }
    const { reference, label } = this.plot;
    if (reference !== null && reference >= y.low && reference <= y.high)
      draw(svg, "line", { class: "reference", x1: left, x2: right, y1: y.at(reference), y2: y.at(reference) });
    draw(svg, "path", { class: "frame", d: `M${left} ${top}V${bottom}H${right}` });
    draw(svg, "text", { class: "title", x: (left + right) / 2, y: this.size.height - 12, "text-anchor": "middle" }, this.settings.xLabel);
    const middle = (top + bottom) / 2;
    draw(svg, "text", { class: "title", x: 16, y: middle, "text-anchor": "middle", transform: `rotate(-90 16 ${middle})` }, label);
  }

  // Runs of values without a gap, as places: of one list, or forth along one and back along the other.
  runs(curve, one, other) {
    const texts = [];
    let places = [];
    const end = () => {
      const back = other ? places.map(([x, , below]) => `${x} ${below}`).reverse() : [];
      if (places.length > 0) texts.push(`M${places.map(([x, above]) => `${x} ${above}`).concat(back).join("L")}${other ? "Z" : ""}`);
      places = [];
    };
    for (let i = 0; i < curve.x.length; ++i) {
      if (curve.x[i] > this.x.high && curve.x[i - 1] > this.x.high * (1 + 1e-9)) break; // one beyond, for the clipped line
      if (curve.y[i] === null) end();
      else if (curve.x[i] > 0 && !(curve.x[i + 1] < this.x.low))
        places.push([this.x.at(curve.x[i]).toFixed(1), this.y.at(one(i)).toFixed(1), other && this.y.at(other(i)).toFixed(1)]);
    }
    end();
    return texts.join("");
  }

  drawCurves() {
    const { left, right, top, bottom } = this.inside;
    const clip = draw(draw(this.svg, "defs", {}), "clipPath", { id: `inside-${this.quantity}` });
    draw(clip, "rect", { x: left, y: top, width: right - left, height: bottom - top });
    const group = draw(this.svg, "g", { "clip-path": `url(#inside-${this.quantity})` });
    if (this.settings.hasBands)
      for (const curve of this.curves)
        if (curve.error)
          draw(group, "path", { class: "band", style: `fill: var(--curve-${curve.slot % report.colors})`,
            d: this.runs(curve, (i) => curve.y[i] + curve.error[i], (i) => curve.y[i] - curve.error[i]) });
    for (const curve of this.curves)
      curve.node = draw(group, "path", { class: "curve", d: this.runs(curve, (i) => curve.y[i]), ...lineStyle(curve.slot) });
  }

  // The place of an event in the picture.
  place(event) {
    const frame = this.svg.getBoundingClientRect();
    return [((event.clientX - frame.left) / frame.width) * this.size.width, ((event.clientY - frame.top) / frame.height) * this.size.height];
  }

  // The curve that is nearest to a place, of those that have a value there.
  nearestCurve(x, y) {
    let best = this.curves[0];
    let distance = Infinity;
    for (const curve of this.curves) {
      const value = valueAt(curve, x);
      const gap = value === null ? Infinity : Math.abs(this.y.at(value) - y);
      if (gap < distance) [best, distance] = [curve, gap];
    }
    return best;
  }

  showCursor(x, series) {
    const place = this.x.at(x);
    for (const end of ["x1", "x2"]) this.cursor.setAttribute(end, place);
    for (const curve of this.curves) curve.node.classList.toggle("near", curve.series === series);
    const curve = this.curves.find((other) => other.series === series);
    const value = curve ? valueAt(curve, x) : null;
    this.dot.setAttribute("cx", value === null ? -9 : place);
    this.dot.setAttribute("cy", value === null ? -9 : Math.min(this.inside.bottom, Math.max(this.inside.top, this.y.at(value))));
  }

  // The frame around a part that will be zoomed to: of all heights where it is low.
  showFrame(from, to) {
    const { left, right, top, bottom } = this.inside;
    const clamp = (v, low, high) => Math.min(high, Math.max(low, v));
    const [x0, x1] = [from[0], to[0]].map((x) => clamp(x, left, right)).sort((a, b) => a - b);
    const isLow = Math.abs(to[1] - from[1]) < 24;
    const [y0, y1] = isLow ? [top, bottom] : [from[1], to[1]].map((y) => clamp(y, top, bottom)).sort((a, b) => a - b);
    for (const [key, value] of Object.entries({ x: x0, y: y0, width: x1 - x0, height: y1 - y0 })) this.frame.setAttribute(key, value);
    return { x: [this.x.inverse(x0), this.x.inverse(x1)], y: isLow ? null : [this.y.inverse(y1), this.y.inverse(y0)], isWide: x1 - x0 > 8 };
  }
}

function lineStyle(slot) {
  return { style: `stroke: var(--curve-${slot % report.colors})`, "stroke-dasharray": report.dashes[Math.floor(slot / report.colors) % report.dashes.length] };
}
