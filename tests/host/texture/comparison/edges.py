"""Computes lost and added edges by numpy alone, from sorted steps, and prints edges_numbers.hpp.

    /usr/bin/python3 tests/host/texture/comparison/edges.py > tests/host/texture/comparison/edges_numbers.hpp
"""
import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parents[3] / "tiles/texture"))
from novelty import leaves

SIDE, SIGMAS, RADIUS = 192, (0.3, 0.4, 0.5, 0.7, 1, 1.5, 2, 3), 9


def picture(side, seed):
    return leaves(side, side, 1, seed, side * side // 25)[..., 0]


def weights(sigma):
    """Returns a Gaussian in whole 65,536ths, whose sum is exact."""
    bell = np.rint(65536 * np.exp(-np.arange(RADIUS + 1) ** 2 / (2 * sigma**2)) /
                   np.exp(-np.arange(-RADIUS, RADIUS + 1) ** 2 / (2 * sigma**2)).sum()).astype(np.int64)
    bell[0] = 65536 - 2 * bell[1:].sum()
    return bell


def blurred(values, sigma):
    for axis in (0, 1):
        values = sum(w * (np.roll(values, d, axis) + (np.roll(values, -d, axis) if d else 0))
                     for d, w in enumerate(weights(sigma)))
    return (values + 2**31) >> 32


def pasted(exemplar, block):
    """Pastes blocks of the exemplar from random places, which do not depend on their neighbours."""
    result, state = np.zeros((2 * SIDE, 2 * SIDE), np.int64), 7
    for y in range(0, 2 * SIDE, block):
        for x in range(0, 2 * SIDE, block):
            places = []
            for _ in range(2):
                state = (state * 1664525 + 1013904223) % 2**32
                places.append((state >> 16) % (SIDE - block + 1))
            result[y:y + block, x:x + block] = exemplar[places[1]:places[1] + block, places[0]:places[0] + block]
    return result


def blend(weight):
    """Adds three pictures by the same law with a weight in 256ths: 85 gives their mean, 148 restores the variance."""
    return np.clip(96 + ((sum(picture(2 * SIDE, seed) - 96 for seed in (2, 3, 4)) * weight + 128) >> 8), 0, 255)


def steps(values):
    """Returns the sorted steps between neighbours within windows of half of the exemplar's side."""
    half = SIDE // 2
    windows = [values[y:y + half, x:x + half] for y in range(0, len(values), half) for x in range(0, len(values), half)]
    return [np.sort(np.concatenate([np.abs(np.diff(w, axis=a)).ravel() for a in (0, 1)])) for w in windows]


def change(texture, exemplar):
    one, other = np.sort(np.concatenate(steps(texture))), np.sort(np.concatenate(steps(exemplar)))
    other = np.repeat(other, len(one) // len(other))
    excess = max(np.maximum(one - limit, 0).mean() - np.maximum(other - limit, 0).mean() for limit in range(256))
    tenth = len(one) // 10  # 72,960 and 291,840 steps are whole tenths
    lost = max(0, 1 - one[-tenth:].mean() / other[-tenth:].mean())
    return lost + min(lost, np.maximum(one - other, 0).mean() / other.mean()), excess / other.mean()


def main():
    exemplar, natural = picture(SIDE, 1), picture(2 * SIDE, 2)
    windows = steps(exemplar)
    own = np.mean([np.abs(a - b).mean() / b.mean() for i, a in enumerate(windows) for j, b in enumerate(windows)
                   if i != j])
    print("// Printed by edges.py.\n#pragma once\n\nnamespace poissonlab {\n")
    print("/// Gaussians of growing width in whole 65,536ths, from the middle to one side.\n"
          f"inline constexpr int edge_blurs[{len(SIGMAS)}][{RADIUS + 1}] = {{")
    for sigma in SIGMAS:
        print("    {" + ", ".join(str(w) for w in weights(sigma)) + "},")
    print("};\n\n/// The change of edges that is natural for the exemplar.")
    print(f"inline constexpr double edge_natural = {max(0.025, own):.12g};\n")
    print("/// Lost and added edges of another picture by the same law; of it by these blurs; of blocks of 12, 48 and 96\n"
          "/// pixels; and of three pictures that are added with weights of 85 and 148 in 256.")
    rows = [natural, *(blurred(natural, s) for s in SIGMAS), *(pasted(exemplar, b) for b in (12, 48, 96)), blend(85),
            blend(148)]
    print(f"inline constexpr double edge_changes[{len(rows)}][2] = {{")
    for row in rows:
        print("    {" + ", ".join(f"{v:.12g}" for v in change(row, exemplar)) + "},")
    print("};\n\n}")


main()
