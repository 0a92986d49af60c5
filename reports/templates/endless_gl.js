// The points of an endless tiling by WebGL2: every point is looked up where it is drawn, by the header
// runtime/poisson_tiles_gpu.h. Places are whole 1/65,536 parts of a tile from the middle of the view until the last
// step, so that nothing is lost far away or close up.
"use strict";

const tilingVertices = (set, header, rankedAt) => `#version 300 es
precision highp float; precision highp int; precision highp usampler2D;
uniform usampler2D ptiles_texture;
uniform usampler2D order;   // the points of each tile by rank
uniform usampler2D limits;  // of the squares of the density: how many ranks, or random numbers, are below it
uniform uint seed, limit;   // limit: everywhere
uniform ivec2 middle, first, at_units, first_cell; // first: the lowest tile seen, from the middle one
uniform int columns, shown, cell_bits; // a square of the density has 2^cell_bits units along each side
uniform bool is_painted;
uniform vec2 at_rest, size;
uniform float pixels_per_unit, reach;
flat out uint id;
out vec2 from_middle; // of the point, in pixels
${header}
uint word(usampler2D words, int n) { return texelFetch(words, ivec2(n & 2047, n >> 11), 0).r; }
void main()
{
    ptiles_tiling t = ptiles_tiling(${set.kind}u, 2u, ${set.colors}u, ${set.tiles}u, ${set.pointsPerTile}u, seed, 0,
                                    ${set.low}, ${set.step}, ${set.below}, ${set.above}, ${rankedAt}u);
    // Two triangles a point; instances would each be a draw of its own where the processor does the graphics.
    int point = gl_VertexID / 6;
    int corner = gl_VertexID % 6;
    int number = point / shown;
    ivec2 away = first + ivec2(number % columns, number / columns);
    ivec2 place = middle + away;
    uint tile = ptiles_tile(t, ivec3(place, 0));
    uint index = word(order, int(tile * t.points_per_tile) + point % shown);
    uint n = tile * t.points_per_tile + index;
    ivec2 units = t.low + t.step * ivec2(int(ptiles_number(2u * n)), int(ptiles_number(2u * n + 1u)));
    id = ptiles_mix(ptiles_hash(t.seed, uint(place.x), uint(place.y), 0u) + 1u + index);
    uint below = limit;
    if (is_painted) {
        ivec2 cell = (away * 65536 + units) >> cell_bits;
        below = texelFetch(limits, cell - first_cell, 0).r;
    }
    uint level = t.ranks == 0u ? id : ptiles_number(t.ranks + n);
    vec2 at = (vec2(away * 65536 + units - at_units) - at_rest) * pixels_per_unit;
    bool is_right = corner == 1 || corner >= 4, is_upper = corner == 2 || corner == 3 || corner == 5;
    from_middle = reach * vec2(is_right ? 1.0 : -1.0, is_upper ? 1.0 : -1.0);
    bool is_there = below == 0xffffffffu || level < below;
    gl_Position = is_there ? vec4((at + from_middle) / size * 2.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}`;

const pointFragments = `#version 300 es
precision highp float; precision highp int;
uniform int look;
uniform float radius, distance_unit;
uniform vec3 ink;
flat in uint id;
in vec2 from_middle;
out vec4 color;
vec3 hue(float h) { return clamp(abs(mod(h * 6.0 + vec3(0.0, 4.0, 2.0), 6.0) - 3.0) - 1.0, 0.0, 1.0); }
void main()
{
    float away = length(from_middle);
    gl_FragDepth = 0.0;
    if (look == 1) { // the distance to the nearest point: that which is nearest stays
        float light = min(1.0, away / distance_unit);
        gl_FragDepth = light;
        color = vec4(vec3(light), 1.0);
        return;
    }
    float inside = radius - away;
    vec3 paint = ink;
    if (look == 2) { // triangles
        float turn = float((id >> 8) & 255u) / 40.74;
        inside = radius;
        for (int side = 0; side < 3; ++side) {
            float angle = turn + 1.0472 + 2.0944 * float(side);
            float part = radius * (0.7 + float((id >> 16) & 255u) / 255.0);
            inside = min(inside, 0.5 * part - dot(from_middle, vec2(cos(angle), sin(angle))));
        }
        paint = 0.45 + (hue(float(id & 255u) / 256.0) - 0.5) * 0.54;
    }
    float covered = clamp(inside + 0.5, 0.0, 1.0);
    if (covered == 0.0) discard;
    color = vec4(paint * covered, covered);
}`;

/** Draws points on a canvas. The constructor throws where there is no WebGL2, or where its textures are too small. */
class GlPoints {
  constructor(canvas, set, header) {
    const gl = canvas.getContext("webgl2", { antialias: false, premultipliedAlpha: true });
    if (!gl) throw new Error("no WebGL2");
    const masked = gl.getParameter(gl.RENDERER);
    const names = /webkit/i.test(masked) && gl.getExtension("WEBGL_debug_renderer_info"); // others say it at once
    const isSoftware = /swiftshader|llvmpipe|software/i.test(names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : masked);
    Object.assign(this, { canvas, gl, set, isSoftware, isLost: false, painted: null });
    canvas.addEventListener("webglcontextlost", () => (this.isLost = true));
    const words = set.points.length + (set.ranks ? set.ranks.length : 0);
    if (words / 2 > 2048 * gl.getParameter(gl.MAX_TEXTURE_SIZE)) throw new Error("the tile set is too large");
    const ranksAt = set.ranks ? (set.ranks.byteOffset - set.points.byteOffset) / 2 : 0;
    this.program = linkedProgram(gl, tilingVertices(set, header, ranksAt), pointFragments);
    gl.useProgram(this.program);
    this.places = new Map();
    this.texture(0, "ptiles_texture", this.fileWords());
    this.texture(1, "order", Uint32Array.from(pointOrder(set)));
    this.texture(2, "limits", new Uint32Array(1));
  }

