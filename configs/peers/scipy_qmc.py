"""A point set of scipy.stats.qmc: METHOD POINTS DIMENSION SEED FILE. Writes a point a line.

Poisson disk sampling is asked for a radius with which as many points fit; it stops when the square is full, or at that
number.
"""
import sys

import numpy
from scipy.stats import qmc

# Bridson's algorithm fills the square at about this part of the distance of the densest packing.
FILLED = 0.70
DENSEST = {2: (2 / 3**0.5) ** 0.5, 3: 2 ** (1 / 6)}


def sampler(method, points, dimension, seed):
    if method == "poisson-disk":
        radius = FILLED * DENSEST[dimension] * points ** (-1 / dimension)
        return qmc.PoissonDisk(dimension, radius=radius, seed=seed)
    if method == "sobol":
        return qmc.Sobol(dimension, scramble=True, seed=seed)
    if method == "halton":
        return qmc.Halton(dimension, scramble=True, seed=seed)
    if method == "latin-hypercube":
        return qmc.LatinHypercube(dimension, seed=seed)
    sys.exit(f"{method}: must be poisson-disk, sobol, halton or latin-hypercube")


def main():
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    method, points, dimension, seed, out = sys.argv[1:]
    points = int(points)
    made = sampler(method, points, int(dimension), int(seed))
    numpy.savetxt(out, made.random(points), fmt="%.17g")


main()
