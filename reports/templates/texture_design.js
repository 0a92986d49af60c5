// The page on which tiles are drawn by hand: all tiles, a window of the endless tiling, and what users do to them.
"use strict";

const byId = (id) => document.getElementById(id);
const tileSet = JSON.parse(byId("set").textContent);
const edgeColors = ["#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
const gap = 10; // between tiles, in pixels of the screen: colours of edges and corners are shown there

const colorBytes = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));
let drawing = new DesignedTiles(tileSet, colorBytes(byId("background").value));
/** Each tile as a picture of its own. */
const pictures = tileSet.tiles.map(() => {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = tileSet.size;
  return canvas;
});

const all = { canvas: byId("tiles"), zoom: 1 };
const plane = { canvas: byId("plane"), zoom: 1, columns: 0, rows: 0 };

/** Puts the pixels of these tiles into their pictures. */
function paint(numbers) {
  for (const number of numbers) {
    const bytes = drawing.bytes(number), context = pictures[number].getContext("2d");
    const image = context.createImageData(tileSet.size, tileSet.size);
    for (let from = 0, to = 0; from < bytes.length; from += 3, to += 4) {
      image.data.set(bytes.subarray(from, from + 3), to);
      image.data[to + 3] = 255;
    }
    context.putImageData(image, 0, 0);
  }
}

const cell = () => tileSet.size * all.zoom + gap;

/** The colours of a tile as bars beside its edges, or as squares at its corners. */
function showColors(context, tile, left, top) {
  const side = tileSet.size * all.zoom, mark = gap / 2 - 1;
  const bar = (color, x, y, width, height) => {
    context.fillStyle = edgeColors[color];
    context.fillRect(left + x, top + y, width, height);
  };
  if (drawing.hasCorners) {
    for (const [corner, [x, y]] of Object.entries(corners)) {
      const across = x ? side - mark : -mark, down = y ? side - mark : -mark, length = 2 * mark;
      bar(tile[corner], across, y ? side : -mark, length, mark);
      bar(tile[corner], x ? side : -mark, down, mark, length);
    }
    return;
  }
  bar(tile.north, 0, -mark, side, mark);
  bar(tile.south, 0, side, side, mark);
  bar(tile.west, -mark, 0, mark, side);
  bar(tile.east, side, 0, mark, side);
}

function showTiles() {
  const { canvas } = all, context = canvas.getContext("2d");
  const room = canvas.parentElement.clientWidth;
  all.zoom = Math.max(1, Math.min(4, Math.floor((room / tileSet.columns - gap) / tileSet.size)));
  [canvas.width, canvas.height] = [tileSet.columns * cell(), tileSet.rows * cell()];
  context.imageSmoothingEnabled = false;
  tileSet.tiles.forEach((tile, number) => {
    const left = tile.column * cell() + gap / 2, top = tile.row * cell() + gap / 2;
    showColors(context, tile, left, top);
    context.drawImage(pictures[number], left, top, tileSet.size * all.zoom, tileSet.size * all.zoom);
  });
}

const seed = () => Number(byId("seed").value) >>> 0;
/** The tile in a column and row of the window, whose lower left one is at (0, 0). */
const tileOfPlane = (column, row) => drawing.tileAt(seed(), column, plane.rows - 1 - row);

function showPlane() {
  const { canvas } = plane, context = canvas.getContext("2d");
  const room = canvas.parentElement.clientWidth;
  plane.columns = Math.max(4, Math.floor(room / tileSet.size));
  plane.rows = Math.max(4, Math.ceil((plane.columns * 3) / 4));
  [canvas.width, canvas.height] = [plane.columns * tileSet.size, plane.rows * tileSet.size];
  for (let row = 0; row < plane.rows; ++row)
    for (let column = 0; column < plane.columns; ++column)
      context.drawImage(pictures[tileOfPlane(column, row)], column * tileSet.size, row * tileSet.size);
  if (!byId("borders").checked) return;
  context.fillStyle = "rgb(128 128 128 / 0.6)";
  for (let column = 1; column < plane.columns; ++column) context.fillRect(column * tileSet.size, 0, 1, canvas.height);
  for (let row = 1; row < plane.rows; ++row) context.fillRect(0, row * tileSet.size, canvas.width, 1);
}

