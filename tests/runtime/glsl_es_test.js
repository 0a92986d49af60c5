// The script of glsl_es_test.cpp: the look-ups of poisson_tiles_gpu.h in WebGL2, pixel by pixel, and those of
// poisson_tiles.js by expected_words.js. `header` and `bytes` are the header's text and a tile set file.
"use strict";

const set = new PoissonTiles.TileSet(bytes);
const rankedAt = set.ranks ? (set.ranks.byteOffset - set.points.byteOffset) / 2 : 0;

/** The file's words as a texture of 2,048 a row. */
function pointTexture(gl) {
  const words = new Uint32Array(2048 * Math.ceil((bytes.length - 128) / 4 / 2048));
  new Uint8Array(words.buffer).set(bytes.subarray(128));
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32UI, 2048, words.length / 2048, 0, gl.RED_INTEGER, gl.UNSIGNED_INT, words);
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
}

/** Draws size x size pixels of four words each by the body of a shader, which sets `words`; gives them. */
function drawnWords(size, seed, period, body) {
  const gl = document.createElement("canvas").getContext("webgl2");
  const program = gl.createProgram();
  const attach = (kind, text) => {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  };
  attach(gl.VERTEX_SHADER, `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`);
  attach(gl.FRAGMENT_SHADER, `#version 300 es
precision highp float; precision highp int; precision highp usampler2D;
uniform usampler2D ptiles_texture;
layout(location = 0) out uvec4 words;
${header}
void main()
{
    ptiles_tiling t = ptiles_tiling(${set.kind}u, ${set.dimension}u, ${set.colors}u, ${set.tiles}u, ${set.pointsPerTile}u,
                                    ${seed}u, ${period}, ${set.low}, ${set.step}, ${set.below}, ${set.above}, ${rankedAt}u);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ${body}
}`);
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);
  pointTexture(gl);
  gl.bindRenderbuffer(gl.RENDERBUFFER, gl.createRenderbuffer());
  gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA32UI, size, size);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, gl.getParameter(gl.RENDERBUFFER_BINDING));
  gl.viewport(0, 0, size, size);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const result = new Uint32Array(4 * size * size);
  gl.readPixels(0, 0, size, size, gl.RGBA_INTEGER, gl.UNSIGNED_INT, result);
  return result;
}

/** The number of places compared, and of those where tile, point, random bits or level are others. */
function differences(seed, period) {
  const words = drawnWords(placesSide, seed, period, `
    ivec3 at = ivec3(pixel.x * 1000003 - 500000000, pixel.y * 999983 - 400000000, t.dimension == 3u ? pixel.x - pixel.y : 0);
    uint tile = ptiles_tile(t, at);
    uint index = uint(pixel.x * 31 + pixel.y) % t.points_per_tile;
    uint id = ptiles_mix(ptiles_hash(t.seed, ptiles_place(at.x, t.period), ptiles_place(at.y, t.period),
                                     ptiles_place(at.z, t.period)) + 1u + index);
    vec3 p = (ptiles_point(t, tile, index) * 65536.0 - float(t.low)) / float(t.step); // exact
    if (t.dimension == 2u) p.z = 0.0;
    words = uvec4(tile, uint(p.x + p.z) + 65536u * uint(p.y), id,
                  uint(ptiles_level(t, tile, index, id) * float(2u * t.points_per_tile)));`);
  return [placesSide * placesSide, otherPlaces(set, seed, period, words)];
}

/** The number of positions, of those with another nearest point, and how much farther that is at most. */
function nearestDifferences() {
  const words = drawnWords(nearestSide, 3, 0, `
    ivec3 home = ivec3(pixel.x * 1000 - 64000, pixel.y * 77 - 5000, 0);
    vec3 f = vec3(float(pixel.x % 11) / 16.0, float(pixel.y % 13) / 16.0, t.dimension == 3u ? 0.25 : 0.0);
    ptiles_nearest n = ptiles_nearest_point(t, home, f);
    words = uvec4(n.index, n.id, floatBitsToUint(n.distance), 0u);`);
  return [nearestSide * nearestSide, ...otherNearest(set, words)];
}
