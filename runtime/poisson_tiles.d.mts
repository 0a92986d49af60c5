// SPDX-License-Identifier: MIT-0
//
// Types of poisson_tiles.mjs: those of poisson_tiles.js.
export * from "./poisson_tiles.js";
