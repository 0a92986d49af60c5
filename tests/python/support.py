"""What the tests of the Python package share: the program, temporary folders, plain readers of its files."""

import csv
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

PROGRAM = os.environ["POISSONLAB_PROGRAM"]
SOURCE = pathlib.Path(os.environ["POISSONLAB_SOURCE"])
TILE_SET = SOURCE / "runtime/tile_sets/corner-c3-n64-r075.ptiles"


class FolderTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def assert_same_bytes(self, a, b):
        self.assertEqual(a.shape, b.shape)
        self.assertEqual(a.dtype, b.dtype)
        self.assertEqual(a.tobytes(), b.tobytes())


def program(*arguments, cwd=None):
    """Runs the program, which must succeed. Returns what it printed."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, cwd=cwd, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{arguments}: {done.stderr}")
    return done.stdout


def error_of_program(*arguments):
    """The error that the program ends with, status 2, without its name."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)
    if done.returncode != 2:
        raise AssertionError(f"{arguments}: status {done.returncode}: {done.stderr}")
    return done.stderr.removeprefix("poissonlab: error: ").rstrip("\n")


def points_of(file):
    """The points of a text file, read by Python's own float()."""
    rows = [line.split() for line in file.read_text().splitlines() if not line.startswith("#")]
    return numpy.array([[float(word) for word in row] for row in rows])


def columns_of(file):
    """The columns of a CSV file by their names."""
    with file.open() as lines:
        rows = list(csv.reader(lines))
    return {name: numpy.array([float(row[i]) for row in rows[1:]]) for i, name in enumerate(rows[0])}


def torus_distance(points):
    """The smallest distance of a set on the torus, by looking at all pairs."""
    smallest = numpy.inf
    for i in range(len(points) - 1):
        offset = points[i + 1:] - points[i]
        offset -= numpy.rint(offset)
        smallest = min(smallest, (offset**2).sum(axis=1).min())
    return float(numpy.sqrt(smallest))
