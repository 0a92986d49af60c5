"""Functions for kinds of work, made from the kinds' own descriptions: see poissonlab.distribute."""

import inspect
import pathlib
import shutil
import tempfile
import weakref

import numpy

from . import _poissonlab, toml
from .samplers import seed_of


class Made:
    """What a kind of work came to.

    label: its name in reports; facts: what it was made from, sentences.
    numbers: what was measured, by key; titles says what each is.
    pictures: arrays of shape (height, width, channels), uint8, by name; captions says what each shows.
    points: the places that were made, shape (n, 2), in units of the longest side, y upwards, those of regions in the
    region's own, of space with shape (n, 3); None where there are none.
    distances: of points whose minimum distance varies: that at each, in the region's units; else None.
    classes: of points with classes: the class of each, uint32; else None.
    normals: of points on surfaces: the normal of each one's triangle, (N, 3); else None.
    mask: of masks: an array of shape (rows, columns); else None.
    tiles: of tilings, tile sets and packings: the indices of tiles, rows from north to south; else None.
    files: the paths of all files, which are there as long as this object is; save() keeps them.
    """

    def __init__(self, folder, made):
        self._folder = folder
        self.label = made["label"]
        self.facts = made["facts"]
        self.numbers = made["numbers"]
        self.titles = made["titles"]
        self.pictures = made["pictures"]
        self.captions = made["captions"]
        self.files = [folder / name for name in made["files"]]
        tiles = folder / "tiles.txt"
        self.tiles = numpy.loadtxt(tiles, dtype=numpy.int64, ndmin=2) if tiles.exists() else None
        self.points, self.distances, self.classes, self.normals, self.mask = (
            self._array(name) for name in ("points", "distances", "classes", "normals", "mask"))
        weakref.finalize(self, shutil.rmtree, folder, ignore_errors=True)

    def _array(self, name):
        file = self._folder / f"{name}.npy"
        return numpy.load(file) if file.exists() else None

    def save(self, folder):
        """Copy all files to a folder, which is made where it is not there. Returns its path."""
        return pathlib.Path(shutil.copytree(self._folder, folder, dirs_exist_ok=True))

    def __repr__(self):
        return f"<poissonlab.Made {self.label!r}: {', '.join(self.facts)}>"


def function_of(description, name):
    """The function of a kind: keyword arguments are its keys."""

    def make(*, rng=1, engine="opencl", device=None, **values):
        unknown = values.keys() - keys.keys()
        if unknown:
            raise TypeError(f"{name}() has no parameter {sorted(unknown)[0]!r}")
        text = "".join(f"{keys[key]['key']} = {toml.value_of(value)}\n"
                       for key, value in values.items() if value is not None)
        folder = pathlib.Path(tempfile.mkdtemp(prefix="poissonlab-"))
        try:
            made = _poissonlab.make(name, description["table"], description["word"], text, seed_of(rng), engine,
                                    "" if device is None else str(device), folder)
            return Made(folder, made)
        except BaseException:
            shutil.rmtree(folder, ignore_errors=True)
            raise

    keys = {key["name"]: key for key in description["keys"]}
    make.__name__ = make.__qualname__ = name
    make.__doc__ = documentation_of(description)
    make.__signature__ = inspect.Signature(
        [inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=None) for key in keys]
        + [inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=value)
           for key, value in {"rng": 1, "engine": "opencl", "device": None}.items()])
    return make


def documentation_of(description):
    """The text of a kind's function."""
    lines = [f"{description['summary']}.", "", "Returns Made. rng, engine and device: see Sampler."]
    lines += [f"{key['name']}: {key['help']}." for key in description["keys"]]
    return "\n".join(lines)


def functions_of(table, names):
    """The functions of the kinds of a table. `names` has those that are not the kind's word, or the table's."""
    functions = {}
    for description in _poissonlab.kinds():
        if description["table"] == table:
            word = description["word"] or table
            name = names.get(word, word.replace("-", "_"))
            functions[name] = function_of(description, name)
    return functions


def function_of_command(command, name):
    """The function of the kind that only a command makes."""
    return function_of(next(each for each in _poissonlab.kinds() if each["command"] == command), name)
