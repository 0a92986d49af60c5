// The page of wgsl.sh: the look-ups of poisson_tiles.wgsl in WebGPU against those of poisson_tiles.js by
// expected_words.js, for a million places and 16,384 nearest points. `library`, `example` and `bytes` are texts and a tile
// set file. Says on the console what differs.
"use strict";

const set = new PoissonTiles.TileSet(bytes);
const ranksAt = set.ranks ? (set.ranks.byteOffset - set.points.byteOffset) / 2 : 0;

/** size x size records of four words by the body of a shader, which sets `words` from `pixel`. */
async function computed(device, size, seed, period, body) {
  const numbers = [set.kind, set.dimension, set.colors, set.tiles, set.pointsPerTile, seed].map((n) => `${n}u`);
  const code = `@group(0) @binding(0) var<storage, read> ptiles_words: array<u32>;
@group(0) @binding(1) var<storage, read_write> results: array<vec4<u32>>;
${library}
@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) at: vec3<u32>) {
    let t = PtilesTiling(${[...numbers, period, set.low, set.step, set.below, set.above, `${ranksAt}u`].join(", ")});
    let pixel = vec2<i32>(at.xy);
    var words: vec4<u32>;
    ${body}
    results[at.y * ${size}u + at.x] = words;
}`;
  const pipeline = device.createComputePipeline({
    layout: "auto", compute: { module: device.createShaderModule({ code }), entryPoint: "main" } });
  const buffer = (length, usage) => device.createBuffer({ size: length, usage });
  const input = buffer(4 * Math.ceil((bytes.length - 128) / 4), GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST);
  const padded = new Uint8Array(input.size);
  padded.set(bytes.subarray(128));
  device.queue.writeBuffer(input, 0, padded);
  const output = buffer(16 * size * size, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC);
  const read = buffer(output.size, GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST);
  const entries = [input, output].map((each, binding) => ({ binding, resource: { buffer: each } }));
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
  pass.dispatchWorkgroups(size / 64, size);
  pass.end();
  encoder.copyBufferToBuffer(output, 0, read, 0, output.size);
  device.queue.submit([encoder.finish()]);
  await read.mapAsync(GPUMapMode.READ);
  return new Uint32Array(read.getMappedRange().slice(0));
}

/** Finds the places, of a million, where tile, point, random bits or level are others. */
async function differences(device, seed, period) {
  return otherPlaces(set, seed, period, await computed(device, placesSide, seed, period, `
    let place = vec3<i32>(pixel.x * 1000003 - 500000000, pixel.y * 999983 - 400000000,
                          select(0, pixel.x - pixel.y, t.dimension == 3u));
    let tile = ptiles_tile(t, place);
    let index = u32(pixel.x * 31 + pixel.y) % t.points_per_tile;
    let id = ptiles_id(t, place, index);
    var p = (ptiles_point(t, tile, index) * 65536.0 - f32(t.low)) / f32(t.step); // exact
    if (t.dimension == 2u) { p.z = 0.0; }
    words = vec4<u32>(tile, u32(p.x + p.z) + 65536u * u32(p.y), id,
                      u32(ptiles_level(t, tile, index, id) * f32(2u * t.points_per_tile)));`));
}

/** Finds the positions, of 16,384, that have another nearest point. */
async function nearestDifferences(device) {
  const words = await computed(device, nearestSide, 3, 0, `
    let f = vec3<f32>(f32(pixel.x % 11) / 16.0, f32(pixel.y % 13) / 16.0, select(0.0, 0.25, t.dimension == 3u));
    let n = ptiles_nearest_point(t, vec3<i32>(pixel.x * 1000 - 64000, pixel.y * 77 - 5000, 0), f);
    words = vec4<u32>(n.index, n.id, bitcast<u32>(n.distance), 0u);`);
  return otherNearest(set, words)[0];
}

async function compare() {
  const adapter = navigator.gpu && (await navigator.gpu.requestAdapter());
  if (!adapter) return "no WebGPU";
  const device = await adapter.requestDevice();
  device.addEventListener("uncapturederror", (event) => (document.title += ` ${event.error.message}`));
  const { messages } = await device.createShaderModule({ code: example + library }).getCompilationInfo();
  for (const message of messages) if (message.type === "error") throw new Error(`the example: ${message.message}`);
  return `different: ${await differences(device, 0, 0)} ${await differences(device, 7, 1000)}; ` +
         `nearest: ${await nearestDifferences(device)}`;
}

compare().catch((problem) => `failed: ${problem.message}`).then((text) => console.log(`[[${text}${document.title}]]`));
