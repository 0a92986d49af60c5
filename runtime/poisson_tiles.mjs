// SPDX-License-Identifier: MIT-0
//
// poisson_tiles.js for `import`. Node finds no names in a module that exports one value; here they are.
import PoissonTiles from "./poisson_tiles.js";

export const { TileSet, Tiling, hash } = PoissonTiles;
