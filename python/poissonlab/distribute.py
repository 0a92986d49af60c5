"""Points and objects that follow densities: what `poissonlab distribute` and [[distribution]] make.

    made = poissonlab.distribute.stipple(image="photo.jpg", points=40000)
    made.points, made.numbers["tone_error"], made.pictures["coverage"]
    trees = poissonlab.distribute.darts(region="park.geojson", min_distance=4).points
"""

from . import kinds as _kinds
from .kinds import Made

_FUNCTIONS = _kinds.functions_of("distribution", {"stippling": "stipple", "hatching": "hatch", "ranks": "rank"})
for _function in _FUNCTIONS.values():
    _function.__module__ = __name__
globals().update(_FUNCTIONS)

__all__ = ["Made", *_FUNCTIONS]
