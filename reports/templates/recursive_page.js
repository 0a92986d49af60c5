// The page of recursive Wang tiles: what is seen, what is painted, and what users do.
"use strict";

const byId = (id) => document.getElementById(id);
const canvas = byId("view");
const about = byId("recursive").dataset;
const set = new RecursiveSet(Uint8Array.from(atob(byId("tiles").textContent.trim()), (c) => c.charCodeAt(0)), about.colors);
const plane = new RecursivePlane(set, Number(about.seed));
const drawing = new RecursiveDrawing(canvas, plane, true);
const leastZoom = 96; // pixels of a tile of level 0
const tileZooms = [128, 512]; // pixels of a tile of any other level
const levelsAbove = 3; // whose points are looked at one by one: lights of 8 bits are no darker than 1 / 16^3
const mostSaved = 200000; // points in a file

/** What is seen: the middle of the view lies at `at`, 0 to 1, in a tile of any level, which is `zoom` pixels wide. */
const state = { tile: [], at: [0.5, 0.5], zoom: 256 };
const level = () => state.tile[0].digits.length;

/** The place of the view's middle in a tile of another level: { address, at } along each axis, and the tile's pixels. */
function middleAt(wanted) {
  const axes = state.tile.map((address, k) => placeAt(address, state.at[k], wanted));
  return { axes, pixels: state.zoom * 4 ** (level() - wanted) };
}

/** A place in a tile as one in the tile of another level there. */
function placeAt({ base, digits }, at, wanted) {
  const to = digits.slice(0, wanted);
  for (let i = digits.length - 1; i >= wanted; --i) at = (at + digits[i]) / 4;
  while (to.length < wanted) {
    to.push(Math.min(3, Math.floor(4 * at)));
    at = 4 * at - to[to.length - 1];
  }
  return { address: { base, digits: to }, at };
}

function move(x, y) {
  [x, y].forEach((by, k) => {
    const sum = state.at[k] + by;
    state.tile[k] = Address.moved(state.tile[k], Math.floor(sum));
    state.at[k] = sum - Math.floor(sum);
  });
}

/** Zooms about a place of the canvas, in pixels from its middle, y upwards. Tiles are never much larger than the view:
 *  then a smaller one is named, so that no zoom is too deep for numbers. */
function zoomBy(factor, x = 0, y = 0) {
  const most = tileZooms[1] / (state.zoom * 4 ** (level() - deepestLevel));
  const zoom = state.zoom * Math.min(most, Math.max(leastZoom / (state.zoom * 4 ** level()), factor));
  move(x / state.zoom - x / zoom, y / state.zoom - y / zoom);
  state.zoom = zoom;
  const goTo = (wanted) => {
    const { axes, pixels } = middleAt(wanted);
    state.tile = axes.map(({ address }) => address);
    state.at = axes.map(({ at }) => at);
    state.zoom = pixels;
  };
  while (state.zoom >= tileZooms[1] && level() < deepestLevel) goTo(level() + 1);
  while (state.zoom < tileZooms[0] && level() > 0) goTo(level() - 1);
}

const spacing = () => Number(byId("spacing").value);
/** Points per tile of the state's level, where the density is 1. */
const perTile = () => (state.zoom / spacing()) ** 2;
const stampPixels = () => Number(byId("stamp-size").value) * spacing();

/** The tiles of a level that the view meets: their lowest one, how many, and its corner from the middle in such tiles. */
function tilesInView(wanted, margin) {
  const { axes, pixels } = middleAt(wanted);
  const halves = [canvas.clientWidth, canvas.clientHeight].map((v) => (v / 2 + margin) / pixels);
  const first = axes.map(({ at }, k) => Math.floor(at - halves[k]));
  return {
    corner: axes.map(({ address }, k) => Address.moved(address, first[k])),
    size: axes.map(({ at }, k) => Math.floor(at + halves[k]) - first[k] + 1),
    offset: axes.map(({ at }, k) => first[k] - at),
    pixels,
  };
}

/** What is drawn: cells of tiles, each with the points that it has by their ranks in its tile. Each level has its points
 *  from its own threshold on, so that none is drawn twice; those of tiles far above are all there. */
