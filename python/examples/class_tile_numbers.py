"""The numbers of docs/classes.md on tiles whose points have classes: how even their tilings are as they are, relaxed
together, and with equal moments.

    PYTHONPATH=build/release/python python3 python/examples/class_tile_numbers.py [--kind edge] [--points 12 36] ...

Without options it makes the table of the page. Each value is the mean over sets, and the standard error of this mean. The
power of a set, |F|^2 / N, is the mean over tilings of 16 x 16 tiles.
"""

import argparse

import numpy

import poissonlab as pl

SIDE = 16  # tiles along each axis of a tiling, so that its frequencies are sixteenths of a cycle a tile
VARIANTS = [{}, {"joint_iterations": 20}, {"joint_iterations": 20, "equal_moments": 1}]
RANGES = ["peaks", "low", "middle"]


def principal_frequency(points):
    """The first peak of the densest packing of so many points in a tile, in cycles a tile."""
    return (2 / 3**0.5 * points)**0.5


def powers(positions, frequencies):
    """|F|^2 / N at all pairs of frequencies along both axes; positions in tiles."""
    waves = [numpy.exp(-2j * numpy.pi * numpy.outer(frequencies, positions[:, axis])) for axis in range(2)]
    return abs(waves[0] @ waves[1].T)**2 / len(positions)


def even_numbers(positions, all_points):
    """The mean power of points, in tiles, in three ranges of frequencies: at those of the lattice up to 1.05 times the
    principal frequency of all points of a tile; at a quarter of the tiles' frequency; between the lattice's, from 0.6 to 1.5
    of the tiles' frequency."""
    largest = 1.05 * principal_frequency(all_points)
    whole = numpy.arange(-int(largest), int(largest) + 1)
    lengths = numpy.hypot(*numpy.meshgrid(whole, whole))
    peaks = powers(positions, whole)[(lengths > 0) & (lengths <= largest)]
    parts = numpy.arange(-24, 25)
    steps = numpy.meshgrid(parts, parts)
    lengths = numpy.hypot(*steps) / SIDE
    power = powers(positions, parts / SIDE)
    of_lattice = (steps[0] % SIDE == 0) & (steps[1] % SIDE == 0)
    low = power[abs(lengths - 0.25) < 0.5 / SIDE]
    middle = power[(lengths >= 0.6) & (lengths <= 1.5) & ~of_lattice]
    return [values.mean() for values in (peaks, low, middle)]


def numbers_of_set(tilings=8, **keys):
    """Builds a set; for all points and for each class its numbers, an array of shape (1 + classes, 3)."""
    made = pl.tiles.keys(**keys)  # its file is there as long as it is
    class_points = pl.TileSet(made.files[0]).class_points
    found = []
    for seed in range(1, tilings + 1):
        tiling = pl.distribute.classes(tiles=str(made.files[0]), torus=SIDE, rng=seed)
        points = tiling.points * SIDE
        sets = [points] + [points[tiling.classes == k] for k in range(len(class_points))]
        found.append([even_numbers(positions, sum(class_points)) for positions in sets])
    return numpy.mean(found, axis=0)


def table(seeds, **keys):
    """Means over the sets of these seeds for each of VARIANTS, and their standard errors: shape (2, variants, 1 + classes, 3)."""
    found = numpy.array([[numbers_of_set(rng=seed, **variant, **keys) for variant in VARIANTS] for seed in seeds])
    return numpy.array([found.mean(axis=0), found.std(axis=0, ddof=1) / len(found)**0.5])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kind", default="corner", choices=["corner", "edge", "template"])
    parser.add_argument("--colors", type=int, default=3, help="of corner and edge tiles; for template tiles their number")
    parser.add_argument("--points", type=int, nargs="+", default=[8, 16, 40], help="of each class in a tile")
    parser.add_argument("--relative-radius", type=float, default=0.65)
    parser.add_argument("--seeds", type=int, default=4, help="sets of each row, of the seeds 1, 2, ...")
    given = parser.parse_args()
    size = "tiles" if given.kind == "template" else "colors"
    means, errors = table(range(1, given.seeds + 1), kind=given.kind, class_points=given.points,
                          relative_radius=given.relative_radius, **{size: given.colors})
    print(f"| | points | {' | '.join(RANGES)} |\n| --- | --- | --- | --- | --- |")
    for variant, of_variant, uncertain in zip(VARIANTS, means, errors):
        name = " ".join(f"--{key.replace('_', '-')} {value}" for key, value in variant.items()) or "as it is"
        for points, values, off in zip(["all", *given.points], of_variant, uncertain):
            print(f"| {name} | {points} | " + " | ".join(f"{v:.2g} ± {o:.1g}" for v, o in zip(values, off)) + " |")
            name = ""


if __name__ == "__main__":
    main()
