// The page of an endless tiling: the view of it, what is drawn, and what users do. The page has the tile set in it.
"use strict";

const byId = (id) => document.getElementById(id);
const canvas = byId("view");
const set = new PoissonTiles.TileSet(Uint8Array.from(atob(byId("tiles").textContent.trim()), (c) => c.charCodeAt(0)));
const farthest = 2147483600; // tiles from the origin that 32 bits can name, and some to look around
const paintCells = 8; // along each axis of a tile

/** Of the tile set, in tiles: as proven; about that of darts where nothing is. */
const minDistance = Number(document.body.dataset.distance) || 0.7 * Math.sqrt(2 / (Math.sqrt(3) * set.pointsPerTile));

/** What is seen: the middle of the view is at `at`, 0 to 1, in `tile`. */
const state = { seed: 1, tile: [0, 0], at: [0.5, 0.5], zoom: 120, look: "disks", density: 1, borders: true, corners: false };
const painted = new Map(); // densities of parts of tiles, by the tile's place
let tiling = new PoissonTiles.Tiling(set, state.seed);

const wholeTile = (v) => Math.max(-farthest, Math.min(farthest, v));

/** Moves the middle of the view by so many tiles: whole tiles and the rest are apart, so nothing is lost far away. */
function move(x, y) {
  [x, y].forEach((by, a) => {
    const sum = state.at[a] + by;
    state.tile[a] = wholeTile(state.tile[a] + Math.floor(sum));
    state.at[a] = sum - Math.floor(sum);
  });
}

/** The density that is painted at a place in a tile; 1 where none is. */
function paintedAt(i, j, u, v) {
  const cells = painted.get(`${i},${j}`);
  const cell = (w) => Math.min(paintCells - 1, Math.max(0, Math.floor(w * paintCells)));
  return cells ? cells[cell(v) * paintCells + cell(u)] : 1;
}

/** Shows the tiles of a part of the plane: visit(i, j, x, y), x and y being the lower left corner's place from the
 *  middle of the view, in tiles. */
function eachTile(halfWidth, halfHeight, visit) {
  const range = (a, half) => [Math.floor(state.at[a] - half), Math.floor(state.at[a] + half)];
  const [[left, right], [bottom, top]] = [range(0, halfWidth), range(1, halfHeight)];
  for (let dj = bottom; dj <= top; ++dj)
    for (let di = left; di <= right; ++di)
      visit(state.tile[0] + di, state.tile[1] + dj, di - state.at[0], dj - state.at[1]);
}

/** The points of a part of the plane that the densities leave: places from the middle of the view, ids and levels. */
function seenPoints(halfWidth, halfHeight) {
  const points = [];
  const over = Math.max(set.below, set.above) / 65536;
  eachTile(halfWidth + over, halfHeight + over, (i, j, x0, y0) => {
    const tile = tiling.tile(i, j);
    for (let index = 0; index < set.pointsPerTile; ++index) {
      const first = 2 * (tile * set.pointsPerTile + index);
      const [u, v] = [set.coordinate(set.points[first]), set.coordinate(set.points[first + 1])];
      const [x, y] = [x0 + u, y0 + v];
      if (Math.abs(x) > halfWidth || Math.abs(y) > halfHeight) continue;
      if (state.density < 1 || painted.size > 0) {
        const [du, dv] = [Math.floor(u), Math.floor(v)]; // chains: the point may lie in the next tile's square
        const density = state.density * paintedAt(i + du, j + dv, u - du, v - dv);
        if (tiling.level([i, j, 0], tile, index) >= density) continue;
      }
      points.push({ x, y, i, j, tile, index, id: tiling.id([i, j, 0], index) });
    }
  });
  return points;
}

const colorOf = (number, count, light) => `hsl(${Math.round((360 * number) / count)} 60% ${light}%)`;

