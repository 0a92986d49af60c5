// SPDX-License-Identifier: MIT-0
//
// Types of monotile_points.js, which says more. Lengths are in edges.

export as namespace MonotilePoints;

export interface MonotilePoint {
  /** Seen from the window's origin. */
  position: [number, number];
  /** The density, from 0 to 1, above which the point is there. */
  level: number;
  /** 32 random bits that stay with the point, such as for its looks. */
  id: number;
  /** Its number in the tile. */
  index: number;
}

/** The tables of a `.ptiles` file with points in hats or spectres. */
export class MonotileSet {
  /** `bytes`: the file's, all of them. Throws Error, which says what is wrong. Does not check the checksum. */
  constructor(bytes: ArrayBuffer | ArrayBufferView);

  readonly tiling: "hat" | "spectre";
  readonly pointsPerTile: number;
  /** The minimum distance of every window that the file promises; 0: none. */
  readonly minDistance: number;
  /** The power spectrum goes to 0 at least with this power of the frequency, between its peaks. */
  readonly exponent: number;

  /**
   * All points p with low <= p < high along each axis, seen from the origin, and a level below `density`, 1 if it is left out.
   * The origin is two integers up to 2^40, of which the second counts in steps of sqrt(3) for hats.
   */
  pointsInWindow(origin: readonly [number, number], low: readonly [number, number], high: readonly [number, number],
                 density?: number, seed?: number): MonotilePoint[];
}
