// Oracle of glsl_es_test.js and wgsl_test.js: the words that their pixels must have, by poisson_tiles.js, which is the C
// header to the last bit.
"use strict";

const placesSide = 1024;
const nearestSide = 128;

/** The number of pixels (x, y) of a square of this side whose words, four each, `isOther(x, y, first)` refuses. */
function refusedPixels(side, isOther) {
  let refused = 0;
  for (let y = 0; y < side; ++y)
    for (let x = 0; x < side; ++x) if (isOther(x, y, 4 * (y * side + x))) ++refused;
  return refused;
}

/** The number of a million places where tile, point, random bits or level are others than the words say. */
function otherPlaces(set, seed, period, words) {
  const tiling = new PoissonTiles.Tiling(set, seed, period);
  const n = set.pointsPerTile;
  return refusedPixels(placesSide, (x, y, first) => {
    const at = [x * 1000003 - 500000000, y * 999983 - 400000000, set.dimension === 3 ? x - y : 0];
    const tile = tiling.tile(...at);
    const index = (x * 31 + y) % n;
    const units = [0, 1, 2].map((a) => (a < set.dimension ? set.points[(tile * n + index) * set.dimension + a] : 0));
    const expected = [tile, (units[0] + units[2] + 65536 * units[1]) >>> 0, tiling.id(at, index),
                      Math.floor(tiling.level(at, tile, index) * 2 * n)];
    return expected.some((word, k) => word !== words[first + k]);
  });
}

/** The number of 16,384 positions with another nearest point, and how much distances differ at most. */
function otherNearest(set, words) {
  const tiling = new PoissonTiles.Tiling(set, 3, 0);
  const distances = new Float32Array(words.buffer);
  let worst = 0;
  const others = refusedPixels(nearestSide, (x, y, first) => {
    const at = [x * 1000 - 64000 + (x % 11) / 16, y * 77 - 5000 + (y % 13) / 16, set.dimension === 3 ? 0.25 : 0];
    const nearest = tiling.nearest(at);
    worst = Math.max(worst, Math.abs(distances[first + 2] - Math.sqrt(nearest.squared)));
    return nearest.index !== words[first] || nearest.id !== words[first + 1];
  });
  return [others, worst];
}