function drawTiles(context, scale, width, height) {
  eachTile(width / 2 / scale, height / 2 / scale, (i, j, x, y) => {
    const [left, below] = [width / 2 + x * scale, height / 2 - y * scale];
    if (state.borders) {
      context.strokeStyle = "rgb(128 128 128 / 0.6)";
      context.strokeRect(left, below - scale, scale, scale);
    }
    if (!state.corners || set.kind !== 0) return;
    const color = tiling.color(tiling.place(i), tiling.place(j));
    context.fillStyle = colorOf(color, set.colors, 55);
    context.fillRect(left - 6, below - 6, 12, 12);
  });
}

/** Each pixel as bright as it is far from the nearest point. */
function drawDistances(context, points, scale, width, height) {
  const step = 3;
  const cell = Math.max(1, (minDistance * scale) | 0);
  const columns = Math.ceil(width / cell) + 1;
  const lists = new Map();
  for (const p of points) {
    const [x, y] = [width / 2 + p.x * scale, height / 2 - p.y * scale];
    const key = Math.floor(y / cell) * columns + Math.floor(x / cell);
    (lists.get(key) || lists.set(key, []).get(key)).push([x, y]);
  }
  for (let y = 0; y < height; y += step)
    for (let x = 0; x < width; x += step) {
      let nearest = (3 * cell) ** 2;
      for (let j = Math.floor(y / cell) - 2; j <= Math.floor(y / cell) + 2; ++j)
        for (let i = Math.floor(x / cell) - 2; i <= Math.floor(x / cell) + 2; ++i)
          for (const [px, py] of lists.get(j * columns + i) || [])
            nearest = Math.min(nearest, (px - x) ** 2 + (py - y) ** 2);
      const light = Math.min(255, Math.round((200 * Math.sqrt(nearest)) / cell));
      context.fillStyle = `rgb(${light} ${light} ${light})`;
      context.fillRect(x, y, step, step);
    }
}

function drawPoints(context, points, scale, width, height) {
  const radius = Math.max(1, (minDistance / 2) * scale * 0.55);
  for (const p of points) {
    const [x, y] = [width / 2 + p.x * scale, height / 2 - p.y * scale];
    context.fillStyle = state.look === "instances" ? colorOf(p.id & 255, 256, 45) : context.canvas.inkColor;
    context.beginPath();
    if (state.look === "instances") {
      const [turn, size] = [((p.id >>> 8) & 255) / 40.74, radius * (0.7 + ((p.id >>> 16) & 255) / 255)];
      for (let corner = 0; corner < 3; ++corner)
        context.lineTo(x + size * Math.cos(turn + 2.0944 * corner), y + size * Math.sin(turn + 2.0944 * corner));
    } else {
      context.arc(x, y, radius, 0, 2 * Math.PI);
    }
    context.fill();
  }
}

/** Fits a canvas to its size on the screen, clears it, and gives what is drawn with. */
function cleared(element) {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [element.clientWidth, element.clientHeight];
  element.width = Math.round(width * ratio);
  element.height = Math.round(height * ratio);
  element.inkColor = getComputedStyle(element).color;
  const context = element.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return [context, width, height];
}

function drawView() {
  const [context, width, height] = cleared(canvas);
  const points = seenPoints(width / 2 / state.zoom, height / 2 / state.zoom);
  if (state.look === "distances") drawDistances(context, points, state.zoom, width, height);
  else drawPoints(context, points, state.zoom, width, height);
  drawTiles(context, state.zoom, width, height);
  const { smallest } = nearPairs(points.map((p) => [p.x, p.y]), minDistance * 1.5);
  byId("status").textContent =
      `${points.length.toLocaleString("en")} points around tile (${state.tile.join(", ")}); ` +
      (Number.isFinite(smallest) ? `the nearest two are ${smallest.toFixed(4)} tiles apart` : "none near another");
}

