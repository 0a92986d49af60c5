// runtime/test_vectors.csv by poisson_tiles.js, as a port would read it.
//
// Usage: node test_vectors.js RUNTIME_FOLDER
"use strict";

const fs = require("fs");
const runtime = process.argv[2];
const { TileSet, Tiling } = require(`${runtime}/poisson_tiles.js`);
const [names, ...rows] = fs.readFileSync(`${runtime}/test_vectors.csv`, "utf8").trim().split("\n").map((line) => line.split(","));
for (const row of rows) {
  const v = Object.fromEntries(row.map((text, i) => [names[i], i > 0 ? Number(text) : text]));
  const bytes = fs.readFileSync(`${runtime}/tile_sets/${v.set}.ptiles`);
  const set = new TileSet(bytes);
  if (set.minDistance !== Math.sqrt(Number(bytes.readBigUInt64LE(40))) / 65536 || !(set.minDistance > 0))
    throw new Error(`${v.set}: ${set.minDistance}`);
  if (set.exponent !== 2 * ((bytes[8] > 1 ? bytes.readUInt32LE(112) : 0) + 1)) throw new Error(`${v.set}: ${set.exponent}`);
  const tiling = new Tiling(set, v.seed, v.period);
  const place = [v.i, v.j, v.k];
  const tile = tiling.tile(...place);
  const point = tiling.pointAt(place, tile, v.index);
  const near = tiling.nearest(place.map((p, a) => p + [v.fx, v.fy, v.fz][a] / 65536));
  const found = [tile, ...point.position.map((p, a) => (p - place[a]) * 65536), point.id, point.level, ...near.tile, near.index,
                 near.id, Math.sqrt(near.squared)];
  const expected = [v.tile, v.x, v.y, v.z, v.id, v.level, v.near_i, v.near_j, v.near_k, v.near_index, v.near_id, v.near_distance];
  expected.forEach((value, i) => {
    if (found[i] !== value) throw new Error(`${row}: ${found[i]}, expected ${value}`);
  });
}
console.log(`${rows.length} lines`);
if (rows.length < 90) throw new Error("too few");
