"""Builds the Python package as a wheel. Its module of C++ is built by CMake, in build/wheel-..., one folder a Python.

POISSONLAB_BUILD names a build folder whose module is packed as it is, and nothing is built: that of `./lab test` is
build/release, for Debian's Python.

With POISSONLAB_LIBRARIES=1 the wheel has the libraries that the module needs, for machines without them. Those of picture
files are left out: they are some two hundred and sixty. Needs patchelf.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parent
MODULES = ["poissonlab_pictures", "poissonlab_particles", "poissonlab_globe", "poissonlab_drawings"]
TARGETS = ["poissonlab_python", *MODULES, "poissonlab_stubs"]
HOW_TO_BUILD = "the compiler, CMake and libraries that it needs: see docs/install.md, or run ./lab test once"


def version():
    """The version of project() in CMakeLists.txt."""
    return re.search(r"project\(poissonlab VERSION ([0-9.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]


def run(*command):
    """Runs a command, with its output where pip shows it. Ends in one line where it fails."""
    try:
        subprocess.run(list(map(str, command)), check=True, cwd=SOURCE)
    except FileNotFoundError:
        raise SystemExit(f"poissonlab: there is no {command[0]}. Building needs {HOW_TO_BUILD}") from None
    except subprocess.CalledProcessError as error:
        raise SystemExit(f"poissonlab: {command[0]} failed with status {error.returncode}. Building needs "
                         f"{HOW_TO_BUILD}") from None


# What every Linux with a desktop or server has: the C library and the compiler's run time.
OF_THE_SYSTEM = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|gcc_s|stdc\+\+))\.so")


def libraries_of(module):
    """The files of the libraries that a module needs, directly or not, by the names that it asks for."""
    lines = subprocess.run(["ldd", module], check=True, capture_output=True, text=True).stdout.splitlines()
    if lost := [line.split()[0] for line in lines if "not found" in line]:
        raise SystemExit(f"poissonlab: {module.name} needs {lost[0]}, which is not on this machine")
    found = dict(line.split()[:3:2] for line in lines if " => /" in line)
    return {name: pathlib.Path(file) for name, file in found.items() if not OF_THE_SYSTEM.match(name)}


def add_libraries(package, modules):
    """Copies what the modules need into the folder `libraries` of the package, and has them look there."""
    folder = package / "libraries"
    folder.mkdir()
    for module in modules:
        for name, file in libraries_of(module).items():
            if not (folder / name).exists():
                shutil.copy2(file, folder / name)
                run("patchelf", "--set-rpath", "$ORIGIN", folder / name)
        run("patchelf", "--set-rpath", "$ORIGIN/libraries", module)


class CMakeModule(build_ext):
    """Puts the module, the modules of pictures, particles, maps and drawings that it loads, and the types that the build wrote beside the package."""

    def run(self):
        named = os.environ.get("POISSONLAB_BUILD")
        folder = SOURCE / named if named else self.built()
        built = folder / "python/poissonlab"
        files = [built / self.get_ext_filename("_poissonlab"), built / "samplers.pyi",
                 *(folder / f"lib{name}.so" for name in MODULES)]
        missing = [file for file in files if not file.is_file()]
        if missing:
            if not named:
                raise SystemExit(f"poissonlab: the build in {folder} left no {missing[0]}. Building needs {HOW_TO_BUILD}")
            raise SystemExit(f"poissonlab: POISSONLAB_BUILD={named}: there is no {missing[0]}: must be a build folder with "
                             f"the Python package for {sys.executable}")
        package = pathlib.Path(self.build_lib) / "poissonlab"
        package.mkdir(parents=True, exist_ok=True)
        for file in files:
            shutil.copy2(file, package)
        if os.environ.get("POISSONLAB_LIBRARIES") == "1":
            # The libraries of picture files stay out.
            add_libraries(package, [package / file.name for file in files
                                    if file.name not in ("samplers.pyi", "libpoissonlab_pictures.so")])

    def built(self):
        """The folder of a build for the Python that runs this, which takes minutes the first time."""
        folder = SOURCE / "build" / f"wheel-{sys.implementation.cache_tag}"
        run("cmake", "-S", SOURCE, "--preset", "release", "-B", folder, "-DPOISSONLAB_PYTHON=ON",
            f"-DPython_EXECUTABLE={sys.executable}")
        run("cmake", "--build", folder, "--target", *TARGETS)
        return folder


# What setuptools writes on the way is gone afterwards: a file that was taken out of the package would stay in the wheel.
with tempfile.TemporaryDirectory() as work:
    setup(version=version(),
          ext_modules=[Extension("poissonlab._poissonlab", sources=[])],
          cmdclass={"build_ext": CMakeModule},
          options={"build": {"build_base": work}, "egg_info": {"egg_base": work}})
