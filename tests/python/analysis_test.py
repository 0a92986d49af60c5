"""analyze(): the program's numbers, oracles that are not ours, files of several tools, the figure."""

import contextlib
import base64
import ctypes
import importlib.util
import re
import struct
import unittest
import unittest.mock
import warnings
import xml.etree.ElementTree

import numpy

import poissonlab as pl
from support import FolderTest, columns_of, error_of_program, program, torus_distance


def sets_of(k, n, d=2):
    return pl.DartThrowing(d=d, relative_radius=0.6, rng=5).realizations(k, n)


class Analyses(FolderTest):
    def analyzed_by_program(self, sets, *options):
        files = [self.folder / f"{i:03}.npy" for i in range(len(sets))]
        for file, points in zip(files, sets):
            numpy.save(file, points)
        out = self.folder / "out"
        program("analyze", *files, "--label", "points", "--out", out, "--quiet", *options)
        return out

    def assert_same_curves(self, analysis, folder):
        stored = columns_of(folder / "radial.csv")
        for name, column in {"frequency": "frequency", "power": "power", "error": "power_error",
                             "anisotropy_db": "anisotropy_db"}.items():
            self.assert_same_bytes(getattr(analysis.radial, name), stored[column])
        numpy.testing.assert_array_equal(analysis.radial.samples, stored["samples"])
        stored = columns_of(folder / "pair-correlation.csv")
        for name, column in {"distance": "distance", "value": "pair_correlation", "error": "standard_error",
                             "pairs": "pairs"}.items():
            self.assert_same_bytes(getattr(analysis.pair_correlation, name), stored[column])
        stored = columns_of(folder / "number-variance.csv")
        for name, column in {"radius": "radius", "points": "points", "variance": "variance",
                             "error": "standard_error"}.items():
            self.assert_same_bytes(getattr(analysis.number_variance, name), stored[column])

    def test_of_points_in_a_region_are_those_of_the_program(self):
        region = "POLYGON ((0 0, 60 4, 64 40, 40 30, 8 44, 0 0))"
        points = numpy.random.default_rng(3).uniform((10, 8), (35, 28), (60, 2))
        out = self.analyzed_by_program([points], "--region", region, "--set", "analysis.envelope=2")
        analysis = pl.analyze(points, region=region, envelope=2)
        stored = columns_of(out / "points" / "region.csv")
        self.assertGreater(len(analysis.region.distance), 50)
        for name, column in analysis.region._asdict().items():
            self.assert_same_bytes(column, stored[name])
            self.assert_same_bytes(getattr(pl.open(out)["points"].region, name), stored[name])
        self.assert_same_bytes(pl.open(out)["points"].sets[0], points)
        self.assertEqual(len(pl.analyze(sets_of(1, 20)).region.distance), 0)
        with self.assertRaisesRegex(pl.InputError, "1 of 61 points lies outside the region"):
            pl.analyze(numpy.vstack([points, [[0, 40]]]), region=region)
        with self.assertRaisesRegex(pl.InputError, "domain: cannot be combined with region"):
            pl.analyze(points, region=region, domain=(0, 64))

    def test_of_points_in_a_periodic_box_are_sums_over_its_own_frequencies(self):
        sides = numpy.array([6.0, 2.0])
        points = numpy.random.default_rng(5).uniform((0, 0), sides, (90, 2))
        analysis = pl.analyze(points, box=sides)
        u, v = numpy.meshgrid(numpy.arange(-40, 41), numpy.arange(-40, 41))
        waves = 2 * numpy.pi * numpy.stack([u / sides[0], v / sides[1]], axis=-1)
        power = abs(numpy.exp(-1j * waves @ points.T).sum(axis=-1))**2 / len(points)
        ring = numpy.rint(numpy.hypot(*numpy.moveaxis(waves, -1, 0)) * numpy.sqrt(sides.prod()) / (2 * numpy.pi))
        for k in range(10):
            numpy.testing.assert_allclose(analysis.radial.power[k], power[ring == k + 1].mean(), rtol=1e-6)
        apart = abs(points[:, None] - points[None])
        apart = numpy.hypot(*numpy.moveaxis(numpy.minimum(apart, sides - apart), -1, 0))
        numpy.fill_diagonal(apart, numpy.inf)
        numpy.testing.assert_allclose(analysis.min_distance[0] * numpy.sqrt(sides.prod()), apart.min(), rtol=1e-9)
        self.assert_same_bytes(pl.analyze(points - [3, 0], domain=[(-3, 3), (0, 2)]).radial.frequency,
                               analysis.radial.frequency)
        square = pl.analyze(points / sides)
        self.assert_same_bytes(pl.analyze(points / sides, box=(1, 1)).radial.power, square.radial.power)

    def test_of_boxes_that_cannot_be_are_refused(self):
        points = sets_of(1, 20)[0]
        for options, words in (({"box": (2, 1), "domain": (0, 2)}, "box: cannot be combined with domain"),
                               ({"box": (2, 1), "periodic": False, "tiles": 2}, "periodic=False: window, tiles"),
                               ({"box": (2, 1), "region": "rectangle 0 0 2 1"}, "box: cannot be combined with region"),
                               ({"box": (2, 0)}, "box: must be"), ({"box": (2, 1, 1)}, "one for each axis"),
                               ({"box": (2, 1), "tiles": 4}, "cannot be combined with tiles")):
            with self.subTest(**options), self.assertRaisesRegex(pl.InputError, words):
                pl.analyze(points, **options)

    def test_have_the_numbers_of_the_program_bit_for_bit(self):
        for k, n, d, options in ((3, 200, 2, {}), (1, 150, 3, {}), (34, 20, 2, {"spectrum": "exact"}),
                                 (2, 64, 2, {"window": True, "bin_width": 2})):
            with self.subTest(k=k, d=d, **options):
                sets = sets_of(k, n, d)
                words = [f"analysis.{key}={str(value).lower()}" for key, value in options.items()]
                out = self.analyzed_by_program(sets, *(word for change in words for word in ("--set", change)))
                analysis = pl.analyze(sets, **options)
                stored = pl.open(out)["points"]
                self.assert_same_curves(analysis, out / "points")
                self.assert_same_curves(stored, out / "points")
                measured, read = ({key for key in a.measures if "time" not in key} for a in (analysis, stored))
                self.assertEqual(measured, read)
                for key, measure in stored.measures.items():
                    if "time" not in key:
                        self.assertEqual((measure.value, measure.error), analysis.measures[key][:2], key)
                        numpy.testing.assert_array_equal(measure.each, analysis.measures[key].each)
                if d == 2:
                    self.assert_same_bytes(analysis.spectrum.astype(numpy.float32),
                                           stored.spectrum.astype(numpy.float32))
                else:
                    self.assertIsNone(stored.spectrum)
                    middle = analysis.spectrum.shape[0] // 2
                    self.assert_same_bytes(analysis.spectrum[middle].astype(numpy.float32),
                                           stored.spectrum_planes["xy"].astype(numpy.float32))
                for a, b in zip(stored.sets, sets, strict=True):
                    self.assert_same_bytes(a, b)

    def test_are_sums_that_numpy_makes_as_well(self):
        sets = sets_of(2, 40)
        analysis = pl.analyze(sets, spectrum="exact", spectrum_size=32)
        f = numpy.arange(-16, 16)
        powers = []
        for x in sets:
            phases = numpy.exp(-2j * numpy.pi * (f[None, :, None] * x[:, 0] + f[:, None, None] * x[:, 1]))
            powers.append(abs(phases.sum(axis=2))**2 / 40)
        # Values are within 1e-11 N of the sum, see spectrum.hpp: so is a power of at most N within some 1e-9.
        numpy.testing.assert_allclose(analysis.spectrum, numpy.mean(powers, axis=0), rtol=0, atol=1e-9)
        numpy.testing.assert_allclose(analysis.spectrum_variance, numpy.var(powers, axis=0, ddof=1), rtol=0, atol=1e-7)
        self.assertAlmostEqual(analysis.spectrum[16, 16], 40, places=9)
        ring = numpy.rint(numpy.hypot(f[:, None], f[None, :])) == 5
        self.assertEqual(analysis.radial.frequency[4], 5)
        self.assertEqual(analysis.radial.samples[4], ring.sum())
        self.assertAlmostEqual(analysis.radial.power[4], numpy.mean(powers, axis=0)[ring].mean(), places=9)

    def test_measure_the_smallest_distance_of_all_pairs(self):
        for d in (2, 3):
            sets = pl.Random(d=d, rng=9).realizations(3, 100)
            analysis = pl.analyze(sets)
            smallest = [torus_distance(points) for points in sets]
            numpy.testing.assert_allclose(analysis.min_distance, smallest, rtol=1e-13)
            largest = (2 / (numpy.sqrt(3) * 100))**(1 / 2) if d == 2 else (numpy.sqrt(2) / 100)**(1 / 3)
            numpy.testing.assert_allclose(analysis.relative_radius, analysis.min_distance / largest, rtol=1e-13)
            self.assertEqual((analysis.dimension, analysis.points, analysis.realizations), (d, 100, 3))

    def test_read_what_several_tools_write(self):
        points, others = sets_of(2, 60)
        plain, utk, ply = self.folder / "plain.txt", self.folder / "utk.dat", self.folder / "set.ply"
        numpy.savetxt(plain, points, fmt="%.17g")
        rows = "\n".join(f"{x:.17g} {y:.17g}" for x, y in points)
        more = "\n".join(f"{x:.17g} {y:.17g}" for x, y in others)
        utk.write_text(f"{rows}\n#\n{more}\n")
        (self.folder / "utk.bin").write_bytes(struct.pack("<4sB3xIII", b"UTK!", 5, 1, 60, 2) + points.tobytes())
        ply.write_bytes(b"ply\nformat binary_little_endian 1.0\nelement vertex 60\nproperty double x\n"
                        b"property double y\nproperty double z\nend_header\n" +
                        b"".join(struct.pack("<3d", x, y, 0) for x, y in points))
        numpy.save(self.folder / "set.npy", numpy.asfortranarray(points))
        files = [plain, utk, ply, self.folder / "set.npy", self.folder / "utk.bin"]
        expected = pl.analyze(points).radial.power
        of_both = pl.analyze([points, others]).radial.power
        for file in files:
            with self.subTest(file.name):
                says_that_z_is_left_out = self.assertWarns(UserWarning) if file is ply else contextlib.nullcontext()
                with says_that_z_is_left_out:
                    analysis = pl.analyze(file)
                self.assertEqual(analysis.realizations, 2 if file is utk else 1)
                self.assert_same_bytes(analysis.sets[0], points)
                numpy.testing.assert_allclose(analysis.radial.power, of_both if file is utk else expected, rtol=1e-12)
        self.assertEqual(pl.analyze([plain, utk]).realizations, 2)  # a set that comes again counts once
        self.assert_same_bytes(pl.analyze(2 * points - 1, domain=(-1, 1)).sets[0],
                               numpy.minimum((2 * points - 1 + 1) / 2, 1 - 2**-53))

    def test_write_what_numpy_reads(self):
        points = sets_of(1, 60)[0]
        pl.write_points(self.folder / "set.npy", points)
        self.assert_same_bytes(numpy.load(self.folder / "set.npy"), points)
        pl.write_points(self.folder / "set.txt", points, "a comment")
        self.assert_same_bytes(numpy.loadtxt(self.folder / "set.txt"), points)
        self.assert_same_bytes(pl.read_points(self.folder / "set.txt")[0], points)

    def test_read_tables_and_snapshots_with_warnings(self):
        (self.folder / "set.csv").write_text("id;X;Y\n1;0,5;0,25\n2;0,125;0,75\n")
        with self.assertWarnsRegex(UserWarning, "only the columns x and y are read; left out: id") as caught:
            points = pl.read_points(self.folder / "set.csv")[0]
        self.assertEqual(caught.filename, __file__)
        self.assert_same_bytes(points, numpy.array([[0.5, 0.25], [0.125, 0.75]]))
        with self.assertWarnsRegex(UserWarning, "left out: id") as caught:
            self.assertEqual(pl.analyze(self.folder / "set.csv", spectrum="none").points, 2)
        self.assertEqual(caught.filename, __file__)
        space = sets_of(1, 20, 3)[0]
        pl.write_points(self.folder / "set.hdf5", space)
        self.assert_same_bytes(pl.read_points(self.folder / "set.hdf5", particles=1)[0], space)
        with self.assertRaisesRegex(pl.InputError, r"has no particles of type 0; it has PartType1 \(20\)"):
            pl.analyze(self.folder / "set.hdf5", particles=0)
        with self.assertRaisesRegex(pl.InputError, "particles=0: is for files of snapshots"):
            pl.analyze(space, particles=0)
        numpy.save(self.folder / "wide.npy", 512 * space)
        with self.assertRaisesRegex(pl.InputError, r"would fit$"):
            pl.read_points(self.folder / "wide.npy")

    def test_take_whatever_becomes_an_array(self):
        points = sets_of(2, 50)
        self.assertEqual(pl.analyze(points[0].tolist()).realizations, 1)
        self.assertEqual(pl.analyze([points[0], points[1]]).realizations, 2)
        self.assertEqual(pl.analyze(points.tolist()).realizations, 2)
        self.assertEqual(pl.analyze(points[0].astype(numpy.float32)).points, 50)
        self.assert_same_bytes(pl.analyze(numpy.asfortranarray(points[0])).sets[0], points[0])
        self.assert_same_bytes(pl.analyze(tuple(point) for point in points[0]).sets[0], points[0])

    def test_map_what_is_below_the_end_of_a_domain_below_1(self):
        points = numpy.array([[-1e9, -1e-10], [-5e8, -1e9]])  # (-1e-10 + 1e9) / 1e9 is rounded to 1
        expected = numpy.array([[0, 1 - 2**-53], [0.5, 0]])
        self.assert_same_bytes(pl.analyze(points, domain=(-1e9, 0)).sets[0], expected)
        numpy.save(self.folder / "set.npy", points)
        self.assert_same_bytes(pl.read_points(self.folder / "set.npy", (-1e9, 0))[0], expected)

    def test_move_coordinates_rounded_to_the_end_of_a_domain_to_its_beginning(self):
        points = sets_of(1, 40)[0].astype(numpy.float32)
        points[7, 1] = 0.99999999
        right = points.copy()
        right[7, 1] = 0
        with self.assertWarnsRegex(UserWarning, "1 of 80 coordinates were rounded to the end of the domain"):
            self.assert_same_bytes(pl.analyze(points).radial.power, pl.analyze(right).radial.power)
        with self.assertWarnsRegex(UserWarning, "were rounded to the end"):
            of_domain = pl.analyze(points * 3, domain=3)
        numpy.testing.assert_allclose(of_domain.min_distance, pl.analyze(right).min_distance, rtol=1e-5)
        grid = numpy.stack(numpy.meshgrid(*[numpy.linspace(0, 1, 6)] * 2), axis=-1).reshape(-1, 2).astype(numpy.float32)
        with self.assertRaisesRegex(pl.InputError, "1: must be a number in"):
            pl.analyze(grid)

    def test_leave_out_what_is_not_asked_for(self):
        analysis = pl.analyze(sets_of(1, 50), spectrum="none", measures="distances")
        self.assertIsNone(analysis.spectrum)
        self.assertEqual(len(analysis.radial.power), 0)
        self.assertEqual(len(analysis.pair_correlation.value), 0)

    def test_are_the_same_each_time(self):
        # The order in which CGAL holds tetrahedra depends on addresses: no last bit may show it.
        sets = sets_of(1, 150, 3)
        radii = {pl.analyze(sets).measures["largest_empty"].value for _ in range(20)}
        self.assertEqual(len(radii), 1)

    def test_are_kept_and_for_reading_only(self):
        analysis = pl.analyze(sets_of(2, 50))
        self.assertIs(analysis.spectrum, analysis.spectrum)
        for array in (analysis.spectrum, analysis.spectrum_variance, analysis.radial.power, analysis.sets[0],
                      analysis.pair_correlation.value, analysis.relative_radius):
            with self.assertRaisesRegex(ValueError, "read-only"):
                array[0] = 0
        with self.assertRaises(TypeError):
            analysis.measures["more"] = 0

    def test_leave_numpy_its_threads(self):
        blas = ctypes.CDLL("libopenblas.so.0")
        blas.openblas_set_num_threads(2)
        pl.analyze(sets_of(1, 50), spectrum="exact")
        self.assertEqual(blas.openblas_get_num_threads(), 2)

    def test_show_the_classic_figure(self):
        page = pl.analyze(sets_of(2, 200), label="Darts <1 & 2>")._repr_html_()
        self.assertIn("Darts &lt;1 &amp; 2&gt;", page)
        pictures = re.findall(r'src="data:(image/[a-z+]+);base64,([^"]+)"', page)
        self.assertEqual([kind for kind, _ in pictures],
                         ["image/svg+xml", "image/png", "image/svg+xml", "image/svg+xml"])
        for kind, data in pictures:
            content = base64.b64decode(data, validate=True)
            if kind == "image/png":
                self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
            else:
                self.assertTrue(xml.etree.ElementTree.fromstring(content).tag.endswith("svg"))
        xml.etree.ElementTree.fromstring(page)  # every tag is closed

    def test_write_reports(self):
        analysis = pl.analyze(sets_of(2, 100), label="Mine")
        analysis.report(self.folder / "report")
        self.assertIn("Mine", (self.folder / "report/index.html").read_text())
        self.assert_same_curves(analysis, self.folder / "report/Mine")

    def test_warn_of_sets_that_are_not_periodic(self):
        random = numpy.random.default_rng(1)
        darts = numpy.empty((0, 2))
        for dart in random.random((4000, 2)):  # 0.05 apart inside the square, but not across its border
            if len(darts) < 230 and (len(darts) == 0 or numpy.hypot(*(darts - dart).T).min() >= 0.05):
                darts = numpy.vstack([darts, dart])
        with self.assertWarnsRegex(UserWarning, "darts: The closest pairs of points meet across the border .*periodic=False"):
            around = pl.analyze(darts, label="darts")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            inside = pl.analyze(darts, periodic=False)
            stretched = pl.analyze(darts * (2, 1), box=(2, 1), periodic=False)
            pl.analyze(darts, periodic=True)
            pl.analyze(random.random((500, 2)))
        distances = numpy.hypot(*(darts[:, None] - darts[None]).T) + 9 * numpy.eye(len(darts))
        self.assertAlmostEqual(inside.min_distance[0], distances.min(), 7)
        distances = numpy.hypot(*((darts[:, None] - darts[None]) * (2, 1)).T) + 9 * numpy.eye(len(darts))
        self.assertAlmostEqual(stretched.min_distance[0], distances.min() / numpy.sqrt(2), 7)
        self.assertLess(around.min_distance[0], 0.9 * distances.min())
        with self.assertRaisesRegex(pl.InputError, "periodic: cannot be combined with region"):
            pl.analyze(darts, periodic=True, region="rectangle 0 0 1 1")

    def test_take_points_of_the_plane_with_a_third_coordinate(self):
        points = sets_of(1, 50)[0]
        flat = numpy.column_stack([points, numpy.zeros(len(points))])
        with self.assertWarnsRegex(UserWarning, "all points have the same third coordinate"):
            analysis = pl.analyze(flat)
        self.assertEqual(analysis.dimension, 2)
        self.assertEqual(analysis.min_distance[0], pl.analyze(points).min_distance[0])

    def test_take_the_end_of_a_domain_alone(self):
        points = sets_of(1, 50)[0]
        for options in ({"domain": 8}, {"domain": (0, 8)}, {"box": 8}, {"box": (8, 8)}):
            self.assert_same_bytes(pl.analyze(8 * points, **options).sets[0], points)
        pl.write_points(self.folder / "set.txt", points)
        self.assert_same_bytes(pl.read_points(self.folder / "set.txt", domain=2)[0], points / 2)

    def test_refuse_in_the_numbers_of_the_caller(self):
        points = 10 * sets_of(1, 50)[0]
        points[7, 1] = 9.5
        for options, words in (({}, r": must be a number in \[0, 1\); the numbers go from .*: domain=\(\S+, \S+\).* would fit$"),
                               ({"domain": 9.5}, r"^points: realization 0: point 7: 9.5: must be a number in \[0, 9.5\)"),
                               ({"domain": (10, 0)}, r"^domain: \(10, 0\): must be two numbers, the second above"),
                               ({"domain": (0, 1, 2)}, r"^domain: \(0, 1, 2\): must be \(low, high\)")):
            with self.subTest(**options), self.assertRaisesRegex(pl.InputError, words):
                pl.analyze(points, **options)

    def test_are_drawn_on_axes(self):
        analysis = pl.analyze(sets_of(2, 50), label="Mine")
        for curve, x, y in ((analysis.radial, "frequency", "power"), (analysis.pair_correlation, "distance", "value"),
                            (analysis.number_variance, "radius", "variance")):
            ax = unittest.mock.MagicMock()
            ax.plot.return_value = [unittest.mock.MagicMock()]
            self.assertIs(curve.plot(ax, color="red"), ax)
            (drawn_x, drawn_y), style = ax.plot.call_args
            self.assert_same_bytes(drawn_x, getattr(curve, x))
            self.assert_same_bytes(drawn_y, getattr(curve, y))
            self.assertEqual(style, {"color": "red"})
            low, high = ax.fill_between.call_args.args[1:]
            numpy.testing.assert_allclose((low + high) / 2, drawn_y)
        ax.reset_mock()
        analysis.plot(ax)
        self.assertEqual(ax.plot.call_args.kwargs, {"label": "Mine"})
        pl.TilePoints(analysis.sets[0], *[None] * 4).plot(ax)
        self.assertEqual(ax.scatter.call_args.args[0].tolist(), analysis.sets[0][:, 0].tolist())

    @unittest.skipIf(importlib.util.find_spec("pandas"), "pandas is there")
    def test_say_what_tables_need(self):
        with self.assertRaisesRegex(ImportError, "^to_dataframe: needs pandas: python3-pandas in Debian, or pip install"):
            pl.analyze(sets_of(1, 50)).radial.to_dataframe()

    def test_refuse_what_is_no_set(self):
        points = sets_of(1, 50)[0]
        wrong = points.copy()
        wrong[7, 1] = 1
        for mistake, words in ((wrong, r"^points: realization 0: point 7: 1: must be a number in \[0, 1\)$"),
                               (points * numpy.nan, r"point 0: nan: must be"),
                               (points[:, :1], r"shape \(50, 1\): must be \(points, 2\) or \(points, 3\)"),
                               (points[:0], "has no points"), ([], "there are no points"),
                               ([points, points[:9]], "has 9 points where .* has 50: realizations must have the same")):
            with self.assertRaisesRegex(pl.InputError, words):
                pl.analyze(mistake)
        with self.assertRaisesRegex(pl.InputError, r"^analyze: spectrum_size = 7: must be"):
            pl.analyze(points, spectrum_size=7)
        with self.assertRaisesRegex(pl.InputError, r"^analyze: .*spectrun"):
            pl.analyze(points, spectrun="none")
        with self.assertRaisesRegex(pl.InputError, "must be a number in"):
            pl.analyze(points, domain=(0, points.max()))

    def test_say_of_files_what_the_program_says(self):
        file = self.folder / "wrong.txt"
        for text in ("0.1 0.2\n0.3\n", "0.1 0.2\n0.5 1.5\n", "", "words"):
            file.write_text(text)
            with self.assertRaises(pl.InputError) as caught:
                pl.analyze(file)
            said = error_of_program("analyze", file, "--out", self.folder / "out")
            said = re.sub("--region '(.*)'", r'region="\1"', said)  # each names its own option
            said = re.sub(r'--domain "\S+ \S+" \(a periodic box\) or ', "", said)
            self.assertEqual(str(caught.exception), said)


if __name__ == "__main__":
    unittest.main()
