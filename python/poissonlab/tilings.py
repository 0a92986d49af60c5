"""Tilings, packings and what is shown of them: what [[tiling]], [[tile_set]], [[packing]], [[construction]] and [[scheme]]
of configs make.

    poissonlab.tilings.tiling(kind="wang", colors=3).tiles          # rows of indices, north first
    poissonlab.tilings.packing(kind="corner", colors=2).pictures
    poissonlab.tilings.isohedral(type=16, random=True, rng=5).pictures
    poissonlab.tilings.template(show="points", window=[0, 0, 6, 4]).pictures["construction"]
"""

from . import kinds as _kinds
from .kinds import Made

_FUNCTIONS = {}
for _table, _names in {"tiling": {}, "tile_set": {}, "packing": {}, "scheme": {"construction": "lattices"},
                       "construction": {}}.items():
    _FUNCTIONS |= _kinds.functions_of(_table, _names)
for _function in _FUNCTIONS.values():
    _function.__module__ = __name__
globals().update(_FUNCTIONS)

__all__ = ["Made", *_FUNCTIONS]