  /** The numbers of the tile set file from its points on, two a word. */
  fileWords() {
    const { points, ranks } = this.set;
    const bytes = new Uint8Array(points.buffer, points.byteOffset, (ranks || points).byteOffset + (ranks || points).byteLength - points.byteOffset);
    const words = new Uint32Array(Math.ceil(bytes.length / 4));
    new Uint8Array(words.buffer).set(bytes);
    return words;
  }

  uniform(name) {
    if (!this.places.has(name)) this.places.set(name, this.gl.getUniformLocation(this.program, name));
    return this.places.get(name);
  }

  /** Words as texels, so many a row. */
  texture(unit, name, words, width = 2048) {
    const { gl } = this;
    const height = Math.ceil(words.length / width);
    const all = words.length === width * height ? words : new Uint32Array(width * height);
    if (all !== words) all.set(words);
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32UI, width, height, 0, gl.RED_INTEGER, gl.UNSIGNED_INT, all);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    gl.uniform1i(this.uniform(name), unit);
  }

  /** How many ranks, or random numbers of points without ranks, are below a density; all ones: every one. */
  limit(density) {
    if (density >= 1) return 0xffffffff;
    return this.set.ranks ? this.set.ranksBelow(density) : Math.max(0, Math.ceil(density * 4294967296));
  }

  /** The limits of the squares of the tiles from `first` on, from the middle one; one tile more on every side. */
  paint(view, first, columns, rows) {
    const { gl } = this;
    const { density, middle } = view;
    const key = [first, columns, rows, middle, view.everywhere, density.changes].join();
    const n = density.cells;
    gl.uniform1i(this.uniform("cell_bits"), 16 - Math.log2(n));
    gl.uniform2i(this.uniform("first_cell"), (first[0] - 1) * n, (first[1] - 1) * n);
    if (key === this.painted) return;
    this.painted = key;
    const table = Array.from(lightOf, (light) => this.limit(view.everywhere * light));
    const width = (columns + 2) * n;
    const limits = new Uint32Array(width * (rows + 2) * n).fill(table[255]);
    for (let j = 0; j < rows + 2; ++j)
      for (let i = 0; i < columns + 2; ++i) {
        const tile = density.tiles.get(`${middle[0] + first[0] - 1 + i},${middle[1] + first[1] - 1 + j}`);
        if (tile) tile.forEach((grey, c) => (limits[(j * n + Math.floor(c / n)) * width + i * n + (c % n)] = table[grey]));
      }
    gl.activeTexture(gl.TEXTURE2);
    gl.deleteTexture(gl.getParameter(gl.TEXTURE_BINDING_2D));
    this.texture(2, "limits", limits, width);
  }

  /** Draws a view: { seed, middle, at, zoom, ratio, look, everywhere, density, shown, first, columns, rows, ink, minDistance };
   *  `first`, `columns` and `rows` are the tiles that are drawn, from the middle one; `zoom` is in pixels of the page. */
  draw(view) {
    const { gl, canvas } = this;
    const scale = view.zoom * view.ratio;
    const isDistance = view.look === "distances";
    const radius = pointRadius(view.minDistance, scale);
    const reach = isDistance ? distanceShown * view.minDistance * scale : view.look === "instances" ? 1.8 * radius + 1 : radius + 1;
    gl.viewport(0, 0, canvas.width, canvas.height);
    const clear = isDistance ? 1 : 0;
    gl.clearColor(clear, clear, clear, clear);
    gl.clearDepth(1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    (isDistance ? gl.enable : gl.disable).call(gl, gl.DEPTH_TEST);
    (isDistance ? gl.disable : gl.enable).call(gl, gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.useProgram(this.program);
    gl.uniform1ui(this.uniform("seed"), view.seed);
    gl.uniform1ui(this.uniform("limit"), this.limit(view.everywhere));
    gl.uniform1i(this.uniform("is_painted"), view.density.isEmpty ? 0 : 1);
    if (!view.density.isEmpty) this.paint(view, view.first, view.columns, view.rows);
    const units = view.at.map((v) => Math.floor(v * 65536));
    gl.uniform2i(this.uniform("middle"), ...view.middle);
    gl.uniform2i(this.uniform("first"), ...view.first);
    gl.uniform2i(this.uniform("at_units"), ...units);
    gl.uniform2f(this.uniform("at_rest"), ...view.at.map((v, a) => v * 65536 - units[a]));
    gl.uniform2f(this.uniform("size"), canvas.width, canvas.height);
    gl.uniform1i(this.uniform("columns"), view.columns);
    gl.uniform1i(this.uniform("shown"), view.shown);
    gl.uniform1f(this.uniform("pixels_per_unit"), scale / 65536);
    gl.uniform1f(this.uniform("reach"), reach);
    gl.uniform1f(this.uniform("radius"), radius);
    gl.uniform1f(this.uniform("distance_unit"), reach);
    gl.uniform1i(this.uniform("look"), ["disks", "distances", "instances"].indexOf(view.look));
    gl.uniform3f(this.uniform("ink"), ...view.ink.map((v) => v / 255));
    gl.drawArrays(gl.TRIANGLES, 0, 6 * view.columns * view.rows * view.shown);
  }
}
