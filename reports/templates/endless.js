// The page of an endless tiling: the view of it, what is drawn, and what users do.
"use strict";

const byId = (id) => document.getElementById(id);
const canvas = byId("view"); // on top: borders and colours, and the points where there is no WebGL2
const about = byId("endless").dataset;
const set = new PoissonTiles.TileSet(Uint8Array.from(atob(byId("tiles").textContent.trim()), (c) => c.charCodeAt(0)));
const farthest = 2147483600; // tiles from the origin that 32 bits can name, and some to look around
const zooms = [4, 1e7]; // pixels of a tile
const mostPoints = { graphics: 200000, processor: 20000 }; // that are drawn, by what draws them; of more, those of low ranks

/** Of the tile set, in tiles: as proven; about that of darts where nothing is. */
const minDistance = Number(about.distance) || 0.7 * Math.sqrt(2 / (Math.sqrt(3) * set.pointsPerTile));

const tooManyTiles = "Too many tiles are in view: zoom in";
const mostSaved = { points: 1e6, pixels: 2 ** 26 }; // browsers hold no longer texts and no larger pictures

const looks = ["disks", "distances", "instances"];
const boxes = ["borders", "corners", "beside", "show-spectrum"]; // what is switched on and off

/** What is seen: the middle of the view is at `at`, 0 to 1, in `tile`. */
const state = { seed: 1, tile: [0, 0], at: [0.5, 0.5], zoom: 120, look: "disks", density: 1 };
const painted = new PaintedDensity();
let tiling = new PoissonTiles.Tiling(set, state.seed);
let glPoints = null; // null: a plain canvas
const order = pointOrder(set);
const isShown = (box) => byId(box).checked;

const wholeTile = (v) => Math.max(-farthest, Math.min(farthest, v));

/** Moves the middle of the view by so many tiles: whole tiles and the rest are apart, so nothing is lost far away. */
function move(x, y) {
  [x, y].forEach((by, a) => {
    const sum = state.at[a] + by;
    state.tile[a] = wholeTile(state.tile[a] + Math.floor(sum));
    state.at[a] = sum - Math.floor(sum);
  });
}

/** The tiles of a part of the plane: the lowest, from the middle one, and how many. */
function tilesAround(halfWidth, halfHeight) {
  const first = [halfWidth, halfHeight].map((half, a) => Math.floor(state.at[a] - half));
  const last = [halfWidth, halfHeight].map((half, a) => Math.floor(state.at[a] + half));
  return { first, columns: last[0] - first[0] + 1, rows: last[1] - first[1] + 1 };
}

/** visit(i, j, x, y) for each of them, x and y being the lower left corner's place from the middle of the view. */
function eachTile(halfWidth, halfHeight, visit) {
  const { first, columns, rows } = tilesAround(halfWidth, halfHeight);
  for (let dj = first[1]; dj < first[1] + rows; ++dj)
    for (let di = first[0]; di < first[0] + columns; ++di)
      visit(state.tile[0] + di, state.tile[1] + dj, di - state.at[0], dj - state.at[1]);
}

const halves = () => [canvas.clientWidth / 2 / state.zoom, canvas.clientHeight / 2 / state.zoom];

/** The tiles that are drawn, and how many points of each, by rank: all, unless they are too many. */
function drawnTiles() {
  const over = Math.max(set.below, set.above) / 65536 + distanceShown * minDistance;
  const tiles = tilesAround(...halves().map((half) => half + over));
  const most = mostPoints[glPoints && !glPoints.isSoftware ? "graphics" : "processor"];
  const wanted = set.ranks ? Math.max(1, set.ranksBelow(state.density)) : set.pointsPerTile;
  return { ...tiles, shown: Math.max(1, Math.min(wanted, Math.floor(most / (tiles.columns * tiles.rows)))) };
}

/** The points of a part of the plane that the densities leave: places from the middle of the view, ids and levels.
 *  `most`: of each tile, by rank. */