let isAsked = false;
const changed = new Set();
function show(numbers) {
  for (const number of numbers) changed.add(number);
  if (isAsked) return;
  isAsked = true;
  requestAnimationFrame(showNow);
}

function showNow() {
  isAsked = false;
  paint(changed);
  changed.clear();
  showTiles();
  showPlane();
  byId("status").textContent = `${drawing.strokes.length} strokes, ${drawing.marks.length} marks`;
  byId("undo").disabled = drawing.strokes.length === 0;
}

const allNumbers = tileSet.tiles.map((_, number) => number);

/** The place of a pointer in a canvas, in its pixels. */
function placeIn(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return [(event.clientX - box.left) * (canvas.width / box.width), (event.clientY - box.top) * (canvas.height / box.height)];
}

const within = (value, low, high) => Math.max(low, Math.min(high, value));

/** The tile at a place of the picture of all tiles, and the place in it; gaps belong to the nearest tile. */
function inTiles([x, y]) {
  const column = within(Math.floor(x / cell()), 0, tileSet.columns - 1), row = within(Math.floor(y / cell()), 0, tileSet.rows - 1);
  const tile = tileSet.tiles.findIndex((each) => each.column === column && each.row === row);
  const local = (at, number) => within((at - number * cell() - gap / 2) / all.zoom, 0, tileSet.size);
  return tile < 0 ? null : { tile, x: local(x, column), y: local(y, row) };
}

function inPlane([x, y]) {
  const column = Math.floor(x / tileSet.size), row = Math.floor(y / tileSet.size);
  if (column < 0 || row < 0 || column >= plane.columns || row >= plane.rows) return null;
  return { tile: tileOfPlane(column, row), x: x - column * tileSet.size, y: y - row * tileSet.size };
}

/** How a mark looks, by the controls; the pressure of a pen makes it smaller. */
function look(event) {
  const pressure = event.pointerType === "pen" ? Math.max(0.2, event.pressure) : 1;
  const radius = within(Number(byId("radius").value) * pressure, 0.5, drawing.mostRadius);
  const turn = byId("turned").checked ? 2 * Math.PI * Math.random() : 0;
  return { shape: byId("shape").value, radius, color: colorBytes(byId("color").value), turn };
}

/** Shapes other than the disk are stamps: so far apart that each is seen. */
const stepOf = (mark) => (mark.shape === "disk" ? mark.radius / 3 : 2.2 * mark.radius);

let stroke = null;
function mark(event, place) {
  const found = stroke.find(place);
  if (found) show(drawing.add({ ...look(event), ...found }));
}

function begin(event, canvas, find, pixels) {
  canvas.setPointerCapture(event.pointerId);
  drawing.beginStroke();
  stroke = { pointer: event.pointerId, find, pixels, at: placeIn(canvas, event) };
  mark(event, stroke.at);
}

/** Marks on the way to where the pointer is. */
function go(event, canvas) {
  if (!stroke || stroke.pointer !== event.pointerId) return;
  const step = Math.max(0.5, stepOf(look(event))) * stroke.pixels();
  for (const each of event.getCoalescedEvents ? [...event.getCoalescedEvents(), event] : [event]) {
    const [x, y] = placeIn(canvas, each), [fromX, fromY] = stroke.at, far = Math.hypot(x - fromX, y - fromY);
    const steps = Math.floor(far / step);
    for (let i = 1; i <= steps; ++i) mark(each, [fromX + ((x - fromX) * i * step) / far, fromY + ((y - fromY) * i * step) / far]);
    if (steps > 0) stroke.at = [fromX + ((x - fromX) * steps * step) / far, fromY + ((y - fromY) * steps * step) / far];
  }
}

function drawOn(canvas, find, pixels) {
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || stroke) return;
    begin(event, canvas, find, pixels);
    event.preventDefault();
  });
  canvas.addEventListener("pointermove", (event) => go(event, canvas));
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, (event) => {
      if (stroke && stroke.pointer === event.pointerId) stroke = null;
    });
}

