"""A class for every method of making point sets, made from the methods' own descriptions.

Conventions are those of scipy.stats.qmc: keywords only, `d` and `rng`, `random(n)` of shape (n, d) in [0, 1) and
`reset()`. Other than there, the n points are one finished set, and the next call makes the next realization, not more
points.
"""

import inspect
import operator

import numpy

from . import _poissonlab, toml
from ._poissonlab import InputError

DEFAULT_POINTS = 16384


def seed_of(rng):
    """The seed, from 0 to 2**63 - 1, that an `rng` argument stands for."""
    if rng is None:
        rng = numpy.random.default_rng()
    if isinstance(rng, numpy.random.Generator):
        return int(rng.integers(2**63 - 1, endpoint=True))
    return operator.index(rng)


class Sampler:
    """Makes the realizations of a method, one after the other. Make an object of one of the classes below it.

    d: 2 or 3, the dimension.
    rng: the seed, from 0 to 2**63 - 1, as in configs; a numpy.random.Generator, which draws one; None for any.
    engine: "opencl", or "reference" for plain sequential C++ that makes the same points.
    device: part of an OpenCL device's name, or its number in `poissonlab devices`; None for the default.
    Other keywords are the parameters of the method, as in configs. A parameter that takes a method takes a name, a dict
    or another sampler, whose own d, rng, engine and device do not matter.
    """

    _description = None  # of the module, in the classes below

    def __init__(self, *, d=2, rng=1, engine="opencl", device=None, **parameters):
        if self._description is None:
            raise TypeError("Sampler is what all methods have in common: make an object of a method")
        reserved = {"sampler", "label", "points"} & parameters.keys()
        if reserved:
            raise TypeError(f"{type(self).__name__}() has no parameter {sorted(reserved)[0]!r}")
        self.d = d
        self.seed = seed_of(rng)
        self.engine = engine
        self.device = device
        self.parameters = {key: value for key, value in parameters.items() if value is not None}
        self._realization = 0
        self._maker = None
        self._points = None
        self._prepare(None if self._description["has_own_points"] else DEFAULT_POINTS)

    @property
    def name(self):
        """The method's name in configs."""
        return self._description["name"]

    @property
    def realization(self):
        """The number of the realization that the next call of random() makes."""
        return self._realization

    def random(self, n=None):
        """Make the next realization.

        n: the number of points, default 16,384. Methods whose sets are there already (File) take none; those with a
        density or a tile size of their own come as near to n as they can.
        Returns a float64 array of shape (n, d) with coordinates in [0, 1), in the order in which points were made.
        """
        self._prepare(n)
        points = self._maker.sample(self._realization)
        self._realization += 1
        return points

    def realizations(self, k, n=None):
        """Make the next k realizations, as k calls of random(n) do. Returns an array of shape (k, n, d).

        Raises InputError where sets differ in size by the nature of the method: call random() for these.
        """
        first = self._realization
        if operator.index(k) < 1:
            raise InputError(f"{type(self).__name__}: realizations: k = {k}: must be an integer of at least 1")
        sets = []
        try:
            for _ in range(k):
                sets.append(self.random(n))
                if len(sets[-1]) != len(sets[0]):
                    raise InputError(f"{type(self).__name__}: realizations: the first set has {len(sets[0])} points, "
                                     f"another one {len(sets[-1])}: these do not fit into one array; call random()")
        except BaseException:
            self._realization = first
            raise
        return numpy.stack(sets)

    def reset(self):
        """Begin with the first realization again. Returns self."""
        self._realization = 0
        return self

    def fast_forward(self, k):
        """Skip k realizations: each is made from its number alone. Returns self."""
        if operator.index(k) < 0:
            raise InputError(f"{type(self).__name__}: fast_forward: {k}: must be an integer of at least 0")
        self._realization += operator.index(k)
        return self

    def _made(self):
        """The maker of the last set."""
        if self._maker is None:
            self._prepare(self._points)
        return self._maker

    @property
    def sizes_vary(self):
        """True where realizations differ in size by the nature of the method. Known once a set was made."""
        return self._made().sizes_vary

    @property
    def is_window(self):
        """True where sets are windows of the plane, not tori: analyze(..., window=True). Known once a set was made."""
        return self._made().is_window

    @property
    def tiles_along_axis(self):
        """The tiles along each axis of a set: analyze(..., tiles=...); 0: none. Known once a set was made."""
        return self._made().tiles_along_axis

    @property
    def proven_relative_radius(self):
        """The relative radius that the last set is proven to have at least; None where only measuring tells."""
        return self._made().proven_relative_radius

    def to_toml(self):
        """The method with its parameters as the value of another method's parameter."""
        return toml.table_of({"sampler": self.name, **self.parameters})

    def config(self, n=None):
        """The config, a text, that makes these sets with the program: `poissonlab run`."""
        lines = [f"seed = {self.seed}", f"engine = {toml.value_of(self.engine)}"]
        if self.device is not None:
            lines.append(f"device = {toml.value_of(str(self.device))}")
        lines += ["[analysis]", f"dimension = {toml.value_of(self.d)}", "[[method]]",
                  f"sampler = {toml.value_of(self.name)}"]
        if n is not None:
            lines.append(f"points = {toml.value_of(n)}")
        lines += [f"{toml.key_of(key)} = {toml.value_of(value)}" for key, value in self.parameters.items()]
        return "\n".join(lines) + "\n"

    def _prepare(self, n):
        """Check the parameters, and have a maker for sets of n points."""
        if n is None and not self._description["has_own_points"]:
            n = DEFAULT_POINTS
        if self._maker is None or n != self._points:
            self._maker = _poissonlab.SetMaker(type(self).__name__, self.config(n))
            self._points = n

    def __getstate__(self):
        """All but the maker, which holds a device: copies and other processes make their own."""
        return {**self.__dict__, "_maker": None}

    def __repr__(self):
        shown = {"d": self.d, **self.parameters, "rng": self.seed}
        if self.engine != "opencl":
            shown["engine"] = self.engine
        return f"{type(self).__name__}({', '.join(f'{key}={value!r}' for key, value in shown.items())})"


