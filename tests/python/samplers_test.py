"""The methods as classes: the program's sets, bit for bit, and the program's errors, word for word."""

import contextlib
import copy
import multiprocessing
import re
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy

import poissonlab as pl
from support import FolderTest, error_of_program, points_of, program

QUICK = ["--set", "analysis.realizations=2", "--set", "analysis.spectrum=none", "--set", "analysis.measures=distances",
         "--set", "analysis.timing_runs=1"]

SAMPLERS = {
    "darts": (lambda: pl.DartThrowing(relative_radius=0.7, rng=7), 300),
    "darts in space": (lambda: pl.DartThrowing(d=3, relative_radius=0.6, rng=7), 200),
    "reference": (lambda: pl.DartThrowing(relative_radius=0.7, rng=7, engine="reference"), 300),
    "relaxed darts": (lambda: pl.Lloyd(iterations=3, start=pl.DartThrowing(relative_radius=0.6), repulsion=True,
                                       until_relative_radius=0.8, rng=1), 128),
    "hierarchy": (lambda: pl.RelaxationDartThrowing(rng=2**63 - 1), 200),
    "jittered": (lambda: pl.Jittered(rng=0), 256),
    "sobol": (lambda: pl.Sobol(rng=1), 64),
    "elimination": (lambda: pl.SampleElimination(rng=1), 100),
}


class Samplers(FolderTest):
    def test_make_the_sets_of_the_program_bit_for_bit(self):
        for name, (make, points) in SAMPLERS.items():
            with self.subTest(name):
                sampler = make()
                config = self.folder / "sets.toml"
                config.write_text(sampler.config(points))
                program("run", config, "--out", self.folder / name, "--quiet", *QUICK)
                files = sorted((self.folder / name).glob("*/realization-*.dat"))
                self.assertGreaterEqual(len(files), 1)
                for file in files:
                    self.assert_same_bytes(sampler.random(points), points_of(file))

    def test_are_all_methods_of_the_program_with_their_parameters(self):
        listed = {}
        on_torus = program("samplers").split("\nIn a region", 1)[0]
        for line in on_torus.splitlines():
            if name := re.match(r"([a-z-]+): .* \(\dD", line):
                keys = listed.setdefault(name[1], [])
            elif (key := re.match(r"    ([a-z_]+) = ", line)) and listed:
                keys.append(key[1])
        self.assertGreater(len(listed), 20)
        classes = {cls._description["name"]: cls for cls in vars(pl).values()
                   if isinstance(cls, type) and issubclass(cls, pl.Sampler) and cls is not pl.Sampler}
        self.assertEqual(classes.keys(), listed.keys())
        for name, keys in listed.items():
            with self.subTest(name):
                self.assertEqual(list(classes[name].__signature__.parameters), [*keys, "d", "rng", "engine", "device"])
                for key in keys:
                    self.assertIn(f"\n{key}: ", classes[name].__doc__)

    def test_are_called_as_their_names(self):
        for name in ("DartThrowing", "RelaxationDartThrowing", "Lloyd", "GaussianBlueNoise", "CornerTiles", "File"):
            self.assertIn(name, pl.__all__)
            self.assertEqual(getattr(pl, name).__name__, name)

    def test_make_the_next_realization_each_time(self):
        sampler = pl.DartThrowing(relative_radius=0.6, rng=3)
        first, second = sampler.random(100), sampler.random(100)
        self.assertEqual(sampler.realization, 2)
        self.assertFalse(numpy.array_equal(first, second))
        self.assertIs(sampler.reset(), sampler)
        self.assert_same_bytes(sampler.random(100), first)
        self.assert_same_bytes(sampler.random(100), second)
        self.assert_same_bytes(sampler.reset().fast_forward(1).random(100), second)
        self.assert_same_bytes(sampler.reset().realizations(2, 100), numpy.stack([first, second]))
        self.assertEqual(sampler.realization, 2)

    def test_make_realizations_side_by_side_that_are_those_of_one_by_one(self):
        for k, n in ((1, 1), (2, 2), (3, 64), (40, 100)):
            sampler = pl.Lloyd(iterations=3, rng=4)
            expected = [sampler.reset().fast_forward(i).random(n) for i in range(k)]
            sampler = pl.Lloyd(iterations=3, rng=4)
            self.assert_same_bytes(sampler.realizations(k, n), numpy.stack(expected))
            self.assertEqual(sampler.realization, k)
            self.assert_same_bytes(sampler.reset().random(n), expected[0])
        with self.assertRaisesRegex(pl.InputError, "realization 4294967300: must be from 0 to"):
            pl.Lloyd(iterations=1).fast_forward(4294967300).realizations(2, 10)

    def test_give_arrays_of_points_in_the_unit_square_or_cube(self):
        for d in (2, 3):
            points = pl.Random(d=d).random(1000)
            self.assertEqual((points.shape, points.dtype), ((1000, d), numpy.float64))
            self.assertTrue(((points >= 0) & (points < 1)).all())
            self.assertTrue(points.flags.owndata or points.base is not None)
            points[0] = 0.5  # it is the caller's
        self.assertEqual(pl.Random().random().shape, (16384, 2))

    def test_take_seeds_generators_and_nothing(self):
        self.assertEqual(pl.Random(rng=numpy.int64(5)).seed, 5)
        drawn = pl.Random(rng=numpy.random.default_rng(1)).seed
        self.assertEqual(drawn, int(numpy.random.default_rng(1).integers(2**63 - 1, endpoint=True)))
        self.assertEqual(pl.Random(rng=numpy.random.RandomState(3)).seed, pl.Random(rng=numpy.random.RandomState(3)).seed)
        self.assertNotEqual(pl.Random().seed, pl.Random().seed)
        drawn = pl.Random()
        self.assert_same_bytes(drawn.random(20), pl.Random(rng=drawn.seed).random(20))

    def test_leave_what_depends_on_the_number_of_points_to_it(self):
        for few, make in ((4, lambda: pl.VoronoiDarts(relative_radius=0.7)), (4, lambda: pl.BestCandidate(candidates=9))):
            self.assertEqual(len(make().random(few)), few)
        with self.assertRaisesRegex(pl.InputError, "^DartThrowing: needs relative_radius"):
            pl.DartThrowing()

    def test_say_what_they_are(self):
        self.assertEqual(repr(pl.DartThrowing(relative_radius=0.7, rng=2)),
                         "DartThrowing(d=2, relative_radius=0.7, rng=2)")
        self.assertIn("relative_radius: ", pl.DartThrowing.__doc__)

    def test_read_files(self):
        sets = [pl.Random(rng=i).random(50) for i in range(2)]
        files = [self.folder / f"{i}.npy" for i in range(2)]
        for file, points in zip(files, sets):
            numpy.save(file, points)
        sampler = pl.File(path=files)
        self.assert_same_bytes(sampler.random(), sets[0])
        self.assert_same_bytes(sampler.random(), sets[1])
        with self.assertRaisesRegex(pl.InputError, "^File: realization 2: must be from 0 to 1$"):
            sampler.random()
        with self.assertRaisesRegex(pl.InputError, "^File: n = 50: cannot be combined with the sampler"):
            sampler.reset().random(50)

    def test_sets_of_several_sizes_are_no_array(self):
        sampler = pl.DartThrowing(min_distance=0.06, stop="saturation", rng=1)
        sizes = {len(sampler.random(200)) for _ in range(5)}
        self.assertGreater(len(sizes), 1)
        self.assertTrue(sampler.sizes_vary)
        with self.assertRaisesRegex(pl.InputError, "do not fit into one array"):
            sampler.reset().realizations(5, 200)
        self.assertEqual(sampler.realization, 0)


