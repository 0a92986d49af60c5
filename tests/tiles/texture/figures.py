"""Builds sets of texture tiles of every exemplar and prints the figures of docs/texture-tiles.md.

    /usr/bin/python3 tests/tiles/texture/figures.py build/release/poissonlab FOLDER [--only NAME ...] [--seeds 1 2 3]

FOLDER keeps the sets and a line of JSON for each of them, so that a run that was stopped goes on where it was. Regions,
variances of blocks and lines of seams are measured here by numpy and scipy, from the pixels and sources that the sets
have; `texture verify --json` gives the rest. One exemplar and seed take about a minute of processor time.
"""
import argparse
import json
import struct
import subprocess
import zlib
from pathlib import Path

import numpy as np
from scipy import ndimage
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

EXEMPLARS = Path(__file__).parents[3] / "configs/exemplars"
PHOTOGRAPHS = "gravel cork sand grass turf leaves granite pebbles stones brick fabric clouds".split()
COLORS, SIZE, BLOCK = 3, 64, 64


def write_png(path, picture):
    height, width, channels = picture.shape
    rows = np.concatenate([np.zeros((height, 1), np.uint8), picture.reshape(height, -1).astype(np.uint8)], axis=1)
    head = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2}[channels], 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for name, data in ((b"IHDR", head), (b"IDAT", zlib.compress(rows.tobytes())), (b"IEND", b"")):
            file.write(struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)))


def unfiltered(line, filter_type, above, step):
    """Returns the bytes of a row from what its filter has left of them (PNG specification, section 9)."""
    if filter_type in (0, 2):
        return line + above if filter_type else line
    if filter_type == 1:
        return np.cumsum(line.reshape(-1, step), axis=0, dtype=np.uint8).ravel()
    row, above = line.tolist(), above.tolist()
    for x in range(len(row)):
        left, up, corner = row[x - step] if x >= step else 0, above[x], above[x - step] if x >= step else 0
        if filter_type == 3:
            row[x] = (row[x] + (left + up) // 2) & 255
        else:
            far = (abs(up - corner), abs(left - corner), abs(left + up - 2 * corner))
            row[x] = (row[x] + (left, up, corner)[far.index(min(far))]) & 255
    return np.array(row, np.uint8)


def read_png(path):
    """Returns (rows, columns, channels) of a picture of 8 or 16 bits, without its alpha."""
    data, at, packed, palette = Path(path).read_bytes(), 8, b"", None
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        chunk = data[at + 8:at + 8 + length]
        at += 12 + length
        if name == b"IHDR":
            width, height, depth, kind = struct.unpack(">IIBB", chunk[:10])
        elif name == b"PLTE":
            palette = np.frombuffer(chunk, np.uint8).reshape(-1, 3)
        elif name == b"IDAT":
            packed += chunk
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[kind]
    step = channels * depth // 8
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + width * step)
    above, result = np.zeros(width * step, np.uint8), []
    for row in rows:
        above = unfiltered(row[1:], row[0], above, step)
        result.append(above)
    picture = np.array(result).reshape(height, width, -1)
    if depth == 16:
        picture = picture[..., ::2].astype(np.int64) * 256 + picture[..., 1::2]
    if kind == 3:
        picture = palette[picture[..., 0]]
    return picture[..., :{1: 1, 2: 1, 3: 3, 4: 3}[picture.shape[2]]]


def dead_leaves(seed, side=512, leaves=2600):
    """Opaque leaves over each other: ellipses of 22 to 46 pixels, each in one colour."""
    random, picture = np.random.default_rng(seed), np.zeros((side, side, 3), np.int64)
    y, x = np.mgrid[:side, :side]
    for _ in range(leaves):
        cx, cy = random.uniform(-30, side + 30, 2)
        long, turn = random.uniform(11, 23), random.uniform(0, np.pi)
        short, color = long * random.uniform(0.4, 0.9), random.integers(20, 236, 3)
        box = np.s_[max(0, int(cy) - 24):max(0, int(cy) + 25), max(0, int(cx) - 24):max(0, int(cx) + 25)]
        dx, dy = x[box] - cx, y[box] - cy
        u, v = dx * np.cos(turn) + dy * np.sin(turn), dy * np.cos(turn) - dx * np.sin(turn)
        picture[box][(u / long) ** 2 + (v / short) ** 2 < 1] = color
    return picture


