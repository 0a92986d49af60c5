// Recursive Wang tiles in JavaScript: the tile set, places without end, and the points of windows, which are those of
// host/tile_sampling/recursive/recursive_plane.cpp. Kopf, Cohen-Or, Deussen and Lischinski, SIGGRAPH 2006.
"use strict";

const farthestTile = 2 ** 52;
const deepestLevel = 1000;

/** A tile along one axis: `base`, a tile of level 0, and digits from 0 to 3, as many as the level. */
const Address = {
  parse(text) {
    const parts = /^(-?\d+)(?::([0-3]{1,1000}))?$/.exec(text);
    if (!parts || Math.abs(Number(parts[1])) > farthestTile) return null;
    return { base: Number(parts[1]), digits: Array.from(parts[2] || "", Number) };
  },
  text: ({ base, digits }) => (digits.length > 0 ? `${base}:${digits.join("")}` : `${base}`),
  /** Moved by so many tiles of its own level. */
  moved({ base, digits }, tiles) {
    const to = digits.slice();
    for (let i = to.length - 1; i >= 0 && tiles !== 0; --i) {
      tiles += to[i];
      to[i] = ((tiles % 4) + 4) % 4;
      tiles = Math.floor(tiles / 4);
    }
    return { base: Math.max(-farthestTile, Math.min(farthestTile, base + tiles)), digits: to };
  },
  /** Its number among all tiles of its level, which has as many digits as it needs. */
  number: ({ base, digits }) => digits.reduce((sum, digit) => 4n * sum + BigInt(digit), BigInt(base)),
  /** The lowest 32 bits of that. */
  low: ({ base, digits }) => digits.reduce((sum, digit) => ((sum << 2) | digit) >>> 0, base >>> 0),
};

/** The tile set of a file of recursive Wang tiles. */
class RecursiveSet {
  /** `byColors`: the number of the tile for each four bits of its colours: north, east, south, west. */
  constructor(bytes, byColors) {
    const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const n = (this.pointsPerTile = data.getUint32(8, true));
    this.byColors = Array.from(byColors, Number);
    this.children = [];
    this.links = new Uint16Array(8 * 16 * n);
    for (let tile = 0, at = 20; tile < 8; ++tile) {
      this.children.push(bytes.slice(at, at + 16));
      at += 16;
      for (let i = 0; i < 16 * n; ++i, at += 2) this.links[tile * 16 * n + i] = data.getUint16(at, true);
    }
    // Places of tiles' own points, in units of 2^-32: every round makes two more bits right.
    let own = new Uint32Array(8 * n * 2);
    for (let round = 0; round < 16; ++round) {
      const next = new Uint32Array(own.length);
      for (let tile = 0; tile < 8; ++tile)
        for (let k = 0; k < n; ++k) next.set(this.placeBy(tile, k, own), 2 * (tile * n + k));
      own = next;
    }
    this.own = own;
    /** For each cell of each tile, by rank: the places of points in the cell, and their ranks in the tile. */
    this.cellPoints = new Uint32Array(8 * 16 * n * 4);
    const filled = new Uint32Array(8 * 16);
    for (let tile = 0; tile < 8; ++tile)
      for (let rank = 0; rank < 16 * n; ++rank) {
        const { cell, point } = this.link(tile, rank);
        const from = 2 * (this.children[tile][cell] * n + point);
        const segment = tile * 16 + cell;
        this.cellPoints.set([own[from], own[from + 1], rank, 0], 4 * (segment * n + filled[segment]++));
      }
  }

  /** The number of points of a cell with a rank below this. */
  ranksBelow(segment, rank) {
    const n = this.pointsPerTile;
    let [low, high] = [0, n];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.cellPoints[4 * (segment * n + middle) + 2] < rank) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  link(tile, rank) {
    const word = this.links[tile * 16 * this.pointsPerTile + rank];
    return { cell: word >> 12, point: word & 4095 };
  }

  placeBy(tile, rank, own) {
    const { cell, point } = this.link(tile, rank);
    const at = 2 * (this.children[tile][cell] * this.pointsPerTile + point);
    return [(((cell & 3) << 30) | (own[at] >>> 2)) >>> 0, (((cell >> 2) << 30) | (own[at + 1] >>> 2)) >>> 0];
  }
}

const cellTurns = [0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5];
const wholeTurn = 2 ** 32;
const turnOfCell = (cell, turn) => Math.floor((cellTurns[cell] * wholeTurn + turn) / 16);

/** The tiling of the plane that a seed gives. */
class RecursivePlane {
  constructor(set, seed) {
    this.set = set;
    this.random = new PoissonTiles.Tiling(null, seed);
  }

  bit(x, y) {
    const high = (v) => Math.floor(v / wholeTurn) >>> 0;
    return this.random.id([x, y, high(x)], high(y)) & 1;
  }

  /** The tile of level 0 at a place, and when it gets its next point. */
  root(x, y) {
    const [sw, se, nw, ne] = [this.bit(x, y), this.bit(x + 1, y), this.bit(x, y + 1), this.bit(x + 1, y + 1)];
    const tile = this.set.byColors[((nw ^ ne) << 3) | ((se ^ ne) << 2) | ((sw ^ se) << 1) | (sw ^ nw)];
    const digit = (v, level) => ((Math.floor(v / 4 ** level) % 4) + 4) % 4;
    let turn = wholeTurn;
    for (let level = 7; level >= 0; --level) turn = turnOfCell(digit(x, level) | (digit(y, level) << 2), turn);
    return { tile, turn };
  }

