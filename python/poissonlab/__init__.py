"""Poisson disk point sets and tile sets: made with OpenCL, measured as the literature does, shown.

    import poissonlab as pl
    points = pl.DartThrowing(d=2, relative_radius=0.7, rng=1).random(16384)   # (n, d) in [0, 1)
    pl.analyze(points)                                                        # in a notebook: the classic figure
    pl.TileSet("corner-c4-n64-r075.ptiles").window(-4, -4, 8, 8, seed=1)      # (n, 2) in tiles
    pl.run("configs/quick.toml")["dart-throwing-rho-0.75"].radial.power       # results as arrays

Points live on the unit torus. The relative radius is the smallest distance between points over the largest that so many
points can have; the radius of the literature is half of the smallest distance, and nothing here is called just radius.

Every set is what the program `poissonlab` makes of the same seed, bit for bit. Errors have the program's words:
InputError (a ValueError), DeviceError (a RuntimeError), StorageError (an OSError). Work goes on without the
interpreter's lock, one call at a time, and ends on Ctrl-C. Other processes can work as well where they are spawned,
not forked: multiprocessing.get_context("spawn").
"""

from . import distribute, hints as _hints, texture, tilings
from . import samplers as _samplers
from ._poissonlab import DeviceError, InputError, StorageError
from ._poissonlab import version as __version__
from .analysis import Analysis, Measure, NumberVariance, PairCorrelation, Radial, RegionCurves, analyze
from .points import read_points, write_points
from .results import Results, open, run
from .samplers import *  # noqa: F403: a class for every method
from .tiles import Certificate, NearestPoints, TilePoints, TileSet

# Not `open`, so that `from poissonlab import *` leaves the interpreter's own.
__all__ = [
    "Analysis", "Certificate", "DeviceError", "InputError", "Measure", "NearestPoints", "NumberVariance",
    "PairCorrelation", "Radial", "RegionCurves", "Results", "StorageError", "TilePoints", "TileSet", "analyze",
    "distribute", "read_points", "run", "texture", "tiles", "tilings", "write_points",
    *_samplers.__all__,
]

_hints.show([globals()[_name] for _name in __all__] + [open])
