// Drawing of recursive Wang tiles by WebGL2. Each point of a cell is a square of two triangles, and all are drawn by one call:
// hundreds of calls would take longer than the points, and so do instances of four corners where a processor draws, because
// each of them is a call within the driver.
"use strict";

/** A point is seen from its threshold on, and whole at so many times the density. */
const fullAt = 1.3;
/** Cells in a row of their texture. */
const cellsInRow = 256;

const recursiveVertices = `#version 300 es
precision highp float;
precision highp int;
layout(location = 0) in uvec2 drawn; // the number of the cell, and of the point; four corners have the same
uniform highp usampler2D points; // places in cells, in 2^-32 of their sides, and ranks in the tiles around
uniform highp usampler2D cells;  // three pixels each, as RecursiveDrawing.cellWords() has them
uniform uint seed;
uniform vec2 size; // of the view, pixels
uniform float stamp_pixels, full_at;
uniform int stamps;
uniform bool is_turned, has_layer;
uniform highp sampler2D layer;
uniform vec2 layer_at, layer_scale;
uniform float ground;
out vec3 at_stamp;
out float shown;
uint mixed(uint v) {
  v = (v ^ (v >> 16)) * 0x21f0aaadu;
  v = (v ^ (v >> 15)) * 0xd35a2d97u;
  return v ^ (v >> 15);
}
float weight_at(vec2 from_middle) {
  if (!has_layer) return ground;
  vec2 at = layer_at + from_middle * layer_scale;
  if (any(lessThan(at, vec2(0))) || any(greaterThanEqual(at, vec2(1)))) return ground;
  return texture(layer, at).r;
}
void main() {
  ivec2 cell = ivec2(3 * (int(drawn.x) & 255), int(drawn.x) >> 8);
  uvec4 which = texelFetch(cells, cell, 0);
  uvec2 low = which.xy;
  uint level = which.z, first_rank = which.w;
  vec4 offset = uintBitsToFloat(texelFetch(cells, cell + ivec2(1, 0), 0));
  vec2 offset_high = offset.xy, offset_low = offset.zw; // of the cell's corner from the middle of the view: 2^-16 cells, and 2^-16 of these
  vec3 sizes = uintBitsToFloat(texelFetch(cells, cell + ivec2(2, 0), 0)).xyz;
  float cell_pixels = sizes.x, turn = sizes.y, demand = sizes.z;
  int index = int(drawn.y);
  uvec3 point = texelFetch(points, ivec2(index & 1023, index >> 10), 0).xyz;
  uint rank = point.z;
  uint bits = mixed(mixed(mixed(mixed(mixed(seed) + low.x) + low.y) + level) + 1u + rank);
  vec2 high = vec2(point.xy >> 16) + offset_high, rest = vec2(point.xy & 0xffffu) + offset_low;
  vec2 from_middle = (high + rest / 65536.0) * (cell_pixels / 65536.0);
  float threshold = float(rank) + turn;
  shown = clamp((demand * weight_at(from_middle) / threshold - 1.0) / (full_at - 1.0), 0.0, 1.0);
  vec2 corner = vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1);
  float angle = is_turned ? float((bits >> 8) & 255u) * 6.283185307 / 256.0 : 0.0;
  if (rank < first_rank) shown = 0.0; // drawn with the tiles above
  float side = stamp_pixels * (0.7 + 0.6 * float((bits >> 16) & 255u) / 255.0);
  vec2 across = (corner - 0.5) * side;
  vec2 at = from_middle + vec2(cos(angle) * across.x - sin(angle) * across.y, sin(angle) * across.x + cos(angle) * across.y);
  at_stamp = vec3(corner.x, 1.0 - corner.y, float(int(bits & 255u) % stamps));
  gl_Position = shown > 0.0 ? vec4(2.0 * at / size, 0, 1) : vec4(2, 2, 2, 1);
}`;

const recursiveFragments = `#version 300 es
precision highp float;
precision highp sampler2DArray;
uniform sampler2DArray stamp;
in vec3 at_stamp;
in float shown;
out vec4 color;
void main() {
  color = texture(stamp, at_stamp) * shown;
}`;

class RecursiveDrawing {
  /** Draws on nothing, or on paper: a browser shows a canvas sooner that nothing shines through. Throws where there is no
   *  WebGL2. */
  constructor(canvas, plane, isOnPaper) {
    this.canvas = canvas;
    this.plane = plane;
    this.paper = [0, 0, 0, 0];
    const gl = (this.gl = canvas.getContext("webgl2", { antialias: false, depth: false, alpha: !isOnPaper, premultipliedAlpha: true }));
    if (!gl) {
      document.getElementById("said").textContent = "This page needs WebGL2, which this browser does not have";
      throw new Error("no WebGL2");
    }
    this.program = linkedProgram(gl, recursiveVertices, recursiveFragments);
    this.places = new Map();
    gl.useProgram(this.program);
    ["stamp", "layer", "cells", "points"].forEach((name, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(name === "stamp" ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D, gl.createTexture());
      gl.uniform1i(this.uniform(name), unit);
    });
    gl.activeTexture(gl.TEXTURE2);
    this.takeNearest(); // whole numbers are not to be read without
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.enableVertexAttribArray(0);
    gl.vertexAttribIPointer(0, 2, gl.UNSIGNED_INT, 0, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    this.squares = 0;
    gl.activeTexture(gl.TEXTURE3);
    this.takeNearest();
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, 1024, plane.set.cellPoints.length / 4096);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 1024, plane.set.cellPoints.length / 4096, gl.RGBA_INTEGER, gl.UNSIGNED_INT, plane.set.cellPoints);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  uniform(name) {
    if (!this.places.has(name)) this.places.set(name, this.gl.getUniformLocation(this.program, name));
    return this.places.get(name);
  }

