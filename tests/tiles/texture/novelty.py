"""Novelty by numpy alone, as tiles/texture/patch_novelty.hpp defines it: whole patches are transformed, one by one, and
compared with all others. Prints what novelty_numbers.hpp has.

    /usr/bin/python3 tests/tiles/texture/novelty.py > tests/tiles/texture/novelty_numbers.hpp
"""
import numpy as np

SIDE, FREQUENCIES, COEFFICIENTS = 15, 9, 40


def leaves(width, height, channels, seed, count=900):
    """Opaque disks over each other, by whole numbers alone."""
    picture = np.zeros((height, width, channels), np.int64)
    y, x = np.mgrid[0:height, 0:width]
    state = seed
    for _ in range(count):
        numbers = []
        for _ in range(6):
            state = (state * 1664525 + 1013904223) % 2**32
            numbers.append(state >> 16)
        radius = 4 + numbers[2] % 5
        disk = (x - numbers[0] % width) ** 2 + (y - numbers[1] % height) ** 2 <= radius * radius
        light = numbers[3] % 192
        picture[disk] = [light, light + numbers[4] % 64, light + numbers[5] % 64][:channels]
    return picture


def blocks(picture, side, seed):
    """Blocks of side x side pixels of the picture in another order."""
    rows, columns = picture.shape[0] // side, picture.shape[1] // side
    order, state = list(range(rows * columns)), seed
    for i in range(len(order) - 1, 0, -1):
        state = (state * 1664525 + 1013904223) % 2**32
        j = (state >> 16) % (i + 1)
        order[i], order[j] = order[j], order[i]
    result = np.zeros((rows * side, columns * side, picture.shape[2]), np.int64)
    for to, at in enumerate(order):
        r, c = to // columns * side, to % columns * side
        a, b = at // columns * side, at % columns * side
        result[r:r + side, c:c + side] = picture[a:a + side, b:b + side]
    return result


def opponent(picture):
    if picture.shape[2] == 1:
        return picture.astype(float)
    return picture @ np.array([[1, 1, 1], [1, 0, -2], [1, -1, 1]]) / np.sqrt([3, 2, 6])


def patches(picture, step):
    """Coefficients of patches (rows, columns, channel * u * v): products with the outer products of cosines."""
    i, k = np.arange(SIDE), np.arange(FREQUENCIES)[:, None]
    cosines = np.where(k == 0, 1, 2**0.5) / SIDE**0.5 * np.cos(np.pi * k * (2 * i + 1) / (2 * SIDE))
    cosines = np.round(cosines * 2**14) / 2**14
    planes = opponent(picture)
    height, width, _ = planes.shape
    return np.array([[np.einsum("vj,jic,ui->cuv", cosines, planes[y:y + SIDE, x:x + SIDE], cosines).ravel()
                      for x in range(0, width - SIDE + 1, step)] for y in range(0, height - SIDE + 1, step)])


def nearest(asked, known):
    return np.array([((known - one) ** 2).sum(1).min() for one in asked])


class Novelty:
    def __init__(self, exemplar):
        sparse = patches(exemplar, SIDE // 4).reshape(-1, exemplar.shape[2] * FREQUENCIES**2)
        self.chosen = np.sort(np.argsort(-sparse.var(0), kind="stable")[:COEFFICIENTS])
        grid = patches(exemplar, 1)[..., self.chosen]
        rows, columns, count = grid.shape
        width, half, apart = exemplar.shape[1], exemplar.shape[1] // 2, max(1, max(rows, columns) // 32)
        west, east = np.arange(columns) + SIDE <= half, np.arange(columns) >= width - half
        distances = np.concatenate([
            nearest(grid[::apart][:, one & (np.arange(columns) % apart == 0)].reshape(-1, count),
                    grid[:, other].reshape(-1, count)) for one, other in ((west, east), (east, west))])
        self.known = grid.reshape(-1, count)
        self.threshold = np.sort(distances)[int(0.9 * len(distances)) - 1]
        self.natural = (distances > self.threshold).mean()

    def share(self, picture, step=4):
        asked = patches(picture, step)[..., self.chosen]
        return (nearest(asked.reshape(-1, len(self.chosen)), self.known) > self.threshold).mean()


def main():
    print("// Printed by novelty.py.\n#pragma once\n\nnamespace poissonlab {\n")
    print("/// For one channel and three: the threshold, the part of the patches in halves of the exemplar above it, then "
          "shares\n/// of new patches in plain repetition, in another picture by the same law, and in blocks in another "
          "order.\ninline constexpr double novelty_numbers[2][5] = {")
    for channels in (1, 3):
        exemplar = leaves(120, 100, channels, 1)
        novelty = Novelty(exemplar)
        repeated = np.tile(exemplar[10:58, 20:68], (3, 3, 1))
        shares = [novelty.share(each) for each in
                  (repeated, leaves(120, 100, channels, 2), blocks(exemplar, 5, 5))]
        print("    {" + ", ".join(f"{v:.8g}" for v in (novelty.threshold, novelty.natural, *shares)) + "},")
    print("};\n\n}")


if __name__ == "__main__":
    main()