def windows(picture, shape):
    """Returns parts of a tiling that are as large as the exemplar, since extremes depend on size."""
    height, width = shape[:2]
    return [picture[y:y + height, x:x + width] for y in range(0, picture.shape[0] - height + 1, height)
            for x in range(0, picture.shape[1] - width + 1, width)]


def widest_region(labels):
    """Returns the longer side of the box around the widest region of one label, in pixels."""
    number = np.arange(labels.size).reshape(labels.shape)
    east, south = labels[:, 1:] == labels[:, :-1], labels[1:] == labels[:-1]
    pairs = np.concatenate([np.stack([number[:, :-1][east], number[:, 1:][east]]),
                            np.stack([number[:-1][south], number[1:][south]])], axis=1)
    graph = coo_matrix((np.ones(pairs.shape[1], bool), pairs), (labels.size, labels.size))
    regions = connected_components(graph, False)[1].reshape(labels.shape) + 1
    return max(max(s.stop - s.start for s in box) for box in ndimage.find_objects(regions))


def light(picture):
    return picture.mean(axis=2)


def labeller(exemplar, is_flat):
    """Returns the labels of a picture's colours: those themselves, or four equally frequent levels of blurred light."""
    if is_flat:
        return lambda picture: picture.astype(np.int64) @ np.array([65536, 256, 1])
    limits = np.quantile(ndimage.gaussian_filter(light(exemplar), 2), [0.25, 0.5, 0.75])
    return lambda picture: np.searchsorted(limits, ndimage.gaussian_filter(light(picture), 2))


def block_variance(values, variance):
    """Returns the variance of the means of all squares of BLOCK pixels, in parts of the variance of pixels."""
    sums = np.pad((values - values.mean()).cumsum(0).cumsum(1), ((1, 0), (1, 0)))
    means = sums[BLOCK:, BLOCK:] - sums[:-BLOCK, BLOCK:] - sums[BLOCK:, :-BLOCK] + sums[:-BLOCK, :-BLOCK]
    return (means / BLOCK**2).var() / variance


def worst_line(folder):
    """Returns the share of seams across the worst line between columns or rows of all tiles, over the mean share."""
    texture, sources = json.loads((folder / "texture.json").read_text()), read_png(folder / "sources.png")
    size = texture["tile_size"]
    tiles = np.array([sources[t["row"] * size:(t["row"] + 1) * size, t["column"] * size:(t["column"] + 1) * size, :2]
                      for t in texture["tiles"]]).astype(np.int64)
    shares = []
    for axis, step in ((2, (1, 0)), (1, (0, 1))):
        is_seam = (np.diff(tiles, axis=axis) != step).any(axis=3)
        shares.append(is_seam.mean(axis=tuple({0, 1, 2} - {axis})))
    return max(s.max() for s in shares) / np.mean(shares)


def lab(*words):
    return subprocess.run([str(w) for w in words], check=True, capture_output=True, text=True).stdout


def measured(program, folder, is_flat):
    exemplar = read_png(folder / "exemplar.png")
    label = labeller(exemplar, is_flat)
    regions, variances = [], []
    for seed in (1, 2, 3):
        lab(program, "texture", "tile", folder, "--seed", seed, "--window", 0, 0, 16, 16, "--out", folder / "plain.png")
        tiling = read_png(folder / "plain.png")
        regions += [widest_region(label(part)) for part in windows(tiling, exemplar.shape)[:4]]
        values = light(tiling)
        variances += [block_variance(part, values.var()) for part in windows(values, exemplar.shape)]
    judged = json.loads(lab(program, "texture", "verify", folder, "--json"))
    return {"region": np.mean(regions) / widest_region(label(exemplar)),
            "blocks": np.mean(variances) / block_variance(light(exemplar), light(exemplar).var()),
            "line": worst_line(folder)} | {
                name: judged[name] for name in ("novelty", "recurrence", "seam_mismatch", "conspicuous_seams")}


