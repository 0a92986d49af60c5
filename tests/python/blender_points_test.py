"""The script for Blender without Blender: its look-ups, in NumPy, have the points of the package to the last bit. What needs
Blender is in tests/runtime/blender."""

import importlib.util
import sys
import unittest

import numpy

import poissonlab as pl
from support import SOURCE, FolderTest, program

FOLDER = SOURCE / "runtime/tile_sets"


def script():
    """runtime/blender/poisson_points.py as a module, of which nothing is left beside it."""
    spec = importlib.util.spec_from_file_location("poisson_points", SOURCE / "runtime/blender/poisson_points.py")
    module = importlib.util.module_from_spec(spec)
    sys.dont_write_bytecode = True
    spec.loader.exec_module(module)
    return module


poisson_points = script()


class BlenderPoints(FolderTest):
    def assert_same_points(self, file, low, size, seed, density):
        tiles = poisson_points.TileSet(file.read_bytes())
        found = tiles.points(low, numpy.add(low, size), seed, density)
        expected = pl.TileSet(file).points(*low, *size, seed=seed, density=density)
        self.assertGreater(len(expected.id), 20)
        self.assert_same_bytes(found.position, expected.position)
        self.assert_same_bytes(found.tile, expected.tile)
        self.assert_same_bytes(found.index, expected.index)
        self.assert_same_bytes(found.id, expected.id)
        self.assert_same_bytes(found.level, expected.level)
        return tiles, found

    def test_have_the_points_of_the_package(self):
        for name, low, size in (("corner-c3-n64-r075", (-2.5, 1.25), (3, 2)), ("corner-c8-n32-r085", (-1e6, 77.5), (1, 4)),
                                ("corner-c4-n64-r085", (2.0**31 - 90, -(2.0**31) + 90), (2.5, 1)),
                                ("sphere-c2-n128-r075", (-1, 2.5, 3), (1, 1.5, 1))):
            for seed, density in ((1, 1.0), (2**32 - 1, 0.3)):
                with self.subTest(name=name, seed=seed):
                    self.assert_same_points(FOLDER / f"{name}.ptiles", low, size, seed, density)

    def test_keep_the_proven_distance(self):
        tiles = poisson_points.TileSet((FOLDER / "corner-c3-n64-r075.ptiles").read_bytes())
        proof = pl.TileSet(FOLDER / "corner-c3-n64-r075.ptiles").verify()
        self.assertAlmostEqual(tiles.min_distance, proof.min_distance, places=12)
        self.assertEqual(tiles.exponent, pl.TileSet(FOLDER / "corner-c3-n64-r075.ptiles").exponent)

    def test_know_every_kind_of_tiles(self):
        for words in ("edge --colors 2 --points 9", "template --tiles 5 --points 16 --ranked",
                      "corner --colors 2 --points 9 --border chain"):
            with self.subTest(words):
                file = self.folder / "set.ptiles"
                program("tiles", "build", *words.split(), "--relative-radius", 0.5, "--lloyd", 1, "--quiet", "--out", file)
                for density in (1.0, 0.6):
                    self.assert_same_points(file, (-3.25, 2), (3, 3), 7, density)

    def test_know_classes(self):
        file = self.folder / "classes.ptiles"
        program("tiles", "build", "corner", "--colors", 2, "--class-points", 3, 8, "--relative-radius", 0.4, "--quiet",
                "--out", file)
        _, found = self.assert_same_points(file, (0, 0), (3, 3), 1, 1.0)
        self.assertTrue((found.kind == (found.index >= 3)).all())

    def test_are_none_of_an_empty_window(self):
        tiles = poisson_points.TileSet((FOLDER / "corner-c3-n64-r075.ptiles").read_bytes())
        self.assertEqual(tiles.points([1, 1], [1, 1]).position.shape, (0, 2))
        self.assertEqual(tiles.points([3, 1], [1, 2]).position.shape, (0, 2))

    def test_are_refused_where_there_are_too_many(self):
        tiles = poisson_points.TileSet((FOLDER / "corner-c3-n64-r075.ptiles").read_bytes())
        for high, count in (([999, 999], "64,000,000"), ([1e9, 0], "64,000,000,064"), ([numpy.inf, 1], "inf")):
            with self.assertRaises(ValueError) as refused:
                tiles.points([0, 0], high)
            self.assertEqual(str(refused.exception), f"{count} points in the tiles there: must be at most 10,000,000")

    def test_are_refused_of_damaged_files(self):
        good = (FOLDER / "corner-c3-n64-r075.ptiles").read_bytes()
        for data, words in ((good[:99], "shorter than the header of a tile set file"), (b"X" + good[1:], "not a tile set file"),
                            (good[:8] + b"\x09" + good[9:], "an unknown version of the file format"),
                            ((FOLDER / "hat-n4.ptiles").read_bytes(), "an unknown version of the file format"),
                            (good[:20] + b"\x03" + good[21:], "numbers of colours, tiles and points that do not fit together"),
                            (good[:108] + b"\x02" + good[109:], "an unknown kind of borders or ranks"),
                            (good + b"\x00", "too short or too long for its points")):
            with self.assertRaises(ValueError) as refused:
                poisson_points.TileSet(data)
            self.assertEqual(str(refused.exception), words)


if __name__ == "__main__":
    unittest.main()
