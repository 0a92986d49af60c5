// The compare page: mouse, fingers and keys on its charts.
"use strict";

let drag = null; // {chart, from, pans}: of the mouse, since the button went down
const fingers = new Map(); // on the chart: their numbers and places
let pinched = ""; // the quantity of the chart under two fingers

// The values under two fingers stay there.
function pinch(event) {
  active = charts.find((chart) => chart.quantity === pinched) || active;
  const other = [...fingers].find(([id]) => id !== event.pointerId)[1];
  const [before, now] = [fingers.get(event.pointerId), active.place(event)];
  const apart = (place) => Math.max(8, Math.hypot(place[0] - other[0], place[1] - other[1]));
  const by = (now[0] - before[0]) / 2 / (active.inside.right - active.inside.left);
  fingers.set(event.pointerId, now);
  zoom(apart(now) / apart(before), active.x.inverse((before[0] + other[0]) / 2), by);
}

function onPointer(event) {
  if (!charts.length) return;
  if (fingers.size === 2 && fingers.has(event.pointerId)) return pinch(event);
  active = chartOf(event);
  const [px, py] = active.place(event);
  if (drag && drag.chart === active) {
    if (drag.pans) {
      const by = (drag.from[0] - px) / (active.inside.right - active.inside.left);
      drag.from = [px, py];
      const { chart } = drag;
      pan(by);
      drag.chart = charts.find((other) => other.quantity === chart.quantity);
      return;
    }
    active.showFrame(drag.from, [px, py]);
  }
  const x = Math.min(active.x.high, Math.max(active.x.low, active.x.inverse(px)));
  moveCursor(x, active.nearestCurve(x, py));
}

function onFinger(event) {
  fingers.set(event.pointerId, active.place(event));
  element("chart").setPointerCapture(event.pointerId); // charts are drawn anew
  pinched = active.quantity;
}

function onDown(event) {
  if (fingers.size === 0) onPointer(event);
  if (active && event.pointerType === "touch") return onFinger(event);
  if (!active || event.button !== 0) return;
  drag = { chart: active, from: active.place(event), pans: event.shiftKey };
  element("chart").setPointerCapture(event.pointerId);
  event.preventDefault();
  element("chart").focus({ preventScroll: true });
}

function onUp(event) {
  fingers.delete(event.pointerId);
  if (!drag) return;
  const { chart, from, pans } = drag;
  drag = null;
  if (pans || !charts.includes(chart)) return;
  const part = chart.showFrame(from, chart.place(event));
  chart.showFrame([-9, 0], [-9, 0]);
  if (!part.isWide) return;
  active = chart;
  showRange(part.x, chart.whole);
  if (part.y) ranges[chart.quantity] = shortRange(part.y);
  changed();
}

function onWheel(event) {
  if (!charts.length || !event.ctrlKey) return; // without it pages scroll
  event.preventDefault();
  active = chartOf(event);
  zoom(Math.exp(-event.deltaY / 300), active.x.inverse(active.place(event)[0]));
}

function onKey(event) {
  if (!active || event.ctrlKey || event.altKey || event.metaKey) return;
  const zooms = { "+": 1.5, "=": 1.5, "-": 1 / 1.5, 0: 0 };
  const pans = { "<": -0.25, ">": 0.25 };
  const near = (cursor && active.curves.find((curve) => curve.series === cursor.series)) || active.curves[0];
  const [first, last] = [nearestIndex(near.x, active.x.low), nearestIndex(near.x, active.x.high)];
  const index = cursor ? nearestIndex(near.x, cursor.x) : first - 1;
  const step = event.shiftKey ? 10 : 1;
  const places = { ArrowRight: index + step, ArrowLeft: index - step, Home: first, End: last };
  const turns = { ArrowDown: 1, ArrowUp: active.curves.length - 1 };
  if (event.key in zooms) zoom(zooms[event.key]);
  else if (event.key in pans) pan(pans[event.key]);
  else if (event.key in places) moveCursor(near.x[Math.min(last, Math.max(first, places[event.key]))], near);
  else if (event.key in turns)
    moveCursor(cursor ? cursor.x : near.x[first], active.curves[(active.curves.indexOf(near) + turns[event.key]) % active.curves.length]);
  else if (event.key === "Enter" && charts.length > 1) {
    active = charts[(charts.indexOf(active) + 1) % charts.length];
    moveCursor(cursor ? cursor.x : active.x.low, active.curves.find((curve) => cursor && curve.series === cursor.series) || active.curves[0]);
  } else return;
  event.preventDefault();
}

element("chart").addEventListener("pointermove", onPointer);
element("chart").addEventListener("pointerdown", onDown);
element("chart").addEventListener("pointerup", onUp);
element("chart").addEventListener("pointercancel", (event) => {
  fingers.delete(event.pointerId);
  drag = null;
});
element("chart").addEventListener("dblclick", () => zoom(0));
element("chart").addEventListener("wheel", onWheel, { passive: false });
element("chart").addEventListener("keydown", onKey);
