"""Functions for kinds of work, made from the kinds' own descriptions: see poissonlab.distribute."""

from __future__ import annotations

import inspect
import pathlib
import shutil
import tempfile
import weakref

import numpy

from . import _poissonlab, hints, toml, views
from ._poissonlab import InputError
from .samplers import refuse_unknown, seed_of


class Made:
    """The result of a kind of work. Attributes that it does not have are None.

    label: its name in reports
    facts: what it was made from, sentences
    numbers: what was measured, by key
    titles: what each number is, by key
    pictures: arrays of shape (height, width, channels), uint8, by name
    captions: what each picture shows, by name
    points: the places that were made, shape (n, 2), in units of the longest side, y upwards; those of regions in the
        region's own units, those of space with shape (n, 3)
    distances: of points whose minimum distance varies: that at each, in the region's units
    classes: of points with classes: the class of each, uint32
    normals: of points on surfaces: the normal of each one's triangle, (n, 3)
    columns: of points on surfaces: a structured array with a field for each column of their file, such as "x"; with
        faces=True also "face", "bary_0" and others
    mask: of masks: an array of shape (rows, columns)
    tiles: of tilings, tile sets and packings: the indices of tiles, rows from north to south
    files: the paths of all files, which are there as long as this object is; save() keeps them
    """

    label: str
    facts: list[str]
    numbers: dict[str, float]
    titles: dict[str, str]
    pictures: dict[str, numpy.ndarray]
    captions: dict[str, str]
    points: numpy.ndarray | None
    distances: numpy.ndarray | None
    classes: numpy.ndarray | None
    normals: numpy.ndarray | None
    columns: numpy.ndarray | None
    mask: numpy.ndarray | None
    tiles: numpy.ndarray | None
    files: list[pathlib.Path]

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
        table = folder / "points.ply"
        self.columns = columns_of_ply(table) if self.normals is not None else None
        weakref.finalize(self, shutil.rmtree, folder, ignore_errors=True)

    def _array(self, name):
        file = self._folder / f"{name}.npy"
        return numpy.load(file) if file.exists() else None

    def save(self, folder):
        """Copy all files to a folder, which is made where it is not there. Returns its path."""
        return pathlib.Path(shutil.copytree(self._folder, folder, dirs_exist_ok=True))

    def plot(self, ax=None, *, picture=None, **style):
        """Draw with Matplotlib, on axes or in a new figure. Returns the axes.

        picture: the name of one of `pictures`; default: points, a mask or tiles, where there are some, else the first
        picture. style: keywords of Axes.scatter() for points, of Axes.imshow() for the others.
        """
        if picture is None and self.points is not None:
            return views.plot_points(ax, self.points, {"c": self.classes, **style} if self.classes is not None else style)
        values = next((each for each in (self.mask, self.tiles) if each is not None and picture is None), None)
        if values is None:
            values = self.pictures[picture or next(iter(self.pictures), "")]
        return views.plot_image(ax, values, style)

    def to_dataframe(self):
        """Return the points as a DataFrame of pandas: x, y (and z), class, distance and normals, as far as
        they are there."""
        if self.points is None:
            raise InputError(f"to_dataframe: {self.label}: there are no points")
        return views.table_of({"position": self.points, "class": self.classes, "distance": self.distances,
                               "normal": self.normals})

    def __repr__(self):
        return f"<poissonlab.Made {self.label!r}: {', '.join(self.facts)}>"


def columns_of_ply(file):
    """Read the vertices of a PLY file that the program has written: binary, in the byte order of this machine."""
    types = {"double": "f8", "float": "f4", "uint": "u4", "uchar": "u1"}
    content = file.read_bytes()
    head, end = content.split(b"end_header\n", 1)[0].decode(), content.index(b"end_header\n") + len(b"end_header\n")
    properties = [line.split() for line in head.splitlines() if line.startswith("property ")]
    return numpy.frombuffer(content, dtype=[(name, types[kind]) for _, kind, name in properties], offset=end)


def function_of(description, name):
    """The function of a kind: keyword arguments are its keys."""

    def make(*, rng=None, engine="opencl", device=None, **values):
        refuse_unknown(name, values, [*keys, *hints.COMMON])
        seed = seed_of(rng, name)
        text = "".join(f"{keys[key]['key']} = {toml.value_of(value)}\n"
                       for key, value in values.items() if value is not None)
        folder = pathlib.Path(tempfile.mkdtemp(prefix="poissonlab-"))
        try:
            made = _poissonlab.make(name, description["table"], description["word"], text, seed, engine,
                                    "" if device is None else str(device), folder)
            return Made(folder, made)
        except BaseException:
            shutil.rmtree(folder, ignore_errors=True)
            raise

    keys = {key["name"]: key for key in description["keys"]}
    make.__name__ = make.__qualname__ = name
    make.__doc__ = documentation_of(description)
    make.__signature__ = inspect.Signature(
        [hints.keyword_of(key, each["kind"], each["default"], each["is_required"]) for key, each in keys.items()]
        + [hints.keyword(key, *each) for key, each in hints.COMMON.items()], return_annotation=hints.Hint("Made"))
    return make


def documentation_of(description):
    """The text of a kind's function."""
    lines = [f"{description['summary']}.", "", "Returns Made. rng, engine and device: see Sampler."]
    lines += [f"{key['name']}: {hints.words_of(key['help'])}." for key in description["keys"]]
    return "\n".join(lines)


def taking_kind(build, make):
    """Returns the function `build`, whose first argument is the kind, with the signature and the documentation of all keys."""
    kind, *others = make.__signature__.parameters.values()
    first = kind.replace(kind=inspect.Parameter.POSITIONAL_OR_KEYWORD, default="corner", annotation=hints.Hint("str"))
    build.__signature__ = make.__signature__.replace(parameters=[first, *others])
    build.__doc__ = inspect.cleandoc(build.__doc__) + "\n" + make.__doc__.split("\n\n", 1)[1].split("\n", 1)[1]
    return build


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
