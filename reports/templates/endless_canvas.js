// The points of an endless tiling on a plain canvas, and what both ways of drawing have in common.
"use strict";

const distanceShown = 1.3; // in minimum distances: what is farther from every point is white

const pointRadius = (minDistance, scale) => Math.max(0.7, 0.275 * minDistance * scale);

const colorOf = (number, count, light) => `hsl(${Math.round((360 * number) / count)} 60% ${light}%)`;

/** The points of each tile by rank; of a set without ranks as they are. */
function pointOrder(set) {
  const n = set.pointsPerTile;
  const order = new Uint16Array(set.tiles * n);
  for (let i = 0; i < order.length; ++i)
    if (set.ranks) order[i - (i % n) + set.ranks[i]] = i % n;
    else order[i] = i % n;
  return order;
}

/** Fits a canvas to its size on the screen. */
function fit(element, ratio) {
  const [width, height] = [element.clientWidth, element.clientHeight].map((v) => Math.max(1, Math.round(v * ratio)));
  if (element.width !== width) element.width = width;
  if (element.height !== height) element.height = height;
}

/** Fits and clears a canvas; gives what is drawn with, in pixels of the page. */
function cleared(element, ratio) {
  fit(element, ratio);
  element.inkColor = getComputedStyle(element).color;
  const context = element.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, element.clientWidth, element.clientHeight);
  return [context, element.clientWidth, element.clientHeight];
}

/** Each pixel, of two by two of the page, as bright as it is far from the nearest point. */
function drawDistances(context, points, { zoom, minDistance }, width, height) {
  const step = 2;
  const reach = (distanceShown * minDistance * zoom) / step;
  const [columns, rows] = [Math.ceil(width / step), Math.ceil(height / step)];
  const squared = new Float32Array(columns * rows).fill(reach ** 2);
  for (const p of points) {
    const [px, py] = [(width / 2 + p.x * zoom) / step - 0.5, (height / 2 - p.y * zoom) / step - 0.5];
    for (let y = Math.max(0, Math.ceil(py - reach)); y <= Math.min(rows - 1, py + reach); ++y)
      for (let x = Math.max(0, Math.ceil(px - reach)); x <= Math.min(columns - 1, px + reach); ++x)
        squared[y * columns + x] = Math.min(squared[y * columns + x], (px - x) ** 2 + (py - y) ** 2);
  }
  const small = document.createElement("canvas");
  [small.width, small.height] = [columns, rows];
  const image = new ImageData(columns, rows);
  squared.forEach((v, n) => image.data.fill((255 * Math.sqrt(v)) / reach, 4 * n, 4 * n + 3));
  for (let n = 3; n < image.data.length; n += 4) image.data[n] = 255;
  small.getContext("2d").putImageData(image, 0, 0);
  context.drawImage(small, 0, 0, columns * step, rows * step);
}

/** Disks, or triangles that are coloured, turned and sized by the points' numbers. */
function drawPoints(context, points, { zoom, minDistance, look }, width, height) {
  const radius = pointRadius(minDistance, zoom);
  for (const p of points) {
    const [x, y] = [width / 2 + p.x * zoom, height / 2 - p.y * zoom];
    context.fillStyle = look === "instances" ? colorOf(p.id & 255, 256, 45) : context.canvas.inkColor;
    context.beginPath();
    if (look === "instances") {
      const { turn, size } = instanceOf(p.id);
      for (let corner = 0; corner < 3; ++corner)
        context.lineTo(x + radius * size * Math.cos(turn + 2.0944 * corner), y - radius * size * Math.sin(turn + 2.0944 * corner));
    } else {
      context.arc(x, y, radius, 0, 2 * Math.PI);
    }
    context.fill();
  }
}
