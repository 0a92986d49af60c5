// The page of a tiling with hats or spectres: what is seen, and what users do.
"use strict";

const byId = (id) => document.getElementById(id);
const canvas = byId("view");
const about = byId("monotile").dataset;
const bytes = Uint8Array.from(atob(byId("tiles").textContent.trim()), (c) => c.charCodeAt(0));
const set = new MonotilePoints.MonotileSet(bytes);
const area = set.tiling === "hat" ? 8 * Math.sqrt(3) : 3 + 3 * Math.sqrt(3); // of a tile
const steps = [1, set.tiling === "hat" ? Math.sqrt(3) : 1]; // edges of a step of a place
const farthest = 2 ** 40 - 2 ** 21; // steps from the origin
const zooms = [3, 4e5]; // pixels of an edge
const most = { drawn: 12000, tiles: 3000, saved: 400000 };
const minDistance = set.minDistance || 0.7 * Math.sqrt((2 * area) / (Math.sqrt(3) * set.pointsPerTile)); // in edges
const looks = ["disks", "distances", "instances"];
const boxes = ["tiles-shown", "show-spectrum"];

/** What is seen: the middle of the view is `at`, 0 to 1, of a step beyond the place `tile`. */
const state = { seed: 1, tile: [0, 0], at: [0.5, 0.5], zoom: 40, look: "disks", density: 1 };
const painted = new PaintedDensity(); // of squares of one step
const isShown = (box) => byId(box).checked;
const wholePlace = (v) => Math.max(-farthest, Math.min(farthest, v));

/** Moves the middle of the view by so many edges: whole steps and the rest are apart, so nothing is lost far away. */
function move(x, y) {
  [x, y].forEach((by, a) => {
    const sum = state.at[a] + by / steps[a];
    state.tile[a] = wholePlace(state.tile[a] + Math.floor(sum));
    state.at[a] = sum - Math.floor(sum);
  });
}

function zoomBy(factor, x = 0, y = 0) {
  const zoom = Math.max(zooms[0], Math.min(zooms[1], state.zoom * factor));
  move(x / state.zoom - x / zoom, y / state.zoom - y / zoom);
  state.zoom = zoom;
}

function goHome() {
  Object.assign(state, { tile: [0, 0], at: [0.5, 0.5] });
}

function paint(x, y) {
  const at = [x, y].map((v, a) => state.at[a] + v / state.zoom / steps[a]);
  const square = at.map((v, a) => state.tile[a] + Math.floor(v));
  const radius = Math.min(16, Number(byId("brush-size").value) / state.zoom);
  painted.paint(square, at.map((v) => v - Math.floor(v)), radius, Number(byId("brush").value));
}

const halves = () => [canvas.clientWidth, canvas.clientHeight].map((v) => v / 2 / state.zoom);

/** The density at a place from the middle of the view, in edges. */
function densityAt(x, y) {
  if (painted.isEmpty) return state.density;
  const at = [x, y].map((v, a) => state.at[a] + v / steps[a]);
  return state.density * painted.at(...at.map((v, a) => state.tile[a] + Math.floor(v)), ...at.map((v) => v - Math.floor(v)));
}

/** The part of all points that is drawn of a part of the plane: of too many those of low ranks. */
const drawnPart = ([w, h]) => Math.min(1, state.density, (most.drawn * area) / (4 * w * h * set.pointsPerTile));

/** What was found around the view, a little farther than it is: moving a little needs no new search. */
const kept = { key: "", tile: [0, 0], half: [0, 0], at: [0, 0], points: [], tiles: [] };
function findAround(half) {
  const part = drawnPart(half);
  const key = `${state.seed} ${part} ${half} ${4 * half[0] * half[1] < most.tiles * area}`;
  const from = kept.tile.map((t, a) => (state.tile[a] - t + state.at[a]) * steps[a]); // the middle, from the kept place
  if (kept.key === key && from.every((v, a) => Math.abs(v - kept.at[a]) + half[a] < kept.half[a])) return;
  Object.assign(kept, { key, tile: [...state.tile], half: half.map((h) => 1.4 * h + 1), at: state.at.map((v, a) => v * steps[a]) });
  const [low, high] = [-1, 1].map((sign) => kept.at.map((v, a) => v + sign * kept.half[a]));
  kept.points = set.pointsInWindow(kept.tile, low, high, part, state.seed);
  kept.tiles = 4 * half[0] * half[1] < most.tiles * area ? tilesIn(kept.tile, low, high) : [];
}

/** Points of a part of the plane that the density leaves, at places from the middle of the view, in edges. */
function seenPoints(half) {
  findAround(half);
  const from = kept.tile.map((t, a) => (t - state.tile[a] - state.at[a]) * steps[a]);
  return kept.points.map((p) => ({ x: p.position[0] + from[0], y: p.position[1] + from[1], id: p.id, level: p.level }))
      .filter(({ x, y, level }) => Math.abs(x) <= half[0] && Math.abs(y) <= half[1] && level < densityAt(x, y));
}

