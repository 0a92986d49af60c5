"""Hex-tiling and by-example noise written down from their papers with numpy, in floating-point numbers: prints what
papers_numbers.hpp has. Hashes are those of runtime/texture_tiles.h, on which the papers leave all choice."""
import numpy as np

W, H, CELL, ROW, SEED = 97, 83, 24, 21, 5  # 83 / (2 sqrt 3) = 23.96, 24 sqrt(3) / 2 = 20.78


def mix(v):
    v = ((v ^ (v >> 16)) * 0x21F0AAAD) & 0xFFFFFFFF
    v = ((v ^ (v >> 15)) * 0xD35A2D97) & 0xFFFFFFFF
    return v ^ (v >> 15)


def exemplar(channels):
    y, x, c = np.mgrid[0:H, 0:W, 0:channels]
    return ((x * x * 7 + y * y * 3 + x * y * 5 + c * 91) % 251 * (x % 13 + 12) // 25).astype(np.int64)


def triangle(x, y):
    """Vertices and barycentric weights: Listing 1 of Heitz and Neyret, skewed by the grid's own row height."""
    skewed = np.array([x / CELL - y / (2 * ROW), y / ROW])
    base = np.floor(skewed + 1e-12).astype(int)
    fx, fy = skewed - base
    z = 1 - fx - fy
    if z > 1e-12:
        return [(base + (0, 0), z), (base + (0, 1), fy), (base + (1, 0), fx)]
    return [(base + (1, 1), -z), (base + (1, 0), 1 - fy), (base + (0, 1), 1 - fx)]


def texel(picture, vertex, x, y):
    i, j = int(vertex[0]), int(vertex[1])
    h = mix((mix((mix(SEED) + (i & 0xFFFFFFFF)) & 0xFFFFFFFF) + (j & 0xFFFFFFFF)) & 0xFFFFFFFF)
    column = CELL + ((h & 0xFFFF) * (W - 2 * CELL) >> 16) + x - (i * CELL + j * CELL // 2)
    row = ROW + ((h >> 16) * (H - 2 * ROW) >> 16) + y - j * ROW
    return picture[row, column]


def turned(picture, vertex, x, y):
    """A piece that is turned around its lattice point, by one of 256 angles up to half a turn to either side."""
    i, j = int(vertex[0]), int(vertex[1])
    h = mix((mix((mix(SEED) + (i & 0xFFFFFFFF)) & 0xFFFFFFFF) + (j & 0xFFFFFFFF)) & 0xFFFFFFFF)
    angle = np.pi * ((2 * (mix(h) >> 24) + 1) / 256 - 1)
    reach = CELL + 2
    dx, dy = x - (i * CELL + j * CELL // 2), y - j * ROW
    column = reach + ((h & 0xFFFF) * (W - 2 * reach) >> 16) + np.cos(angle) * dx - np.sin(angle) * dy
    row = reach + ((h >> 16) * (H - 2 * reach) >> 16) + np.sin(angle) * dx + np.cos(angle) * dy
    c, r = int(np.floor(column)), int(np.floor(row))
    u, v = column - c, row - r
    return ((1 - u) * ((1 - v) * picture[r, c] + v * picture[r + 1, c])
            + u * ((1 - v) * picture[r, c + 1] + v * picture[r + 1, c + 1]))


def hexagons(picture, x, y, piece=texel):
    """Mikkelsen, Listing 4: weights by lightness and a power, no contrast."""
    seen = [(piece(picture, v, x, y).astype(float), w) for v, w in triangle(x, y)]
    light = [np.dot(c, (0.299, 0.587, 0.114)) / 255 if len(c) == 3 else c[0] / 255 for c, _ in seen]
    weights = np.array([(1 + 0.6 * (l - 1)) * w**7 for l, (_, w) in zip(light, seen)])
    weights /= weights.sum()
    return sum(w * c for w, (c, _) in zip(weights, seen))


def gaussian(picture):
    """The quantiles of ranks, of a grey exemplar; equal values by their neighbourhoods."""
    from scipy.special import ndtri
    from scipy.ndimage import convolve
    grey = picture[:, :, 0]
    near = convolve(grey, np.ones((3, 3), int), mode="constant")
    far = convolve(grey, np.ones((5, 5), int), mode="constant")
    ties = (np.arange(grey.size) * 0x9E3779B1) % 2**32
    order = np.lexsort((ties, far.ravel(), near.ravel(), grey.ravel()))
    numbers = np.empty(grey.size)
    numbers[order] = ndtri((np.arange(grey.size) + 0.5) / grey.size)
    return numbers.reshape(grey.shape), np.sort(grey.ravel())


def blended(numbers, values, x, y, moved):
    """Heitz and Neyret: blending at equal variance, then the exemplar's own quantile, of a number moved a little."""
    from scipy.special import ndtr
    seen = [(texel(numbers, v, x, y), w) for v, w in triangle(x, y)]
    g = sum(w * n for n, w in seen) / np.sqrt(sum(w * w for _, w in seen))
    return values[min(len(values) - 1, int(ndtr(g + moved) * len(values)))]


def lines(name, numbers):
    print(f"inline constexpr double {name}[] = {{")
    for i in range(0, len(numbers), 12):
        print("    " + ", ".join(f"{v:.4g}" for v in numbers[i:i + 12]) + ",")
    print("};\n")


print("// Printed by hexagons.py: pixels of hex-tiling, and of by-example noise with numbers moved by 1 / 128 either way.\n"
      "#pragma once\n\nnamespace poissonlab {\n")
window = [(x, y) for y in range(-9, 30, 3) for x in range(-40, 60, 7)]
colored, grey = exemplar(3), exemplar(1)
lines("hexagon_colors", [v for x, y in window for v in hexagons(colored, x, y)])
lines("turned_colors", [v for x, y in window for v in hexagons(colored, x, y, turned)])
numbers, values = gaussian(grey)
for name, moved in (("lower_noise", -1 / 128), ("upper_noise", 1 / 128)):
    lines(name, [blended(numbers, values, x, y, moved) for x, y in window])
print("}")
