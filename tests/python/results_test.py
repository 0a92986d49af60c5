"""run() and open(): the program's results, as arrays."""

import unittest

import numpy

import poissonlab as pl
from support import FolderTest, error_of_program, program

CONFIG = """
title = "Two methods"
[analysis]
points = 128
realizations = 2
timing_runs = 1
[[method]]
sampler = "dart-throwing"
relative_radius = [0.60, 0.65]
[[method]]
sampler = "jittered"
"""


class Runs(FolderTest):
    def setUp(self):
        super().setUp()
        self.config = self.folder / "two.toml"
        self.config.write_text(CONFIG)

    def test_have_the_results_of_the_program(self):
        results = pl.run(self.config, self.folder / "ours", changes={"seed": 4, "engine": "reference"}, report=False)
        program("run", self.config, "--out", self.folder / "theirs", "--quiet", "--set", "seed=4", "--set",
                "engine=reference")
        theirs = pl.open(self.folder / "theirs")
        self.assertEqual(list(results), ["dart-throwing-rho-0.60", "dart-throwing-rho-0.65", "jittered"])
        self.assertEqual(list(theirs), list(results))
        self.assertEqual((results.title, results.config), ("Two methods", CONFIG))
        for name, series in results.items():
            for a, b in zip(series.sets, theirs[name].sets, strict=True):
                self.assert_same_bytes(a, b)
            for a, b in zip((*series.radial, *series.pair_correlation, series.spectrum),
                            (*theirs[name].radial, *theirs[name].pair_correlation, theirs[name].spectrum), strict=True):
                self.assert_same_bytes(a, b)
        sampler = pl.DartThrowing(relative_radius=0.65, rng=4)
        numpy.testing.assert_array_equal(results["dart-throwing-rho-0.65"].sets, sampler.realizations(2, 128))
        self.assertFalse((self.folder / "ours/index.html").exists())

    def test_write_reports(self):
        results = pl.run(self.config, self.folder / "out")
        self.assertIn("Two methods", (self.folder / "out/index.html").read_text())
        self.assertEqual(results.report(self.folder / "again"), str(self.folder / "again/index.html"))
        self.assertTrue((self.folder / "again/index.html").exists())
        page = results._repr_html_()
        self.assertIn("jittered", page)
        self.assertEqual(results["jittered"].figure().count("<img"), 4)
        with self.assertRaisesRegex(pl.InputError, "have a report of their own"):
            results["jittered"].report(self.folder / "third")

    def test_may_be_those_of_a_collection(self):
        collection = self.folder / "all.toml"
        collection.write_text('title = "All"\ninclude = ["two.toml", "one.toml"]\n')
        (self.folder / "one.toml").write_text(CONFIG.replace("[0.60, 0.65]", "0.60"))
        results = pl.run(collection, self.folder / "all", report=False)
        self.assertEqual(list(results), ["two/dart-throwing-rho-0.60", "two/dart-throwing-rho-0.65", "two/jittered",
                                         "one/dart-throwing-rho-0.60", "one/jittered"])
        self.assertEqual(list(pl.open(self.folder / "all")), list(results))
        program("report", self.folder / "all", "--quiet")

    def test_warn_of_series_that_are_left_out(self):
        self.config.write_text(CONFIG + '[[method]]\nsampler = "command"\nlabel = "Mine"\n'
                               'command = "no-such-program {out}"\nneeds = "no-such-program --help"\n')
        with self.assertWarnsRegex(UserWarning, "^Mine: left out: ") as caught:
            results = pl.run(self.config, self.folder / "out", report=False)
        self.assertEqual(caught.filename, __file__)  # the line of the call
        self.assertEqual(len(results), 3)

    def test_refuse_in_the_words_of_the_program(self):
        wrong = self.folder / "wrong.toml"
        for text in ("sed = 1", CONFIG.replace("0.65", "1.65"), "[[method]]\nsampler = 3", "seed ="):
            wrong.write_text(text)
            with self.assertRaises(pl.InputError) as caught:
                pl.run(wrong, self.folder / "out")
            self.assertEqual(str(caught.exception), error_of_program("run", wrong, "--out", self.folder / "out"))
        for wrong in (self.folder / "nowhere.toml", self.folder):
            with self.assertRaises(pl.InputError) as caught:
                pl.run(wrong)
            self.assertEqual(str(caught.exception), error_of_program("run", wrong))
        with self.assertRaises(pl.InputError):
            pl.open(self.folder / "nowhere")
        with self.assertRaisesRegex(pl.InputError, "--set analysis.points=0"):
            pl.run(self.config, self.folder / "out", changes={"analysis.points": 0})


if __name__ == "__main__":
    unittest.main()