// Tiles are drawn by their outline, whose corners are numbers a + b z + c z^2 + d z^3, z a twelfth of a turn.

const outline = about.outline.split(";").map((corner) => corner.split(",").map(Number));
const timesZ = ([a, b, c, d]) => [-d, a, b + d, c];
const mirrored = ([a, b, c, d]) => [a + c, b, -c, -b - d];
const stateTable = 128 + 16 * (set.pointsPerTile + set.starts.length + set.parts.length);
/** 1: tiles of a state are turned by a twelfth, 2: they are mirrored, 3: both. */
const ownOf = (number) => bytes[stateTable + 8 * number + 6];

/** The corners of an outline of tiles of a state, turned by sixths, as [x, y] from the tile's place. */
const outlines = new Map();
function outlineOf(number, sixths) {
  const key = ownOf(number) * 6 + sixths;
  if (!outlines.has(key))
    outlines.set(key, outline.map((corner) => {
      let place = ownOf(number) & 2 ? mirrored(corner) : corner;
      for (let turn = 2 * sixths + (ownOf(number) & 1); turn > 0; --turn) place = timesZ(place);
      return [set.rough(place, 0), set.rough(place, 1)];
    }));
  return outlines.get(key);
}

/** The tiles of a window: places in edges from its origin, corners, and what is dark: the rarer orientation. */
function tilesIn(origin, low, high) {
  const walker = Object.create(set);
  walker.addPoints = (window, tile) => window.found.push({
    at: [0, 1].map((axis) => set.fixed(tile.at, axis) / 2 ** 32),
    corners: outlineOf(tile.state, tile.turn),
    isDark: ownOf(tile.state) !== 0,
  });
  const reach = 6; // of outlines beyond points
  return walker.pointsInWindow(origin, low.map((v) => v - reach), high.map((v) => v + reach));
}

function drawTiles(context, width, height) {
  const from = kept.tile.map((t, a) => (t - state.tile[a] - state.at[a]) * steps[a]);
  context.strokeStyle = "rgb(128 128 128 / 0.8)";
  for (const { at, corners, isDark } of kept.tiles) {
    context.beginPath();
    for (const [x, y] of corners)
      context.lineTo(width / 2 + (at[0] + x + from[0]) * state.zoom, height / 2 - (at[1] + y + from[1]) * state.zoom);
    context.closePath();
    context.fillStyle = isDark ? "rgb(70 120 170 / 0.45)" : "rgb(120 170 210 / 0.14)";
    context.fill();
    context.stroke();
  }
}

function drawView() {
  const [context, width, height] = cleared(canvas, window.devicePixelRatio || 1);
  const around = distanceShown * minDistance;
  const points = seenPoints(halves().map((half) => half + around));
  const look = { ...state, minDistance };
  if (state.look === "distances") drawDistances(context, points, look, width, height);
  if (isShown("tiles-shown")) drawTiles(context, width, height);
  if (state.look !== "distances") drawPoints(context, points, look, width, height);
  if (!isShown("painting")) return;
  context.strokeStyle = canvas.inkColor;
  context.strokeRect(width / 2 - 5, height / 2 - 5, 10, 10); // where the keyboard paints
}

/** The spectrum of a square around the middle of the view. */
function drawSpectrum() {
  const size = 256;
  const side = Math.sqrt((4096 * area) / set.pointsPerTile);
  const low = state.at.map((v, a) => v * steps[a] - side / 2);
  const points = set.pointsInWindow(state.tile, low, low.map((v) => v + side), state.density, state.seed);
  const power = powerOf(points.map(({ position }) => position.map((v, a) => Math.min((v - low[a]) / side, 0.9999999))), size);
  const element = byId("spectrum");
  element.width = element.height = size;
  const context = element.getContext("2d");
  const image = context.createImageData(size, size);
  power.forEach((p, i) => {
    const light = Math.min(255, 128 * Math.log2(1 + p));
    image.data.set([light, light, light, 255], 4 * (size * (size - 1 - Math.floor(i / size)) + (i % size)));
  });
  context.putImageData(image, 0, 0);
}

/** The window of the view, as commands have it: the place of its lowest corner, and its size in whole edges. */
function seenWindow() {
  const half = halves();
  const low = state.at.map((v, a) => Math.floor(v - half[a] / steps[a]));
  const size = low.map((v, a) => Math.ceil((state.at[a] - v) * steps[a] + half[a]));
  return [state.tile[0] + low[0], state.tile[1] + low[1], ...size];
}

/** Its points with the densities, from its lowest corner. */
function windowPoints([i, j, width, height]) {
  const from = [i, j].map((v, a) => (v - state.tile[a] - state.at[a]) * steps[a]);
  return set.pointsInWindow([i, j], [0, 0], [width, height], state.density, state.seed)
      .filter(({ position: [x, y], level }) => level < densityAt(x + from[0], y + from[1]));
}