/** The same window by chunks of Bridson's points, with those in red that are too near to one of another chunk. */
function drawChunks() {
  const [context, width, height] = cleared(byId("chunks"));
  const points = [];
  eachTile(width / 2 / state.zoom, height / 2 / state.zoom, (i, j, x, y) => {
    const seed = PoissonTiles.hash(state.seed, tiling.place(i), tiling.place(j), 7);
    for (const [u, v] of chunkPoints(minDistance, seed)) points.push([x + u, y + v]);
  });
  const { near } = nearPairs(points, minDistance);
  points.forEach(([x, y], i) => {
    context.fillStyle = near.has(i) ? "#d22" : byId("chunks").inkColor;
    context.beginPath();
    context.arc(width / 2 + x * state.zoom, height / 2 - y * state.zoom,
                Math.max(1, (minDistance / 2) * state.zoom * 0.55), 0, 2 * Math.PI);
    context.fill();
  });
  byId("chunks-status").textContent = `${points.length.toLocaleString("en")} points, ${near.size} of them too near to one across a border`;
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
  const range = (a, half) => [Math.floor(state.at[a] - half), Math.floor(state.at[a] + half)];
  const [x, y] = [range(0, canvas.clientWidth / 2 / state.zoom), range(1, canvas.clientHeight / 2 / state.zoom)];
  return [state.tile[0] + x[0], state.tile[1] + y[0], x[1] - x[0] + 1, y[1] - y[0] + 1];
}

/** The points of whole tiles, at the density of the slider and as painted. */
function windowPoints([i, j, width, height]) {
  return tiling.pointsInWindow([i, j], [i + width, j + height], state.density).filter(({ position: [x, y], level }) => {
    const [ti, tj] = [Math.floor(x), Math.floor(y)];
    return level < state.density * paintedAt(ti, tj, x - ti, y - tj);
  });
}

function showTexts() {
  const view = seenWindow();
  const [i, j, width, height] = view;
  const name = document.body.dataset.name;
  const thin = state.density < 1 ? ` --density ${state.density}` : "";
  byId("command").textContent =
      `poissonlab tiles points ${name} --window ${view.join(" ")} --seed ${state.seed}${thin} --out points.txt`;
  byId("call").textContent = `double low[] = {${i}, ${j}}, high[] = {${i + width}, ${j + height}};\n` +
      `n = ptiles_in_window(&tiling, low, high, points, capacity, ${state.density}); // tiling.seed: ${state.seed}`;
  const { seed, tile, at, zoom, look, density } = state;
  const place = `seed=${seed}&tile=${tile}&at=${at}&zoom=${zoom}&look=${look}&density=${density}`;
  byId("link").href = `#${place}`;
}

let isWaiting = false;
function redraw() {
  if (isWaiting) return;
  isWaiting = true;
  requestAnimationFrame(() => {
    isWaiting = false;
    drawNow();
  });
}
function drawNow() {
  drawView();
  if (byId("beside").checked) drawChunks();
  if (byId("show-spectrum").checked) drawSpectrum();
  showTexts();
}

/** Zooms about a place of the canvas, in pixels from its middle. */
function zoomBy(factor, x = 0, y = 0) {
  const zoom = Math.max(12, Math.min(4000, state.zoom * factor));
  move(x / state.zoom - x / zoom, -(y / state.zoom - y / zoom));
  state.zoom = zoom;
  redraw();
}

