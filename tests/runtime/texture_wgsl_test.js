// The page of texture_wgsl.sh: where runtime/texture_look_up.wgsl finds tiles, against packings by their definitions:
// of corner tiles a grid of colours whose windows of 2 x 2 are all tiles, of Wang tiles the row of dominoes along both
// axes. Says on the console how many places differ, for each set.
"use strict";

const mix = (value) => {
  let v = value;
  v = Math.imul(v ^ (v >>> 16), 0x21f0aaad);
  v = Math.imul(v ^ (v >>> 15), 0xd35a2d97);
  return (v ^ (v >>> 15)) >>> 0;
};
const hash = (seed, ...numbers) => numbers.reduce((word, number) => mix((word + number) | 0), mix(seed));

/** The colour at (x, y) of the closed packing of corner tiles. */
function packedColor(colors, x, y) {
  const side = colors * colors;
  if (colors % 2 === 1) {
    const circle = [];
    for (let i = 0; i < colors; ++i) {
      circle.push(i);
      for (let j = i + 1; j < colors; ++j) circle.push(i, j);
    }
    return circle[(y + (x * (x - 1)) / 2) % side];
  }
  const half = colors / 2, a = y >> 2, b = x >> 2;
  const digit = y % 2 === 0 ? (x % 2 === 0 ? a % half : Math.floor(a / half)) : x % 2 === 0 ? b % half : Math.floor(b / half);
  return Number(["0001", "0010", "1011", "0111"][y % 4][x % 4]) + 2 * digit;
}

/** The place of each corner tile by its colours, lower left first. */
function cornerPlaces(colors) {
  const side = colors * colors, places = new Map();
  const at = (x, y) => packedColor(colors, x % side, y % side);
  for (let y = 0; y < side; ++y)
    for (let x = 0; x < side; ++x) places.set([at(x + 1, y + 1), at(x + 1, y), at(x, y), at(x, y + 1)].join(), y * side + x);
  if (places.size !== side * side) throw new Error(`no packing of ${colors} colours`);
  return places;
}

/** The place of each domino: each colour's block puts its pairs with lower ones behind those of lower ones. */
function dominoPlaces(colors) {
  const row = [[0, 0]];
  for (let c = 1; c < colors; ++c) {
    row.push([0, c]);
    for (let lower = 1; lower < c; ++lower) row.push([c, lower], [lower, c]);
    row.push([c, c], [c, 0]);
  }
  return new Map(row.map((pair, place) => [pair.join(), place]));
}

function expectedPlace(places, isWang, colors, seed, x, y) {
  const color = (i, j, z = 0) => hash(seed, i, j, z) % colors;
  if (!isWang) return places.get([color(x + 1, y + 1), color(x + 1, y), color(x, y), color(x, y + 1)].join());
  const south = places.get([color(x, y, 0), color(x, y + 1, 0)].join());
  return south * colors * colors + places.get([color(x, y, 1), color(x + 1, y, 1)].join());
}

const side = 320; // of the tiles that are compared
const tileAt = (i) => [((i % side) * 7919 - 1000000) | 0, (Math.floor(i / side) * 104729 - 2000000000) | 0];

async function foundPlaces(device, isWang, colors, seed) {
  const code = `const ttiles_colors = ${colors}u; const ttiles_size = 64; const ttiles_levels = 7; const ttiles_wang = ${isWang};
${library}
@group(0) @binding(0) var<storage, read_write> results: array<u32>;
@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) at: vec3<u32>) {
    results[at.y * ${side}u + at.x] = ttiles_place(${seed}u, vec2<i32>(i32(at.x) * 7919 - 1000000, i32(at.y) * 104729 - 2000000000));
}`;
  const module = device.createShaderModule({ code });
  const problem = (await module.getCompilationInfo()).messages.find(({ type }) => type === "error");
  if (problem) throw new Error(`line ${problem.lineNum}: ${problem.message}`);
  const pipeline = device.createComputePipeline({ layout: "auto", compute: { module, entryPoint: "main" } });
  const buffer = (usage) => device.createBuffer({ size: 4 * side * side, usage });
  const output = buffer(GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC);
  const read = buffer(GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST);
  const encoder = device.createCommandEncoder(), pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries: [{ binding: 0, resource: { buffer: output } }] }));
  pass.dispatchWorkgroups(side / 64, side);
  pass.end();
  encoder.copyBufferToBuffer(output, 0, read, 0, output.size);
  device.queue.submit([encoder.finish()]);
  await read.mapAsync(GPUMapMode.READ);
  return new Uint32Array(read.getMappedRange().slice(0));
}

async function compare() {
  const adapter = navigator.gpu && (await navigator.gpu.requestAdapter());
  if (!adapter) return "no WebGPU";
  const device = await adapter.requestDevice();
  device.addEventListener("uncapturederror", (event) => (document.title += ` ${event.error.message}`));
  const counts = [];
  for (const [isWang, colors] of [[false, 2], [false, 3], [false, 4], [false, 5], [false, 6], [true, 2], [true, 4]]) {
    const places = isWang ? dominoPlaces(colors) : cornerPlaces(colors);
    const found = await foundPlaces(device, isWang, colors, 3000000007);
    counts.push(found.reduce((sum, place, i) => sum + (place !== expectedPlace(places, isWang, colors, 3000000007, ...tileAt(i))), 0));
  }
  return `different: ${counts.join(" ")}`;
}

compare().catch((problem) => `failed: ${problem.message}`).then((text) => console.log(`[[${text}${document.title}]]`));
