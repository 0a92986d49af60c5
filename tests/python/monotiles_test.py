"""Hats and spectres: points of files against the program and brute force, and what their tables say of the tilings."""

import json
import sys
import unittest

import numpy

import poissonlab as pl
from support import SOURCE, FolderTest, error_of_program, program

sys.path.insert(0, str(SOURCE / "python/examples"))
from monotile_numbers import GROWTH, Substitution, exponent_of

FILES = {kind: SOURCE / f"runtime/tile_sets/{kind}-n4.ptiles" for kind in GROWTH}
AREA = {"hat": 8 * 3**0.5, "spectre": 3 + 3 * 3**0.5}
FAR = (987_654_321_012, -1_023_456_789_001)


def least_distance(points):
    offsets = points[:, None] - points
    return numpy.sqrt((offsets**2).sum(axis=2))[~numpy.eye(len(points), dtype=bool)].min()


class MonotileSets(FolderTest):
    def each(self):
        for kind, file in FILES.items():
            with self.subTest(kind):
                yield kind, file, pl.TileSet(file)

    def test_have_the_points_of_the_program_bit_for_bit(self):
        out = self.folder / "points.npy"
        for kind, file, tiles in self.each():
            self.assertEqual((tiles.kind, tiles.unit, tiles.dimension, tiles.points_per_tile), (kind, "edges", 2, 4))
            self.assertAlmostEqual(tiles.density, 4 / AREA[kind], places=14)
            self.assertEqual((tiles.ranked, tiles.exponent, tiles.class_points), (True, 2, []))
            for density in (1.0, 0.3):
                program("tiles", "points", file, "--window", *FAR, 40, 25, "--seed", 9, "--density", density, "--out", out)
                found = tiles.points(0, 0, 40, 25, seed=9, density=density, origin=FAR)
                self.assert_same_bytes(found.position, numpy.load(out))
                self.assertEqual(found.tile.shape, (len(found.id), 0))
                self.assertTrue((found.level < density).all())
            self.assertAlmostEqual(len(tiles.window(0, 0, 300, 300)) / 9e4, tiles.density, delta=0.01 * tiles.density)

    def test_windows_fit_together_and_densities_are_nested(self):
        for _, _, tiles in self.each():
            whole = {*map(tuple, tiles.window(-9.5, 3, 20, 20, origin=FAR))}
            parts = [tiles.window(-9.5, 3, 12.25, 20, origin=FAR), tiles.window(2.75, 3, 7.75, 20, origin=FAR)]
            self.assertEqual(whole, {tuple(p) for part in parts for p in part})
            some = {*map(tuple, tiles.window(-9.5, 3, 20, 20, origin=FAR, density=lambda x, y: numpy.where(x < 0, 1, 0.4)))}
            self.assertTrue(some < whole)
            self.assertEqual({p for p in some if p[0] < 0}, {p for p in whole if p[0] < 0})

    def test_prove_what_the_program_proves_and_what_all_pairs_have(self):
        for _, file, tiles in self.each():
            said = json.loads(program("tiles", "verify", file, "--json"))
            proven = tiles.verify()
            self.assertEqual(proven.min_distance, said["min_distance"])
            self.assertAlmostEqual(proven.relative_radius, said["relative_radius"], places=9)
            self.assertTrue(numpy.isnan(proven.largest_empty_radius))
            least = least_distance(tiles.window(0, 0, 60, 60, origin=FAR))
            self.assertGreater(least, proven.min_distance - 2**-29)
            self.assertLess(least, 1.02 * proven.min_distance)
            self.assertLess(abs(tiles.min_distance - proven.min_distance), 2**-16)

    def test_find_the_nearest_of_all_points(self):
        for _, _, tiles in self.each():
            positions = numpy.random.default_rng(3).uniform(-4, 9, (300, 2))
            around = tiles.points(-15, -15, 35, 35, origin=FAR)
            distances = numpy.sqrt(((positions[:, None] - around.position)**2).sum(axis=2))
            found = tiles.nearest(positions, origin=FAR)
            numpy.testing.assert_allclose(found.distance, distances.min(axis=1), rtol=1e-12)
            self.assert_same_bytes(found.id, around.id[distances.argmin(axis=1)])

    def test_fill_regions_as_the_program_does(self):
        region = "POLYGON ((500000 5400000, 500090 5400010, 500060 5400080, 500000 5400000))"
        out = self.folder / "points.npy"
        for _, file, tiles in self.each():
            made = tiles.in_region(region, min_distance=2, planar=True).position
            said = json.loads(program("tiles", "points", file, "--region", region, "--planar", "--min-distance", 2, "--out", out,
                                      "--json"))
            self.assertEqual({*map(tuple, made)}, {*map(tuple, numpy.load(out))})
            self.assertGreaterEqual(least_distance(made), 2)
            # The region's points are those of the plane, at places times the length of an edge.
            edge = said["edge"]
            self.assertAlmostEqual(edge, 2 / tiles.min_distance, delta=1e-7)
            step = numpy.array([1, 3**0.5 if tiles.kind == "hat" else 1])
            origin = numpy.floor(numpy.array([500000, 5400000]) / edge / step).astype(int)
            plane = edge * (tiles.window(-5, -5, 100, 100, origin=origin) + origin * step)
            corners = numpy.array([[500000, 5400000], [500090, 5400010], [500060, 5400080]])
            inside = numpy.ones(len(plane), bool)
            for a, b in zip(corners, numpy.roll(corners, -1, axis=0)):
                inside &= (b - a)[0] * (plane - a)[:, 1] - (b - a)[1] * (plane - a)[:, 0] >= 0
            self.assertEqual(len(made), inside.sum())
            nearest = numpy.sqrt(((made[:, None] - plane[inside])**2).sum(axis=2)).min(axis=1)
            self.assertLess(nearest.max(), 1e-7)
            some = tiles.in_region(region, points=321, planar=True, density=0.5)
            self.assertEqual(len(some.position), 321)
            # Two regions that share an edge have all points of both, and none twice, but for the rounding of coordinates.
            halves = [tiles.in_region(f"rectangle {x} 0 {x + 30} 40", min_distance=1).position for x in (0, 30)]
            both = tiles.in_region("rectangle 0 0 60 40", min_distance=1).position
            self.assertEqual(len(both), sum(map(len, halves)))
            gaps = numpy.sqrt(((both[:, None] - numpy.concatenate(halves))**2).sum(axis=2)).min(axis=1)
            self.assertLess(gaps.max(), 1e-9)

    def test_are_sets_of_a_series(self):
        for kind, file, tiles in self.each():
            sampler = {"hat": pl.HatTiles, "spectre": pl.SpectreTiles}[kind]
            for options, part in (({}, 1), ({"density": 0.25}, 0.25), ({"kept_points": 2}, 0.5)):
                made = sampler(tiles=str(file), rng=4, **options)
                sets = [made.random(1500) for _ in range(3)]
                distances = [least_distance(points) for points in sets]
                for points in sets:
                    self.assertTrue((points >= 0).all() and (points < 1).all())
                    self.assertAlmostEqual(len(points), 1500, delta=60)
                if part == 1:
                    least = tiles.min_distance * (tiles.density / 1500)**0.5
                    self.assertGreater(min(distances), least * (1 - 1e-6))
                    self.assertLess(min(distances), least * 1.03)
                self.assertEqual(len({points.tobytes() for points in sets}), 3)

    def test_refuse_what_is_no_window(self):
        tiles = pl.TileSet(FILES["hat"])
        for window, options, words in (((0, 0, 1), {}, "must be x, y, width, height, in edges"),
                                       ((0, 0, 0, 1), {}, "sizes must be above 0"),
                                       ((0, 0, 2e6, 1), {}, "must be a number from -1048448 to 1048448, in edges"),
                                       ((0, 0, 1e6, 1e6), {}, "points: must be at most"),
                                       ((0, 0, 1, 1), {"origin": (2**41, 0)}, "origin = 2199023255552: must be from"),
                                       ((0, 0, 1, 1), {"origin": (1,)}, "origin: must be two integers")):
            with self.assertRaisesRegex(pl.InputError, words):
                tiles.window(*window, **options)
        with self.assertRaisesRegex(pl.InputError, "origin: is for hats and spectres"):
            pl.TileSet(SOURCE / "runtime/tile_sets/corner-c3-n64-r075.ptiles").window(0, 0, 1, 1, origin=(1, 0))
        damaged = self.folder / "damaged.ptiles"
        good = FILES["hat"].read_bytes()
        for bytes_ in (good[:-1], good[:300] + bytes([good[300] ^ 1]) + good[301:]):
            damaged.write_bytes(bytes_)
            with self.assertRaises(pl.InputError) as caught:
                pl.TileSet(damaged).verify()
            self.assertEqual(str(caught.exception), error_of_program("tiles", "verify", damaged))