  /** Random bits that stay with a point: the lowest bits of its tile's numbers, the level, the rank there. */
  bits(lowX, lowY, level, rank) {
    return this.random.id([lowX, lowY, level], rank);
  }

  /** Calls visit(level, block, above) for each level down to that of a window { corner: [x, y], size: [w, h] }. A block has the
   *  tiles of the level that meet the window, in rows: { size, digit, tiles, turns, low }; `digit` is where the lowest one
   *  lies in the tile above, `low` are the lowest 32 bits of its numbers. `above` is the block before, null at first. */
  eachLevel({ corner, size }, visit) {
    const deepest = corner[0].digits.length;
    const sizes = [size];
    const digit = (level) => corner.map((address) => (level > 0 ? address.digits[level - 1] : 0));
    for (let level = deepest; level > 0; --level)
      sizes.unshift(sizes[0].map((n, k) => Math.floor((digit(level)[k] + n - 1) / 4) + 1));
    let above = null;
    for (let level = 0; level <= deepest; ++level) {
      const [columns, rows] = sizes[level];
      const block = { size: sizes[level], digit: digit(level), tiles: new Uint8Array(columns * rows), turns: new Float64Array(columns * rows) };
      block.low = above ? above.low.map((low, k) => ((low << 2) | block.digit[k]) >>> 0) : corner.map(({ base }) => base >>> 0);
      for (let j = 0; j < rows; ++j)
        for (let i = 0; i < columns; ++i) {
          let from;
          if (above) {
            const [x, y] = [i + block.digit[0], j + block.digit[1]];
            const parent = (y >> 2) * above.size[0] + (x >> 2);
            const cell = (x & 3) | ((y & 3) << 2);
            from = { tile: this.set.children[above.tiles[parent]][cell], turn: turnOfCell(cell, above.turns[parent]) };
          } else {
            from = this.root(corner[0].base + i, corner[1].base + j);
          }
          block.tiles[j * columns + i] = from.tile;
          block.turns[j * columns + i] = from.turn;
        }
      visit(level, block, above);
      above = block;
    }
  }

  /** The points of a window: { x, y } in its tiles from the lowest corner, and { bits, threshold }: the points per tile of
   *  the window's level from which on it is there, which is at most `perTile` times the weight from 0 to 1 there. */
  points({ corner, size }, perTile, weightAt = () => 1) {
    const { set } = this;
    const n = set.pointsPerTile;
    const deepest = corner[0].digits.length;
    const digits = (level) => (level <= deepest ? corner.map((a) => a.digits[level - 1]) : [0, 0]);
    const sizes = [];
    const lows = [];
    let nodes = [];
    this.eachLevel({ corner, size }, (level, block) => {
      sizes.push(block.size);
      lows.push(block.low);
      if (level === 0) block.tiles.forEach((tile, i) => nodes.push({ tile, x: i % block.size[0], y: Math.floor(i / block.size[0]), turn: block.turns[i] }));
    });
    const has = (level, x, y) => level > deepest || (x >= 0 && y >= 0 && x < sizes[level][0] && y < sizes[level][1]);
    const found = [];
    for (let level = 0; nodes.length > 0; ++level) {
      if (level > deepest) lows.push(lows[level - 1].map((low) => (low << 2) >>> 0));
      const most = perTile * 16 ** (deepest - level); // points per tile of this level
      const next = [];
      for (const { tile, x, y, turn } of nodes) {
        for (let rank = level > 0 ? n : 0; rank < 16 * n && rank + turn / wholeTurn <= most; ++rank) {
          let { cell, point } = set.link(tile, rank);
          let holder = tile;
          let [px, py, at] = [x, y, level];
          do {
            holder = set.children[holder][cell];
            const [dx, dy] = digits(++at);
            [px, py] = [4 * px + (cell & 3) - dx, 4 * py + (cell >> 2) - dy];
            if (!has(at, px, py)) break;
            if (at < deepest) ({ cell, point } = set.link(holder, point));
          } while (at < deepest);
          if (!has(at, px, py)) continue;
          const scale = 4 ** (at - deepest);
          const place = 2 * (holder * n + point);
          const [u, v] = [(px + set.own[place] / wholeTurn) / scale, (py + set.own[place + 1] / wholeTurn) / scale];
          const threshold = (rank + turn / wholeTurn) * 16 ** (level - deepest); // 0 far above the window
          const weight = weightAt(u, v);
          if (weight === 0 || threshold > perTile * weight) continue;
          found.push({ x: u, y: v, threshold, bits: this.bits((lows[level][0] + x) >>> 0, (lows[level][1] + y) >>> 0, level, rank) });
        }
        if (most / 16 < n) continue;
        for (let cell = 0; cell < 16; ++cell) {
          const [dx, dy] = digits(level + 1);
          const [cx, cy] = [4 * x + (cell & 3) - dx, 4 * y + (cell >> 2) - dy];
          if (has(level + 1, cx, cy)) next.push({ tile: set.children[tile][cell], x: cx, y: cy, turn: turnOfCell(cell, turn) });
        }
      }
      nodes = next;
    }
    return found;
  }
}