def built(program, exemplar, folder, seed, joint):
    """Builds a set, and returns whether its tiles are chosen together."""
    said = lab(program, "texture", "build", "corner", "--colors", COLORS, "--size", SIZE, "--exemplar", exemplar,
               "--seed", seed, "--joint", joint, "--out", folder)
    return "Fitted one after another" not in said


def figures(program, name, seed, work):
    exemplar, is_flat = EXEMPLARS / f"{name}.png", name == "dead-leaves"
    if is_flat:
        exemplar = work / "dead-leaves.png"
        write_png(exemplar, dead_leaves(1))
    one = work / f"{name}-{seed}"
    result = {"name": name, "seed": seed}
    is_together = built(program, exemplar, f"{one}-kept", seed, "auto")
    result["together"] = is_together
    result["kept"] = measured(program, Path(f"{one}-kept"), is_flat)
    other = "off" if is_together else "on"
    built(program, exemplar, f"{one}-{other}", seed, other)
    result["other"] = measured(program, Path(f"{one}-{other}"), is_flat)
    picture = read_png(exemplar)
    height, width = picture.shape[0] * 3 // 4, picture.shape[1] * 3 // 4
    write_png(work / f"{name}-{seed}.png", picture[:height, :width])
    built(program, work / f"{name}-{seed}.png", f"{one}-part", seed, "on" if is_together else "off")
    result["part"] = json.loads(lab(program, "texture", "verify", f"{one}-part", "--json"))["recurrence"]
    return result


def by_name(rows):
    return [(name, [row for row in rows if row["name"] == name]) for name in dict.fromkeys(row["name"] for row in rows)]


def print_choice(rows):
    """Prints means over the seeds: of pieces that are fitted one after another, and of tiles that are chosen together."""
    print("| exemplar | seam mismatch | conspicuous seams, % | recurs, % | new patches, % | kept together |")
    print("|" + " --- |" * 6)
    for name, own in by_name(rows):
        sets = [(row["other"], row["kept"]) if row["together"] else (row["kept"], row["other"]) for row in own]
        cells = [", ".join(f"{scale * np.mean([pair[k][key] for pair in sets]):.{digits}f}" for k in (0, 1))
                 for key, scale, digits in (("seam_mismatch", 1, 2), ("conspicuous_seams", 100, 1),
                                            ("recurrence", 100, 1), ("novelty", 100, 1))]
        print(f"| {name} | {' | '.join(cells)} | {sum(row['together'] for row in own)} of {len(own)} |")


def print_figures(rows):
    """Prints the mean over the seeds and the largest value of what the kept sets have."""
    print("| exemplar | widest region | block variance | worst line | recurs, % | of a part, % |")
    print("|" + " --- |" * 6)
    for name, own in by_name(rows):
        values = [[row["kept"][key] for row in own] for key in ("region", "blocks", "line")]
        values += [[100 * row["kept"]["recurrence"] for row in own], [100 * row["part"] for row in own]]
        cells = [f"{np.mean(v):.{d}f}, {max(v):.{d}f}" for v, d in zip(values, (2, 2, 1, 1, 1))]
        print(f"| {name} | {' | '.join(cells)} |")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", nargs="+", default=[*PHOTOGRAPHS, "dead-leaves"])
    parser.add_argument("--seeds", nargs="+", type=int, default=[1, 2, 3])
    asked = parser.parse_args()
    asked.folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for name in asked.only:
        for seed in asked.seeds:
            stored = asked.folder / f"{name}-{seed}.json"
            if not stored.exists():
                stored.write_text(json.dumps(figures(asked.program, name, seed, asked.folder)) + "\n")
            rows.append(json.loads(stored.read_text()))
    print_choice(rows)
    print()
    print_figures(rows)


if __name__ == "__main__":
    main()
