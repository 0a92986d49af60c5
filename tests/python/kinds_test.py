"""Kinds of work in Python: what they make is what the program makes, and refuses."""

import csv
import json
import pathlib
import shutil
import struct
import tempfile
import unittest
import zlib
from xml.etree import ElementTree

import numpy
import pyproj
import scipy.spatial
import shapely.affinity
import shapely.geometry

import poissonlab
from poissonlab import _poissonlab, distribute, kinds
from support import SOURCE, TILE_SET, program


def ratios_of_pairs(points, kept, distances):
    """The distances of all pairs over those that they keep."""
    i, j = numpy.triu_indices(len(points), 1)
    return numpy.linalg.norm(points[i] - points[j], axis=1) / kept(distances[i], distances[j])


def grey_png(values):
    """Returns the bytes of a PNG of 8 bits."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    height, width = values.shape
    rows = b"".join(b"\0" + row.tobytes() for row in values)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Kinds(unittest.TestCase):
    def test_stippling_has_points_pictures_and_numbers(self):
        made = distribute.stipple(image="0.2 + 0.1*x", points=200, by="warping", engine="reference", rng=3)
        self.assertEqual(made.points.shape, (200, 2))
        self.assertTrue(((made.points >= 0) & (made.points < 1)).all())
        self.assertIn("tone_error", made.numbers)
        self.assertIn("Tone error", made.titles["tone_error"])
        self.assertEqual(made.pictures["coverage"].ndim, 3)
        self.assertEqual(made.pictures["marks"].dtype, numpy.uint8)
        self.assertEqual(made.label, "Stippling of 0.2 + 0.1*x")
        # The number of dots times their area is the ink.
        height, width = made.pictures["coverage"].shape[:2]
        self.assertAlmostEqual(200 * made.numbers["mark_area"] / (0.2 * width * height), 1, places=2)

    def test_stipples_are_plotted(self):
        made = distribute.stipple(image="0.2", points=200, by="warping", engine="reference", width="200mm", pen="0.5mm")
        sheet = ElementTree.fromstring(next(f for f in made.files if f.name == "plot.svg").read_text())
        margins = 2 * 200 * made.numbers["mark_width"] / made.pictures["coverage"].shape[1]
        self.assertAlmostEqual(float(sheet.get("width").removesuffix("mm")), 200 + margins, places=3)
        self.assertEqual(len([e for e in sheet.iter() if e.tag.endswith("circle")]), 200)
        with self.assertRaisesRegex(poissonlab.InputError, "pen = .*needs width"):
            distribute.stipple(image="0.2", points=200, pen="0.5mm")

    def test_points_on_lines_are_measured_as_numpy_does(self):
        along = numpy.sort(numpy.random.default_rng(5).uniform(0, 50, 40))
        points = numpy.column_stack([0.6 * along, 0.8 * along])
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "points.npy"
            numpy.save(file, points)
            made = distribute.line_set(set=file, region="LINESTRING (0 0, 30 40)")
        gaps = numpy.diff(along)
        nearest = numpy.minimum(numpy.append(gaps, numpy.inf), numpy.insert(gaps, 0, numpy.inf))
        self.assertAlmostEqual(made.numbers["length"], 50, places=9)
        self.assertAlmostEqual(made.numbers["least_distance"], gaps.min(), places=9)
        self.assertAlmostEqual(made.numbers["mean_nearest"], nearest.mean(), places=9)
        self.assertAlmostEqual(made.numbers["gap_variation"], gaps.std() / gaps.mean(), places=9)
        self.assertAlmostEqual(made.numbers["jamming_share"], gaps.min() / (50 / 40) / 0.7475979202534114, places=9)

    def test_classes_are_measured_as_numpy_and_shapely_do(self):
        # The sides of the frame are a power of two: corners are whole parts of 2^31 of it.
        region = shapely.geometry.Polygon([(2, 1), (18, 1), (18, 5), (7, 5), (7, 9), (2, 9)],
                                          [[(3, 2), (5, 2), (5, 4), (3, 4)]])
        random = numpy.random.default_rng(3)
        points = random.uniform((2, 1), (18, 9), (150, 2))
        points = points[[region.contains(shapely.geometry.Point(point)) for point in points]]
        species = random.choice(["oak", "ash", "10"], len(points), p=[0.5, 0.3, 0.2])
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "trees.csv"
            file.write_text("id,x,y,species\n" + "".join(
                f"{i},{x!r},{y!r},{name}\n" for i, ((x, y), name) in enumerate(zip(points.tolist(), species))))
            made = distribute.class_set(set=file, classes="species", region=region.wkt)
            with self.assertRaisesRegex(poissonlab.InputError, "genus: is not a column with classes.*: id, species"):
                distribute.class_set(set=file, classes="genus", region=region.wkt)
        names = ["10", "ash", "oak"]  # numbers before words
        found = {}
        with open(next(f for f in made.files if f.name == "pairs.csv"), newline="") as rows:
            for row in csv.DictReader(rows):
                found.setdefault((row["first"], row["second"]), []).append((float(row["distance"]), float(row["g"])))
        self.assertEqual(set(found), {("", "")} | {(a, b) for i, a in enumerate(names) for b in names[i:]})
        distance = scipy.spatial.distance.cdist(points, points)
        common = numpy.array([[region.intersection(shapely.affinity.translate(region, *(p - q))).area
                               for q in points] for p in points])
        for (a, b), curve in found.items():
            first, second = (species == a) | (a == ""), (species == b) | (b == "")
            n, m = first.sum(), second.sum()
            together = n if a == b else n + m
            half = 0.15 * (region.area / together)**0.5
            pairs = numpy.outer(first, second) & (distance > 0)
            d, weight = distance[pairs], region.area**2 / common[pairs] / pairs.sum()
            for r, g in curve[::7]:
                kernel = numpy.maximum(0, 0.75 * (1 - ((r - d) / half)**2)) / half
                self.assertAlmostEqual(g, (weight * kernel / (2 * numpy.pi * d)).sum(), delta=1e-11 * max(1, g))
        for i, a in enumerate(names):
            for j, b in enumerate(names):
                between = numpy.where(distance == 0, numpy.inf, distance)[species == a][:, species == b]
                key = f"mean_nearest_{i}" if i == j else f"mean_nearest_{i}_{j}"
                self.assertAlmostEqual(made.numbers[key], between.min(axis=1).mean(), places=12)
        own = sum((species == a).sum() * ((species == a).sum() - 1) for a in names) / len(points) / (len(points) - 1)
        half = 0.15 * (region.area / len(points))**0.5
        pairs = distance > 0
        d, weight = distance[pairs], 1 / common[pairs] / distance[pairs]
        same = numpy.equal.outer(species, species)[pairs]
        marks = numpy.genfromtxt(next(f for f in made.files if f.name == "marks.csv"), delimiter=",", names=True)
        for row in marks[50::11]:
            kernel = weight * numpy.maximum(0, 1 - ((row["distance"] - d) / half)**2)
            self.assertAlmostEqual(row["mark_correlation"], kernel[same].sum() / kernel.sum() / own, places=10)
            self.assertLessEqual(row["low"], row["high"])

    def test_mask_pictures_are_measured_as_numpy_does(self):
        height, width = 24, 40
        mask = numpy.random.default_rng(2).integers(0, 256, (height, width), dtype=numpy.uint8)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "mask.png"
            file.write_bytes(grey_png(mask))
            made = distribute.mask_picture(mask=file)
        field = mask - mask.mean()
        power = abs(numpy.fft.fft2(field))**2 / (field**2).sum()
        v, u = numpy.meshgrid(numpy.fft.fftfreq(height), numpy.fft.fftfreq(width), indexing="ij")
        length, rings = numpy.hypot(u, v), min(width, height) // 2
        ring = numpy.rint(length * 2 * rings).astype(int)
        ring[length > 0.5] = 0
        kept = numpy.zeros_like(ring, dtype=bool)
        for j in range(height // 2 + 1):
            own = j == 0 or 2 * j == height
            kept[j, :] = (2 * numpy.arange(width) <= width) if own else True
        means, parts, middles = [], [], []
        for k in range(1, rings + 1):
            values = power[(ring == k) & kept]
            means.append(values.mean())
            parts.append(values.var(ddof=1) / values.mean()**2)
            middles.append(k / (2 * rings))
        means, parts, middles = map(numpy.array, (means, parts, middles))
        low = middles < 0.125
        self.assertAlmostEqual(made.numbers["low_power"], (means * middles)[low].sum() / middles[low].sum(), places=9)
        self.assertAlmostEqual(made.numbers["anisotropy"], 10 * numpy.log10(parts[2:].mean()), places=9)
        self.assertEqual(made.numbers["distinct_values"], len(numpy.unique(mask)))
        even = abs(numpy.cumsum(numpy.bincount(mask.ravel(), minlength=256)) / mask.size - numpy.arange(1, 257) / 256)
        self.assertAlmostEqual(made.numbers["histogram_error"], even.max(), places=12)
        # Pixels below the first threshold, nearest ones on the torus.
        below = numpy.argwhere(mask < numpy.sort(mask.ravel())[round(float(made.numbers["below_1"]))])
        tree = scipy.spatial.cKDTree(below, boxsize=(height, width))
        nearest = tree.query(below, 2)[0][:, 1]
        self.assertAlmostEqual(made.numbers["least_distance_1"], nearest.min(), places=6)
        densest = numpy.sqrt(2 / numpy.sqrt(3) * width * height / len(below))
        self.assertAlmostEqual(made.numbers["mean_nearest_1"], nearest.mean() / densest, places=9)

    def test_the_same_seed_makes_the_same(self):
        first, again, other = (distribute.warp(density="x + 2", points=64, engine="reference", rng=seed).points
                               for seed in (1, 1, 2))
        numpy.testing.assert_array_equal(first, again)
        self.assertTrue((first != other).any())

    def test_points_along_lines_of_the_globe(self):
        roads = {"type": "FeatureCollection", "features": [
            {"type": "Feature", "id": f"road {k}", "geometry": {"type": "LineString", "coordinates": line}}
            for k, line in enumerate([[[4.70, 50.86], [4.72, 50.87]], [[4.70, 50.87], [4.72, 50.86]]])]}
        made = distribute.darts(region=roads, along=True, min_distance=25, rng=2)
        lengths, pairs = pyproj.Geod(ellps="WGS84"), numpy.triu_indices(len(made.points), 1)
        apart = lengths.inv(*made.points[pairs[0]].T, *made.points[pairs[1]].T)[2]
        self.assertGreaterEqual(apart.min(), 25 * (1 - made.numbers["distortion"]))
        # Longitudes and latitudes of the two lines are linear in each other.
        x, y = (made.points - [4.70, 50.86]).T / numpy.array([[0.02], [0.01]])
        self.assertLess(numpy.minimum(abs(x - y), abs(x + y - 1)).max(), 1e-4)
        length = sum(lengths.line_length(*numpy.array(f["geometry"]["coordinates"]).T) for f in roads["features"])
        self.assertAlmostEqual(made.numbers["length"] / length, 1, places=4)
        self.assertAlmostEqual(len(made.points) / (0.7476 * length / 25), 1, delta=0.1)
        with self.assertRaisesRegex(poissonlab.InputError, "along: needs method darts|along.*darts"):
            distribute.points(region=roads, along=True, method="lloyd", points=9)

    def test_points_on_the_sphere_are_unit_vectors_whose_nearest_ones_scipy_finds(self):
        made = distribute.sphere(points=3840, rng=1)
        self.assertEqual(made.points.shape, (3840, 3))
        self.assertLess(abs(numpy.linalg.norm(made.points, axis=1) - 1).max(), 1e-14)
        nearest = 2 * numpy.arcsin(scipy.spatial.cKDTree(made.points).query(made.points, 2)[0][:, 1] / 2)
        packed = numpy.sqrt(2 / numpy.sqrt(3) * 4 * numpy.pi / 3840)
        self.assertAlmostEqual(made.numbers["least_angle"], numpy.degrees(nearest.min()), places=9)
        self.assertAlmostEqual(made.numbers["relative_radius"], nearest.min() / packed, places=9)
        self.assertAlmostEqual(made.numbers["mean_nearest_distance"], nearest.mean() / packed, places=9)
        mean_distance = 2 * scipy.spatial.distance.pdist(made.points).sum() / 3840**2
        self.assertAlmostEqual(made.numbers["cap_discrepancy"], 3 * 3840 * (4 / 3 - mean_distance) / 4, places=6)
        self.assertEqual(len(distribute.sphere(points=1, rng=1).points), 1)
        with self.assertRaisesRegex(poissonlab.InputError, "seen_from = .*needs environment"):
            distribute.sphere(points=9, seen_from="outside")

    def test_unknown_keywords_of_kinds_are_not_those_of_samplers(self):
        with self.assertRaisesRegex(TypeError, r"no parameter 'n': it has"):
            distribute.darts(n=3)

    def test_every_kind_is_there_with_its_keys(self):
        self.assertEqual(set(distribute.__all__) - {"Made"},
                         {"warp", "objects", "self_similar_tile", "rank", "stipple", "hatch", "icons", "instances",
                          "darts", "points", "classes", "surface", "mri_mask", "dither_mask", "mask_picture", "line_set",
                          "mesh_set", "class_set", "surface_classes", "cells", "textured_surface", "surface_objects", "geometry_tiles",
                          "recursive_tiles", "sphere", "discrepancy"})
        self.assertIn("ink: The part of the ink that is printed: a number from 0.001 to 1; default: 1.",
                      distribute.stipple.__doc__)

    def test_classes_and_masks_are_arrays(self):
        made = distribute.classes(points=[10, 40], engine="reference", rng=1)
        self.assertEqual(made.points.shape, (50, 2))
        self.assertEqual(list(numpy.bincount(made.classes)), [10, 40])
        mask = distribute.mri_mask(shape=[32, 24], acceleration=4, calibration=[4, 4], rng=1).mask
        self.assertEqual((mask.shape, mask.dtype, mask.sum()), ((32, 24), numpy.uint8, 192))
        ranks = distribute.dither_mask(size=32, rng=1).mask
        self.assertEqual(sorted(ranks.ravel()), list(range(1024)))

    def test_points_lie_on_meshes(self):
        with tempfile.TemporaryDirectory() as folder:
            mesh = pathlib.Path(folder) / "square.off"
            mesh.write_text("OFF\n4 1 0\n0 0 5\n2 0 5\n2 2 5\n0 2 5\n4 0 1 2 3\n")
            made = distribute.surface(mesh=str(mesh), min_distance=0.2, engine="reference", rng=1)
        self.assertTrue((made.points[:, 2] == 5).all())
        numpy.testing.assert_array_equal(made.normals, numpy.tile([0, 0, 1], (len(made.points), 1)))
        gaps = numpy.linalg.norm(made.points[:, None] - made.points[None], axis=2)
        self.assertGreaterEqual(gaps[numpy.triu_indices(len(gaps), 1)].min(), 0.2)
        self.assertEqual(made.numbers["uncovered"], 0)

    def test_columns_of_points_on_surfaces_lead_back_to_the_mesh(self):
        mesh = SOURCE / "configs/surfaces/vase.obj"
        made = distribute.surface(mesh=str(mesh), points=100, faces=True, engine="reference", rng=1)
        words = [line.split() for line in mesh.read_text().splitlines()]
        vertices = numpy.array([row[1:4] for row in words if row[:1] == ["v"]], dtype=float)
        faces = [[int(corner.split("/")[0]) - 1 for corner in row[1:]] for row in words if row[:1] == ["f"]]
        shares = numpy.stack([made.columns[f"bary_{k}"] for k in range(3)], axis=1)
        numbers = numpy.stack([made.columns[f"vertex_{k}"] for k in range(3)], axis=1)
        places = (shares[:, :, None] * vertices[numbers]).sum(axis=1)
        numpy.testing.assert_allclose(places, made.points, atol=numpy.ptp(vertices, axis=0).max() * 2.0**-29)
        for face, corners in zip(made.columns["face"], numbers):
            self.assertLessEqual(set(corners), set(faces[face]))
        self.assertIn("u", made.columns.dtype.names)

    def test_tiles_lie_on_texture_coordinates(self):
        mesh = SOURCE / "configs/surfaces/vase.obj"
        made = distribute.surface(mesh=str(mesh), tiles=TILE_SET, tiles_per_unit=6, closed=True, rng=2)
        nearest = scipy.spatial.cKDTree(made.points).query(made.points, k=2)[0][:, 1]
        self.assertAlmostEqual(made.numbers["least_of_any"], nearest.min(), 12)
        self.assertLessEqual(made.numbers["surface_distance"] * 0.95, nearest.min())
        self.assertEqual(made.numbers["broken_by_seams"], 0)
        distance = 1.2 * nearest.min()
        thinned = distribute.surface(mesh=str(mesh), tiles=TILE_SET, tiles_per_unit=6, min_distance=distance,
                                     normal_angle=180, rng=2).points
        self.assertGreaterEqual(scipy.spatial.cKDTree(thinned).query(thinned, k=2)[0][:, 1].min(), distance)

    def test_darts_fall_into_regions_in_their_own_units(self):
        made = distribute.darts(region="rectangle 500 -20 540 10", min_distance=2, engine="reference", rng=1)
        low, high = made.points.min(axis=0), made.points.max(axis=0)
        self.assertTrue((low >= [500, -20]).all() and (high <= [540, 10]).all(), (low, high))
        gaps = numpy.linalg.norm(made.points[:, None] - made.points[None], axis=2)
        self.assertGreaterEqual(gaps[numpy.triu_indices(len(gaps), 1)].min(), 2)
        self.assertEqual(made.numbers["points"], len(made.points))

    def test_darts_fall_into_regions_of_longitude_and_latitude(self):
        # PROJ's geodesics know distances on the ellipsoid.
        park = {"type": "Polygon", "coordinates": [[[4.700, 50.860], [4.712, 50.861], [4.709, 50.869], [4.700, 50.860]]]}
        made = distribute.darts(region=park, min_distance=20, rng=1)
        i, j = numpy.triu_indices(len(made.points), 1)
        metres = pyproj.Geod(ellps="WGS84").inv(*made.points[i].T, *made.points[j].T)[2]
        self.assertGreater(len(made.points), 300)
        self.assertGreaterEqual(metres.min(), 20 * (1 - made.numbers["distortion"]) - 1e-6)
        self.assertLess(metres.min(), 20.5)

        class Layer:  # as geopandas has them
            __geo_interface__ = park
            crs = pyproj.CRS("EPSG:31370")
        self.assertNotIn("distortion", distribute.darts(region=Layer(), min_distance=0.002, rng=1).numbers)
        told = distribute.darts(region=park, crs="EPSG:4326", min_distance=20, rng=1)
        self.assertTrue(numpy.array_equal(made.points, told.points))

    def test_darts_fill_regions_of_space(self):
        # SciPy knows the least distance, and corners of Voronoi cells are farther from all points than places around.
        made = distribute.darts(region="ball 3 0 0 2", min_distance=0.4, rng=1)
        tree = scipy.spatial.cKDTree(made.points)
        self.assertEqual(made.points.shape[1], 3)
        self.assertLessEqual(numpy.linalg.norm(made.points - [3, 0, 0], axis=1).max(), 2 + 1e-8)
        self.assertGreaterEqual(tree.query(made.points, k=2)[0][:, 1].min(), 0.4)
        corners = scipy.spatial.Voronoi(made.points).vertices
        inside = corners[numpy.linalg.norm(corners - [3, 0, 0], axis=1) <= 2]
        directions = numpy.random.default_rng(1).normal(size=(20000, 3))
        surface = [3, 0, 0] + 2 * directions / numpy.linalg.norm(directions, axis=1)[:, None]
        for places in (inside, surface):
            self.assertGreater(len(places), 500)
            self.assertLess(tree.query(places)[0].max(), 0.4 + 1e-7)
        whole = distribute.points(region="solid -4 -4 -4 4 4 4 1-x*x-y*y-z*z", method="darts", boundary="disks",
                                  min_distance=0.3, engine="reference", rng=1).points
        self.assertLessEqual(numpy.linalg.norm(whole, axis=1).max(), 1 - 0.15)

    def test_methods_make_points_in_regions(self):
        for method, keys in (("elimination", {"points": 60, "candidates": 3}), ("lloyd", {"points": 60, "iterations": 5}),
                             ("relaxation", {"points": 60, "attempts": 100}), ("bridson", {"min_distance": 0.9})):
            made = distribute.points(region="disk 0 0 5", method=method, engine="reference", **keys, rng=1)
            self.assertGreaterEqual(len(made.points), 60)
            self.assertLessEqual(numpy.linalg.norm(made.points, axis=1).max(), 5)

    def test_distances_vary_over_regions(self):
        for between, kept in (("smaller", numpy.minimum), ("mean", lambda a, b: (a + b) / 2)):
            made = distribute.points(region="rectangle 0 0 2 1", min_distance="0.04 + 0.1*x", between=between,
                                     engine="reference", rng=1)
            r = 0.04 + 0.1 * made.points[:, 0]
            numpy.testing.assert_allclose(made.distances, r, rtol=1e-12)
            near = ratios_of_pairs(made.points, kept, r)
            self.assertGreaterEqual(near.min(), 1)
            self.assertAlmostEqual(near.min(), made.numbers["least_ratio_typed"], 6)
            # No further point fits: no place of a lattice is far enough from all points.
            x, y = (axis.ravel() for axis in numpy.meshgrid(numpy.linspace(0, 2, 401), numpy.linspace(0, 1, 201)))
            gaps = numpy.hypot(x[:, None] - made.points[:, 0], y[:, None] - made.points[:, 1])
            self.assertLess((gaps / kept((0.04 + 0.1 * x)[:, None], r)).min(axis=1).max(), 1)

    def test_regions_may_have_a_geo_interface(self):
        class Triangle:
            __geo_interface__ = {"type": "Polygon", "coordinates": [[(0, 0), (4000, 0), (0, 3000), (0, 0)]]}

        made = distribute.darts(region=Triangle(), points=50, engine="reference", rng=1)
        as_dict = distribute.darts(region=Triangle.__geo_interface__, points=50, engine="reference", rng=1)
        numpy.testing.assert_array_equal(as_dict.points, made.points)
        self.assertEqual(made.points.shape, (50, 2))
        self.assertTrue((made.points @ [3000, 4000] <= 12_000_000 * (1 + 1e-9)).all())
        self.assertEqual(made.numbers["area"], 6_000_000)

    def test_errors_have_the_words_of_the_program(self):
        with self.assertRaisesRegex(poissonlab.InputError, r"^stipple: ink = 2: must be a number from 0.001 to 1$"):
            distribute.stipple(image="0.5", points=9, ink=2)
        with self.assertRaisesRegex(poissonlab.InputError, r"^stipple: needs points or dot$"):
            distribute.stipple(image="0.5")
        with self.assertRaisesRegex(TypeError, r"no parameter 'colour'"):
            distribute.stipple(image="0.5", points=9, colour=2)


class EveryKind(unittest.TestCase):
    def test_numbers_out_of_range_are_refused_as_the_program_describes_them(self):
        described = json.loads(program("kinds", "--json"))["kinds"]
        refused = 0
        for kind, here in zip(described, _poissonlab.kinds()):
            self.assertEqual((kind["table"], kind["kind"], kind["command"]),
                             (here["table"], here["word"], here["command"]))
            make = kinds.function_of(here, "work")
            names = {key["key"]: key["name"] for key in here["keys"]}
            for key in kind["keys"]:
                if not key["allowed"].startswith(("a number from", "an integer from")) or key.get("maximum", 1e16) > 1e15:
                    continue
                value = int(key["maximum"]) + 1
                with self.assertRaises(poissonlab.InputError) as error:
                    make(engine="reference", **{names[key["key"]]: value})
                # Keys that are needed, and those that others must go with, may be missed first.
                message = str(error.exception)
                if message.startswith(f"work: {key['key']} = "):
                    self.assertEqual(message, f"work: {key['key']} = {value}: must be {key['allowed']}")
                    refused += 1
        self.assertGreater(refused, 60)


class OtherKinds(unittest.TestCase):
    def test_tile_sets_with_classes_keep_what_is_proven_of_each_pair(self):
        tiles = poissonlab.tiles.build("corner", colors=2, class_points=[5, 12], relative_radius=0.5,
                                       engine="reference", rng=1)
        self.assertEqual(list(tiles.class_points), [5, 12])
        points = tiles.points(0, 0, 8, 8)
        classes = tiles.class_of(points.index)
        self.assertEqual(numpy.bincount(classes).tolist(), [64 * 5, 64 * 12])
        proven = tiles.verify().class_distances
        offsets = points.position[:, None] - points.position
        distances = numpy.sqrt((offsets**2).sum(axis=2)) + 9 * numpy.eye(len(points.position))
        for i in range(2):
            for j in range(2):
                self.assertGreaterEqual(distances[classes == i][:, classes == j].min(), proven[i, j] * (1 - 1e-12))
        with self.assertRaisesRegex(poissonlab.InputError, "have no classes"):
            poissonlab.TileSet(TILE_SET).class_of([0])

    def test_tile_sets_are_built(self):
        tiles = poissonlab.tiles.build("corner", colors=2, points=16, relative_radius=0.6, engine="reference", rng=3)
        self.assertEqual((tiles.kind, tiles.colors, tiles.tiles, tiles.points_per_tile), ("corner", 2, 16, 16))
        self.assertGreaterEqual(tiles.verify().relative_radius, 0.6)
        with self.assertRaisesRegex(poissonlab.InputError, r"tiles = 3: is for template tiles"):
            poissonlab.tiles.build("corner", colors=2, points=16, tiles=3)

    def test_tilings_and_packings_have_tiles(self):
        tiling = poissonlab.tilings.tiling(kind="wang", colors=3, window=[-2, 5, 4, 3], rng=1)
        self.assertEqual(tiling.tiles.shape, (3, 4))
        packing = poissonlab.tilings.packing(kind="corner", colors=2, rng=1)
        self.assertEqual(sorted(packing.tiles.ravel()), list(range(16)))

    def test_textures_are_built(self):
        made = poissonlab.texture.build("wang", pattern="noise", pattern_size=64, size=16, colors=2, attempts=2,
                                        show=["tiling"], engine="reference", rng=1)
        self.assertEqual(made.numbers["tiles"], 16)
        self.assertIn("tiling", made.pictures)

    def test_textures_are_advised(self):
        advice = poissonlab.texture.advise(SOURCE / "configs/exemplars/pebbles.png")
        self.assertEqual((advice["texture"], advice["size"], advice["colors"]), (True, 128, 3))
        self.assertEqual(poissonlab.texture.advise(SOURCE / "configs/exemplars/cat.png")["obstacle"], "one object")
        with self.assertRaisesRegex(poissonlab.InputError, r"nothere\.png"):
            poissonlab.texture.advise("nothere.png")

    def test_endless_textures_are_drawn_without_tiles(self):
        small = {"engine": "reference", "pattern": "noise", "pattern_size": 64}
        made = poissonlab.texture.build("hexagons", show=["exemplar", "tiling"], **small, rng=1)
        self.assertEqual(made.numbers["fetches"], 3)
        with tempfile.TemporaryDirectory() as name:
            folder = made.save(pathlib.Path(name) / "made")
            drawn = poissonlab.texture.endless(kind="blended", exemplar=folder / "exemplar.png", window=[5, -3, 40, 20],
                                               engine="reference", rng=1)
            self.assertIn("texture", drawn.pictures)

    def test_textures_have_companions(self):
        small = {"size": 16, "colors": 2, "attempts": 2, "show": ["set"], "engine": "reference"}
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            poissonlab.texture.build("corner", pattern="noise", pattern_size=64, **small, rng=1).save(folder / "first")
            picture = folder / "first" / "exemplar.png"
            height = shutil.copy(picture, folder / "height.png")
            poissonlab.texture.build("corner", exemplar=picture, also=[height], level=False, **small, rng=1).save(folder / "set")
            self.assertEqual((folder / "set" / "atlas-height.png").read_bytes(),
                             (folder / "set" / "atlas.png").read_bytes())
            with self.assertRaisesRegex(poissonlab.InputError, r"also: .*atlas.png: 64 x 64 pixels: must have 80 x 80"):
                poissonlab.texture.build("corner", pattern="noise", pattern_size=80, **small, rng=1).save(folder / "large")
                poissonlab.texture.build("corner", exemplar=folder / "large" / "exemplar.png",
                                         also=[folder / "set" / "atlas.png"], **small, rng=1)

    def test_maps_of_cells_are_put_together_from_what_tiled_reads(self):
        made = distribute.cells(alphabet=SOURCE / "configs/alphabets/islands.toml", window=[-7, 12, 9, 6], rng=4)
        self.assertEqual(made.numbers["cells"], 54)
        picture, cells = made.pictures["map"], made.pictures["map-tiles"]
        with tempfile.TemporaryDirectory() as name:
            root = ElementTree.parse(made.save(pathlib.Path(name) / "map") / "map.tmx").getroot()
        self.assertEqual((root.get("width"), root.get("height"), root.get("orientation")), ("9", "6", "orthogonal"))
        image = root.find("tileset/image")
        self.assertEqual((image.get("source"), image.get("width")), ("map-tiles.png", str(cells.shape[1])))
        rows = root.find("layer/data").text.strip().splitlines()
        numbers = numpy.array([[int(word) for word in row.strip(",").split(",")] for row in rows]) - 1
        drawn = cells.reshape(9, 16, 9, 16, -1).swapaxes(1, 2).reshape(81, 16, 16, -1)[numbers]
        numpy.testing.assert_array_equal(drawn.swapaxes(1, 2).reshape(picture.shape), picture)
        self.assertEqual(len(root.findall("tileset/wangsets/wangset/wangtile")), 81)

    def test_schemes_and_constructions_are_drawn(self):
        self.assertTrue(poissonlab.tilings.isohedral(type=16, random=True, rng=5).pictures)
        for tiling in ("chair", "hat", "turtle", "spectre"):
            self.assertTrue(poissonlab.tilings.substitution(tiling=tiling, depth=2, rng=1).pictures)
        self.assertTrue(poissonlab.tilings.set(show="lloyd", points=9, rng=1).pictures)
        with self.assertRaisesRegex(poissonlab.InputError, r"type = 94: must be an integer from 1 to 93"):
            poissonlab.tilings.isohedral(type=94)


if __name__ == "__main__":
    unittest.main()
