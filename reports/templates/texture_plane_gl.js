// The endless plane of a texture set by WebGL2: the look-ups of runtime/texture_look_up.glsl, seen by the camera of
// `poissonlab texture map`.
"use strict";

const looks = { packed: 0, exact: 1, layered: 2 };

const planeVertices = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`;

const planeFragments = (lookUp) => `#version 300 es
precision highp float; precision highp int; precision highp sampler2D; precision highp sampler2DArray;
uniform sampler2D atlas;
uniform sampler2DArray layers;
uniform uint seed;
uniform ivec2 home;              // the tile of the place 0
uniform vec3 u, v, w;            // a place is u / w, v / w; each at the upper left corner, and its steps right and down
uniform vec2 size;
uniform int look;
uniform bool has_levels, shows_borders, goes_up; // goes_up: rows of the picture go from the top
uniform vec3 mean;
out vec4 color;
${lookUp}
const vec3 sky = vec3(0.6);
vec3 encoded(vec3 light)
{
    return mix(12.92 * light, 1.055 * pow(max(light, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
}
// Where a pixel covers whole tiles, blocks of 2 x 2 and 4 x 4 of them are its texels, and then the mean of all.
const int far_levels = 2;
vec3 block_light(ivec2 tile, vec2 inside, int block)
{
    ivec2 within = ivec2(uvec2(tile) % uint(block));
    vec2 at = (vec2(within) + inside) / float(block) - 0.5, part = at - floor(at);
    vec3 sum = vec3(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 step = ivec2(k % 2, k / 2), corner = tile - within + (ivec2(floor(at)) + step) * block;
        vec3 light = vec3(0.0);
        for (int n = 0; n < block * block; ++n)
            light += ttiles_packed_texel(atlas, seed, corner + ivec2(n % block, n / block), ivec2(0), TTILES_LEVELS - 1).rgb;
        sum += (step.x == 1 ? part.x : 1.0 - part.x) * (step.y == 1 ? part.y : 1.0 - part.y) / float(block * block) * light;
    }
    return sum;
}
vec3 level_light(ivec2 tile, vec2 inside, int level)
{
    int beyond = level - (TTILES_LEVELS - 1);
    if (beyond > far_levels) return mean;
    if (beyond > 0) return block_light(tile, inside, 1 << beyond);
    return look == 1 ? ttiles_packed_level(atlas, seed, tile, inside, level).rgb
                     : ttiles_layer_level(layers, seed, tile, inside, level).rgb;
}
vec3 exact_light(ivec2 tile, vec2 inside, float texels)
{
    int level = 0;
    for (; texels >= 2.0 && level < TTILES_LEVELS + far_levels; texels /= 2.0) ++level;
    vec3 light = level_light(tile, inside, level);
    float upper = clamp(texels - 1.0, 0.0, 1.0);
    return upper > 0.0 ? mix(light, level_light(tile, inside, level + 1), upper) : light;
}
void main()
{
    vec3 pixel = vec3(1.0, gl_FragCoord.x, goes_up ? size.y - gl_FragCoord.y : gl_FragCoord.y);
    float divisor = dot(w, pixel);
    if (!(divisor > 6e-8)) { color = vec4(encoded(sky), 1.0); return; }
    vec2 at = vec2(dot(u, pixel), dot(v, pixel)) / divisor;
    vec2 dx = (vec2(u.y, v.y) - at * w.y) / divisor, dy = (vec2(u.z, v.z) - at * w.z) / divisor;
    ivec2 tile = home + ivec2(floor(at));
    vec2 inside = at - floor(at);
    float texels = has_levels ? max(length(dx), length(dy)) * float(TTILES_SIZE) : 1.0;
    vec3 light;
    if (look == 0) { // hardware has no levels beyond a tile's: colours go over to the mean of all
        light = ttiles_packed(atlas, seed, tile, inside, dx, dy).rgb;
        light = mix(light, mean, clamp(log2(texels / float(TTILES_SIZE)) / 2.0, 0.0, 1.0));
    } else
        light = exact_light(tile, inside, texels);
    vec2 border = min(inside, 1.0 - inside) / max(abs(dx), abs(dy));
    if (shows_borders && min(border.x, border.y) < 0.75) light = mix(light, vec3(1.0, 0.4, 0.0), 0.7);
    color = vec4(encoded(light), 1.0);
}`;

/** The functions of a view: host/texture/mapping/texture_map.cpp, view_of(). Angles are in degrees. */
function viewOf({ width, height, above, pitch, yaw, field, start }) {
  const [p, y] = [pitch, yaw].map((angle) => (angle * Math.PI) / 180);
  const ahead = [Math.sin(y), Math.cos(y), 0], right = [Math.cos(y), -Math.sin(y), 0];
  const axis = [ahead[0] * Math.cos(p), ahead[1] * Math.cos(p), -Math.sin(p)];
  const up = [ahead[0] * Math.sin(p), ahead[1] * Math.sin(p), Math.cos(p)];
  const half = Math.tan((field * Math.PI) / 360), step = (2 * half) / height;
  const directions = [0, 1, 2].map((a) => [
    axis[a] - ((half * width) / height) * right[a] + half * up[a], step * right[a], -step * up[a]]);
  const w = directions[2].map((down) => -down / above);
  const place = (a) => directions[a].map((part, i) => part + start[a] * w[i]);
  return { u: place(0), v: place(1), w };
}

class GlPlane {
  /** levels: bytes of the packed atlas, rows from the north. The constructor throws where there is no WebGL2. */
  constructor(canvas, { colors, size, channels, levels, lookUp }) {
    const gl = canvas.getContext("webgl2", { antialias: false, alpha: false });
    if (!gl) throw new Error("no WebGL2");
    Object.assign(this, { gl, canvas, colors, size, places: new Map() });
    this.program = linkedProgram(gl, planeVertices, planeFragments(lookUp));
    gl.useProgram(this.program);
    const texels = levels.map((bytes) => GlPlane.opaque(bytes, channels));
    this.atlas = this.texture(gl.TEXTURE_2D, 0, texels);
    this.layers = this.texture(gl.TEXTURE_2D_ARRAY, 1, texels.map((level, n) => this.inLayers(level, size >> n)));
    const last = levels[levels.length - 1];
    this.mean = [0, 1, 2].map((c) => GlPlane.meanLight(last, channels, channels === 1 ? 0 : c));
  }

  static opaque(bytes, channels) {
    const texels = new Uint8Array((bytes.length / channels) * 4).fill(255);
    for (let i = 0; i < texels.length / 4; ++i)
      for (let c = 0; c < 3; ++c) texels[4 * i + c] = bytes[channels * i + (channels === 1 ? 0 : c)];
    return texels;
  }

  static meanLight(bytes, channels, channel) {
    let sum = 0;
    for (let i = channel; i < bytes.length; i += channels) sum += lightOf[bytes[i]];
    return (sum * channels) / bytes.length;
  }

  /** The tiles of the packed atlas one after another: the lower left one first, rows of tiles going north. */
  inLayers(texels, size) {
    const side = this.colors ** 2, row = 4 * size;
    const layers = new Uint8Array(texels.length);
    for (let layer = 0; layer < side * side; ++layer)
      for (let y = 0; y < size; ++y) {
        const from = (((side - 1 - Math.floor(layer / side)) * size + y) * side + (layer % side)) * row;
        layers.set(texels.subarray(from, from + row), (layer * size + y) * row);
      }
    return layers;
  }

  texture(target, unit, levels) {
    const { gl } = this, isArray = target === gl.TEXTURE_2D_ARRAY, side = this.colors ** 2;
    if (isArray && side * side > gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS)) return null;
    if (!isArray && side * this.size > gl.getParameter(gl.MAX_TEXTURE_SIZE)) throw new Error("the atlas is too large");
    const made = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(target, made);
    levels.forEach((bytes, level) => {
      const wide = this.size >> level;
      if (isArray) gl.texImage3D(target, level, gl.SRGB8_ALPHA8, wide, wide, side * side, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      else gl.texImage2D(target, level, gl.SRGB8_ALPHA8, wide * side, wide * side, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    });
    gl.texParameteri(target, gl.TEXTURE_MAX_LEVEL, levels.length - 1);
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    const anisotropic = gl.getExtension("EXT_texture_filter_anisotropic");
    if (anisotropic) gl.texParameterf(target, anisotropic.TEXTURE_MAX_ANISOTROPY_EXT, gl.getParameter(anisotropic.MAX_TEXTURE_MAX_ANISOTROPY_EXT));
    return made;
  }

  uniform(name) {
    if (!this.places.has(name)) this.places.set(name, this.gl.getUniformLocation(this.program, name));
    return this.places.get(name);
  }

  /** Draws a view into what is bound: width, height, tile, start (in it, 0 to 1), above, pitch, yaw, field, seed, look. */
  draw(view) {
    const { gl } = this, { u, v, w } = viewOf(view);
    gl.viewport(0, 0, view.width, view.height);
    gl.uniform1i(this.uniform("atlas"), 0);
    gl.uniform1i(this.uniform("layers"), 1);
    gl.uniform1ui(this.uniform("seed"), view.seed >>> 0);
    gl.uniform2i(this.uniform("home"), view.tile[0] | 0, view.tile[1] | 0);
    for (const [name, value] of Object.entries({ u, v, w, mean: this.mean })) gl.uniform3fv(this.uniform(name), value);
    gl.uniform2f(this.uniform("size"), view.width, view.height);
    gl.uniform1i(this.uniform("look"), looks[view.look]);
    gl.uniform1i(this.uniform("has_levels"), view.hasLevels === false ? 0 : 1);
    gl.uniform1i(this.uniform("shows_borders"), view.borders ? 1 : 0);
    gl.uniform1i(this.uniform("goes_up"), view.isRead ? 0 : 1);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** Draws a view into bytes: red, green, blue, 255, rows from the top. */
  pixels(view) {
    const { gl } = this, bytes = new Uint8Array(4 * view.width * view.height);
    const buffer = gl.createRenderbuffer(), frame = gl.createFramebuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, view.width, view.height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, buffer);
    this.draw({ ...view, isRead: true });
    gl.readPixels(0, 0, view.width, view.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(frame);
    gl.deleteRenderbuffer(buffer);
    return bytes;
  }
}
