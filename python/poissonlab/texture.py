"""Texture tiles from pictures: what `poissonlab texture build` and [[texture]] make.

    made = poissonlab.texture.build("corner", exemplar="gravel.png", colors=3, size=64)
    made.numbers["seam_mismatch"], made.pictures["tiling"], made.save("gravel")
"""

import json as _json
import os as _os

from . import _poissonlab, kinds as _kinds
from .kinds import Made

_build = _kinds.functions_of("texture", {})["texture"]


def build(kind="corner", **keys):
    """Make texture tiles, and measure their seams, or an endless texture without tiles.

    Returns Made. rng, engine and device: see Sampler."""
    return _build(kind=kind, **keys)


_kinds.taking_kind(build, _build)

def advise(picture):
    """Say which texture tiles fit a picture, and whether it is a texture, as `poissonlab texture advise` does.

    Returns a dict: size in pixels, colors, straighten, flatten, texture (False: do not tile it), lines (sentences that say
    why), and what was measured. Raises InputError for what is no picture, and for pictures smaller than 16 x 16 pixels."""
    return _json.loads(_poissonlab.texture_advice(_os.fspath(picture)))


#: The function that build() calls.
keys = _build

#: endless("hexagons", exemplar=..., window=[0, 0, 1920, 1080]): a window of an endless texture by other methods than tiles.
endless = _kinds.function_of_command("texture endless", "endless")

__all__ = ["Made", "advise", "build", "endless"]