/** Sets the painted density around a place of the canvas. */
function paint(x, y) {
  const value = Number(byId("brush").value);
  for (let dy = -2; dy <= 2; ++dy)
    for (let dx = -2; dx <= 2; ++dx) {
      const at = [state.at[0] + x / state.zoom + dx / paintCells, state.at[1] - y / state.zoom + dy / paintCells];
      const tile = at.map((v, a) => state.tile[a] + Math.floor(v));
      const cell = at.map((v) => Math.floor((v - Math.floor(v)) * paintCells));
      const key = tile.join(",");
      if (!painted.has(key)) painted.set(key, new Float64Array(paintCells * paintCells).fill(1));
      painted.get(key)[cell[1] * paintCells + cell[0]] = value;
    }
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
  if (byId("painting").checked) paint(...fromMiddle(event));
});
canvas.addEventListener("pointermove", (event) => {
  if (!fingers.has(event.pointerId)) return;
  const [before, now] = [fingers.get(event.pointerId), fromMiddle(event)];
  fingers.set(event.pointerId, now);
  if (byId("painting").checked) return paint(...now);
  if (fingers.size === 2) {
    const other = [...fingers].find(([id]) => id !== event.pointerId)[1];
    const apart = (p) => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
    return zoomBy(apart(now) / apart(before), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
  }
  move((before[0] - now[0]) / state.zoom, (now[1] - before[1]) / state.zoom);
  redraw();
});
for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => fingers.delete(event.pointerId));
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  zoomBy(Math.exp(-event.deltaY / 500), ...fromMiddle(event));
}, { passive: false });
canvas.addEventListener("keydown", (event) => {
  const step = 40 / state.zoom;
  const moves = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] };
  if (moves[event.key]) move(...moves[event.key]);
  else if (event.key === "+") zoomBy(1.25);
  else if (event.key === "-") zoomBy(0.8);
  else if (event.key === "Home") Object.assign(state, { tile: [0, 0], at: [0.5, 0.5] });
  else return;
  event.preventDefault();
  redraw();
});

byId("jump").addEventListener("click", () => {
  state.tile[0] += state.tile[0] + 1e9 > farthest ? -2e9 : 1e9;
  redraw();
});
byId("clear").addEventListener("click", () => {
  painted.clear();
  redraw();
});
byId("seed").addEventListener("input", (event) => {
  state.seed = Number(event.target.value) >>> 0;
  tiling = new PoissonTiles.Tiling(set, state.seed);
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
for (const key of ["borders", "corners"])
  byId(key).addEventListener("change", (event) => {
    state[key] = event.target.checked;
    redraw();
  });
for (const [key, part] of [["beside", "chunks-part"], ["show-spectrum", "spectrum-part"]])
  byId(key).addEventListener("change", (event) => {
    byId(part).hidden = !event.target.checked;
    redraw();
  });
for (const button of document.querySelectorAll("[data-save]"))
  button.addEventListener("click", () => {
    const kind = button.dataset.save;
    const text = fileOf(kind, windowPoints(seenWindow()), byId("command").textContent);
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
    link.download = `points.${kind}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  });
for (const button of document.querySelectorAll("[data-copy]"))
  button.addEventListener("click", () => {
    const shown = byId(button.dataset.copy);
    if (navigator.clipboard) navigator.clipboard.writeText(shown.textContent).catch(() => {});
    getSelection().selectAllChildren(shown);
  });

/** Takes the view from the page's address. */
function readAddress() {
  const given = new URLSearchParams(location.hash.slice(1));
  const pair = (key) => (given.get(key) || "").split(",").map(Number);
  if (pair("tile").length === 2 && pair("tile").every(Number.isInteger)) state.tile = pair("tile").map(wholeTile);
  if (pair("at").length === 2 && pair("at").every((v) => v >= 0 && v < 1)) state.at = pair("at");
  if (Number(given.get("seed"))) state.seed = Number(given.get("seed")) >>> 0;
  if (Number(given.get("zoom"))) state.zoom = Math.max(12, Math.min(4000, Number(given.get("zoom"))));
  if (Number(given.get("density"))) state.density = Math.min(1, Math.max(0, Number(given.get("density"))));
  if (["disks", "distances", "instances"].includes(given.get("look"))) state.look = given.get("look");
  tiling = new PoissonTiles.Tiling(set, state.seed);
  for (const key of ["seed", "density", "look"]) byId(key).value = state[key];
  redraw();
}
addEventListener("hashchange", readAddress);
addEventListener("resize", redraw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
readAddress();
drawNow();
