// The density that a page's points follow: squares of a grid, painted with a brush or taken from a picture. A square
// has the grey of a picture's pixel, so that the picture that is saved says the same to `poissonlab tiles points`.
"use strict";

/** Of sRGB: the grey that is nearest to a light from 0 to 1. */
const greyOf = (light) =>
  Math.max(0, Math.min(255, Math.round(255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055))));

/** Light of a pixel of a picture, Rec. 709. */
const lightOfPixel = (data, at) =>
  0.2126 * lightOf[data[at]] + 0.7152 * lightOf[data[at + 1]] + 0.0722 * lightOf[data[at + 2]];

/** Squares of the plane, `cells` along each side of a tile; those of tiles that nobody has painted have the density 1.
 *  Tiles are named by their places. */
class PaintedDensity {
  constructor() {
    this.cells = 16;
    this.tiles = new Map();
    this.changes = 0;
  }

  get isEmpty() {
    return this.tiles.size === 0;
  }

  clear() {
    this.tiles.clear();
    ++this.changes;
  }

  set(i, j, column, row, grey) {
    const key = `${i},${j}`;
    if (!this.tiles.has(key)) this.tiles.set(key, new Uint8Array(this.cells * this.cells).fill(255));
    this.tiles.get(key)[row * this.cells + column] = grey;
    ++this.changes;
  }

  grey(i, j, column, row) {
    const tile = this.tiles.get(`${i},${j}`);
    return tile ? tile[row * this.cells + column] : 255;
  }

  /** The density at a place in the square of a tile, 0 <= u, v < 1. */
  at(i, j, u, v) {
    if (this.isEmpty) return 1;
    return lightOf[this.grey(i, j, Math.floor(u * this.cells), Math.floor(v * this.cells))];
  }

  /** The largest density in a window of tiles. */
  most([i, j, width, height]) {
    if (this.tiles.size < width * height) return 1;
    let most = 0;
    for (let y = j; y < j + height; ++y)
      for (let x = i; x < i + width; ++x) {
        const tile = this.tiles.get(`${x},${y}`);
        if (!tile) return 1;
        most = Math.max(most, ...tile);
      }
    return lightOf[most];
  }

  /** Paints a disk: `at` from the lower corner of the tile at a place, all in tiles. */
  paint([i, j], at, radius, light) {
    const grey = greyOf(light);
    const reach = Math.max(0.5, radius * this.cells);
    const middle = at.map((v) => v * this.cells);
    for (let row = Math.floor(middle[1] - reach); row <= middle[1] + reach; ++row)
      for (let column = Math.floor(middle[0] - reach); column <= middle[0] + reach; ++column) {
        if (Math.hypot(column + 0.5 - middle[0], row + 0.5 - middle[1]) > Math.max(0.8, reach)) continue;
        const tile = [column, row].map((c) => Math.floor(c / this.cells));
        this.set(i + tile[0], j + tile[1], column - tile[0] * this.cells, row - tile[1] * this.cells, grey);
      }
  }

  /** Lays a picture, anything that a canvas can draw, over a window of tiles. Its densest place has the density 1, as
   *  for the command. */
  layPicture(picture, [i, j, width, height], isInk) {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [width * this.cells, height * this.cells];
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.fillStyle = isInk ? "#fff" : "#000"; // below what is transparent: nothing
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(picture, 0, 0, canvas.width, canvas.height);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    const lights = Float64Array.from({ length: data.length / 4 }, (_, n) => lightOfPixel(data, 4 * n));
    if (isInk) lights.forEach((light, n) => (lights[n] = Math.max(0, 1 - light)));
    const most = lights.reduce((a, b) => Math.max(a, b), 0) || 1;
    this.clear();
    lights.forEach((light, n) => {
      const [column, row] = [n % canvas.width, canvas.height - 1 - Math.floor(n / canvas.width)];
      const tile = [column, row].map((c) => Math.floor(c / this.cells));
      this.set(i + tile[0], j + tile[1], column % this.cells, row % this.cells, greyOf(light / most));
    });
  }

  /** The density of a window of tiles as a canvas, a pixel a square: `tiles points --density` takes its picture. */
  pictureOf([i, j, width, height]) {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [width * this.cells, height * this.cells];
    const context = canvas.getContext("2d");
    const image = context.createImageData(canvas.width, canvas.height);
    for (let y = 0; y < canvas.height; ++y)
      for (let x = 0; x < canvas.width; ++x) {
        const tile = [x, canvas.height - 1 - y].map((c) => Math.floor(c / this.cells));
        const grey = this.grey(i + tile[0], j + tile[1], x % this.cells, (canvas.height - 1 - y) % this.cells);
        image.data.set([grey, grey, grey, 255], 4 * (y * canvas.width + x));
      }
    context.putImageData(image, 0, 0);
    return canvas;
  }
}
