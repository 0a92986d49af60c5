"""Thousands of calls of each kind leave no memory behind."""

import gc
import pathlib
import unittest

import numpy

import poissonlab as pl
from support import TILE_SET

CALLS = 4_000  # arrays of so many calls would be half as much again as what is allowed


def resident():
    """The memory of this process in bytes."""
    pages = int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096


class Memory(unittest.TestCase):
    def assert_keeps_nothing(self, call, bytes_a_call, calls=CALLS, else_kept=4 * 2**20):
        """A call that kept its arrays, of so many bytes, would show: a fifth is allowed, and what else is kept."""
        for _ in range(calls // 10):
            call()
        gc.collect()
        before = resident()
        for _ in range(calls):
            call()
        gc.collect()
        self.assertLess(resident() - before, calls * bytes_a_call / 5 + else_kept)

    def test_would_show(self):
        kept = []
        with self.assertRaises(AssertionError):
            self.assert_keeps_nothing(lambda: kept.append(numpy.ones(800)), 6400)

    def test_of_sets(self):
        sampler = pl.Jittered()
        self.assert_keeps_nothing(lambda: sampler.random(400), 6400)

    def test_of_sets_from_a_device(self):
        sampler = pl.DartThrowing(relative_radius=0.5)
        self.assert_keeps_nothing(lambda: sampler.random(144), 2304)

    def test_of_samplers(self):
        self.assert_keeps_nothing(lambda: pl.Random().random(200), 3200)

    def test_of_windows(self):
        tiles = pl.TileSet(TILE_SET)
        self.assert_keeps_nothing(lambda: tiles.points(0, 0, 2, 2), 12000)

    def test_of_nearest_points(self):
        tiles = pl.TileSet(TILE_SET)
        places = numpy.random.default_rng(1).random((100, 2))
        self.assert_keeps_nothing(lambda: tiles.nearest(places), 5000)

    def test_of_errors(self):
        points = numpy.full((500, 2), 2.0)

        def fail():
            try:
                pl.analyze(points)
            except pl.InputError:
                pass

        self.assert_keeps_nothing(fail, 8000)

    def test_of_analyses(self):
        points = pl.Jittered().random(256)
        # An analysis takes 15 ms. Two hundred spectra would take nearly three times what is allowed.
        self.assert_keeps_nothing(
            lambda: pl.analyze(points, measures="distances").spectrum, 64 * 64 * 8, calls=200, else_kept=2**20
        )


if __name__ == "__main__":
    unittest.main()