function seenPoints(halfWidth, halfHeight, most = set.pointsPerTile) {
  const points = [];
  const over = Math.max(set.below, set.above) / 65536;
  eachTile(halfWidth + over, halfHeight + over, (i, j, x0, y0) => {
    const tile = tiling.tile(i, j);
    for (let k = 0; k < most; ++k) {
      const index = order[tile * set.pointsPerTile + k];
      const first = 2 * (tile * set.pointsPerTile + index);
      const [u, v] = [set.coordinate(set.points[first]), set.coordinate(set.points[first + 1])];
      const [x, y] = [x0 + u, y0 + v];
      if (Math.abs(x) > halfWidth || Math.abs(y) > halfHeight) continue;
      if (state.density < 1 || !painted.isEmpty) {
        const [du, dv] = [Math.floor(u), Math.floor(v)]; // chains: the point may lie in the next tile's square
        const density = state.density * painted.at(i + du, j + dv, u - du, v - dv);
        if (tiling.level([i, j, 0], tile, index) >= density) continue;
      }
      points.push({ x, y, i, j, tile, index, id: tiling.id([i, j, 0], index) });
    }
  });
  return points;
}

/** Borders of tiles, and what decides which tile is where: colours of corners or edges, or the number of the tile. */
function drawTiles(context, width, height) {
  const scale = state.zoom;
  if (scale < 16) return;
  const mark = Math.min(12, scale / 6);
  eachTile(width / 2 / scale, height / 2 / scale, (i, j, x, y) => {
    const [left, below] = [width / 2 + x * scale, height / 2 - y * scale];
    if (isShown("borders")) {
      context.strokeStyle = "rgb(128 128 128 / 0.6)";
      context.strokeRect(left, below - scale, scale, scale);
    }
    if (!isShown("corners")) return;
    const color = (z) => colorOf(tiling.color(tiling.place(i), tiling.place(j), z), set.colors, 55);
    context.fillStyle = color(0);
    if (set.kind === 0) context.fillRect(left - mark / 2, below - mark / 2, mark, mark);
    if (set.kind === 1) {
      context.fillRect(left, below - mark / 4, scale, mark / 2);
      context.fillStyle = color(1);
      context.fillRect(left - mark / 4, below - scale, mark / 2, scale);
    }
    if (set.kind === 2) {
      context.fillStyle = colorOf(tiling.tile(i, j), set.tiles, 55);
      context.font = `${Math.min(24, scale / 4)}px sans-serif`;
      context.fillText(String(tiling.tile(i, j)), left + 4, below - 4);
    }
  });
}

function drawView() {
  const ratio = window.devicePixelRatio || 1;
  const [context, width, height] = cleared(canvas, ratio);
  const tiles = drawnTiles();
  const { seed, tile, at, zoom, look, density } = state;
  if (glPoints && glPoints.isLost) glPoints = null;
  byId("points").hidden = !glPoints;
  if (glPoints) {
    fit(byId("points"), ratio);
    const ink = canvas.inkColor.match(/[\d.]+/g).slice(0, 3).map(Number);
    glPoints.draw({ ...tiles, seed, middle: tile, at, zoom, ratio, look, minDistance, ink, density: painted, everywhere: density });
  } else {
    const around = distanceShown * minDistance;
    const points = seenPoints(...halves().map((half) => half + around), tiles.shown);
    (look === "distances" ? drawDistances : drawPoints)(context, points, { zoom, look, minDistance }, width, height);
  }
  drawTiles(context, width, height);
  if (isShown("painting")) {
    context.strokeStyle = canvas.inkColor;
    context.strokeRect(width / 2 - 5, height / 2 - 5, 10, 10); // where the keyboard paints
  }
}

const chunks = new Map(); // Bridson's points of the tiles that were seen lately

