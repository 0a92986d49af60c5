// SPDX-License-Identifier: MIT-0
//
// Poisson disk (sphere) distributions without end, from a tile set file, in JavaScript: the look-ups of poisson_tiles.h,
// to the last bit. A script for pages (then it is PoissonTiles) and for node (then require() gives it).
//
//     const tiling = new PoissonTiles.Tiling(new PoissonTiles.TileSet(bytes), seed);
//     for (const point of tiling.pointsInWindow([0, 0], [16, 9])) draw(point.position);
//
// docs/tile-set-file.md describes the file. Tiles have side 1, the tile (i, j, k) has its lowest corner there; positions
// are from -2^31 + 2 to 2^31 - 3 along each axis.
"use strict";

const PoissonTiles = (() => {
  const magic = [0x50, 0x54, 0x49, 0x4c, 0x45, 0x53, 13, 10];

  /** How many tiles a set has that knows so many colours. Template tiles: any number. */
  const tileCount = (kind, dimension, colors) => colors ** (kind === 1 ? 12 : 2 ** dimension);

  /** The tiles: what a file says, and where its points are. Nothing is copied. */
  class TileSet {
    /** `bytes`: an ArrayBuffer or a view of one. Throws Error, which says what is wrong. Does not check the checksum. */
    constructor(bytes) {
      const view = ArrayBuffer.isView(bytes) ? bytes : new Uint8Array(bytes);
      const data = new DataView(view.buffer, view.byteOffset, view.byteLength);
      const size = view.byteLength;
      const word = (at) => data.getUint32(at, true);
      const check = (holds, problem) => {
        if (!holds) throw new Error(problem);
      };
      check(size >= 128, "shorter than the header of a tile set file");
      check(magic.every((byte, i) => data.getUint8(i) === byte), "not a tile set file");
      const version = word(8);
      check(version >= 1 && version <= 3 && word(12) === 128, "an unknown version of the file format");
      this.kind = word(16); // 0: by colours of corners, 1: by colours of edges, 2: template tiles
      this.dimension = word(20);
      this.colors = word(24);
      this.tiles = word(28);
      this.pointsPerTile = word(32);
      const of2 = (at) => (version > 1 ? word(at) : 0);
      const chains = of2(88);
      const ranked = of2(108);
      // The number u is the coordinate low + step * u, in units of 1/65536.
      this.low = chains ? -32768 : 0;
      this.step = chains ? 2 : 1;
      // Units that points are below or above their tile's square at most, along any axis.
      this.below = of2(100);
      this.above = of2(104);
      check(ranked <= 1 && chains <= 1 && this.below <= 32768 && this.above <= 32768,
            "an unknown kind of borders or ranks");
      check(this.kind <= 2 && (this.dimension === 2 || (this.dimension === 3 && this.kind === 0)),
            "an unknown kind of tiles");
      check(this.colors > 0 && this.tiles > 0 && this.pointsPerTile > 0 && this.pointsPerTile <= 65536 &&
                (this.kind === 2 || this.tiles === tileCount(this.kind, this.dimension, this.colors)),
            "numbers of colours, tiles and points that do not fit together");
      /** The minimum distance of every tiling that the file promises, in tiles; 0: none. */
      this.minDistance = Math.sqrt(word(40) + 2 ** 32 * word(44)) / 65536;
      /** The power spectrum of tilings goes to 0 with this power of the frequency, at least. */
      this.exponent = 2 * (of2(112) + 1);
      const points = this.tiles * this.pointsPerTile;
      const beforeRanks = points * this.dimension + (chains ? 2 * this.colors * this.colors : 0);
      const end = 128 + 2 * (beforeRanks + (ranked ? points : 0));
      const classes = version > 2 ? word(36) : 0;
      // Then come the number of points of each class, and two distances of each pair of classes, which are not read.
      check(classes <= 32 && (version < 3 || classes > 0) && size === end + 4 * classes + 8 * classes * (classes + 1),
            "too short or too long for its points");
      this.classPoints = Array.from({ length: classes }, (_, i) => word(end + 4 * i)); // empty: points have no classes
      check(classes === 0 || this.classPoints.reduce((sum, n) => sum + n) === this.pointsPerTile,
            "classes that have not all points of a tile");
      const numbers = (first, count) => {
        const at = view.byteOffset + 128 + 2 * first;
        if (at % 2 === 0 && new Uint8Array(new Uint16Array([1]).buffer)[0] === 1)
          return new Uint16Array(view.buffer, at, count);
        return Uint16Array.from({ length: count }, (_, i) => data.getUint16(128 + 2 * (first + i), true));
      };
      this.points = numbers(0, points * this.dimension); // tile after tile, point after point, x before y before z
      this.ranks = ranked ? numbers(beforeRanks, points) : null;
    }

    /** A number as a coordinate, in tiles from the tile's lowest corner. */
    coordinate(number) {
      return (this.low + this.step * number) / 65536;
    }

    /** The class of a point by its index in its tile, where points come class after class; 0 where they have none. */
    classOf(index) {
      let of = 0;
      for (; of + 1 < this.classPoints.length && index >= this.classPoints[of]; ++of) index -= this.classPoints[of];
      return of;
    }

    /** Points of a ranked tile with a rank below this have a level below the density. */
    ranksBelow(density) {
      const n = this.pointsPerTile;
      let rank = density >= 1 ? n : density > 0 ? Math.floor(density * n) : 0;
      while (rank > 0 && (rank - 0.5) / n >= density) --rank;
      while (rank < n && (rank + 0.5) / n < density) ++rank;
      return rank;
    }
  }

  function mix(v) {
    v = Math.imul(v ^ (v >>> 16), 0x21f0aaad);
    v = Math.imul(v ^ (v >>> 15), 0xd35a2d97);
    return (v ^ (v >>> 15)) >>> 0;
  }

  const hash = (seed, x, y, z) => mix(mix(mix(mix(seed) + x) + y) + z);

  /** The squared distance along an axis of `f`, in the tile 0, from where points of a tile so far away can be. */
  function gap(f, offset, below, above) {
    const away = offset > 0 ? offset - below - f : offset < 0 ? f - (offset + 1 + above) : 0;
    return away > 0 ? away * away : 0;
  }

  /** Which tile is where: every seed, of 32 bits, gives another tiling. */
  class Tiling {
    /** `period`: it closes after so many tiles along each axis; 0: never. */
    constructor(set, seed = 1, period = 0) {
      this.set = set;
      this.seed = seed >>> 0;
      this.period = period;
    }

    /** A place as the hash function takes it, and those after and before it. */
    place(i) {
      return this.period === 0 ? i >>> 0 : ((i % this.period) + this.period) % this.period;
    }
    after(x) {
      return x + 1 === this.period ? 0 : (x + 1) >>> 0;
    }
    before(x) {
      return ((x === 0 ? this.period : x) - 1) >>> 0;
    }

    /** The colour at a lattice point: of the corner (x, y, z), or of the edge that goes east (z = 0) or north (z = 1). */
    color(x, y, z = 0) {
      return hash(this.seed, x, y, z) % this.set.colors;
    }

    corners(x, y, z) {
      const c = this.set.colors;
      const [east, north] = [this.after(x), this.after(y)];
      const tile = this.color(east, north, z) * c + this.color(east, y, z);
      return (tile * c + this.color(x, y, z)) * c + this.color(x, north, z);
    }

    edges(x, y) {
      const [east, west, north, south] = [this.after(x), this.before(x), this.after(y), this.before(y)];
      const edges = [[x, north, 0], [east, y, 1], [x, y, 0], [x, y, 1], [east, north, 0], [east, north, 1],
                     [east, y, 0], [east, south, 1], [west, y, 0], [x, south, 1], [west, north, 0], [x, north, 1]];
      return edges.reduce((tile, edge) => tile * this.set.colors + this.color(...edge), 0);
    }

    /** The number of the tile at a place; k is 0 in 2D. */
    tile(i, j, k = 0) {
      const [x, y, z] = [this.place(i), this.place(j), this.place(k)];
      const set = this.set;
      if (set.kind === 2) return hash(this.seed, x, y, 0) % set.tiles;
      if (set.kind === 1) return this.edges(x, y);
      if (set.dimension === 2) return this.corners(x, y, 0);
      return this.corners(x, y, this.after(z)) * set.colors ** 4 + this.corners(x, y, z);
    }

    /** Random bits that stay with a point (and its repetitions). */
    id(place, index) {
      const [x, y, z] = place.map((i) => this.place(i));
      return mix(hash(this.seed, x, y, z) + 1 + index);
    }

    /** The density, from 0 to 1, above which a point is there. `tile`: the number of its tile. */
    level(place, tile, index) {
      const set = this.set;
      if (set.ranks) return (set.ranks[tile * set.pointsPerTile + index] + 0.5) / set.pointsPerTile;
      return this.id(place, index) / 4294967296;
    }

    /** The point of the tile at a place (3 numbers), whose number is `tile`. */
    pointAt(place, tile, index) {
      const set = this.set;
      const first = (tile * set.pointsPerTile + index) * set.dimension;
      const position = [0, 0, 0];
      for (let a = 0; a < set.dimension; ++a) position[a] = place[a] + set.coordinate(set.points[first + a]);
      return { position, tile: place, index, id: this.id(place, index), level: this.level(place, tile, index) };
    }

    /** All points p with low <= p < high along each axis and a level below `density`, in the order of poisson_tiles.h:
     *  rows of tiles from south to north (3D: layers from the bottom), in each from west to east. */
    pointsInWindow(low, high, density = 1) {
      const set = this.set;
      const [d, n] = [set.dimension, set.pointsPerTile];
      const ranks = density < 1 ? set.ranks : null;
      const ranksBelow = set.ranksBelow(density);
      const first = [0, 0, 0];
      const last = [0, 0, 0];
      for (let a = 0; a < d; ++a) {
        first[a] = Math.floor(low[a] - set.above / 65536);
        last[a] = Math.floor(high[a] + set.below / 65536);
      }
      const found = [];
      for (let k = first[2]; k <= last[2]; ++k)
        for (let j = first[1]; j <= last[1]; ++j)
          for (let i = first[0]; i <= last[0]; ++i) {
            const at = [i, j, k];
            const tile = this.tile(i, j, k);
            for (let index = 0; index < n; ++index) {
              if (ranks && ranks[tile * n + index] >= ranksBelow) continue;
              let inside = true;
              for (let a = 0; a < d; ++a) {
                const x = at[a] + set.coordinate(set.points[(tile * n + index) * d + a]);
                inside = inside && x >= low[a] && x < high[a];
              }
              if (!inside || (density < 1 && !ranks && this.level(at, tile, index) >= density)) continue;
              found.push(this.pointAt(at, tile, index));
            }
          }
      return found;
    }

    /** The point that is nearest to a position, with `squared`, its squared distance; of several the one in the tile
     *  that is visited first: rings of tiles around that of the position, as long as they can have a nearer point. */
    nearest(position) {
      const set = this.set;
      const d = set.dimension;
      const [below, above, step] = [set.below / 65536, set.above / 65536, set.step / 65536];
      const home = [0, 0, 0];
      const f = [0, 0, 0];
      let border = 1;
      for (let a = 0; a < d; ++a) {
        home[a] = Math.floor(position[a]);
        f[a] = position[a] - home[a];
        border = Math.min(border, f[a], 1 - f[a]);
      }
      let squared = 1e300;
      let best = null;
      const visit = (offset) => {
        const place = home.map((h, a) => h + offset[a]);
        const tile = this.tile(...place);
        let limit = squared / (step * step);
        let index = -1;
        for (let n = 0; n < set.pointsPerTile; ++n) {
          let sum = 0;
          for (let a = 0; a < d; ++a) {
            const at = (f[a] - offset[a] - set.low / 65536) / step;
            const difference = set.points[(tile * set.pointsPerTile + n) * d + a] - at;
            sum += difference * difference;
          }
          if (sum >= limit) continue;
          limit = sum;
          index = n;
        }
        if (index < 0) return;
        squared = limit * (step * step);
        best = this.pointAt(place, tile, index);
      };
      for (let ring = 0; ; ++ring) {
        const away = border + ring - 1 - Math.max(below, above);
        if (ring > 0 && away > 0 && away * away >= squared) break;
        const layers = d === 3 ? ring : 0;
        for (let k = -layers; k <= layers; ++k)
          for (let j = -ring; j <= ring; ++j) {
            const outer = j === -ring || j === ring || (d === 3 && (k === -ring || k === ring));
            for (let i = -ring; i <= ring; i += outer || ring === 0 ? 1 : 2 * ring)
              if (gap(f[0], i, below, above) + gap(f[1], j, below, above) + gap(f[2], k, below, above) < squared)
                visit([i, j, k]);
          }
      }
      return { ...best, squared };
    }
  }

  return { TileSet, Tiling, hash };
})();

if (typeof module !== "undefined") module.exports = PoissonTiles;
