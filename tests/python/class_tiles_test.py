"""Tiles with classes: how much evener joint relaxation and equal moments make their tilings, by sums over their points."""

import sys
import unittest

import numpy

from support import SOURCE

sys.path.insert(0, str(SOURCE / "python/examples"))
from class_tile_numbers import even_numbers, table


class EvenTiles(unittest.TestCase):
    def test_powers_are_those_of_random_points_and_of_a_lattice(self):
        random = numpy.random.default_rng(1).uniform(0, 16, (16384, 2))
        # The means are over 112, 12 and 738 independent exponential values, but for pairs that are equal.
        for value, count in zip(even_numbers(random, 64), (112, 12, 738)):
            self.assertAlmostEqual(value, 1, delta=5 / count**0.5)
        lattice = numpy.stack(numpy.meshgrid(numpy.arange(64), numpy.arange(64)), axis=2).reshape(-1, 2) / 4
        peaks, low, middle = even_numbers(lattice, 16)
        # Four of the 68 frequencies up to 4.5 cycles a tile, those of 4 cycles, have all points in phase: power 4096.
        self.assertAlmostEqual(peaks, 4 * 4096 / 68, places=6)
        self.assertLess(max(low, middle), 1e-20)

    def test_relaxation_takes_peaks_and_moments_take_low_frequencies(self):
        (alone, together, moments), errors = table(range(1, 5), tilings=1, kind="corner", colors=2, class_points=[12, 36],
                                                   relative_radius=0.62)
        self.assertEqual(errors.shape, (3, 3, 3))
        peaks, low, middle = range(3)
        self.assertLess(together[0, peaks], 0.6 * alone[0, peaks])  # of all points
        self.assertLess(together[0, middle], 0.6 * alone[0, middle])
        for of_set in range(3):  # all points, and each class
            self.assertLess(moments[of_set, low], 0.25 * alone[of_set, low])
            self.assertLess(moments[of_set, low], 0.25 * together[of_set, low])


if __name__ == "__main__":
    unittest.main()
