// Hand-drawn tiles: marks, which tiles each of them belongs to, and the pixels of these tiles.
"use strict";

/** The sides of a tile: the two corners at their ends, and the step to the tile beyond. */
const sides = {
  north: { ends: ["nw", "ne"], step: [0, -1], facing: "south" },
  east: { ends: ["se", "ne"], step: [1, 0], facing: "west" },
  south: { ends: ["sw", "se"], step: [0, 1], facing: "north" },
  west: { ends: ["sw", "nw"], step: [-1, 0], facing: "east" },
};
/** The places of corners, in sides of a tile; y goes down. */
const corners = { ne: [1, 0], se: [1, 1], sw: [0, 1], nw: [0, 0] };

/** The hash of runtime/texture_tiles.h. */
function mix(v) {
  v = Math.imul(v ^ (v >>> 16), 0x21f0aaad);
  v = Math.imul(v ^ (v >>> 15), 0xd35a2d97);
  return (v ^ (v >>> 15)) >>> 0;
}

/** Distances from the border of each shape, of size 1, to (x, y); negative inside. */
const shapes = {
  disk: (x, y) => Math.hypot(x, y) - 1,
  square: (x, y) => Math.max(Math.abs(x), Math.abs(y)) - Math.SQRT1_2,
  triangle: (x, y) => Math.max(0.5 * y + 0.8660254037844386 * Math.abs(x), -y) - 0.5,
  leaf: (x, y) => Math.hypot(Math.abs(x) + 0.75, y) - 1.25,
};

/**
 * A set of tiles by the colours of their edges or corners, and the marks on them.
 *
 * A mark is a shape around a place in a tile, and reaches no farther than its radius. One that comes into the ring of a side
 * belongs to the side's colours: it is in every tile with them at this side, and, a tile's width away, at the side that faces
 * it. One that comes into the rings of two sides belongs to the corner between them, and is at every corner of its colour;
 * of edge tiles all corners are alike. So tiles whose colours fit show the same marks on both sides of their border.
 */
class DesignedTiles {
  constructor(set, background) {
    Object.assign(this, { set, size: set.size, ring: set.ring, background, marks: [], strokes: [] });
    this.places = new Map(set.tiles.map((tile, number) => [this.colorsKey(tile), number]));
    this.bySide = new Map();
    this.byCorner = new Map();
    const add = (map, key, value) => (map.has(key) ? map.get(key).push(value) : map.set(key, [value]));
    set.tiles.forEach((tile, number) => {
      for (const side of Object.keys(sides)) add(this.bySide, `${side} ${this.sideColors(tile, side)}`, number);
      for (const corner of Object.keys(corners)) add(this.byCorner, this.cornerColor(tile, corner), [number, corner]);
    });
    this.clear();
  }

  get hasCorners() {
    return this.set.kind === "corner";
  }

  colorsKey(tile) {
    return (this.hasCorners ? Object.keys(corners) : Object.keys(sides)).map((part) => tile[part]).join(" ");
  }

  sideColors(tile, side) {
    return this.hasCorners ? sides[side].ends.map((corner) => tile[corner]).join(" ") : String(tile[side]);
  }

  cornerColor(tile, corner) {
    return this.hasCorners ? tile[corner] : 0;
  }

  /** The largest radius of marks: none comes into the rings of two sides that face each other. */
  get mostRadius() {
    return Math.floor(this.size / 2 - this.ring - 1);
  }

  clear() {
    this.marks = [];
    this.strokes = [];
    this.restart();
  }

  restart() {
    const pixels = this.size * this.size;
    this.values = this.set.tiles.map(() => {
      const values = new Float32Array(3 * pixels);
      for (let i = 0; i < values.length; ++i) values[i] = this.background[i % 3];
      return values;
    });
  }

  /** Where a mark is drawn: numbers of tiles, with its place in each. */
  drawnAt(mark) {
    const reach = mark.radius + 1 + this.ring, { x, y, tile } = mark;
    const across = x < reach ? "west" : x > this.size - reach ? "east" : null;
    const along = y < reach ? "north" : y > this.size - reach ? "south" : null;
    if (!across && !along) return [[tile, x, y]];
    if (across && along) return this.atCorners(mark, along[0] + across[0]);
    return this.atSides(mark, across || along);
  }

  atCorners({ x, y, tile }, corner) {
    const [left, top] = corners[corner].map((part) => part * this.size);
    return this.byCorner.get(this.cornerColor(this.set.tiles[tile], corner)).map(([number, other]) => {
      const [toLeft, toTop] = corners[other].map((part) => part * this.size);
      return [number, x - left + toLeft, y - top + toTop];
    });
  }

  atSides({ x, y, tile }, side) {
    const { step, facing } = sides[side], colors = this.sideColors(this.set.tiles[tile], side);
    const beyond = (this.bySide.get(`${facing} ${colors}`) || []);
    return [
      ...this.bySide.get(`${side} ${colors}`).map((number) => [number, x, y]),
      ...beyond.map((number) => [number, x - step[0] * this.size, y - step[1] * this.size]),
    ];
  }

