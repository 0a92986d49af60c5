"""Tile sets: points of windows, nearest points, the proof; against the program and against numpy."""

import json
import unittest

import numpy

import poissonlab as pl
from support import SOURCE, TILE_SET, FolderTest, error_of_program, program

FOLDER = SOURCE / "runtime/tile_sets"


class TileSets(FolderTest):
    def points_of_program(self, file, window, *options):
        out = self.folder / "points.npy"
        program("tiles", "points", file, "--window", *window, "--out", out, *options)
        return numpy.load(out)

    def test_have_the_points_of_the_program_bit_for_bit(self):
        files = sorted(set(FOLDER.glob("*.ptiles")) - set(FOLDER.glob("hat-*")) - set(FOLDER.glob("spectre-*")))
        self.assertEqual(len(files), 11) # those of square tiles; monotiles_test.py reads the others
        self.assertEqual([file.name for file in files if pl.TileSet(file).class_points],
                         ["corner-classes-c3-n8-16-40-r070.ptiles"])
        for file in files:
            with self.subTest(file.name):
                tiles = pl.TileSet(file)
                window = (-3, 5, 4, 2) if tiles.dimension == 2 else (-3, 5, 1, 2, 1, 2)
                corner = numpy.array(window[:tiles.dimension])
                of_program = self.points_of_program(file, window, "--seed", 9)
                points = tiles.points(*window, seed=9)
                if tiles.class_points:
                    self.assert_same_bytes(tiles.class_of(points.index), of_program["class"])
                    of_program = numpy.stack([of_program["x"], of_program["y"]], axis=1)
                # The program says them from the window's corner: multiples of 2^-16, so that nothing is rounded.
                self.assert_same_bytes(points.position - corner, of_program)

    def test_thin_out_without_moving_a_point(self):
        tiles = pl.TileSet(TILE_SET)
        self.assertTrue(tiles.ranked)
        some = tiles.window(0, 0, 4, 4, density=0.3)
        self.assert_same_bytes(some, self.points_of_program(TILE_SET, (0, 0, 4, 4), "--density", 0.3))
        self.assertTrue({*map(tuple, some)} < {*map(tuple, tiles.window(0, 0, 4, 4, density=0.6))})
        half = tiles.window(0, 0, 4, 4, density=lambda x, y: numpy.where(x < 2, 1, 0.3))
        self.assert_same_bytes(half[half[:, 0] >= 2], some[some[:, 0] >= 2])
        full = tiles.window(0, 0, 4, 4)
        self.assert_same_bytes(half[half[:, 0] < 2], full[full[:, 0] < 2])

    def test_fill_regions_as_the_program_does(self):
        tiles = pl.TileSet(TILE_SET)
        region = "POLYGON ((500000 5400000, 500090 5400010, 500060 5400080, 500000 5400000))"
        out = self.folder / "points.npy"

        def of_program(*options):
            program("tiles", "points", TILE_SET, "--region", region, "--planar", "--seed", 3, "--out", out, *options)
            return {*map(tuple, numpy.load(out))}

        made = tiles.in_region(region, min_distance=2, planar=True, seed=3)
        self.assertEqual({*map(tuple, made.position)}, of_program("--min-distance", 2))
        gaps = numpy.sqrt(((made.position[:, None] - made.position)**2).sum(axis=2))
        self.assertGreaterEqual(gaps[numpy.triu_indices(len(gaps), 1)].min(), 2)
        some = tiles.in_region(region, points=321, planar=True, seed=3, density=0.5)
        self.assertEqual(len(some.position), 321)
        self.assertEqual({*map(tuple, some.position)}, of_program("--points", 321, "--density", 0.5))
        left = tiles.in_region("disk 0 0 9", min_distance=1, density=lambda x, y: numpy.where(x < 0, 1, 0))
        self.assertTrue((left.position[:, 0] < 0).all() and len(left.position) > 50)
        road = "LINESTRING (0 0, 60 10, 90 50)"
        corridor = tiles.in_region(road, min_distance=1, buffer=2, seed=3).position
        program("tiles", "points", TILE_SET, "--region", road, "--buffer", 2, "--min-distance", 1, "--seed", 3, "--out", out)
        self.assertEqual({*map(tuple, corridor)}, {*map(tuple, numpy.load(out))})
        ends = numpy.array([[0, 0], [60, 10], [90, 50]], dtype=float)
        gaps = []
        for a, b in zip(ends[:-1], ends[1:]):
            along = numpy.clip((corridor - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
            gaps.append(numpy.linalg.norm(corridor - a - along[:, None] * (b - a), axis=1))
        self.assertLess(numpy.min(gaps, axis=0).max(), 2 + 1e-9)
        twice = "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 0)), ((1 0, 9 0, 9 8, 1 0)))"
        self.assertGreater(len(tiles.in_region(twice, min_distance=1, planar=True).position), 9)
        with self.assertRaisesRegex(pl.InputError, "overlap|share|cross"):
            tiles.in_region(twice, min_distance=1, planar=True, overlap="refuse")
        for wrong, message in (({"overlap": "join"}, "overlap = join: must be union or refuse"),
                               ({"buffer": -1}, "buffer = -1: must be a number from 0")):
            with self.assertRaisesRegex(pl.InputError, message):
                tiles.in_region(road, min_distance=1, **wrong)
        with self.assertRaisesRegex(pl.InputError, "needs min_distance or points, and not both"):
            tiles.in_region("disk 0 0 9")

    def test_windows_fit_together(self):
        tiles = pl.TileSet(TILE_SET)
        whole = tiles.points(-1.5, 0.25, 3, 2)
        parts = [tiles.points(-1.5, 0.25, 1.75, 2), tiles.points(0.25, 0.25, 1.25, 2)]
        self.assertEqual({*map(tuple, whole.position)}, {tuple(p) for part in parts for p in part.position})
        self.assertEqual({*whole.id}, {i for part in parts for i in part.id})
        self.assertLessEqual(abs(whole.position - whole.tile - 0.5).max(), 1)  # chains reach half a tile farther
        self.assertFalse(numpy.array_equal(tiles.window(0, 0, 1, 1, seed=1), tiles.window(0, 0, 1, 1, seed=2)))

    def test_find_the_nearest_of_all_points(self):
        for name in ("corner-c3-n64-r075.ptiles", next(FOLDER.glob("sphere*")).name):
            tiles = pl.TileSet(FOLDER / name)
            d = tiles.dimension
            positions = numpy.random.default_rng(3).uniform(-1, 2, (200, d))
            around = tiles.points(*[-2] * d, *[5] * d, seed=4)
            distances = numpy.sqrt(((positions[:, None] - around.position)**2).sum(axis=2))
            found = tiles.nearest(positions, seed=4)
            numpy.testing.assert_allclose(found.distance, distances.min(axis=1), rtol=1e-12)
            self.assert_same_bytes(found.position, around.position[distances.argmin(axis=1)])
            self.assert_same_bytes(found.id, around.id[distances.argmin(axis=1)])
        self.assertEqual(pl.TileSet(TILE_SET).nearest((0.5, 0.5)).distance.shape, (1,))

    def test_nothing_is_lost_a_billion_tiles_away(self):
        tiles = pl.TileSet(TILE_SET)
        found = tiles.points(1e9, -1e9, 2, 2)
        self.assertGreater(len(found.id), 200)
        again = tiles.nearest(found.position)
        self.assert_same_bytes(again.id, found.id)
        self.assertEqual(again.distance.max(), 0)

    def test_prove_what_the_program_proves(self):
        tiles = pl.TileSet(TILE_SET)
        said = json.loads(program("tiles", "verify", TILE_SET, "--json"))
        proven = tiles.verify()
        self.assertEqual(proven.class_distances.size, 0)
        for name, value in proven._asdict().items():
            if name != "class_distances":
                self.assertEqual(value, said[name], name)
        points = tiles.window(0, 0, 6, 6)
        offsets = points[:, None] - points
        distances = numpy.sqrt((offsets**2).sum(axis=2))[~numpy.eye(len(points), dtype=bool)]
        self.assertGreaterEqual(distances.min(), proven.min_distance)

    def test_refuse_damaged_files_in_the_words_of_the_program(self):
        damaged = self.folder / "damaged.ptiles"
        for change in (lambda b: b[:-1], lambda b: b"nothing", lambda b: b[:40] + b"\xff" + b[41:]):
            damaged.write_bytes(change(TILE_SET.read_bytes()))
            with self.assertRaises(pl.InputError) as caught:
                pl.TileSet(damaged).verify()
            self.assertEqual(str(caught.exception), error_of_program("tiles", "verify", damaged))

    def test_refuse_what_is_no_window(self):
        tiles = pl.TileSet(TILE_SET)
        for window, words in (((0, 0, 1), "must be x, y, width, height"), ((0, 0, 0, 1), "sizes must be above 0"),
                              ((0, 0, 1e6, 1e6), "points: must be at most"), ((1e10, 0, 1, 1), "must be a number from"),
                              ((numpy.nan, 0, 1, 1), "must be a number from")):
            with self.assertRaisesRegex(pl.InputError, words):
                tiles.window(*window)
        for options, words in (({"seed": -1}, "seed = -1"), ({"seed": 2**32}, "to 4294967295"),
                               ({"density": 0}, "density = 0"), ({"density": 2}, "= 2")):
            with self.assertRaisesRegex(pl.InputError, words):
                tiles.window(0, 0, 1, 1, **options)
        with self.assertRaisesRegex(pl.InputError, r"shape \(positions, 2\)"):
            tiles.nearest([1, 2, 3])
        with self.assertRaisesRegex(pl.InputError, "must be a number"):
            tiles.nearest([numpy.inf, 0])


if __name__ == "__main__":
    unittest.main()
