// The page of an endless plane: where the camera is, and what users do.
"use strict";

const byId = (id) => document.getElementById(id);
const about = byId("plane").dataset;
const bytesOf = (element) => Uint8Array.from(atob(element.textContent.trim()), (c) => c.charCodeAt(0));
const canvas = byId("view");

/** Where the camera is: `start`, 0 to 1, in `tile`; angles in degrees, the height in tiles. */
const state = { seed: 1, tile: [0, 0], start: [0.5, 0.5], above: 2, pitch: 15, yaw: 0, field: 60, look: "exact" };
const heights = [0.05, 200];
let plane = null;

const within = (value, [low, high]) => Math.max(low, Math.min(high, value));

/** Moves the camera so many tiles ahead and to the right; tiles and the rest are apart, so nothing is lost far away. */
function move(ahead, right) {
  const yaw = (state.yaw * Math.PI) / 180;
  const by = [Math.sin(yaw) * ahead + Math.cos(yaw) * right, Math.cos(yaw) * ahead - Math.sin(yaw) * right];
  by.forEach((part, a) => {
    const sum = state.start[a] + part;
    state.tile[a] = (state.tile[a] + Math.floor(sum)) | 0;
    state.start[a] = sum - Math.floor(sum);
  });
}

function turn(yaw, pitch) {
  state.yaw = (state.yaw + yaw + 540) % 360 - 180;
  state.pitch = within(state.pitch + pitch, [0, 90]);
}

function lift(factor) {
  state.above = within(state.above * factor, heights);
}

const rounded = (value) => Number(value.toFixed(4));

/** The view that is drawn: numbers have the digits that its command has, so that the command draws the same. */
function shown() {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio].map(Math.round);
  const [above, pitch, yaw] = [state.above, state.pitch, state.yaw].map(rounded);
  return { ...state, start: state.start.map(rounded), above, pitch, yaw, width, height };
}

/** The command that draws a view. Hardware filters of packed atlases are anisotropic, and round weights to 8 bits. */
function commandOf({ tile, start, above, pitch, yaw, field, seed, look, width, height }) {
  const filter = look === "packed" ? "anisotropic --lookup packed" : "mipmap --lookup exact";
  return `poissonlab texture map ${about.name} --size ${width} ${height} --tile ${tile.join(" ")} --start ${start.join(" ")} --above ${above} --pitch ${pitch} --yaw ${yaw} --field ${field} --seed ${seed} --filter ${filter} --out plane.png`;
}

function describe(view) {
  byId("status").textContent = `Above tile (${view.tile.join(", ")}), ${view.above} tiles high, ${view.pitch}° below the horizon, ${view.yaw}° from north`;
  byId("command").textContent = commandOf(view);
}

function drawNow() {
  const view = shown();
  [canvas.width, canvas.height] = [view.width, view.height];
  plane.draw({ ...view, borders: byId("borders").checked });
  describe(view);
}

let isAsked = false;
function redraw() {
  if (isAsked) return;
  isAsked = true;
  requestAnimationFrame(() => {
    isAsked = false;
    drawNow();
  });
}

/** The bytes of a view that is not shown: for tests and for pictures. */
const pixelsOf = (view) => plane.pixels({ ...state, ...view });

let lastFrame = null;
const times = [];
function fly(now) {
  if (!byId("fly").checked) {
    lastFrame = null;
    return;
  }
  if (lastFrame !== null) {
    move(((now - lastFrame) / 1000) * state.above, 0);
    times.push(now - lastFrame);
    if (times.length > 30) times.shift();
    byId("frames").textContent = `${Math.round((1000 * times.length) / times.reduce((a, b) => a + b))} frames a second`;
  }
  lastFrame = now;
  drawNow();
  requestAnimationFrame(fly);
}

const keys = {
  ArrowUp: () => move(state.above / 8, 0), ArrowDown: () => move(-state.above / 8, 0),
  ArrowLeft: () => move(0, -state.above / 8), ArrowRight: () => move(0, state.above / 8),
  "+": () => lift(1 / 1.1), "=": () => lift(1 / 1.1), "-": () => lift(1.1),
};

function listen() {
  canvas.addEventListener("keydown", (event) => {
    if (!keys[event.key]) return;
    keys[event.key]();
    event.preventDefault();
    redraw();
  });
  canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    if (!event.buttons) return;
    const degrees = state.field / canvas.clientHeight;
    turn(-event.movementX * degrees, -event.movementY * degrees);
    redraw();
  });
  canvas.addEventListener("wheel", (event) => {
    lift(1.001 ** event.deltaY);
    event.preventDefault();
    redraw();
  }, { passive: false });
  byId("seed").addEventListener("change", (event) => {
    state.seed = Number(event.target.value) >>> 0;
    redraw();
  });
  byId("look").addEventListener("change", (event) => {
    state.look = event.target.value;
    redraw();
  });
  byId("borders").addEventListener("change", redraw);
  byId("fly").addEventListener("change", () => requestAnimationFrame(fly));
  addEventListener("resize", redraw);
}

function begin() {
  const levels = [...document.querySelectorAll(".level")].map(bytesOf);
  const [colors, size, channels] = [about.colors, about.size, about.channels].map(Number);
  plane = new GlPlane(canvas, { colors, size, channels, levels, lookUp: byId("look-up").textContent });
  if (!plane.layers) byId("look").querySelector("[value=layered]").remove();
  listen();
  redraw();
}

try {
  begin();
} catch (problem) {
  byId("status").textContent = `The plane is not shown: ${problem.message}`;
}