class Errors(FolderTest):
    MISTAKES = [
        ("dart-throwing", "DartThrowing", {"relative_radius": 1.5}),
        ("dart-throwing", "DartThrowing", {"relative_radius": "wide"}),
        ("lloyd", "Lloyd", {"iterations": -1}), ("lloyd", "Lloyd", {"iterations": 2.5}),
        ("lloyd", "Lloyd", {"start": "darts"}),
        ("lloyd", "Lloyd", {"start": {"sampler": "dart-throwing", "relative_radius": 2}}),
        ("file", "File", {}), ("file", "File", {"path": "nowhere\n.txt"}),
    ]

    def test_have_the_words_of_the_program(self):
        for sampler, name, parameters in self.MISTAKES:
            with self.subTest(sampler, **parameters):
                config = self.folder / "wrong.toml"
                lines = [f"{key} = {pl.toml.value_of(value)}" for key, value in parameters.items()]
                config.write_text("\n".join(["[[method]]", f'sampler = "{sampler}"', *lines]))
                said = error_of_program("run", config, "--out", self.folder / "out")
                # Paths are relative to the folder of the config, here to that of the process.
                with contextlib.chdir(self.folder), self.assertRaises(pl.InputError) as caught:
                    getattr(pl, name)(**parameters).random(16 if sampler != "file" else None)
                place, words = str(caught.exception).split(": ", 1)
                self.assertEqual(place, name)
                said = said.replace(str(self.folder) + "/", "")
                self.assertRegex(said, r"^wrong.toml:\d+: ")
                self.assertEqual(words, said.split(": ", 1)[1])

    def test_are_about_all_arguments(self):
        with self.assertRaisesRegex(pl.InputError, "^Random: d = 4: must be"):
            pl.Random(d=4)
        for rng in (-1, 2**63):
            with self.assertRaisesRegex(pl.InputError, f"^Random: rng = {rng}: must be an integer from 0"):
                pl.Random(rng=rng)
        for rng in (1.5, "x"):
            with self.assertRaisesRegex(TypeError, "^Random: rng = .*: must be an integer from 0"):
                pl.Random(rng=rng)
        with self.assertRaisesRegex(pl.InputError, "^Random: engine = .*: must be"):
            pl.Random(engine="steam")
        with self.assertRaisesRegex(pl.InputError, "^Random: n = 0: must be"):
            pl.Random().random(0)
        with self.assertRaisesRegex(pl.InputError, "^DartThrowing: a list of values makes several series"):
            pl.DartThrowing(relative_radius=[0.6, 0.7])
        with self.assertRaisesRegex(pl.DeviceError, "no such device here"):
            pl.DartThrowing(relative_radius=0.7, device="no such device here")
        with self.assertRaisesRegex(pl.InputError, "k = 0"):
            pl.Random().realizations(0, 10)
        with self.assertRaisesRegex(TypeError, "no parameter 'points'"):
            pl.Random(points=3)
        with self.assertRaisesRegex(TypeError, r"no parameter 'seed': it is called rng, as in Random\(rng=3\)"):
            pl.Random(seed=3)
        with self.assertRaisesRegex(TypeError, "no parameter 'relative_radios'; did you mean 'relative_radius'"):
            pl.DartThrowing(relative_radios=0.7)
        with self.assertRaisesRegex(TypeError, "make an object of a method"):
            pl.Sampler()

    def test_are_what_python_programs_catch(self):
        self.assertTrue(issubclass(pl.InputError, ValueError))
        self.assertTrue(issubclass(pl.DeviceError, RuntimeError))
        self.assertTrue(issubclass(pl.StorageError, OSError))
        self.assertEqual(pl.InputError.__module__, "poissonlab")


