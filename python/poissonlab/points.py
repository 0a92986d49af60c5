"""Point files, in the formats that the program reads and writes."""

import os
from typing import Optional

import numpy
import numpy.typing

from . import _poissonlab


def read_points(file: "str | os.PathLike[str]",
                domain: Optional[tuple[float, float]] = None, particles: Optional[int] = None) -> list[numpy.ndarray]:
    """Read the sets of a point file: text, CSV, PLY, NumPy, HDF5 or UTK's .bin, told apart by content.

    Coordinates are mapped to [0, 1) from `domain`, a pair (low, high); default: what the file says, or (0, 1).
    `particles`: the type of a snapshot's particles, 0 for PartType0; default: its only one. A snapshot in several files
    is read as a whole where one of them is named. Warns of what was left out, or taken for something else.
    Returns a list of float64 arrays of shape (points, 2) or (points, 3), one a realization.
    Raises InputError with file and line.
    """
    return _poissonlab.read_points([file], domain, particles, False, 2)


def write_points(file: "str | os.PathLike[str]", points: numpy.typing.ArrayLike, comment: str = "") -> None:
    """Write one set: .npy, .csv, .ply, .usda, .geojson, .dxf by the extension, else text that reads back as the same doubles.

    `points`: shape (n, 2) or (n, 3) in [0, 1). The file is there whole or not at all.
    """
    _poissonlab.write_points(file, points, comment)
