"""Point files, in the formats that the program reads and writes."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Union

import numpy
from numpy.typing import ArrayLike

from . import _poissonlab

#: A range (low, high) of all coordinates, its upper end where the lower one is 0, or a range for each axis.
Domain = Union[float, tuple[float, float], Sequence[tuple[float, float]]]


def ranges_of(domain):
    """A domain as ranges (low, high), a list of one for all axes or of one for each; None: what files say."""
    if domain is None:
        return None
    ranges = numpy.asarray(domain, dtype=float)
    ranges = numpy.array([0, ranges]) if ranges.ndim == 0 else ranges
    if ranges.ndim not in (1, 2) or ranges.size == 0 or ranges.shape[-1] != 2:
        raise _poissonlab.InputError(f"domain: {domain!r}: must be (low, high), its upper end alone where it begins at 0, "
                                     "or a range (low, high) for each axis")
    for low, high in ranges.reshape(-1, 2):
        if not low < high:
            raise _poissonlab.InputError(f"domain: ({low:g}, {high:g}): must be two numbers, the second above the first")
    return ranges.reshape(-1, 2).tolist()


def read_points(file: str | os.PathLike[str],
                domain: Domain | None = None, particles: int | None = None) -> list[numpy.ndarray]:
    """Read the sets of a point file: text, CSV, PLY, NumPy, HDF5 or UTK's .bin, told apart by content.

    Coordinates are mapped to [0, 1) from `domain`: (low, high), its upper end where it begins at 0, such as domain=10, or
    a range for each axis; default: what the file says, or (0, 1).
    `particles`: the type of a snapshot's particles, 0 for PartType0; default: its only one. A snapshot in several files
    is read as a whole where one of them is named. Warns of what was left out, or taken for something else.
    Returns a list of float64 arrays of shape (points, 2) or (points, 3), one a realization.
    Raises InputError with file and line.
    """
    return _poissonlab.read_points([file], ranges_of(domain), particles, False, 2)


def write_points(file: str | os.PathLike[str], points: ArrayLike, comment: str = "") -> None:
    """Write one set: .npy, .csv, .ply, .usda, .geojson, .dxf by the extension, else text that reads back as the same doubles.

    `points`: shape (n, 2) or (n, 3) in [0, 1). The file is there whole or not at all.
    """
    _poissonlab.write_points(file, points, comment)