  /** Takes stamps: canvases of one size, which are as wide as this part of the width of stamps. */
  setStamps(stamps, part = 1) {
    this.part = part;
    const { gl } = this;
    const side = stamps[0].width;
    gl.activeTexture(gl.TEXTURE0);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, true);
    gl.deleteTexture(gl.getParameter(gl.TEXTURE_BINDING_2D_ARRAY));
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, gl.createTexture());
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, Math.log2(side) + 1, gl.RGBA8, side, side, stamps.length);
    stamps.forEach((stamp, i) => gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, i, side, side, 1, gl.RGBA, gl.UNSIGNED_BYTE, stamp));
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false); // not of whole numbers
    gl.generateMipmap(gl.TEXTURE_2D_ARRAY);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_NEAREST);
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D_ARRAY, wrap, gl.CLAMP_TO_EDGE);
    this.stamps = stamps.length;
  }

  /** Takes the weights of the painted layer, rows from below. */
  setLayer(weights, width, height) {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, width, height, 0, gl.RED, gl.FLOAT, weights);
    this.takeNearest();
  }

  takeNearest() {
    const { gl } = this;
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
  }

  /** Draws { seed, parts, ratio, stampPixels, isTurned, layer, ground }: parts of the view, see partsOf(). */
  draw(view) {
    const { gl, canvas } = this;
    const set = this.plane.set;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(...this.paper);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.uniform1ui(this.uniform("seed"), view.seed);
    gl.uniform2f(this.uniform("size"), canvas.width / view.ratio, canvas.height / view.ratio);
    gl.uniform1f(this.uniform("stamp_pixels"), view.stampPixels * this.part);
    gl.uniform1f(this.uniform("full_at"), fullAt);
    gl.uniform1i(this.uniform("stamps"), this.stamps);
    gl.uniform1i(this.uniform("is_turned"), view.isTurned);
    gl.uniform1i(this.uniform("has_layer"), view.layer !== null);
    gl.uniform1f(this.uniform("ground"), view.ground);
    if (view.layer) {
      gl.uniform2f(this.uniform("layer_at"), ...view.layer.at);
      gl.uniform2f(this.uniform("layer_scale"), ...view.layer.scale);
    }
    this.setCells(view.parts);
    const points = this.pointsOf(view.parts);
    gl.bufferData(gl.ARRAY_BUFFER, points, gl.STREAM_DRAW);
    this.needSquares(points.length / 8);
    gl.drawElements(gl.TRIANGLES, (points.length / 8) * 6, gl.UNSIGNED_INT, 0);
  }

  /** Twelve words for each cell: its tile, level and first rank; its corner; its size, turn and demand. */
  cellWords(parts) {
    const rows = Math.max(1, Math.ceil(parts.length / cellsInRow));
    const whole = new Uint32Array(12 * cellsInRow * rows);
    const real = new Float32Array(whole.buffer);
    parts.forEach((part, i) => {
      [whole[12 * i], whole[12 * i + 1]] = part.low;
      whole[12 * i + 2] = part.level;
      whole[12 * i + 3] = part.firstRank;
      part.offset.forEach((offset, k) => {
        const units = Math.floor(offset * 65536);
        real[12 * i + 4 + k] = units;
        real[12 * i + 6 + k] = (offset * 65536 - units) * 65536;
      });
      real[12 * i + 8] = part.pixels;
      real[12 * i + 9] = part.turn;
      real[12 * i + 10] = part.demand;
    });
    return { whole, rows };
  }

  setCells(parts) {
    const { gl } = this;
    const { whole, rows } = this.cellWords(parts);
    gl.activeTexture(gl.TEXTURE2);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32UI, 3 * cellsInRow, rows, 0, gl.RGBA_INTEGER, gl.UNSIGNED_INT, whole);
  }

  /** The cell and the number of each point that is drawn, for each corner of its square. */
  pointsOf(parts) {
    const points = new Uint32Array(8 * parts.reduce((sum, { count }) => sum + count, 0));
    let next = 0;
    parts.forEach((part, i) => {
      const first = part.segment * this.plane.set.pointsPerTile + part.first;
      for (let corner = 0; corner < 4 * part.count; ++corner) {
        points[next++] = i;
        points[next++] = first + (corner >> 2);
      }
    });
    return points;
  }

  /** Makes the corners of the triangles of so many squares. */
  needSquares(squares) {
    if (squares <= this.squares) return;
    this.squares = 2 * squares;
    const corners = [0, 1, 2, 2, 1, 3];
    const indices = new Uint32Array(6 * this.squares);
    for (let square = 0, at = 0; square < this.squares; ++square)
      for (const corner of corners) indices[at++] = 4 * square + corner;
    this.gl.bufferData(this.gl.ELEMENT_ARRAY_BUFFER, indices, this.gl.STATIC_DRAW);
  }
}
