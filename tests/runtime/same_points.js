// Points by poisson_tiles.js against those of poisson_tiles.h, which a test wrote: see javascript_test.cpp.
//
// Usage: node same_points.js RUNTIME_FILE TILE_SET EXPECTED
// EXPECTED is numbers of 64 bits: cases, each of which begins with seed, period and what is asked:
//   0, count, then i, j, k and the tile's number; 1, low, high (3 each), density, count, then x, y, z, index, id, level, class;
//   2, count, then a position (3), squared distance, place (3) and index.
"use strict";

const fs = require("fs");
const [, , runtime, file, expectedFile] = process.argv;
const { TileSet, Tiling } = require(runtime);
const bytes = fs.readFileSync(expectedFile);
const numbers = new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
const set = new TileSet(fs.readFileSync(file));
let at = 0;
let compared = 0;

function expectSame(found, what) {
  for (const number of found) {
    if (!Object.is(number + 0, numbers[at] + 0)) throw new Error(`${what}: ${number}, expected ${numbers[at]}`);
    ++at;
  }
  ++compared;
}

const take = (count) => Array.from(numbers.subarray(at, (at += count)));
while (at < numbers.length) {
  const [seed, period, kind] = take(3);
  const tiling = new Tiling(set, seed, period);
  if (kind === 0)
    for (let [count] = take(1); count > 0; --count) expectSame([tiling.tile(...take(3))], "tile");
  if (kind === 1) {
    const [low, high, [density, count]] = [take(3), take(3), take(2)];
    const points = tiling.pointsInWindow(low, high, density);
    if (points.length !== count) throw new Error(`${points.length} points, expected ${count}`);
    for (const p of points) expectSame([...p.position, p.index, p.id, p.level, set.classOf(p.index)], "point");
  }
  if (kind === 2)
    for (let [count] = take(1); count > 0; --count) {
      const near = tiling.nearest(take(3));
      expectSame([near.squared, ...near.tile, near.index], "nearest");
    }
}
console.log(compared);
