"""The wheel of the package: what `pip install .` makes, of the build that is there, unpacked and imported elsewhere."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest
import zipfile

import numpy

import poissonlab as pl
from support import PROGRAM, SOURCE, TILE_SET, FolderTest

# What pip calls, so that no pip is needed.
BUILD_WHEEL = "import sys; from setuptools import build_meta; print(build_meta.build_wheel(sys.argv[1]))"

# Prints where the package is, and writes points that it makes. A figure needs the module of pictures.
USE_WHEEL = """
import sys
import numpy
import poissonlab as pl
points = pl.DartThrowing(d=2, relative_radius=0.7, rng=1).random(300)
assert pl.analyze(points).figure().count("<img") == 4
numpy.save("points.npy", points)
numpy.save("tiles.npy", pl.TileSet(sys.argv[1]).window(-3, 5, 4, 2, seed=9))
with open("/proc/self/maps") as maps:
    print(*sorted({line.split()[-1] for line in maps if "poissonlab" in line and ".so" in line}))
"""


@unittest.skipUnless(all(map(importlib.util.find_spec, ("setuptools", "wheel"))), "needs python3-setuptools, -wheel")
class Wheels(FolderTest):
    def build(self, build_folder, **more):
        environment = {**os.environ, "POISSONLAB_BUILD": str(build_folder), **more}
        environment.pop("PYTHONPATH")
        return subprocess.run([sys.executable, "-B", "-c", BUILD_WHEEL, self.folder], cwd=SOURCE, env=environment,
                              capture_output=True, text=True, check=False)

    def left_behind(self):
        """What setuptools may write into the checkout. Other tests may make files of theirs at the same time."""
        patterns = ("*.egg-info", "build", "build/lib*", "build/bdist*", "build/temp*", "dist")
        return {path for folder in (SOURCE, SOURCE / "python") for pattern in patterns for path in folder.glob(pattern)}

    def test_hold_the_package_and_work_elsewhere(self):
        before = self.left_behind()
        done = self.build(pathlib.Path(PROGRAM).parent)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.left_behind(), before, "files are left in the checkout")

        version = re.search(r"^project\(poissonlab VERSION ([0-9.]+)", (SOURCE / "CMakeLists.txt").read_text(), re.M)[1]
        tag = f"cp{sys.version_info.major}{sys.version_info.minor}"
        (wheel,) = self.folder.glob(f"poissonlab-{version}-{tag}-{tag}-linux_*.whl")
        installed = self.folder / "installed"
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(installed)
        files = {file.name for file in (SOURCE / "python/poissonlab").iterdir() if file.suffix in (".py", ".pyi", ".typed")}
        module = pathlib.Path(pl._poissonlab.__file__).name
        self.assertEqual({file.name for file in (installed / "poissonlab").iterdir()},
                         files | {module, "samplers.pyi", "libpoissonlab_pictures.so", "libpoissonlab_particles.so",
                                  "libpoissonlab_globe.so", "libpoissonlab_drawings.so", "py.typed"})
        self.assertEqual(sorted(path.name for path in installed.iterdir()), ["poissonlab", f"poissonlab-{version}.dist-info"])
        metadata = (installed / f"poissonlab-{version}.dist-info/METADATA").read_text()
        self.assertRegex(metadata, r"(?m)^Requires-Dist: numpy")
        self.assert_works(installed)

    def assert_works(self, installed):
        done = subprocess.run([sys.executable, "-B", "-W", "error", "-c", USE_WHEEL, TILE_SET], cwd=self.folder,
                              env={**os.environ, "PYTHONPATH": str(installed)}, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        libraries = done.stdout.split()
        self.assertGreaterEqual(len(libraries), 2)
        for library in libraries:
            self.assertTrue(library.startswith(f"{installed}/poissonlab/"), library)
        self.assert_same_bytes(numpy.load(self.folder / "points.npy"),
                               pl.DartThrowing(d=2, relative_radius=0.7, rng=1).random(300))
        self.assert_same_bytes(numpy.load(self.folder / "tiles.npy"), pl.TileSet(TILE_SET).window(-3, 5, 4, 2, seed=9))

    @unittest.skipUnless(shutil.which("patchelf"), "needs patchelf")
    def test_with_libraries_load_only_system_libraries_from_outside_the_wheel(self):
        done = self.build(pathlib.Path(PROGRAM).parent, POISSONLAB_LIBRARIES="1")
        self.assertEqual(done.returncode, 0, done.stderr)
        (wheel,) = self.folder.glob("*.whl")
        package = self.folder / "installed/poissonlab"
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(package.parent)
        libraries = package / "libraries"
        loaded = {pathlib.Path(pl._poissonlab.__file__).name,
                  *(f"libpoissonlab_{name}.so" for name in ("particles", "globe", "drawings"))}
        for file in [*(package / name for name in loaded), *libraries.iterdir()]:
            for line in subprocess.run(["ldd", file], check=True, capture_output=True, text=True).stdout.splitlines():
                name, _, place = line.strip().partition(" => ")
                if place and not re.match(r"lib(c|m|dl|rt|pthread|resolv|util|gcc_s|stdc\+\+)\.so", name):
                    self.assertTrue(place.startswith(f"{libraries}/"), f"{file.name}: {line}")
        self.assert_works(package.parent)

    def test_are_refused_of_a_folder_without_a_build(self):
        done = self.build(self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr.splitlines()[-1],
                         rf"^poissonlab: POISSONLAB_BUILD={self.folder}: there is no .*_poissonlab\..*: must be a build folder")


if __name__ == "__main__":
    unittest.main()