/** Draws the window by chunks of Bridson's points, with those in red that are too near to one of another chunk. */
function drawChunks() {
  const [context, width, height] = cleared(byId("chunks"), window.devicePixelRatio || 1);
  const { columns, rows } = tilesAround(...halves());
  if (columns * rows * set.pointsPerTile > mostPoints.processor) {
    byId("chunks-status").textContent = tooManyTiles;
    return;
  }
  const points = [];
  if (chunks.size > 4000) chunks.clear();
  eachTile(width / 2 / state.zoom, height / 2 / state.zoom, (i, j, x, y) => {
    const key = `${state.seed},${i},${j}`;
    if (!chunks.has(key)) {
      const seed = PoissonTiles.hash(state.seed, tiling.place(i), tiling.place(j), 7);
      chunks.set(key, chunkPoints(minDistance, seed));
    }
    for (const [u, v] of chunks.get(key)) points.push([x + u, y + v]);
  });
  const { near } = nearPairs(points, minDistance);
  const radius = pointRadius(minDistance, state.zoom);
  let [seen, seenNear] = [0, 0];
  points.forEach(([x, y], i) => {
    if (Math.abs(x) * state.zoom < width / 2 && Math.abs(y) * state.zoom < height / 2) {
      ++seen;
      if (near.has(i)) ++seenNear;
    }
    context.fillStyle = near.has(i) ? "#d22" : byId("chunks").inkColor;
    context.beginPath();
    context.arc(width / 2 + x * state.zoom, height / 2 - y * state.zoom, radius, 0, 2 * Math.PI);
    context.fill();
  });
  byId("chunks-status").textContent = `${seen.toLocaleString("en")} points, ${seenNear} of them too near to one across a border`;
}