class Substitutions(FolderTest):
    """Sums over the tiles of a divided tile grow by eigenvalues of the substitution matrix, with a phase for each turn. Numbers
    grow by those of the papers: phi^4 for hats (Smith and others 2024), 4 + sqrt 15 for spectres. Vectors grow by the roots of
    these, as lengths do, so that dipoles add up as if they were independent; all else that decides low frequencies is bounded."""

    def test_grow_by_the_closed_forms(self):
        files = {(kind, levels): None for kind in FILES for levels in (0, 1)}
        for kind, levels in files:
            with self.subTest(f"{kind}, {levels}"):
                file = self.folder / f"{kind}{levels}.ptiles"
                program("tiles", "build", kind, "--points", 1, "--levels", levels, "--out", file)
                numbers, dipoles, quadrupoles = (Substitution(file).moduli(turns) for turns in range(3))
                # Eigenvalues of multiplicity k are rounded to about the k-th root of the precision.
                self.assertAlmostEqual(numbers[0], GROWTH[kind], delta=1e-9)
                self.assertLess(numbers[1], 1 + 1e-3)
                self.assertAlmostEqual(dipoles[0], GROWTH[kind]**0.5, delta=1e-6)
                self.assertLess(quadrupoles[0], 1 + 1e-3)
                self.assertGreater(quadrupoles[0], 1 - 1e-3)

    def test_make_variances_fall_as_the_page_says(self):
        tiles = pl.TileSet(FILES["spectre"])
        value, error, widest, _, _, _ = exponent_of("spectre", tiles, 1, 16, least=2)
        self.assertAlmostEqual(value, 2, delta=1)
        self.assertLess(error, 0.6)
        self.assertLess(widest, 1e-4)


if __name__ == "__main__":
    unittest.main()