def next_set(sampler):
    """The next set of a sampler that came from another process."""
    return sampler.random(300)


class Processes(unittest.TestCase):
    def test_make_the_same_sets(self):
        samplers = [pl.DartThrowing(relative_radius=0.7, rng=seed).fast_forward(seed) for seed in range(3)]
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            made = pool.map(next_set, samplers)
        for sampler, points in zip(samplers, made):
            self.assertEqual(points.tobytes(), sampler.random(300).tobytes())

    def test_have_copies_of_their_own(self):
        sampler = pl.Random()
        sampler.random(10)
        twin = copy.copy(sampler)
        self.assertEqual(sampler.random(10).tobytes(), twin.random(10).tobytes())
        self.assertFalse(copy.copy(twin).sizes_vary)


class Threads(unittest.TestCase):
    def test_take_turns(self):
        expected = [pl.DartThrowing(relative_radius=0.7, rng=seed).random(2000) for seed in range(6)]
        made = [None] * 6

        def make(seed):
            made[seed] = pl.DartThrowing(relative_radius=0.7, rng=seed).random(2000)

        threads = [threading.Thread(target=make, args=(seed,)) for seed in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for a, b in zip(expected, made):
            self.assertEqual(a.tobytes(), b.tobytes())

    def test_go_on_while_sets_are_made(self):
        sampler = pl.Lloyd(iterations=400)
        ticks, done = [], threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.001)

        thread = threading.Thread(target=tick)
        thread.start()
        begin = time.monotonic()
        sampler.random(2000)
        end = time.monotonic()
        done.set()
        thread.join()
        # With the interpreter's lock held, there would be no tick in the middle of the call.
        middle = [t for t in ticks if begin + (end - begin) / 4 < t < end - (end - begin) / 4]
        self.assertGreater(len(middle), 3)


class Interrupts(unittest.TestCase):
    SCRIPT = """
import signal, time
import poissonlab as pl
before = pl.DartThrowing(relative_radius=0.7, rng=1).random(500)
print("ready", flush=True)
try:
    {work}
    print("was not interrupted")
except KeyboardInterrupt:
    print("interrupted", flush=True)
assert (pl.DartThrowing(relative_radius=0.7, rng=1).random(500) == before).all()
try:
    signal.raise_signal(signal.SIGINT)
    print("the interpreter's handler is gone")
except KeyboardInterrupt:
    print("as before")
"""

    def interrupt(self, work):
        script = subprocess.Popen([sys.executable, "-B", "-c", self.SCRIPT.format(work=work)], stdout=subprocess.PIPE,
                                  text=True)
        with script:
            self.assertEqual(script.stdout.readline(), "ready\n")
            time.sleep(0.7)
            script.send_signal(2)
            begin = time.monotonic()
            self.assertEqual(script.stdout.readline(), "interrupted\n")
            seconds = time.monotonic() - begin
            self.assertEqual(script.stdout.read(), "as before\n")
        self.assertEqual(script.returncode, 0)
        return seconds

    def test_end_kernels_that_follow_each_other(self):
        self.assertLess(self.interrupt("pl.Lloyd(iterations=1000000).random(5000)"), 2)

    def test_end_runs(self):
        config = "open('long.toml', 'w').write(pl.Lloyd(iterations=1000000).config(5000))"
        with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
            self.assertLess(self.interrupt(f"pl.run('long.toml' if {config} else '')"), 2)

    def test_end_analyses(self):
        self.assertLess(self.interrupt("pl.analyze(pl.Random().realizations(2000, 1000), spectrum='exact')"), 2)


if __name__ == "__main__":
    unittest.main()
