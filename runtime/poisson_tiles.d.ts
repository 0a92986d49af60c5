// SPDX-License-Identifier: MIT-0
//
// Types of poisson_tiles.js, which says more. Lengths are in tiles, which have side 1.

export as namespace PoissonTiles;

/** Three numbers; in the plane the third is 0, or left out where a function takes places. */
export type Vector = [number, number, number];
export type Place = readonly [number, number] | readonly [number, number, number];

/** The tiles of a `.ptiles` file. */
export class TileSet {
  /** `bytes`: the file's, all of them. Throws Error, which says what is wrong. Does not check the checksum. */
  constructor(bytes: ArrayBuffer | ArrayBufferView);

  /** 0: tiles by colours of corners, 1: by colours of edges, 2: template tiles. */
  readonly kind: 0 | 1 | 2;
  readonly dimension: 2 | 3;
  readonly colors: number;
  /** How many tiles the set has. */
  readonly tiles: number;
  readonly pointsPerTile: number;
  /** The minimum distance of every tiling that the file promises; 0: none. */
  readonly minDistance: number;
  /** The power spectrum of tilings goes to 0 with this power of the frequency, at least. */
  readonly exponent: number;
  /** The stored number u is the coordinate low + step * u, in units of 1/65536 tile. */
  readonly low: number;
  readonly step: number;
  /** Units that points are below and above their tile's square at most, along any axis. */
  readonly below: number;
  readonly above: number;
  /** Of each class the number of its points in a tile; empty: points have no classes. */
  readonly classPoints: readonly number[];
  /** Tile after tile, point after point, x before y before z. */
  readonly points: Uint16Array;
  /** Of each point in its tile; null: the set is not ranked. */
  readonly ranks: Uint16Array | null;

  /** A stored number as a coordinate, from the tile's lowest corner. */
  coordinate(number: number): number;
  /** The class of a point by its index in its tile; 0 where points have none. */
  classOf(index: number): number;
  /** Points of a ranked tile with a rank below this have a level below the density. */
  ranksBelow(density: number): number;
}

export interface TilePoint {
  /** In 2D the last number is 0. */
  position: Vector;
  /** The place of its tile. */
  tile: Vector;
  /** Its number in the tile. */
  index: number;
  /** 32 random bits that stay with the point, such as for its looks. */
  id: number;
  /** The density, from 0 to 1, above which the point is there. */
  level: number;
}

export interface NearestPoint extends TilePoint {
  /** The squared distance. */
  squared: number;
}

/** Which tile is where: every seed is another tiling of the plane, or of space. */
export class Tiling {
  /** `seed`: 32 bits, 1 if it is left out. `period`: it closes after so many tiles along each axis; 0: never. */
  constructor(set: TileSet, seed?: number, period?: number);

  readonly set: TileSet;
  readonly seed: number;
  readonly period: number;

  /** The number of the tile at a place. */
  tile(i: number, j: number, k?: number): number;
  /** Random bits that stay with a point (and its repetitions). */
  id(place: readonly [number, number, number], index: number): number;
  /** The density above which a point is there. `tile`: the number of its tile. */
  level(place: readonly [number, number, number], tile: number, index: number): number;
  /** A point of the tile at a place, whose number is `tile`. */
  pointAt(place: Vector, tile: number, index: number): TilePoint;
  /** All points p with low <= p < high along each axis and a level below `density`, 1 if it is left out. */
  pointsInWindow(low: Place, high: Place, density?: number): TilePoint[];
  /** The point that is nearest to a position. */
  nearest(position: Place): NearestPoint;
}

/** The hash that says which tile is where. All numbers are of 32 bits. */
export function hash(seed: number, x: number, y: number, z: number): number;