# How signatures and stubs show the kinds of parameters.
HINTS = {"number": "float", "integer": "int", "boolean": "bool", "text": "str", "choice": "str",
         "paths": "str | os.PathLike[str] | Sequence[str | os.PathLike[str]]", "command": "str | Sequence[str]",
         "sampler": "Sampler | str | dict[str, Any]"}

COMMON = {"d": ("int", 2), "rng": ("int | numpy.random.Generator | None", 1), "engine": ("str", "opencl"),
          "device": ("str | None", None)}


def class_name(name):
    """DartThrowing of dart-throwing."""
    return "".join(word.capitalize() for word in name.split("-"))


def signature_of(description):
    """The keywords of a method's class. A parameter without a value is left out, so that its default holds."""
    keywords = {}
    for parameter in description["parameters"]:
        keywords[parameter["key"]] = (HINTS[parameter["kind"]] + " | None", None)
    return inspect.Signature([inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=hint)
                              for key, (hint, default) in {**keywords, **COMMON}.items()])


def documentation_of(description):
    """The text of a method's class: what it makes, in which dimensions, and its parameters."""
    dimensions = " or ".join(str(d) for d in description["dimensions"])
    lines = [f"{description['title']}: {description['summary']}.", "",
             f"When to use it: {description['use']}", f"When not: {description['avoid']}",
             f"Source: {description['source']}", "",
             f"d: {dimensions}; rng, engine and device: see Sampler."
             + (" All realizations are one set." if description["deterministic"] else "")]
    for parameter in description["parameters"]:
        more = f"; {parameter['unless_given']}" if parameter["unless_given"] else ""
        if parameter["default"] is None and not more:
            more = "; needed"
        lines.append(f"{parameter['key']}: {parameter['help']}{more}.")
    return "\n".join(lines)


def make_class(description):
    """The class of a method."""
    return type(class_name(description["name"]), (Sampler,),
                {"__doc__": documentation_of(description), "__module__": "poissonlab", "_description": description,
                 "__signature__": signature_of(description)})


METHODS = {class_name(description["name"]): make_class(description) for description in _poissonlab.samplers()}
globals().update(METHODS)

__all__ = ["Sampler", *METHODS]