  /** Places are sixteenths of a pixel, so that a mark is the same to the last bit wherever it is drawn. */
  add(mark) {
    const exact = { ...mark, x: Math.round(16 * mark.x) / 16, y: Math.round(16 * mark.y) / 16 };
    this.marks.push(exact);
    return this.draw(exact);
  }

  /** Draws a mark, and returns the tiles that have changed. */
  draw(mark) {
    const changed = new Set();
    for (const [number, x, y] of this.drawnAt(mark)) {
      this.drawIn(this.values[number], mark, x, y);
      changed.add(number);
    }
    return changed;
  }

  drawIn(values, { shape, radius, color, turn }, x, y) {
    const sine = Math.sin(turn), cosine = Math.cos(turn), distance = shapes[shape], last = this.size - 1;
    const from = (at) => Math.max(0, Math.floor(at - radius - 1)), to = (at) => Math.min(last, Math.ceil(at + radius));
    for (let row = from(y); row <= to(y); ++row)
      for (let column = from(x); column <= to(x); ++column) {
        const across = (column + 0.5 - x) / radius, down = (row + 0.5 - y) / radius;
        const far = distance(cosine * across + sine * down, cosine * down - sine * across) * radius;
        const share = Math.max(0, Math.min(1, 0.5 - far));
        if (share === 0) continue;
        const at = 3 * (row * this.size + column);
        for (let channel = 0; channel < 3; ++channel)
          values[at + channel] += (color[channel] - values[at + channel]) * share;
      }
  }

  beginStroke() {
    this.strokes.push(this.marks.length);
  }

  undo() {
    if (this.strokes.length === 0) return;
    this.marks.length = this.strokes.pop();
    this.redraw();
  }

  redraw() {
    this.restart();
    for (const mark of this.marks) this.draw(mark);
  }

  /** The bytes of a tile, three a pixel. */
  bytes(number) {
    return Uint8Array.from(this.values[number], (value) => Math.round(value));
  }

  colorAt(seed, x, y, isVertical) {
    return mix(mix(mix(mix(seed) + x) + y) + (this.hasCorners ? 0 : isVertical)) % this.set.colors;
  }

  /** The tile at a place of the endless tiling, as `texture tile` has it; y goes up. */
  tileAt(seed, x, y) {
    const at = (dx, dy, isVertical) => this.colorAt(seed, (x + dx) >>> 0, (y + dy) >>> 0, isVertical);
    const colors = this.hasCorners ? [at(1, 1), at(1, 0), at(0, 0), at(0, 1)]
      : [at(0, 1, 0), at(1, 0, 1), at(0, 0, 0), at(0, 0, 1)];
    return this.places.get(colors.join(" "));
  }

  /**
   * Where each pixel of a tile has its source in the atlas: pixels of the ring in the first tile with the side's colours, those
   * in the rings of two sides in the first with the corner's (edge tiles: those of the nearer side).
   */
  sourceOf(number, column, row) {
    const last = this.size - 1, tile = this.set.tiles[number];
    const toSide = { north: row, east: last - column, south: last - row, west: column };
    const near = Object.keys(sides).filter((side) => toSide[side] < this.ring);
    if (near.length === 0) return [number, column, row];
    if (near.length === 2 && this.hasCorners) {
      const corner = near.find((side) => sides[side].step[0] === 0)[0] + near.find((side) => sides[side].step[1] === 0)[0];
      const [first] = this.byCorner.get(tile[corner]).find(([, place]) => place === corner);
      return [first, column, row];
    }
    // North and south come before east and west where two are as near.
    const nearest = ["north", "south", "east", "west"].filter((side) => near.includes(side))
      .reduce((best, side) => (toSide[side] < toSide[best] ? side : best));
    return [this.bySide.get(`${nearest} ${this.sideColors(tile, nearest)}`)[0], column, row];
  }

  /** The atlas, and the column and row in it of every pixel's source, both row after row. */
  pictures() {
    const { columns, rows, tiles } = this.set, size = this.size, width = columns * size;
    const atlas = new Uint8Array(3 * width * rows * size), sources = new Uint16Array(atlas.length);
    tiles.forEach((tile, number) => {
      const bytes = this.bytes(number);
      for (let row = 0; row < size; ++row)
        for (let column = 0; column < size; ++column) {
          const at = 3 * ((tile.row * size + row) * width + tile.column * size + column), from = 3 * (row * size + column);
          const [source, x, y] = this.sourceOf(number, column, row);
          for (let channel = 0; channel < 3; ++channel) atlas[at + channel] = bytes[from + channel];
          sources[at] = tiles[source].column * size + x;
          sources[at + 1] = tiles[source].row * size + y;
        }
    });
    return { atlas, sources, width, height: rows * size };
  }
}