function partsOf() {
  const n = set.pointsPerTile;
  const demandAt = (l) => perTile() * 16 ** (level() - l);
  let last = 0; // the level whose points are coming, or are there but not yet whole
  while (demandAt(last + 1) > n && last + 1 < deepestLevel) ++last;
  const top = Math.max(0, last - 1 - levelsAbove);
  const view = tilesInView(last + 1, stampPixels());
  const offsets = [];
  offsets[last + 1] = view.offset;
  for (let l = last + 1; l > top + 1; --l)
    offsets[l - 1] = offsets[l].map((v, k) => (v - view.corner[k].digits[l - 1]) / 4);
  const parts = [];
  plane.eachLevel(view, (l, block, above) => {
    if (l <= top) return;
    const demand = demandAt(l - 1);
    const firstRank = l - 1 > top ? n : 0;
    for (let j = 0; j < block.size[1]; ++j)
      for (let i = 0; i < block.size[0]; ++i) {
        const [x, y] = [i + block.digit[0], j + block.digit[1]];
        const [px, py] = [x >> 2, y >> 2];
        const parent = py * above.size[0] + px;
        const segment = above.tiles[parent] * 16 + ((x & 3) | ((y & 3) << 2));
        const turn = above.turns[parent] / wholeTurn;
        const first = set.ranksBelow(segment, firstRank);
        const count = set.ranksBelow(segment, Math.floor(demand - turn) + 1) - first;
        if (count <= 0) continue;
        parts.push({
          segment, first, count, firstRank, turn, demand, level: l - 1,
          offset: [offsets[l][0] + i, offsets[l][1] + j],
          pixels: view.pixels * 4 ** (last + 1 - l),
          low: [(above.low[0] + px) >>> 0, (above.low[1] + py) >>> 0],
        });
      }
  });
  return parts;
}

/** The painted layer: greys of a grid over whole tiles of a level, and the grey of all other places. */
const painted = { ground: 255, layer: null };

/** Lays a layer over the view and a quarter of it on each side, with some 512 squares along its longer side. */
function newLayer() {
  let wanted = 0;
  while (middleAt(wanted).pixels > Math.max(canvas.clientWidth, canvas.clientHeight) / 8 && wanted < deepestLevel) ++wanted;
  const { corner, size } = tilesInView(wanted, Math.max(canvas.clientWidth, canvas.clientHeight) / 4);
  const cells = Math.max(1, Math.floor(512 / Math.max(...size)));
  const [columns, rows] = size.map((v) => v * cells);
  painted.layer = { corner, size, cells, columns, rows, greys: new Uint8Array(columns * rows).fill(painted.ground), isNew: true };
}

/** A place as one of the layer, 0 to 1 along each axis where it is in it. */
function placeInLayer(addresses, ats) {
  const { corner, size } = painted.layer;
  return addresses.map((address, k) => {
    const place = placeAt(address, ats[k], corner[k].digits.length);
    return (Number(Address.number(place.address) - Address.number(corner[k])) + place.at) / size[k];
  });
}

/** The weight of places of a window, from its lowest corner in its tiles. */
function weightIn({ corner }) {
  const { layer, ground } = painted;
  if (!layer) return () => lightOf[ground];
  const from = placeInLayer(corner, [0, 0]);
  const scale = layer.size.map((n, k) => 4 ** (layer.corner[k].digits.length - corner[k].digits.length) / n);
  return (x, y) => {
    const [u, v] = [from[0] + x * scale[0], from[1] + y * scale[1]];
    if (!(u >= 0 && u < 1 && v >= 0 && v < 1)) return lightOf[ground];
    return lightOf[layer.greys[Math.floor(v * layer.rows) * layer.columns + Math.floor(u * layer.columns)]];
  };
}

/** The layer for drawing: where the middle of the view lies in it, and how much of it a pixel is. */
function layerInView() {
  const { layer } = painted;
  if (!layer) return null;
  const { corner, size } = layer;
  const { pixels } = middleAt(corner[0].digits.length);
  return { at: placeInLayer(state.tile, state.at), scale: size.map((n) => 1 / (n * pixels)) };
}

/** Paints around a place of the canvas, in pixels from its middle, y upwards. */
function paint(x, y) {
  if (!painted.layer) newLayer();
  const { layer } = painted;
  const { at, scale } = layerInView();
  const [u, v] = [(at[0] + x * scale[0]) * layer.columns, (at[1] + y * scale[1]) * layer.rows];
  const reach = Math.max(0.5, Number(byId("brush-size").value) * scale[0] * layer.columns);
  const grey = greyOf(Number(byId("brush").value));
  const isHere = u > -reach && v > -reach && u < layer.columns + reach && v < layer.rows + reach;
  byId("said").textContent = isHere ? "" : "The painted sheet lies elsewhere: an empty or a full one begins here";
  for (let row = Math.max(0, Math.floor(v - reach)); row <= Math.min(layer.rows - 1, v + reach); ++row)
    for (let column = Math.max(0, Math.floor(u - reach)); column <= Math.min(layer.columns - 1, u + reach); ++column)
      if (Math.hypot(column + 0.5 - u, row + 0.5 - v) <= Math.max(0.8, reach)) layer.greys[row * layer.columns + column] = grey;
  layer.isNew = true;
  redraw();
}

/** A new sheet: all of the plane has this grey. */
function newSheet(ground) {
  Object.assign(painted, { ground, layer: null });
  redraw();
}

