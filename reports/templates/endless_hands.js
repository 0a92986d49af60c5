// The page of an endless tiling: mouse, fingers, keys and buttons.
"use strict";

/** Zooms about a place of the canvas, in pixels from its middle. */
function zoomBy(factor, x = 0, y = 0) {
  const zoom = Math.max(zooms[0], Math.min(zooms[1], state.zoom * factor));
  move(x / state.zoom - x / zoom, -(y / state.zoom - y / zoom));
  state.zoom = zoom;
  redraw();
}

/** Paints around a place of the canvas, in pixels from its middle. */
function paint(x, y) {
  const at = [state.at[0] + x / state.zoom, state.at[1] - y / state.zoom];
  const tile = at.map((v, a) => state.tile[a] + Math.floor(v));
  const radius = Math.min(16, Number(byId("brush-size").value) / state.zoom);
  painted.paint(tile, at.map((v) => v - Math.floor(v)), radius, Number(byId("brush").value));
  redraw();
}

const fromMiddle = (event) => {
  const box = canvas.getBoundingClientRect();
  return [event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2];
};

const fingers = new Map();
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, fromMiddle(event));
  if (isShown("painting")) paint(...fromMiddle(event));
});
canvas.addEventListener("pointermove", (event) => {
  if (!fingers.has(event.pointerId)) return;
  const [before, now] = [fingers.get(event.pointerId), fromMiddle(event)];
  fingers.set(event.pointerId, now);
  if (fingers.size === 2) {
    const other = [...fingers].find(([id]) => id !== event.pointerId)[1];
    const apart = (p) => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
    return zoomBy(apart(now) / apart(before), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
  }
  if (isShown("painting")) return paint(...now);
  move((before[0] - now[0]) / state.zoom, (now[1] - before[1]) / state.zoom);
  redraw();
});
for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => fingers.delete(event.pointerId));
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  zoomBy(Math.exp(-event.deltaY / 500), ...fromMiddle(event));
}, { passive: false });
canvas.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const step = (event.shiftKey ? 400 : 40) / state.zoom;
  const moves = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] };
  if (moves[event.key]) move(...moves[event.key]);
  else if (event.key === "+" || event.key === "=") zoomBy(1.25);
  else if (event.key === "-") zoomBy(0.8);
  else if (event.key === "Home") Object.assign(state, { tile: [0, 0], at: [0.5, 0.5] });
  else if (event.key === " " && isShown("painting")) paint(0, 0);
  else return;
  event.preventDefault();
  redraw();
});

byId("jump").addEventListener("click", () => {
  state.tile[0] += state.tile[0] + 1e9 > farthest ? -2e9 : 1e9;
  redraw();
});
byId("place").addEventListener("change", (event) => {
  const place = event.target.value.split(/[\s,;]+/).filter((word) => word !== "").map(Number);
  if (place.length !== 2 || !place.every(Number.isFinite)) {
    byId("status").textContent = `${event.target.value}: must be two numbers, x and y, in tiles`;
    return;
  }
  state.tile = place.map((v) => wholeTile(Math.floor(v)));
  state.at = place.map((v) => v - Math.floor(v));
  redraw();
});
for (const slider of ["brush", "brush-size"]) byId(slider).addEventListener("input", showNumbers);
byId("clear").addEventListener("click", () => {
  painted.clear();
  byId("picture").value = "";
  redraw();
});
byId("seed").addEventListener("input", (event) => {
  setSeed(Number(event.target.value));
  redraw();
});
byId("density").addEventListener("input", (event) => {
  state.density = Number(event.target.value);
  redraw();
});
byId("look").addEventListener("change", (event) => {
  state.look = event.target.value;
  redraw();
});
for (const box of [...boxes, "painting"])
  byId(box).addEventListener("change", () => {
    showParts();
    redraw();
  });

/** Lays the chosen picture over the whole tiles in view. */
async function takePicture() {
  const file = byId("picture").files[0];
  if (!file || !canHold("png")) return;
  try {
    painted.layPicture(await createImageBitmap(file), seenWindow(), byId("picture-of").value === "ink");
  } catch (error) {
    byId("status").textContent = `${file.name}: is no picture that this browser reads`;
    return;
  }
  redraw();
}
for (const id of ["picture", "picture-of"]) byId(id).addEventListener("change", takePicture);

// Flying shows how many frames a second the browser draws.
let flight = null;
function fly(now) {
  if (!flight) return;
  flight.times.push(now);
  if (flight.times.length > 30) flight.times.shift();
  const seconds = (now - flight.times[0]) / 1000;
  if (seconds > 0.2) byId("frames").textContent = `${((flight.times.length - 1) / seconds).toFixed(0)} frames a second by ${glPoints ? "WebGL2" : "a plain canvas"}`;
  const passed = flight.times.length > 1 ? now - flight.times[flight.times.length - 2] : 0;
  move((0.06 * Math.min(100, passed)) / state.zoom, 0);
  redraw();
  requestAnimationFrame(fly);
}
byId("fly").addEventListener("change", (event) => {
  flight = event.target.checked ? { times: [] } : null;
  byId("frames").textContent = "";
  if (flight) requestAnimationFrame(fly);
});

function save(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
for (const button of document.querySelectorAll("[data-save]"))
  button.addEventListener("click", () => {
    const kind = button.dataset.save;
    if (!canHold(kind)) return;
    if (kind === "png") return painted.pictureOf(seenWindow()).toBlob((blob) => save(blob, "density.png"));
    const text = fileOf(kind, filePoints(seenWindow()), byId("command").textContent, pointRadius(minDistance, 1));
    save(new Blob([text], { type: "text/plain" }), `points.${kind}`);
  });
for (const button of document.querySelectorAll("[data-copy]"))
  button.addEventListener("click", () => {
    const shown = byId(button.dataset.copy);
    if (navigator.clipboard) navigator.clipboard.writeText(shown.textContent).catch(() => {});
    getSelection().selectAllChildren(shown);
  });

addEventListener("hashchange", readAddress);
addEventListener("resize", redraw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
readAddress();
drawNow();
