// Points of a window by the installed package poissonlab-runtime, against those that `poissonlab tiles points` wrote.
//
// Usage: node npm_package.js TILE_SET SEED DENSITY EXPECTED.npy WINDOW...
const { TileSet, Tiling } = require("poissonlab-runtime");

const fs = require("fs");
const [name, seed, density, expectedFile, ...words] = process.argv.slice(2);
const window = words.map(Number);
const axes = window.length / 2;
const low = window.slice(0, axes);
const high = low.map((x, a) => x + window[axes + a]);

const file = require.resolve(`poissonlab-runtime/tile_sets/${name}.ptiles`);
const tiling = new Tiling(new TileSet(fs.readFileSync(file)), Number(seed));
const points = tiling.pointsInWindow(low, high, Number(density));

const bytes = fs.readFileSync(expectedFile); // NumPy's format 1.0: the length of the header at 8, then float64
const begin = 10 + bytes.readUInt16LE(8);
const count = (bytes.length - begin) / (8 * axes);
if (count < 100 || points.length !== count) throw new Error(`${points.length} points, expected ${count}`);
points.forEach((point, i) => {
  for (let a = 0; a < axes; ++a) {
    const expected = bytes.readDoubleLE(begin + 8 * (i * axes + a));
    if (point.position[a] - low[a] !== expected) throw new Error(`point ${i}: ${point.position}, expected ${expected}`);
  }
});
