// Files that the page of hand-drawn tiles saves: PNG, ZIP, and a texture set of these (docs/texture-set.md).
"use strict";

const crcTable = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = crcTable[(crc ^ byte) & 255] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

const joined = (parts) => {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
};

/** The bytes of numbers, given as pairs of a number and how many bytes it has. */
function bytesOfNumbers(pairs, littleEndian) {
  const view = new DataView(new ArrayBuffer(pairs.reduce((sum, [, size]) => sum + size, 0)));
  let at = 0;
  for (const [number, size] of pairs) {
    if (size === 1) view.setUint8(at, number);
    else if (size === 2) view.setUint16(at, number, littleEndian);
    else view.setUint32(at, number, littleEndian);
    at += size;
  }
  return new Uint8Array(view.buffer);
}

async function deflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** A PNG of three channels, 8 or 16 bits. */
async function pngFile({ width, height, values }) {
  const depth = 8 * values.BYTES_PER_ELEMENT, line = (3 * width * depth) / 8;
  const rows = new Uint8Array(height * (line + 1)), view = new DataView(rows.buffer);
  for (let row = 0; row < height; ++row)
    for (let i = 0; i < 3 * width; ++i) {
      const at = row * (line + 1) + 1 + (i * depth) / 8, value = values[row * 3 * width + i];
      if (depth === 8) rows[at] = value;
      else view.setUint16(at, value);
    }
  const chunk = (name, data) => {
    const named = joined([new TextEncoder().encode(name), data]);
    return joined([bytesOfNumbers([[data.length, 4]]), named, bytesOfNumbers([[crc32(named), 4]])]);
  };
  return joined([
    Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10),
    chunk("IHDR", bytesOfNumbers([[width, 4], [height, 4], [depth, 1], [2, 1], [0, 1], [0, 1], [0, 1]])),
    chunk("IDAT", await deflated(rows)),
    chunk("IEND", new Uint8Array(0)),
  ]);
}

/** A ZIP archive of files as they are, from pairs of a name and bytes. */
function zipFile(files) {
  const parts = [], directory = [];
  let offset = 0;
  for (const [name, bytes] of files) {
    const letters = new TextEncoder().encode(name);
    // Names are UTF-8, nothing is compressed, and the date is the first that there is: equal drawings are equal files.
    const head = [[0x0800, 2], [0, 2], [0, 2], [33, 2], [crc32(bytes), 4], [bytes.length, 4], [bytes.length, 4], [letters.length, 2], [0, 2]];
    const local = joined([bytesOfNumbers([[0x04034b50, 4], [20, 2], ...head], true), letters]);
    directory.push(joined([
      bytesOfNumbers([[0x02014b50, 4], [20, 2], [20, 2], ...head, [0, 2], [0, 2], [0, 2], [0, 4], [offset, 4]], true), letters,
    ]));
    parts.push(local, bytes);
    offset += local.length + bytes.length;
  }
  const index = joined(directory);
  const end = bytesOfNumbers([[0x06054b50, 4], [0, 2], [0, 2], [files.length, 2], [files.length, 2], [index.length, 4], [offset, 4], [0, 2]], true);
  return joined([...parts, index, end]);
}

/** XXH64 of bytes, with seed 0, as 16 digits. */
function xxh64(bytes) {
  const [p1, p2, p3, p4, p5] = [11400714785074694791n, 14029467366897019727n, 1609587929392839161n, 9650029242287828579n, 2870177450012600261n];
  const cut = (v) => BigInt.asUintN(64, v), turned = (v, by) => cut((v << by) | (v >> (64n - by)));
  const round = (sum, word) => cut(turned(cut(sum + word * p2), 31n) * p1);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  let at = 0, hash = p5;
  if (bytes.length >= 32) {
    const sums = [cut(p1 + p2), p2, 0n, cut(-p1)];
    for (; at + 32 <= bytes.length; at += 32) for (let i = 0; i < 4; ++i) sums[i] = round(sums[i], view.getBigUint64(at + 8 * i, true));
    hash = cut([1n, 7n, 12n, 18n].reduce((sum, by, i) => sum + turned(sums[i], by), 0n));
    for (const sum of sums) hash = cut((hash ^ round(0n, sum)) * p1 + p4);
  }
  hash = cut(hash + BigInt(bytes.length));
  for (; at + 8 <= bytes.length; at += 8) hash = cut(turned(hash ^ round(0n, view.getBigUint64(at, true)), 27n) * p1 + p4);
  if (at + 4 <= bytes.length) {
    hash = cut(turned(hash ^ cut(BigInt(view.getUint32(at, true)) * p1), 23n) * p2 + p3);
    at += 4;
  }
  for (; at < bytes.length; ++at) hash = cut(turned(hash ^ cut(BigInt(bytes[at]) * p5), 11n) * p1);
  hash = cut((hash ^ (hash >> 33n)) * p2);
  hash = cut((hash ^ (hash >> 29n)) * p3);
  return (hash ^ (hash >> 32n)).toString(16).padStart(16, "0");
}

/** The texture set of drawn tiles, whose exemplar is their atlas, as a ZIP archive of one folder. */
async function textureSetFile(drawing, folder) {
  const { set } = drawing, { atlas, sources, width, height } = drawing.pictures();
  const hash = xxh64(atlas);
  const texture = {
    format: "poissonlab texture set",
    kind: set.kind,
    horizontal_colors: set.colors,
    vertical_colors: set.colors,
    tile_size: set.size,
    ring: set.ring,
    smoothed: false,
    channels: 3,
    atlas_columns: set.columns,
    atlas_rows: set.rows,
    exemplar_hash: hash,
    atlas_hash: hash,
    sources_hash: xxh64(new Uint8Array(sources.buffer)),
    tiles: set.tiles.map(({ index, column, row }) => ({ index, column, row })),
    parameters: { made: "drawn by hand" },
  };
  const picture = await pngFile({ width, height, values: atlas });
  return zipFile([
    [`${folder}/atlas.png`, picture],
    [`${folder}/exemplar.png`, picture],
    [`${folder}/sources.png`, await pngFile({ width, height, values: sources })],
    [`${folder}/texture.json`, new TextEncoder().encode(JSON.stringify(texture, null, 2) + "\n")],
  ]);
}
