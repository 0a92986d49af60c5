"""A point set of blue-sampler: METHOD POINTS DIMENSION SEED FILE. Writes a point a line.

The package takes its random numbers from numpy, which is given the seed; some of its methods make a generator of their
own, whose sets differ from run to run. Releases before 2.0 have one method, and no name for it.
"""
import sys

import numpy
import blue_sampler


def main():
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    method, points, dimension, seed, out = sys.argv[1:]
    numpy.random.seed(int(seed))
    made = blue_sampler.sample_points(N=int(points), D=int(dimension), method=method, verbose=0)
    if hasattr(made, "detach"):
        made = made.detach().cpu().numpy()
    numpy.savetxt(out, numpy.asarray(made, dtype=float) % 1.0, fmt="%.17g")


main()
