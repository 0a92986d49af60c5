// Points by monotile_points.js against those of monotile_points.h, which a test wrote: see monotile_points_test.cpp.
//
// Usage: node same_monotile_points.js RUNTIME_FILE TILE_SET EXPECTED
// EXPECTED is numbers of 64 bits: for each window its seed, origin, low and high corner, density and number of points; then
// x, y, level, id and index of each.
"use strict";

const fs = require("fs");
const [, , runtime, file, expectedFile] = process.argv;
const { MonotileSet } = require(runtime);
const bytes = fs.readFileSync(expectedFile);
const numbers = new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
const set = new MonotileSet(fs.readFileSync(file));
let at = 0;
let compared = 0;
const take = (count) => Array.from(numbers.subarray(at, (at += count)));
while (at < numbers.length) {
  const [seed, x, y, left, bottom, right, top, density, count] = take(9);
  const points = set.pointsInWindow([x, y], [left, bottom], [right, top], density, seed);
  if (points.length !== count) throw new Error(`${points.length} points, expected ${count}`);
  for (const p of points) {
    const found = [...p.position, p.level, p.id, p.index];
    const expected = take(5);
    if (!found.every((number, i) => Object.is(number + 0, expected[i] + 0))) throw new Error(`${found}, expected ${expected}`);
    ++compared;
  }
}
console.log(compared);
