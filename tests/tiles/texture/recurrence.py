"""What recurs in a tiling, by numpy's transform of the whole picture. Prints what recurrence_numbers.hpp has.

    /usr/bin/python3 tests/tiles/texture/recurrence.py > tests/tiles/texture/recurrence_numbers.hpp
"""
import numpy as np


def three_tiles(channels):
    """9 x 6 tiles of 7 x 5 pixels, each one of three, by whole numbers alone."""
    state = channels

    def number():
        nonlocal state
        state = (state * 1664525 + 1013904223) % 2**32
        return state >> 16

    tiles = [np.array([number() % 256 for _ in range(35 * channels)]).reshape(5, 7, channels) for _ in range(3)]
    return np.concatenate([np.concatenate([tiles[number() % 3] for _ in range(9)], axis=1) for _ in range(6)])


def recurrence(picture, width, height):
    """The share of the power at multiples of 1/width and 1/height, less the share of such frequencies."""
    power = (np.abs(np.fft.fft2(picture, axes=(0, 1)))**2).sum(2)
    power[0, 0] = 0
    rows, columns = picture.shape[0] // height, picture.shape[1] // width
    lattice = power[::rows, ::columns]
    chance = (lattice.size - 1) / (power.size - 1)
    return (lattice.sum() / power.sum() - chance) / (1 - chance)


def main():
    print("// Printed by recurrence.py.\n#pragma once\n\nnamespace poissonlab {\n")
    print("/// For one channel and three: what recurs with each tile, and with 3 x 2 tiles.\n"
          "inline constexpr double recurrence_numbers[2][2] = {")
    for channels in (1, 3):
        picture = three_tiles(channels)
        print(f"    {{{recurrence(picture, 7, 5):.15g}, {recurrence(picture, 21, 10):.15g}}},")
    print("};\n\n}")


main()
