// Shows the steps of a construction, one at a time: forward, back, or by themselves.
"use strict";

const data = JSON.parse(document.getElementById("steps-data").textContent);
const part = (id) => document.getElementById(id);
const classes = ["surroundings", "outer", "held", "inner"]; // as construction.json has them, in drawing order
let shown = 0;
let timer = null;

// The places of a class of points: [x, y] pairs of the ranges that the step names.
function placesOf(ranges) {
  const places = [];
  for (let i = 0; i < ranges.length; i += 2)
    for (let k = ranges[i]; k < ranges[i + 1]; ++k) places.push([data.places[2 * k], data.places[2 * k + 1]]);
  return places;
}

// Disks that reach across a border of the torus are seen on the other side as well.
function copies(place, radius) {
  const along = (c) => [0, c < radius ? data.side : c > data.side - radius ? -data.side : 0];
  const all = [];
  for (const dx of new Set(along(place[0])))
    for (const dy of new Set(along(place[1]))) all.push([place[0] + dx, place[1] + dy]);
  return all;
}

// The places from which points came: lines from the step before, the short way around.
function ways(step, before) {
  const from = placesOf(before.points[3]);
  const wrapped = (d) => d - data.side * Math.round(d / data.side);
  return placesOf(step.points[3]).map(([x, y], i) => {
    const dx = wrapped(from[i][0] - x);
    const dy = wrapped(from[i][1] - y);
    return `<line class="way" x1="${x}" y1="${data.side - y}" x2="${x + dx}" y2="${data.side - y - dy}"/>`;
  });
}

function drawing(index) {
  const step = data.steps[index];
  const shapes = [];
  step.points.forEach((ranges, kind) => {
    for (const place of placesOf(ranges))
      for (const [x, y] of copies(place, step.radius))
        shapes.push(`<circle class="disk ${classes[kind]}" cx="${x}" cy="${data.side - y}" r="${step.radius}"/>`);
  });
  if (data.moves && index > 0) shapes.push(...ways(step, data.steps[index - 1]));
  const dot = data.side / 130;
  step.points.forEach((ranges, kind) => {
    for (const [x, y] of placesOf(ranges))
      shapes.push(`<circle class="dot ${classes[kind]}" cx="${x}" cy="${data.side - y}" r="${dot}"/>`);
  });
  return `<svg viewBox="0 0 ${data.side} ${data.side}" aria-hidden="true">${shapes.join("")}</svg>`;
}

function show(index) {
  shown = Math.max(0, Math.min(data.steps.length - 1, index));
  const step = data.steps[shown];
  if (step.svg) {
    const image = new Image();
    image.alt = "";
    image.src = "data:image/svg+xml," + encodeURIComponent(step.svg);
    part("stage").replaceChildren(image);
  } else {
    part("stage").innerHTML = drawing(shown);
  }
  part("caption").textContent = `${shown} of ${data.steps.length - 1}: ${step.caption}`;
  part("place").value = String(shown);
  part("first").disabled = part("back").disabled = shown === 0;
  part("last").disabled = part("forward").disabled = shown === data.steps.length - 1;
}

function pause() {
  clearInterval(timer);
  timer = null;
  part("play").textContent = "play";
  part("caption").setAttribute("aria-live", "polite");
}

function play() {
  if (shown === data.steps.length - 1) show(0);
  part("caption").setAttribute("aria-live", "off"); // steps would talk over each other
  part("play").textContent = "pause";
  timer = setInterval(() => {
    show(shown + 1);
    if (shown === data.steps.length - 1) pause();
  }, 1000 / Number(part("speed").value));
}

part("play").addEventListener("click", () => (timer === null ? play() : pause()));
part("speed").addEventListener("change", () => {
  if (timer === null) return;
  pause();
  play();
});
for (const [id, place] of [["first", () => 0], ["back", () => shown - 1], ["forward", () => shown + 1], ["last", () => Infinity]])
  part(id).addEventListener("click", () => {
    pause();
    show(place());
  });
part("place").addEventListener("input", (event) => {
  pause();
  show(Number(event.target.value));
});
part("steps").hidden = false;
show(0);
