// The page of an endless tiling: zoom, brush and buttons.
"use strict";

/** Zooms about a place of the canvas, in pixels from its middle, y upwards. */
function zoomBy(factor, x = 0, y = 0) {
  const zoom = Math.max(zooms[0], Math.min(zooms[1], state.zoom * factor));
  move(x / state.zoom - x / zoom, y / state.zoom - y / zoom);
  state.zoom = zoom;
  redraw();
}

/** Paints around a place of the canvas, in pixels from its middle, y upwards. */
function paint(x, y) {
  const at = [state.at[0] + x / state.zoom, state.at[1] + y / state.zoom];
  const tile = at.map((v, a) => state.tile[a] + Math.floor(v));
  const radius = Math.min(16, Number(byId("brush-size").value) / state.zoom);
  painted.paint(tile, at.map((v) => v - Math.floor(v)), radius, Number(byId("brush").value));
  redraw();
}

function goHome() {
  Object.assign(state, { tile: [0, 0], at: [0.5, 0.5] });
}

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
