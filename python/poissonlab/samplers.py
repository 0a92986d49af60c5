"""A class for every method of making point sets, made from the methods' own descriptions.

Conventions are those of scipy.stats.qmc: keywords only, `d` and `rng`, `random(n)` of shape (n, d) in [0, 1) and
`reset()`. Other than there, the n points are one finished set, and the next call makes the next realization, not more
points.
"""

import difflib
import inspect
import operator
import re

import numpy

from . import _poissonlab, hints, toml
from ._poissonlab import InputError

DEFAULT_POINTS = 16384
OTHER_POINTS = 4096  #: also a square, a cube and a power of 2

#: Configs have these keys for every method, beside its own parameters.
SHARED_KEYS = {"order", "region", "planar", "crs", "overlap", "buffer"}


def seed_of(rng, name):
    """Returns the seed, from 0 to 2**63 - 1, that the `rng` of a call stands for. `name` begins messages."""
    allowed = "must be an integer from 0 to 2**63 - 1, a numpy.random.Generator, which draws one, or None"
    if hasattr(rng, "__index__"):
        if not 0 <= operator.index(rng) < 2**63:
            raise InputError(f"{name}: rng = {rng}: {allowed}")
        return operator.index(rng)
    if isinstance(rng, numpy.random.RandomState):
        return int(rng.randint(0, 2**63 - 1, dtype=numpy.int64))
    try:
        generator = numpy.random.default_rng(rng)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: rng = {rng!r}: {allowed}") from None
    return int(generator.integers(2**63 - 1, endpoint=True))


def refuse_unknown(name, given, known, has_random=False):
    """Raises TypeError where a keyword is not one of these; has_random: the object has random(n)."""
    for key in given:
        if key in known:
            continue
        if key in ("seed", "random_state"):
            raise TypeError(f"{name}() has no parameter {key!r}: it is called rng, as in {name}(rng={given[key]!r})")
        if has_random and key in ("n", "points", "samples"):
            raise TypeError(f"{name}() has no parameter {key!r}: random(n) takes the number of points")
        near = difflib.get_close_matches(key, known, 1)
        hint = f"; did you mean {near[0]!r}?" if near else f": it has {', '.join(known)}"
        raise TypeError(f"{name}() has no parameter {key!r}{hint}")


class Sampler:
    """Makes the realizations of a method, one after the other. Make an object of one of the classes below it.

    d: 2 or 3, the dimension.
    rng: the seed, an integer from 0 to 2**63 - 1 as in configs, which makes the same sets each time; or a
        numpy.random.Generator, which draws one. Default: None, other sets each time; `seed` says which it was.
    engine: "opencl", or "reference" for plain sequential C++ that makes the same points.
    device: part of an OpenCL device's name, or its number in `poissonlab devices`; None for the default.
    Other keywords are the parameters of the method, as in configs. A parameter that takes a method takes a name, a dict
    or another sampler, whose own d, rng, engine and device do not matter.
    """

    _description = None  # of the module, in the classes below

    def __init__(self, *, d=2, rng=None, engine="opencl", device=None, **parameters):
        if self._description is None:
            raise TypeError("Sampler is what all methods have in common: make an object of a method")
        name = type(self).__name__
        own = list(self.__signature__.parameters)
        refuse_unknown(name, {key: value for key, value in parameters.items() if key not in SHARED_KEYS}, own,
                       has_random=True)
        self.d = d
        self.seed = seed_of(rng, name)
        self.engine = engine
        self.device = device
        self.parameters = {key: value for key, value in parameters.items() if value is not None}
        self._realization = 0
        self._maker = None
        self._points = None
        self._check()

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
            self._prepare(n)
            self._maker.expect(first, k)
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

    def _check(self):
        """Check the parameters. What depends on the number of points is left to random(), which is told one: a message
        that two numbers have in common does not depend on it."""
        try:
            self._prepare(None)
        except InputError as error:
            if self._description["has_own_points"]:
                raise
            try:
                self._prepare(OTHER_POINTS)
            except InputError as other:
                if str(other) == str(error):
                    raise
            self._maker = self._points = None

    def _prepare(self, n):
        """Check the parameters, and have a maker for sets of n points."""
        if n is None and not self._description["has_own_points"]:
            n = DEFAULT_POINTS
        if self._maker is None or n != self._points:
            self._maker = self._maker_of(n)
            self._points = n

    def _maker_of(self, n):
        """Returns the maker for sets of n points. Messages call arguments as this class does, not as configs do."""
        name = type(self).__name__
        try:
            return _poissonlab.SetMaker(name, self.config(n))
        except InputError as error:
            words = str(error).removeprefix(f"{name}: ").removeprefix(f'sampler = "{self.name}": ')
            words = re.sub(r"^points\b|\banalysis\.points\b", "n", re.sub(r"^dimension\b|\banalysis\.dimension\b", "d", words))
            raise InputError(f"{name}: {words}") from None

    def __getstate__(self):
        """All but the maker, which holds a device: copies and other processes make their own."""
        return {**self.__dict__, "_maker": None}

    def __repr__(self):
        shown = {"d": self.d, **self.parameters, "rng": self.seed}
        if self.engine != "opencl":
            shown["engine"] = self.engine
        return f"{type(self).__name__}({', '.join(f'{key}={value!r}' for key, value in shown.items())})"


def class_name(name):
    """DartThrowing of dart-throwing."""
    return "".join(word.capitalize() for word in name.split("-"))


def signature_of(description):
    """Returns the keywords of a method's class."""
    own = [hints.keyword_of(each["key"], each["kind"], each["default"],
                            each["default"] is None and not each["unless_given"]) for each in description["parameters"]]
    common = {"d": ("int", 2), **hints.COMMON}
    return inspect.Signature(own + [hints.keyword(key, *each) for key, each in common.items()])


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
        lines.append(f"{parameter['key']}: {hints.words_of(parameter['help'] + more)}.")
    return "\n".join(lines)


def make_class(description):
    """The class of a method."""
    return type(class_name(description["name"]), (Sampler,),
                {"__doc__": documentation_of(description), "__module__": "poissonlab", "_description": description,
                 "__signature__": signature_of(description)})


METHODS = {class_name(description["name"]): make_class(description) for description in _poissonlab.samplers()}
globals().update(METHODS)

__all__ = ["Sampler", *METHODS]
