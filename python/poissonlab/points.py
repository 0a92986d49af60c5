"""Point files, in the formats that the program reads and writes."""

import os
from collections.abc import Sequence
from typing import Optional, Union

import numpy
import numpy.typing

from . import _poissonlab

#: A range (low, high) of all coordinates, or one for each axis.
Domain = Union[tuple[float, float], Sequence[tuple[float, float]]]


def ranges_of(domain):
    """A domain as ranges (low, high), a list of one for all axes or of one for each; None: what files say."""
    if domain is None:
        return None
    ranges = numpy.asarray(domain, dtype=float)
    if ranges.ndim not in (1, 2) or ranges.size == 0 or ranges.shape[-1] != 2:
        raise _poissonlab.InputError("domain: must be (low, high), or such a range for each axis")
    return ranges.reshape(-1, 2).tolist()


def read_points(file: "str | os.PathLike[str]",
                domain: Optional[Domain] = None) -> list[numpy.ndarray]:
    """Read the sets of a point file: text, CSV, PLY, NumPy or UTK's .bin, told apart by content.

    Coordinates are mapped to [0, 1) from `domain`, a pair (low, high) or one for each axis; default: what the file says,
    or (0, 1).
    Returns a list of float64 arrays of shape (points, 2) or (points, 3), one a realization.
    Raises InputError with file and line.
    """
    return _poissonlab.read_points(file, ranges_of(domain))


def write_points(file: "str | os.PathLike[str]", points: numpy.typing.ArrayLike, comment: str = "") -> None:
    """Write one set: .npy, .csv, .ply, .usda by the extension, else text that reads back as the same doubles.

    `points`: shape (n, 2) or (n, 3) in [0, 1). The file is there whole or not at all.
    """
    _poissonlab.write_points(file, points, comment)
