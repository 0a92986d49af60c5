#!/usr/bin/env python3
"""Writes the stubs of types of poissonlab.samplers, the classes of all methods, which are made at import.

The build calls it with the file to write, once the module is there.
"""

import inspect
import os
import pathlib
import sys

from poissonlab import samplers

HEAD = '''# Written at the build by python/tools/write_stubs.py, from the methods' own descriptions.
import os
from typing import Any, Sequence

import numpy
import numpy.typing

class Sampler:
    d: int
    seed: int
    engine: str
    device: str | int | None
    parameters: dict[str, Any]
    def __init__(self, *, d: int = 2, rng: int | numpy.random.Generator | None = None, engine: str = "opencl",
                 device: str | int | None = None, **parameters: Any) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def realization(self) -> int: ...
    def random(self, n: int | None = None) -> numpy.typing.NDArray[numpy.float64]: ...
    def realizations(self, k: int, n: int | None = None) -> numpy.typing.NDArray[numpy.float64]: ...
    def reset(self) -> "Sampler": ...
    def fast_forward(self, k: int) -> "Sampler": ...
    @property
    def sizes_vary(self) -> bool: ...
    @property
    def is_window(self) -> bool: ...
    @property
    def tiles_along_axis(self) -> int: ...
    @property
    def proven_relative_radius(self) -> float | None: ...
    def to_toml(self) -> str: ...
    def config(self, n: int | None = None) -> str: ...
'''


def stub_of(name, method):
    """The stub of a method's class."""
    keywords = ",\n                 ".join(f"{keyword.name}: {keyword.annotation}{shown(keyword.default)}"
                                         for keyword in method.__signature__.parameters.values())
    return f"\nclass {name}(Sampler):\n    def __init__(self, *, {keywords}) -> None: ...\n"


def shown(value):
    """Returns a default as a stub has it, behind its sign; nothing where the parameter is needed."""
    if value is inspect.Parameter.empty:
        return ""
    return f' = "{value}"' if isinstance(value, str) else f" = {value!r}"


def write_whole(file, text):
    """The file has the whole text or what it had before; a link is replaced, not followed."""
    part = file.with_suffix(".part")
    part.write_text(text, encoding="utf-8")
    os.replace(part, file)


if __name__ == "__main__":
    write_whole(pathlib.Path(sys.argv[1]),
                HEAD + "".join(stub_of(name, method) for name, method in samplers.METHODS.items()))