/** The spectrum of a square of tiles around the middle of the view: windows have a cross on the axes. */
function drawSpectrum() {
  const size = 256;
  const half = Math.max(1, Math.round(64 / Math.sqrt(set.pointsPerTile))) / 2;
  const points = seenPoints(half, half).map((p) => [(p.x + half) / (2 * half), (p.y + half) / (2 * half)]);
  const power = powerOf(points.filter(([x, y]) => x < 1 && y < 1), size);
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

/** The whole tiles in view: lowest ones, and how many. */
function seenWindow() {
  const { first, columns, rows } = tilesAround(...halves());
  return [state.tile[0] + first[0], state.tile[1] + first[1], columns, rows];
}

/** The points of whole tiles, at the density of the slider and as painted. */
function windowPoints([i, j, width, height]) {
  return tiling.pointsInWindow([i, j], [i + width, j + height], state.density).filter(({ position: [x, y], level }) => {
    const [ti, tj] = [Math.floor(x), Math.floor(y)];
    return level < state.density * painted.at(ti, tj, x - ti, y - tj);
  });
}

/** These points with places from the corner of the window, as files of the command have them: small numbers anywhere. */
function filePoints(view) {
  return windowPoints(view).map((point) => ({ ...point, position: point.position.map((v, a) => v - view[a]) }));
}

/** False, with a word to the user, where the tiles in view are too many for a file or a picture over them. */
function canHold(kind) {
  const [, , width, height] = seenWindow();
  const each = kind === "png" ? painted.cells ** 2 : set.pointsPerTile;
  const isHeld = width * height * each <= (kind === "png" ? mostSaved.pixels : mostSaved.points);
  if (!isHeld) byId("status").textContent = tooManyTiles;
  return isHeld;
}

/** The number of places that are left of points where a coordinate of the plane is a float of 32 bits. */
function floatPlaces(points) {
  const columns = new Map();
  for (const { i, j, tile, index } of points) {
    const first = 2 * (tile * set.pointsPerTile + index);
    const [x, y] = [i, j].map((t, a) => Math.fround(t + set.coordinate(set.points[first + a])));
    if (!columns.has(x)) columns.set(x, new Set());
    columns.get(x).add(y);
  }
  return Array.from(columns.values(), (ys) => ys.size).reduce((a, b) => a + b, 0);
}

function describeView() {
  const { shown, columns, rows } = drawnTiles();
  const most = Math.min(shown, Math.ceil(mostPoints.processor / (columns * rows)));
  const points = seenPoints(...halves(), most);
  const { smallest } = nearPairs(points.map((p) => [p.x, p.y]), minDistance * 1.5);
  const places = floatPlaces(points);
  const parts = [`${points.length.toLocaleString("en")} points around tile (${state.tile.join(", ")})`,
                 Number.isFinite(smallest) ? `the nearest two are ${smallest.toFixed(4)} tiles apart` : "none near another"];
  if (places < points.length) parts.push(`coordinates of 32-bit floats would leave ${places.toLocaleString("en")} places of them`);
  if (most < set.ranksBelow(state.density)) parts.push(`of each tile the first ${most} by rank`);
  byId("status").textContent = parts.join("; ");
}

/** The page's address of this view; what is painted is not in it. */
function address() {
  const { seed, tile, at, zoom, look, density } = state;
  return `seed=${seed}&tile=${tile}&at=${at}&zoom=${zoom}&look=${look}&density=${density}&show=${boxes.filter(isShown)}`;
}

/** What the command must be told of the density, and what it cannot be told: it takes pictures in parts of their densest
 *  place. */
function densityWords(view) {
  if (painted.isEmpty) return [state.density < 1 ? ` --density ${state.density}` : "", ""];
  const most = state.density * painted.most(view);
  const note = most < 1 ? ` # with all points at the densest place, which has ${Number(most.toPrecision(3))} of them here` : "";
  return [" --density density.png", note];
}

/** The numbers beside the sliders, and the place of the middle, unless one is being typed. */
function showNumbers() {
  for (const slider of ["density", "brush", "brush-size"]) byId(`${slider}-number`).textContent = byId(slider).value;
  if (document.activeElement !== byId("place"))
    byId("place").value = state.tile.map((t, a) => (t + state.at[a]).toFixed(2)).join(", ");
}

function showTexts() {
  const view = seenWindow();
  const [i, j, width, height] = view;
  const [thin, note] = densityWords(view);
  byId("command").textContent =
      `poissonlab tiles points ${about.name} --window ${view.join(" ")} --seed ${state.seed}${thin} --out points.txt${note}`;
  byId("call").textContent = `double low[] = {${i}, ${j}}, high[] = {${i + width}, ${j + height}};\n` +
      `n = ptiles_in_window(&tiling, low, high, points, capacity, ${state.density}); // tiling.seed: ${state.seed}`;
  byId("link").href = `#${address()}`;
  byId("link").textContent = location.href.replace(/#.*/, "") + `#${address()}`;
}

// Drawing is done once a frame; words and the spectrum follow some times a second.
let isWaiting = false;
let isDescribing = false;
function redraw() {
  if (isWaiting) return;
  isWaiting = true;
  requestAnimationFrame(() => {
    isWaiting = false;
    drawPicture();
  });
  if (isDescribing) return;
  isDescribing = true;
  setTimeout(() => {
    isDescribing = false;
    describe();
  }, 120);
}
function drawPicture() {
  showNumbers();
  drawView();
  if (isShown("beside")) drawChunks();
}
function describe() {
  describeView();
  if (isShown("show-spectrum")) drawSpectrum();
  showTexts();
}
function drawNow() {
  drawPicture();
  describe();
}

/** Shows the tiling of a seed. */
function setSeed(seed) {
  state.seed = seed >>> 0;
  tiling = new PoissonTiles.Tiling(set, state.seed);
}

/** Takes the view from the page's address. */
function readAddress() {
  const given = new URLSearchParams(location.hash.slice(1));
  const pair = (key) => (given.get(key) || "").split(",").map(Number);
  const number = (key, low, high) =>
    given.get(key) && Number.isFinite(Number(given.get(key))) && (state[key] = Math.max(low, Math.min(high, Number(given.get(key)))));
  if (pair("tile").length === 2 && pair("tile").every(Number.isInteger)) state.tile = pair("tile").map(wholeTile);
  if (pair("at").length === 2 && pair("at").every((v) => v >= 0 && v < 1)) state.at = pair("at");
  number("zoom", ...zooms);
  number("density", Number(byId("density").min), 1);
  number("seed", 0, 4294967295);
  if (looks.includes(given.get("look"))) state.look = given.get("look");
  setSeed(state.seed);
  for (const key of ["seed", "density", "look"]) byId(key).value = state[key];
  if (given.has("show")) for (const box of boxes) byId(box).checked = given.get("show").split(",").includes(box);
  showParts();
  usePainter(given.get("draw") !== "canvas");
  redraw();
}

/** WebGL2 where it is wanted and there, else a plain canvas. */
function usePainter(isGlWanted) {
  if (!isGlWanted) glPoints = null;
  if (!isGlWanted || glPoints) return;
  try {
    glPoints = new GlPoints(byId("points"), set, byId("header").textContent);
  } catch (error) {
    glPoints = null;
  }
}

function showParts() {
  byId("chunks-part").hidden = !isShown("beside");
  byId("spectrum-part").hidden = !isShown("show-spectrum");
}