function save(bytes, name, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([bytes], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

const nameOfSet = () => byId("name").value.replace(/[^\w-]/g, "_") || "drawn";

/** Marks and background as text, to go on from later. */
function drawingText() {
  const { kind, colors, size, ring } = tileSet;
  return JSON.stringify({ format: "poissonlab drawn tiles", kind, colors, size, ring, background: drawing.background,
    strokes: drawing.strokes, marks: drawing.marks });
}

const isNumber = (value, low, high) => typeof value === "number" && value >= low && value <= high;
const isColor = (color) => Array.isArray(color) && color.length === 3 && color.every((value) => isNumber(value, 0, 255));
const isMark = (m) => Object.hasOwn(shapes, m.shape) && isNumber(m.radius, 0.5, drawing.mostRadius) && isColor(m.color) &&
  isNumber(m.turn, -7, 7) && isNumber(m.x, 0, tileSet.size) && isNumber(m.y, 0, tileSet.size) &&
  Number.isInteger(m.tile) && isNumber(m.tile, 0, tileSet.tiles.length - 1);

/** Takes up a saved drawing; throws an error that says what is wrong with it. */
function openDrawing(text) {
  let saved;
  try {
    saved = JSON.parse(text);
  } catch {
    throw new Error("the file is no drawing of this page");
  }
  if (saved?.format !== "poissonlab drawn tiles") throw new Error("the file is no drawing of this page");
  for (const key of ["kind", "colors", "size", "ring"])
    if (saved[key] !== tileSet[key]) throw new Error(`the drawing has ${key} ${saved[key]}, and this page has ${tileSet[key]}`);
  const { background, marks, strokes } = saved;
  const isWhole = isColor(background) && Array.isArray(marks) && marks.every((m) => m && isMark(m)) && Array.isArray(strokes) &&
    strokes.every((first, i) => Number.isInteger(first) && first >= (i ? strokes[i - 1] : 0) && first <= marks.length);
  if (!isWhole) throw new Error("the drawing is damaged");
  Object.assign(drawing, { background, marks, strokes });
  drawing.redraw();
  byId("background").value = "#" + background.map((value) => Math.round(value).toString(16).padStart(2, "0")).join("");
  show(allNumbers);
}

const textureSet = () => textureSetFile(drawing, nameOfSet());

function say(problem) {
  byId("problem").textContent = problem ? `${problem.message}.` : "";
  byId("problem").hidden = !problem;
}

function listen() {
  drawOn(all.canvas, inTiles, () => all.zoom);
  drawOn(plane.canvas, inPlane, () => 1);
  const undo = () => {
    drawing.undo();
    show(allNumbers);
  };
  byId("undo").addEventListener("click", undo);
  addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() !== "z" || !(event.ctrlKey || event.metaKey)) return;
    event.preventDefault();
    undo();
  });
  byId("clear").addEventListener("click", () => {
    if (drawing.marks.length > 0 && !confirm("Remove everything that is drawn?")) return;
    drawing.clear();
    show(allNumbers);
  });
  byId("background").addEventListener("input", (event) => {
    drawing.background = colorBytes(event.target.value);
    drawing.redraw();
    show(allNumbers);
  });
  byId("radius").max = drawing.mostRadius;
  const showRadius = () => (byId("radius-number").textContent = byId("radius").value);
  byId("radius").addEventListener("input", showRadius);
  showRadius();
  for (const id of ["seed", "borders"]) byId(id).addEventListener("change", () => show([]));
  byId("save-set").addEventListener("click", () =>
    textureSet().then((bytes) => save(bytes, `${nameOfSet()}.zip`, "application/zip")).then(() => say(null), say));
  byId("save").addEventListener("click", () => save(drawingText(), `${nameOfSet()}.json`, "application/json"));
  byId("open").addEventListener("change", (event) => {
    const [file] = event.target.files;
    if (file) file.text().then(openDrawing).then(() => say(null), say);
    event.target.value = "";
  });
  addEventListener("resize", () => show([]));
  addEventListener("beforeunload", (event) => {
    if (drawing.marks.length > 0) event.preventDefault();
  });
}

listen();
show(allNumbers);