function describe() {
  const half = halves();
  const points = seenPoints(half);
  const { smallest } = nearPairs(points.map((p) => [p.x, p.y]), minDistance * 1.5);
  const least = (Math.floor(1e4 * minDistance) / 1e4).toFixed(4);
  const parts = [`${points.length.toLocaleString("en")} points around ${state.tile.join(", ")}`,
                 Number.isFinite(smallest) ? `the nearest two are ${smallest.toFixed(4)} edges apart; none in the plane are nearer than ${least}` : "none near another"];
  if (drawnPart(half) < state.density) parts.push("too many for a view: those of low ranks");
  byId("status").textContent = parts.join("; ");
  if (isShown("show-spectrum")) drawSpectrum();
  const view = seenWindow();
  const thin = state.density < 1 ? ` --density ${state.density}` : "";
  byId("command").textContent =
      `poissonlab tiles points ${about.name} --window ${view.join(" ")} --seed ${state.seed}${thin} --out points.txt`;
  byId("call").textContent = `int64_t origin[] = {${view[0]}, ${view[1]}}; double low[] = {0, 0}, high[] = {${view[2]}, ${view[3]}};\n` +
      `n = pmono_in_window(&set, ${state.seed}, origin, low, high, points, capacity, ${state.density});`;
  const { seed, tile, at, zoom, look, density } = state;
  const address = `seed=${seed}&tile=${tile}&at=${at}&zoom=${zoom}&look=${look}&density=${density}&show=${boxes.filter(isShown)}`;
  byId("link").href = `#${address}`;
  byId("link").textContent = `${location.href.replace(/#.*/, "")}#${address}`;
}

function drawPicture() {
  byId("spectrum-part").hidden = !isShown("show-spectrum");
  for (const slider of ["density", "brush", "brush-size"]) byId(`${slider}-number`).textContent = byId(slider).value;
  if (document.activeElement !== byId("place"))
    byId("place").value = state.tile.map((t, a) => (t + state.at[a]).toFixed(2)).join(", ");
  drawView();
}

// Drawing is done once a frame; words and the spectrum follow some times a second.
let isWaiting = false;
let isDescribing = false;
function redraw() {
  if (!isWaiting) {
    isWaiting = true;
    requestAnimationFrame(() => {
      isWaiting = false;
      drawPicture();
    });
  }
  if (isDescribing) return;
  isDescribing = true;
  setTimeout(() => {
    isDescribing = false;
    describe();
  }, 150);
}

/** Takes the view from the page's address. */
function readAddress() {
  const given = new URLSearchParams(location.hash.slice(1));
  const pair = (key) => (given.get(key) || "").split(",").map(Number);
  const number = (key, low, high) =>
    given.get(key) && Number.isFinite(Number(given.get(key))) && (state[key] = Math.max(low, Math.min(high, Number(given.get(key)))));
  if (pair("tile").length === 2 && pair("tile").every(Number.isInteger)) state.tile = pair("tile").map(wholePlace);
  if (pair("at").length === 2 && pair("at").every((v) => v >= 0 && v < 1)) state.at = pair("at");
  number("zoom", ...zooms);
  number("density", Number(byId("density").min), 1);
  number("seed", 0, 4294967295);
  state.seed >>>= 0;
  if (looks.includes(given.get("look"))) state.look = given.get("look");
  for (const key of ["seed", "density", "look"]) byId(key).value = state[key];
  if (given.has("show")) for (const box of boxes) byId(box).checked = given.get("show").split(",").includes(box);
  redraw();
}

byId("jump").addEventListener("click", () => {
  state.tile[0] = wholePlace(state.tile[0] + 1e9);
  redraw();
});
byId("place").addEventListener("change", (event) => {
  const place = event.target.value.split(/[\s,;]+/).filter((word) => word !== "").map(Number);
  if (place.length !== 2 || !place.every(Number.isFinite)) {
    byId("status").textContent = `${event.target.value}: must be two numbers, x and y`;
    return;
  }
  state.tile = place.map((v) => wholePlace(Math.floor(v)));
  state.at = place.map((v) => v - Math.floor(v));
  redraw();
});
for (const slider of ["brush", "brush-size"]) byId(slider).addEventListener("input", redraw);
for (const box of [...boxes, "painting"]) byId(box).addEventListener("change", redraw);
byId("clear").addEventListener("click", () => {
  painted.clear();
  redraw();
});
for (const [key, taken] of [["seed", (v) => v >>> 0], ["density", Number], ["look", String]])
  byId(key).addEventListener("input", (event) => {
    state[key] = taken(event.target.value);
    redraw();
  });
for (const button of document.querySelectorAll("[data-save]"))
  button.addEventListener("click", () => {
    const view = seenWindow();
    if ((view[2] * view[3] * set.pointsPerTile) / area > most.saved) {
      byId("status").textContent = "Too many points are in view: zoom in";
      return;
    }
    const text = fileOf(button.dataset.save, windowPoints(view), byId("command").textContent, pointRadius(minDistance, 1));
    save(new Blob([text], { type: "text/plain" }), `points.${button.dataset.save}`);
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
drawPicture();
describe();