/** The layer as a picture: `--density` takes it. */
function layerPicture() {
  if (!painted.layer) newLayer();
  const { columns, rows, greys } = painted.layer;
  const picture = Object.assign(document.createElement("canvas"), { width: columns, height: rows });
  const image = new ImageData(columns, rows);
  greys.forEach((grey, i) => image.data.set([grey, grey, grey, 255], 4 * ((rows - 1 - Math.floor(i / columns)) * columns + (i % columns))));
  picture.getContext("2d").putImageData(image, 0, 0);
  return picture;
}

/** The window of whole tiles that the view meets. */
const seenWindow = () => {
  const { corner, size } = tilesInView(level(), 0);
  return { corner, size };
};
const windowPoints = (window) => plane.points(window, perTile(), weightIn(window));

function csvOf(points, stamps) {
  const isTurned = about.turned === "1";
  const row = ({ x, y, bits }) =>
    `${x},${y},${(bits & 255) % stamps},${isTurned ? (((bits >>> 8) & 255) * 2 * Math.PI) / 256 : 0},${0.7 + (0.6 * ((bits >>> 16) & 255)) / 255}\n`;
  return `x,y,stamp,turn,size\n${points.map(row).join("")}`;
}

let isDue = false;
function redraw() {
  if (!isDue) requestAnimationFrame(drawNow);
  isDue = true;
}

function drawNow() {
  drawPicture();
  showWords();
}

function drawPicture() {
  isDue = false;
  const ratio = window.devicePixelRatio || 1;
  fit(canvas, ratio);
  drawOn(drawing, ratio);
}

/** Draws the view by a drawing whose canvas has so many pixels along a pixel of the page. */
function drawOn(where, ratio) {
  const { layer } = painted;
  if (layer && (layer.isNew || where !== drawing)) where.setLayer(Float32Array.from(layer.greys, (grey) => lightOf[grey]), layer.columns, layer.rows);
  if (layer && where === drawing) layer.isNew = false;
  where.draw({ seed: plane.random.seed, parts: partsOf(), ratio, stampPixels: stampPixels(), isTurned: about.turned === "1", layer: layerInView(), ground: lightOf[painted.ground] });
}

let transparent = null;
/** The view without paper, in a canvas of its own. */
function transparentPicture() {
  transparent ??= new RecursiveDrawing(document.createElement("canvas"), plane, false);
  Object.assign(transparent.canvas, { width: canvas.width, height: canvas.height });
  const [all, part] = stampsNow();
  if (all.length > 0) transparent.setStamps(all, part);
  else if (!transparent.stamps) transparent.setStamps([dotStamp(getComputedStyle(canvas).color)], 0.5 / 0.85);
  drawOn(transparent, window.devicePixelRatio || 1);
  return transparent;
}

function showWords() {
  const doublings = 2 * level() + Math.log2(state.zoom / 256);
  const perRoot = level() === 0 ? perTile().toFixed(1) : `2^${(Math.log2(perTile()) + 4 * level()).toFixed(1)}`;
  byId("status").textContent = `Level ${level()}, magnified 2^${doublings.toFixed(1)} times; a tile of level 0 has ${perRoot} points`;
  const { corner, size } = seenWindow();
  const points = Math.round(perTile() * size[0] * size[1]);
  const fits = points > 0 && points <= 2 ** 24 && Math.max(...size) <= 256;
  byId("command").textContent = fits ? `poissonlab ${about.command} --x ${Address.text(corner[0])} --y ${Address.text(corner[1])} --size ${size[0]} ${size[1]} --points ${points} --out points.csv` : "";
  byId("link").href = `#x=${Address.text(state.tile[0])}&y=${Address.text(state.tile[1])}&at=${state.at.join(",")}&zoom=${state.zoom}`;
  for (const slider of ["spacing", "stamp-size", "brush", "brush-size"]) byId(`${slider}-number`).textContent = byId(slider).value;
}

/** Takes the view from the page's address. */
function readAddress() {
  const words = new URLSearchParams(location.hash.slice(1) || about.place);
  const [x, y] = ["x", "y"].map((name) => Address.parse(words.get(name) || "0"));
  if (!x || !y || x.digits.length !== y.digits.length) {
    byId("said").textContent = "The address of this page names no place";
    return false;
  }
  const at = (words.get("at") || "0.5,0.5").split(",").map(Number);
  const zoom = Number(words.get("zoom") || 256);
  state.tile = [x, y];
  state.at = at.length === 2 && at.every((v) => v >= 0 && v < 1) ? at : [0.5, 0.5];
  state.zoom = zoom > 0 && zoom < 1e9 ? zoom : 256;
  zoomBy(1);
  redraw();
  return true;
}
