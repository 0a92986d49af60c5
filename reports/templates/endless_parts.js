// Parts of the page of an endless tiling that know nothing of it: spectra, points by chunks, and files.
"use strict";

/** The discrete Fourier transform of n = 2^k complex numbers with a stride, in place. */
function transform(real, imaginary, first, stride, n) {
  for (let i = 1, j = 0; i < n; ++i) {
    let bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j)
      for (const part of [real, imaginary])
        [part[first + i * stride], part[first + j * stride]] = [part[first + j * stride], part[first + i * stride]];
  }
  for (let half = 1; half < n; half *= 2)
    for (let k = 0; k < half; ++k) {
      const [c, s] = [Math.cos((-Math.PI * k) / half), Math.sin((-Math.PI * k) / half)];
      for (let i = k; i < n; i += 2 * half) {
        const [a, b] = [first + i * stride, first + (i + half) * stride];
        const [x, y] = [real[b] * c - imaginary[b] * s, real[b] * s + imaginary[b] * c];
        [real[b], imaginary[b]] = [real[a] - x, imaginary[a] - y];
        [real[a], imaginary[a]] = [real[a] + x, imaginary[a] + y];
      }
    }
}

/** The power |F|^2 / count of points [x, y] in [0, 1) at size x size frequencies, the lowest one in the middle. */
function powerOf(points, size) {
  const [real, imaginary] = [new Float64Array(size * size), new Float64Array(size * size)];
  for (const [x, y] of points) ++real[Math.floor(y * size) * size + Math.floor(x * size)];
  for (let row = 0; row < size; ++row) transform(real, imaginary, row * size, 1, size);
  for (let column = 0; column < size; ++column) transform(real, imaginary, column, size, size);
  const power = new Float64Array(size * size);
  for (let i = 0; i < size * size; ++i) {
    const [x, y] = [((i % size) + size / 2) % size, (Math.floor(i / size) + size / 2) % size];
    power[y * size + x] = (real[i] ** 2 + imaginary[i] ** 2) / Math.max(1, points.length);
  }
  power[(size / 2) * size + size / 2] = 0;
  return power;
}

/** Random numbers in [0, 1) from a seed of 32 bits. */
function randomFrom(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let v = Math.imul(state ^ (state >>> 15), state | 1);
    v ^= v + Math.imul(v ^ (v >>> 7), v | 61);
    return ((v ^ (v >>> 14)) >>> 0) / 4294967296;
  };
}

/** Bridson's points (SIGGRAPH sketches 2007) in a unit square that knows nothing of the squares around it. */
function chunkPoints(distance, seed) {
  const random = randomFrom(seed);
  const cells = Math.max(1, Math.ceil(Math.SQRT2 / distance));
  const grid = new Int32Array(cells * cells).fill(-1);
  const points = [];
  const cell = (v) => Math.min(cells - 1, Math.floor(v * cells));
  const add = (x, y) => {
    grid[cell(y) * cells + cell(x)] = points.length;
    points.push([x, y]);
  };
  const fits = (x, y) => {
    if (x < 0 || x >= 1 || y < 0 || y >= 1) return false;
    for (let j = Math.max(0, cell(y) - 2); j <= Math.min(cells - 1, cell(y) + 2); ++j)
      for (let i = Math.max(0, cell(x) - 2); i <= Math.min(cells - 1, cell(x) + 2); ++i) {
        const other = grid[j * cells + i];
        if (other >= 0 && Math.hypot(points[other][0] - x, points[other][1] - y) < distance) return false;
      }
    return true;
  };
  add(random(), random());
  const active = [0];
  while (active.length > 0) {
    const chosen = Math.floor(random() * active.length);
    const [x, y] = points[active[chosen]];
    let found = false;
    for (let attempt = 0; attempt < 30 && !found; ++attempt) {
      const [angle, away] = [2 * Math.PI * random(), distance * Math.sqrt(1 + 3 * random())];
      const [px, py] = [x + away * Math.cos(angle), y + away * Math.sin(angle)];
      if (!fits(px, py)) continue;
      active.push(points.length);
      add(px, py);
      found = true;
    }
    if (!found) active.splice(chosen, 1);
  }
  return points;
}

/** The numbers of points [x, y] that have another one nearer than a distance, and the smallest distance. */
function nearPairs(points, distance) {
  const cells = new Map();
  const key = (x, y) => Math.floor(x / distance) * 2 ** 26 + Math.floor(y / distance); // at most 2^25 apart
  points.forEach(([x, y], i) => {
    const list = cells.get(key(x, y));
    if (list) list.push(i);
    else cells.set(key(x, y), [i]);
  });
  const near = new Set();
  let smallest = Infinity;
  points.forEach(([x, y], i) => {
    for (let dy = -1; dy <= 1; ++dy)
      for (let dx = -1; dx <= 1; ++dx)
        for (const other of cells.get(key(x + dx * distance, y + dy * distance)) || []) {
          if (other === i) continue;
          const away = Math.hypot(points[other][0] - x, points[other][1] - y);
          smallest = Math.min(smallest, away);
          if (away < distance * (1 - 1e-9)) near.add(i);
        }
  });
  return { near, smallest };
}

/** How a point's random bits turn and size an instance: radians counterclockwise, and a factor. */
const instanceOf = (id) => ({ turn: ((id >>> 8) & 255) / 40.74, size: 0.7 + ((id >>> 16) & 255) / 255 });

/** An instancer of triangles around points, each turned and sized by its number. */
function usdOf(points, comment, radius) {
  const list = (what) => `[${points.map(what).join(", ")}]`;
  const corner = (k) => `(${radius * Math.cos(2.0944 * k)}, ${radius * Math.sin(2.0944 * k)}, 0)`;
  const turned = ({ turn }) => `(${Math.cos(turn / 2).toFixed(4)}, 0, 0, ${Math.sin(turn / 2).toFixed(4)})`;
  return `#usda 1.0\n# ${comment}\ndef PointInstancer "points"\n{\n    rel prototypes = </points/triangle>\n` +
         `    int[] protoIndices = ${list(() => 0)}\n    int64[] ids = ${list((p) => p.id)}\n` +
         `    point3f[] positions = ${list((p) => `(${p.position[0]}, ${p.position[1]}, 0)`)}\n` +
         `    quath[] orientations = ${list((p) => turned(instanceOf(p.id)))}\n` +
         `    float3[] scales = ${list((p) => `(${Array(3).fill(instanceOf(p.id).size.toFixed(4)).join(", ")})`)}\n` +
         `    def Mesh "triangle"\n    {\n        int[] faceVertexCounts = [3]\n        int[] faceVertexIndices = [0, 1, 2]\n` +
         `        point3f[] points = [${[0, 1, 2].map(corner).join(", ")}]\n    }\n}\n`;
}

/** Points { position, level, id } as the text of a file of a kind: csv, ply or usda. `radius`: of instances. */
function fileOf(kind, points, comment, radius) {
  const rows = (row) => points.map(row).join("\n");
  if (kind === "csv") return `x,y,level,id\n${rows((p) => `${p.position[0]},${p.position[1]},${p.level},${p.id}`)}\n`;
  if (kind === "usda") return usdOf(points, comment, radius);
  return `ply\nformat ascii 1.0\ncomment ${comment}\nelement vertex ${points.length}\nproperty double x\n` +
         `property double y\nend_header\n${rows((p) => `${p.position[0]} ${p.position[1]}`)}\n`;
}
