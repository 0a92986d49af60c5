// Mouse, fingers and keys on the canvas of a page without end, and files that it saves. The
// page's script has state.zoom, move(), zoomBy(), paint(), goHome() and redraw().
"use strict";

/** The place of an event on the canvas, in pixels from its middle, y upwards. */
const fromMiddle = (event) => {
  const box = canvas.getBoundingClientRect();
  return [event.clientX - box.left - box.width / 2, box.height / 2 - (event.clientY - box.top)];
};

/** Paints from one place to another, which a fast hand leaves far apart. */
function paintAlong(from, to) {
  const steps = Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / (0.25 * Number(byId("brush-size").value)));
  for (let step = 1; step <= steps; ++step) paint(...from.map((v, k) => v + ((to[k] - v) * step) / steps));
}

const fingers = new Map();
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, fromMiddle(event));
  if (byId("painting").checked && fingers.size === 1) paint(...fromMiddle(event));
});
canvas.addEventListener("pointermove", (event) => {
  if (!fingers.has(event.pointerId)) return;
  const [before, now] = [fingers.get(event.pointerId), fromMiddle(event)];
  fingers.set(event.pointerId, now);
  if (fingers.size === 2) {
    const other = [...fingers].find(([id]) => id !== event.pointerId)[1];
    const apart = (p) => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
    zoomBy(apart(now) / apart(before), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
  } else if (byId("painting").checked) {
    paintAlong(before, now);
  } else {
    move((before[0] - now[0]) / state.zoom, (before[1] - now[1]) / state.zoom);
  }
  redraw();
});
for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => fingers.delete(event.pointerId));
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  zoomBy(Math.exp(-event.deltaY / 500), ...fromMiddle(event));
  redraw();
}, { passive: false });
canvas.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const step = (event.shiftKey ? 400 : 40) / state.zoom;
  const moves = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] };
  if (moves[event.key]) move(...moves[event.key]);
  else if (event.key === "+" || event.key === "=") zoomBy(1.25);
  else if (event.key === "-") zoomBy(0.8);
  else if (event.key === "Home") goHome();
  else if (event.key === " " && byId("painting").checked) paint(0, 0);
  else return;
  event.preventDefault();
  redraw();
});

/** Saves a file from the page. */
function save(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
