// SPDX-License-Identifier: MIT-0
//
// Points without end from one tile that never repeats, hats or spectres, in JavaScript: those of monotile_points.h, to the
// last bit. A script for pages (then it is MonotilePoints) and for node (then require() gives it).
//
//     const set = new MonotilePoints.MonotileSet(bytes);
//     for (const point of set.pointsInWindow([0, 0], [0, 0], [16, 9])) draw(point.position);
//
// docs/tile-set-file.md describes the file; monotile_points.h says what places of windows mean.
"use strict";

const MonotilePoints = (() => {
  const magic = [0x50, 0x54, 0x49, 0x4c, 0x45, 0x53, 13, 10];
  const divisions = 32;
  const mostParts = 16;
  const rootOfThree = 16751367537235082715147169n; // sqrt(3) times 2^83

  function mix(v) {
    v = Math.imul(v ^ (v >>> 16), 0x21f0aaad);
    v = Math.imul(v ^ (v >>> 15), 0xd35a2d97);
    return (v ^ (v >>> 15)) >>> 0;
  }

  /** Turns a number a + b z + c z^2 + d z^3, z a twelfth of a turn, by some sixths of a turn. */
  function turned([a, b, c, d], sixths) {
    for (; sixths > 0; --sixths) [a, b, c, d] = [-c, -d, a + c, b + d];
    return [a, b, c, d];
  }

  class MonotileSet {
    /** `bytes`: an ArrayBuffer or a view of one. Throws Error, which says what is wrong. Does not check the checksum. */
    constructor(bytes) {
      const view = ArrayBuffer.isView(bytes) ? bytes : new Uint8Array(bytes);
      const data = new DataView(view.buffer, view.byteOffset, view.byteLength);
      const size = view.byteLength;
      const word = (at) => data.getUint32(at, true);
      const half = (at) => data.getUint16(at, true);
      const check = (holds, problem) => {
        if (!holds) throw new Error(problem);
      };
      check(size >= 128, "shorter than the header of a tile set file");
      check(magic.every((byte, i) => data.getUint8(i) === byte), "not a tile set file");
      check(word(8) === 4 && word(12) === 128, "not version 4 of the file format");
      check(word(16) === 3 && word(20) === 2 && word(24) <= 1, "an unknown kind of tiles");
      /** "hat" or "spectre". */
      this.tiling = ["hat", "spectre"][word(24)];
      const [t, n] = [word(28), word(32)];
      const [p, s] = [word(48), word(52)];
      this.flips = word(56);
      this.odd = word(60);
      check(n >= 1 && n <= mostParts && t >= 1 && t <= 65536 && p >= 1 && p <= 1048576 && s >= 1 && s <= 8 &&
                this.flips <= 1 && this.odd === (word(24) ? 1 : 3) && word(80) === divisions,
            "numbers of states, parts and points that do not fit together");
      check(size === 128 + 16 * (n + s + p) + 8 * t + 8 * t * n + 2 * p * n, "too short or too long for its points");
      this.pointsPerTile = n;
      /** The minimum distance of every window that the file promises, in edges; 0: none. */
      this.minDistance = Math.sqrt(word(40) + 2 ** 32 * word(44)) / 65536;
      /** The power spectrum goes to 0 at least with this power of the frequency, between its peaks. */
      this.exponent = 2;
      const record = (at) => ({
        state: word(at),
        at: [4, 6, 8, 10].map((i) => data.getInt16(at + i, true)),
        turn: half(at + 12),
        order: half(at + 14),
      });
      const records = (first, count) => Array.from({ length: count }, (_, i) => record(first + 16 * i));
      const start = 128 + 16 * n;
      const [part, state] = [start + 16 * s, start + 16 * (s + p)];
      const place = state + 8 * t;
      const rank = place + 8 * t * n;
      this.starts = records(start, s);
      this.parts = records(part, p);
      this.ranks = Uint16Array.from({ length: p * n }, (_, i) => half(rank + 2 * i));
      const own = [];
      this.states = Array.from({ length: t }, (_, i) => {
        own.push(half(state + 8 * i + 6));
        return { first: word(state + 8 * i), count: half(state + 8 * i + 4) };
      });
      this.checkStates(check, own);
      check(this.starts.every((tile) => this.isRight(tile)), "tiles around the origin that do not fit together");
      check(this.states.reduce((sum, { count }) => sum + count, 0) === p, "tiles that do not fit together");
      /** The places of points in their tiles, in units of 2^-16, as numbers of the ring. */
      this.places = Array.from({ length: t * n }, (_, i) => {
        const x = data.getInt32(place + 8 * i, true);
        const mirrored = own[Math.floor(i / n)] & 2;
        const y = (mirrored ? -1 : 1) * data.getInt32(place + 8 * i + 4, true);
        check(Math.max(Math.abs(x), Math.abs(y)) <= 1048576, "tiles that do not fit together");
        return own[Math.floor(i / n)] & 1 ? [-y, x, y, 0] : [x, 0, 0, y];
      });
      this.findLevels(check, Array.from({ length: 16 }, (_, i) => data.getInt8(64 + i)));
    }

    isRight(tile) {
      return tile.state < this.states.length && tile.turn <= 5 && tile.at.every((x) => Math.abs(x) <= 64);
    }

    /** Parts follow those of the state before; orders and ranks have each number once. */
    checkStates(check, own) {
      const problem = "states whose parts or ranks do not fit together";
      const n = this.pointsPerTile;
      const each = (numbers) => numbers.every((x) => x < numbers.length) && new Set(numbers).size === numbers.length;
      let next = 0;
      this.states.forEach(({ first, count }, i) => {
        check(first === next && count <= mostParts && count <= this.parts.length - first && own[i] <= 3, problem);
        const parts = this.parts.slice(first, first + count);
        check(parts.every((part) => this.isRight(part)) && each(parts.map((part) => part.order)) &&
                  each(Array.from(this.ranks.subarray(first * n, (first + count) * n))),
              problem);
        next += count;
      });
    }

    /** Computes the images of places and the reach of tiles, level after level. */
    findLevels(check, growth) {
      const problem = "tiles that do not fit together";
      const longest = (places) => Math.sqrt(places.reduce((most, at) => Math.max(most, this.squared(at)), 0));
      this.powers = [Array.from({ length: 16 }, (_, i) => (i % 5 === 0 ? 1 : 0))];
      this.reach = [longest(this.places) / 65536];
      for (let level = 1, tiles = 5; level <= divisions; ++level, tiles *= 5) {
        const reach = this.reach[level - 1] + longest(this.parts.map(({ at }) => this.image(level - 1, at)));
        this.reach.push(reach);
        check(tiles <= 64 * (1 + reach * reach), problem);
        if (level === divisions) break;
        check(growth.every((g) => Math.abs(g) <= 8), problem);
        this.powers.push([0, 4, 8, 12].map((i) => this.image(level - 1, growth.slice(i, i + 4))).flat());
        check(this.powers[level].every((x) => Math.abs(x) <= 2 ** 47), problem);
      }
    }

    /** The image of a place after some divisions. */
    image(level, place) {
      const m = this.powers[level];
      return [0, 1, 2, 3].map((j) => m[j] * place[0] + m[4 + j] * place[1] + m[8 + j] * place[2] + m[12 + j] * place[3]);
    }

    /** Twice a coordinate: whole + root * sqrt(3). */
    twice([a, b, c, d], axis) {
      const even = axis ? c : b;
      const other = axis ? b + 2 * d : 2 * a + c;
      if (this.odd === 1) return [other, even];
      return axis ? [0, even + other] : [other + 3 * b, 0];
    }

    rough(place, axis) {
      const [whole, root] = this.twice(place, axis);
      return (whole + 1.7320508075688772 * root) / 2;
    }

    squared(place) {
      return this.rough(place, 0) ** 2 + this.rough(place, 1) ** 2;
    }

    /** A coordinate of a tile, in units of 2^-32: sums of large numbers whose rest is small, modulo 2^64. */
    fixed(place, axis) {
      const [whole, root] = this.twice(place, axis);
      const product = (rootOfThree * BigInt(Math.abs(root))) >> 52n;
      return Number(BigInt.asIntN(64, (root < 0 ? -product : product) + BigInt(whole) * 2147483648n));
    }

    /** A coordinate of a place in a tile, which is in units of 2^-16, in units of 2^-32. */
    fixedPart(place, axis) {
      const [whole, root] = this.twice(place, axis);
      return whole * 32768 + Math.trunc(root * 56755.84086241697);
    }

    /**
     * All points p with low <= p < high along each axis, seen from the origin, whose two coordinates are integers from -2^40
     * to 2^40, and a level below `density`. Windows are from -2^20 to 2^20.
     */
    pointsInWindow(origin, low, high, density = 1, seed = 1) {
      const found = [];
      for (let axis = 0; axis < 2; ++axis)
        if (!(low[axis] >= -1048576 && high[axis] <= 1048576 && low[axis] < high[axis] &&
              Math.abs(origin[axis]) <= 2 ** 40 && Number.isInteger(origin[axis])))
          return found;
      // Tilings have fewer than half a tile to visit on each unit of area, and few more on the way there. Tables that lie
      // must not make a search without end.
      const visits = 100000 + 50 * (high[0] - low[0] + 2 * this.reach[0]) * (high[1] - low[1] + 2 * this.reach[0]);
      const window = { low, high, density, found, visits };
      this.starts.forEach((tile, i) => {
        const at = this.image(divisions - 1, this.image(1, tile.at));
        const hash = mix((mix(seed >>> 0) + i) >>> 0);
        this.walk(window, {
          state: tile.state, turn: tile.turn, at: [at[0] - origin[0], at[1], at[2], at[3] - origin[1]],
          hash, threshold: hash, part: 0, ofPart: 1, whole: 0,
        }, divisions);
      });
      return found;
    }

    isNear({ low, high }, tile, level) {
      let squared = 0;
      for (let axis = 0; axis < 2; ++axis) {
        const x = this.rough(tile.at, axis);
        squared += Math.max(low[axis] - x, x - high[axis], 0) ** 2;
      }
      return squared <= (this.reach[level] * (1 + 1e-9) + 0.01) ** 2;
    }

    walk(window, tile, level) {
      if (--window.visits < 0 || !this.isNear(window, tile, level)) return;
      if (level === 0) {
        this.addPoints(window, tile);
        return;
      }
      const { first, count } = this.states[tile.state];
      const turn = this.flips ? (6 - tile.turn) % 6 : tile.turn;
      for (let i = 0; i < count; ++i) {
        const part = this.parts[first + i];
        const image = this.image(level - 1, turned(part.at, turn));
        const order = (part.order + (tile.hash % count)) % count;
        this.walk(window, {
          state: part.state, turn: (turn + part.turn) % 6, at: tile.at.map((x, k) => x + image[k]),
          hash: mix((tile.hash + i + 1) >>> 0), threshold: Math.floor((order * 2 ** 32 + tile.threshold) / count),
          part: first + i, ofPart: count, whole: tile.threshold,
        }, level - 1);
      }
    }

    addPoints({ low, high, density, found }, tile) {
      const n = this.pointsPerTile;
      const base = [this.fixed(tile.at, 0), this.fixed(tile.at, 1)];
      for (let index = 0; index < n; ++index) {
        const place = turned(this.places[tile.state * n + index], tile.turn);
        const position = base.map((x, axis) => (x + this.fixedPart(place, axis)) / 2 ** 32);
        const rank = this.ranks[tile.part * n + index];
        const level = Math.floor((rank * 2 ** 32 + tile.whole) / (tile.ofPart * n)) / 2 ** 32;
        if (position.some((x, axis) => !(x >= low[axis] && x < high[axis])) || level >= density) continue;
        found.push({ position, level, id: mix((tile.hash + Math.imul(0x9e3779b9, index + 1)) >>> 0), index });
      }
    }
  }

  return { MonotileSet };
})();

if (typeof module !== "undefined") module.exports = MonotilePoints;
