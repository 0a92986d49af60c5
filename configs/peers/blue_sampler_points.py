"""A point set of blue-sampler: METHOD POINTS DIMENSION SEED FILE. Writes a point a line.

The package takes its random numbers from numpy and, where that is there, torch: both are given the seed.
"""
import sys

import numpy
import blue_sampler


def main():
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    method, points, dimension, seed, out = sys.argv[1:]
    numpy.random.seed(int(seed))
    if "torch" in sys.modules:
        sys.modules["torch"].manual_seed(int(seed))
    made = blue_sampler.sample_points(N=int(points), D=int(dimension), method=method)
    if hasattr(made, "detach"):
        made = made.detach().cpu().numpy()
    numpy.savetxt(out, numpy.asarray(made, dtype=float) % 1.0, fmt="%.17g")


main()
