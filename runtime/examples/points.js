// SPDX-License-Identifier: MIT-0
//
// Points from a tile set file: those in a window as text, and the one that is nearest to the window's middle.
//
//   node points.js FILE X Y W H [DENSITY]     (in 3D the window is one tile deep)
"use strict";

const fs = require("fs");
const { TileSet, Tiling } = require("../poisson_tiles.js");

const [file, ...numbers] = process.argv.slice(2);
const [x, y, width, height, density = 1] = numbers.map(Number);
const tiling = new Tiling(new TileSet(fs.readFileSync(file)), 1, 0); // the seed, and no period

for (const point of tiling.pointsInWindow([x, y, 0], [x + width, y + height, 1], density))
  console.log(point.position.join(" "));
const near = tiling.nearest([x + width / 2, y + height / 2, 0.5]);
console.log(`# nearest to the middle: ${near.position.join(" ")}, number ${near.index} of its tile`);
