"""What is measured on point sets: spectra, curves over frequency and distance, and the catalogue of measures."""

from __future__ import annotations

import base64
import html
import os
import warnings
from collections.abc import Mapping, Sequence
from functools import cached_property
from types import MappingProxyType
from typing import Any, NamedTuple, Union

import numpy
from numpy.typing import ArrayLike

from . import _poissonlab, toml, views
from .points import Domain, ranges_of

#: What becomes an array, the name of a point file, or several of either.
Points = Union[ArrayLike, str, "os.PathLike[str]", "list[str | os.PathLike[str]]"]


class Radial(NamedTuple):
    """Power over frequency: the spectrum in rings (3D: shells) around frequency zero. Arrays of shape (rings,).

    Lagae, Tile-Based Methods in Computer Graphics, 2007, equations 6.3 to 6.5.

    frequency: the middle of the ring, in cycles per unit length
    power: mean power; 1 for white noise
    error: standard error of the power over the realizations; 0 for a single one
    anisotropy_db: variance over squared mean in the ring, in decibels
    samples: frequencies in the ring (int64)
    """

    frequency: numpy.ndarray
    power: numpy.ndarray
    error: numpy.ndarray
    anisotropy_db: numpy.ndarray
    samples: numpy.ndarray

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw power over frequency with its standard error, with Matplotlib: on axes or in a new figure. style: keywords
        of Axes.plot(). Returns the axes."""
        return views.plot_curve(ax, self.frequency, self.power, (self.power - self.error, self.power + self.error),
                                ("frequency, cycles per unit length", "power"), style)

    to_dataframe = views.to_dataframe


class PairCorrelation(NamedTuple):
    """Pairs of points over their distance, over those of independent points. Arrays of shape (bins,).

    distance: the middle of the bin, in unit lengths
    value: g; 1 for independent points
    error: standard error over the realizations; 0 for a single one
    pairs: pairs in the bin, mean over the sets
    """

    distance: numpy.ndarray
    value: numpy.ndarray
    error: numpy.ndarray
    pairs: numpy.ndarray

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw the function with its standard error: see Radial.plot()."""
        return views.plot_curve(ax, self.distance, self.value, (self.value - self.error, self.value + self.error),
                                ("distance, unit lengths", "pair correlation"), style)

    to_dataframe = views.to_dataframe


class NumberVariance(NamedTuple):
    """How much the number of points in a disk (3D: ball) varies from place to place. Arrays of shape (radii,).

    Torquato and Stillinger, Physical Review E 68, 041113, 2003. Independent points have points * (1 - V), V the volume.

    radius: of the balls, in unit lengths
    points: mean number of points in the ball
    variance: of that number, mean over the sets
    error: standard error over the realizations; 0 for a single one
    """

    radius: numpy.ndarray
    points: numpy.ndarray
    variance: numpy.ndarray
    error: numpy.ndarray

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw the variance with its standard error, both axes logarithmic: see Radial.plot()."""
        ax = views.plot_curve(ax, self.radius, self.variance, (self.variance - self.error, self.variance + self.error),
                              ("radius, unit lengths", "number variance"), style)
        ax.set_xscale("log")
        ax.set_yscale("log")
        return ax

    to_dataframe = views.to_dataframe


class RegionCurves(NamedTuple):
    """Curves of points in a region over distance, in the region's units (metres, if it is in longitude and latitude).

    Arrays of shape (distances,).

    Of each curve, `_low` and `_high` are the least and the largest of random sets of as many points in the region.

    distance: in these units
    k_isotropic: Ripley's K with his isotropic correction, in squares of these units
    pair_correlation: g by a kernel; 1 for independent points
    k: K with the translation correction; pi r^2 for independent points
    nearest: G, the share of points with a neighbour that near
    empty_space: F, the share of places with a point that near
    j: (1 - G) / (1 - F); nan where fewer than a thousandth of places are left
    """

    distance: numpy.ndarray
    k_isotropic: numpy.ndarray
    pair_correlation: numpy.ndarray
    pair_correlation_low: numpy.ndarray
    pair_correlation_high: numpy.ndarray
    k: numpy.ndarray
    k_low: numpy.ndarray
    k_high: numpy.ndarray
    nearest: numpy.ndarray
    nearest_low: numpy.ndarray
    nearest_high: numpy.ndarray
    empty_space: numpy.ndarray
    empty_space_low: numpy.ndarray
    empty_space_high: numpy.ndarray
    j: numpy.ndarray
    j_low: numpy.ndarray
    j_high: numpy.ndarray

    def plot(self, ax: Any = None, *, curve: str = "pair_correlation", **style: Any) -> Any:
        """Draw one of the curves, and the range of random sets as a band around it: see Radial.plot()."""
        value = getattr(self, curve)
        low, high = (getattr(self, f"{curve}_{end}", value) for end in ("low", "high"))
        return views.plot_curve(ax, self.distance, value, (low, high),
                                ("distance in the region", curve.replace("_", " ")), style)

    to_dataframe = views.to_dataframe


class Measure(NamedTuple):
    """One number that is measured on a series.

    value: the mean over the realizations
    error: standard error over the realizations; None where it is not known
    each: of each realization, shape (realizations,); empty where one number stands for all
    name, unit, meaning: what it is, in words
    """

    value: float
    error: float | None
    each: numpy.ndarray
    name: str
    unit: str
    meaning: str


def frozen(array):
    """The array, for reading only: results are kept, and handed out again."""
    array.flags.writeable = False
    return array


def frozen_columns(columns):
    """A dict of which no array can be changed."""
    return {key: frozen(value) if isinstance(value, numpy.ndarray) else value for key, value in columns.items()}


class Analysis:
    """A series of point sets with all that was measured on them. Made by analyze() and by open().

    In a notebook it shows the classic figure: points, power spectrum, radial power, anisotropy. Arrays are for reading
    only. Those of opened results are read from files when they are first asked for.
    """

    def __init__(self, source):
        self._source = source

    @property
    def name(self) -> str:
        """The name of its folder among results."""
        return self._source.name

    @property
    def label(self) -> str:
        """The name for readers."""
        return self._source.label

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return self._source.dimension

    @property
    def points(self) -> int:
        """The number of points of a set; the mean where sets differ in size."""
        return self._source.points

    @property
    def realizations(self) -> int:
        """The number of sets."""
        return self._source.realizations

    @cached_property
    def sets(self) -> list[numpy.ndarray]:
        """The sets that are there, a list of arrays of shape (points, dimension)."""
        return [frozen(points) for points in self._source.sets()]

    @cached_property
    def measures(self) -> Mapping[str, Measure]:
        """Every measure that these sets have, by its key in results.json."""
        return MappingProxyType({key: Measure(**frozen_columns(measure))
                                 for key, measure in self._source.measures().items()})

    @property
    def relative_radius(self) -> numpy.ndarray:
        """The smallest distance over the largest that so many points can have; of each set, shape (realizations,)."""
        return self.measures["relative_radius"].each

    @property
    def min_distance(self) -> numpy.ndarray:
        """The smallest distance between points, in unit lengths; of each set, shape (realizations,)."""
        return self.measures["min_distance"].each

    @cached_property
    def radial(self) -> Radial:
        """Radially averaged power and anisotropy: a Radial, without rings where no spectrum was made."""
        return Radial(**frozen_columns(self._source.radial()))

    @cached_property
    def pair_correlation(self) -> PairCorrelation:
        """The pair correlation function: a PairCorrelation, without bins where it was not measured."""
        return PairCorrelation(**frozen_columns(self._source.pairs()))

    @cached_property
    def number_variance(self) -> NumberVariance:
        """The number variance: a NumberVariance, without radii where sets have a few points only."""
        return NumberVariance(**frozen_columns(self._source.number_variance()))

    @cached_property
    def region(self) -> RegionCurves:
        """The curves of points in a region: a RegionCurves, without distances for sets on the torus."""
        return RegionCurves(**frozen_columns(self._source.region()))

    @cached_property
    def spectrum(self) -> numpy.ndarray | None:
        """The mean power of each frequency, shape (M, M), in 3D (M, M, M); None where it is not there.

        Row v, column u is the frequency (u - M/2, v - M/2) in cycles per unit length; in 3D the slice comes first. In
        a box these are cycles along its sides.
        White noise has power 1; frequency zero, in the middle, has the number of points. Results that were opened have
        float32 values, of 2D spectra beyond 2,048 frequencies along an axis means over blocks (unless the config has
        keep_spectrum = true), and of 3D spectra the planes only: see spectrum_planes.
        """
        return frozen_columns(self._source.spectra(False)).get("")

    @cached_property
    def spectrum_variance(self) -> numpy.ndarray | None:
        """The variance of each power between realizations, like `spectrum`; None for one realization."""
        variance = frozen_columns(self._source.spectra(True)).get("")
        return None if variance is None or variance.size == 0 else variance

    @cached_property
    def spectrum_planes(self) -> dict[str, numpy.ndarray]:
        """Planes of an opened 3D spectrum by their names, such as "xy" and "xy_32", each of shape (M, M)."""
        return {name: plane for name, plane in frozen_columns(self._source.spectra(False)).items() if name}

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw with Matplotlib. Returns the axes, or an array of those of a new figure.

        On axes: the radial power, named by the label, or the pair correlation where no spectrum was made; style: keywords
        of Axes.plot(). Without axes: points, spectrum, power and pair correlation, as far as they are there.
        """
        if ax is not None:
            curves = (self.radial, self.pair_correlation, self.region)
            curve = next((each for each in curves if len(each[0])), self.radial)
            return curve.plot(ax, **{"label": self.label, **style})
        panels = self._panels()
        figure = views.needed("matplotlib.pyplot", "plot").figure(figsize=(4 * len(panels), 4), layout="constrained")
        figure.suptitle(self.label)
        return numpy.array([draw(figure.add_subplot(1, len(panels), i + 1, **options))
                            for i, (draw, options) in enumerate(panels)])

    def _panels(self):
        """Returns how the pictures of the figure are drawn, and what axes these need."""
        panels = [(lambda ax: views.plot_points(ax, self.sets[0], {}),
                   {"projection": "3d"} if self.dimension == 3 else {})] if self.sets else []
        spectrum = self.spectrum if self.spectrum is not None else self.spectrum_planes.get("xy")
        if spectrum is not None:
            plane = spectrum[len(spectrum) // 2] if spectrum.ndim == 3 else spectrum
            side = len(plane) // 2
            panels.append((lambda ax: views.plot_image(ax, plane, {"vmin": 0, "vmax": 2, "origin": "lower",
                                                                   "extent": (-side, side, -side, side)}), {}))
        return panels + [(curve.plot, {}) for curve in (self.radial, self.pair_correlation, self.region) if len(curve[0])]

    def to_dataframe(self) -> Any:
        """Return the measures as a DataFrame of pandas: a row a measure, by its key, with value, error, unit,
        name and meaning."""
        columns = ("value", "error", "unit", "name", "meaning")
        return views.table_of({column: [getattr(measure, column) for measure in self.measures.values()]
                               for column in columns}, index=list(self.measures))

    def figure(self) -> str:
        """The classic figure as HTML: points, power spectrum, radial power, anisotropy. Needs gnuplot."""
        pictures = []
        for title, caption, kind, content in self._source.figure():
            data = base64.b64encode(content).decode()
            pictures.append(
                f'<figure style="margin:0.5em"><img alt="{html.escape(title)}" style="width:20em" '
                f'src="data:{kind};base64,{data}"/><figcaption style="width:20em"><b>{html.escape(title)}.</b> '
                f"{html.escape(caption)}</figcaption></figure>")
        return ('<div style="background:white;color:black;padding:0.5em">'
                f"<p><b>{html.escape(self.label)}</b></p>"
                f'<div style="display:flex;flex-wrap:wrap">{"".join(pictures)}</div></div>')

    def _repr_html_(self):
        return self.figure()

    def report(self, folder: str | os.PathLike[str]) -> None:
        """Write the output folder of `poissonlab analyze` for these sets, with the report, folder/index.html."""
        if not hasattr(self._source, "report"):
            raise _poissonlab.InputError("report: these results have a report of their own: Results.report()")
        self._source.report(folder)

    def __repr__(self):
        radius = self.measures.get("relative_radius")
        measured = f", relative radius {radius.value:.4f}" if radius else ""
        return f"<poissonlab.Analysis {self.label!r}: {self.realizations} x {self.points} points{measured}>"


def to_unit(points, ranges, name):
    """Coordinates of a domain in [0, 1). `name` begins messages, which have the numbers of the caller."""
    if points.ndim != 2:
        return points
    if len(ranges) > 1 and points.shape[1] != len(ranges):
        raise _poissonlab.InputError(f"analyze: points have {points.shape[1]} coordinates where the domain has "
                                     f"{len(ranges)} ranges: must have one for each axis")
    low, high = numpy.broadcast_to(numpy.asarray(ranges), (points.shape[1], 2)).T
    outside = numpy.argwhere(~((points >= low) & (points < high)))
    if len(outside):
        point, axis = outside[0]
        raise _poissonlab.InputError(f"{name}: point {point}: {points[point, axis]}: must be a number in "
                                     f"[{low[axis]:.6g}, {high[axis]:.6g}), the domain")
    return numpy.minimum((points - low) / (high - low), 1 - 2.0**-53)


def without_rounding(item, ranges, name):
    """The points of an argument. A few float32 coordinates that rounding has moved to the end of a domain (0.99999999
    becomes 1) are moved to its beginning, as in files."""
    given = numpy.asarray(item)
    points = numpy.asarray(given, dtype=float)
    ranges = numpy.asarray(ranges or [(0, 1)], dtype=float)
    if given.dtype.kind != "f" or given.dtype.itemsize >= 8 or points.ndim != 2 or len(ranges) not in (1, points.shape[1]):
        return points
    low, high = numpy.broadcast_to(ranges, (points.shape[1], 2)).T
    reach = numpy.finfo(given.dtype).eps / 2 * numpy.maximum(abs(low), abs(high))
    rounded = ((points >= high) & (points <= high + reach)) | ((points < low) & (points >= low - reach))
    if 0 < rounded.sum() <= max(3, points.size // 10000):
        warnings.warn(f"{name}: {rounded.sum()} of {points.size} coordinates were rounded to the end of the domain; "
                      "they count as its beginning, as on a torus", stacklevel=4)
        return numpy.where(rounded, low, points)
    return points


def sets_of(points, ranges, particles, label):
    """The sets that an argument stands for, a list of arrays of shape (points, dimension)."""
    is_one = isinstance(points, (str, os.PathLike)) or (hasattr(points, "__array__") and numpy.ndim(points) == 2)
    items = [points] if is_one else list(points)
    if items and all(isinstance(item, (str, os.PathLike)) for item in items):
        return _poissonlab.read_points(items, ranges, particles, True, 3)
    if particles is not None:
        raise _poissonlab.InputError(f"analyze: particles={particles}: is for files of snapshots")
    if items and numpy.ndim(items[0]) < 2:  # its items are points
        items = [items]
    if ranges is not None and numpy.isinf(ranges[0][0]):
        return [numpy.asarray(item, dtype=float) for item in items]
    arrays = [without_rounding(item, ranges, f"{label}: realization {i}") for i, item in enumerate(items)]
    if ranges is None:
        return arrays
    return [to_unit(array, ranges, f"{label}: realization {i}") for i, array in enumerate(arrays)]


def box_options(ranges, periodic, options):
    """The options of sets whose domain has a range for each axis: its sides may differ."""
    if ranges is None or len(ranges) == 1:
        return options
    sides = [high - low for low, high in ranges]
    if periodic is False and len(set(sides)) > 1:
        raise _poissonlab.InputError("analyze: periodic=False: sets in space can be measured without wrapping in cubes only"
                                     if len(sides) == 3 else "analyze: periodic=False: window, tiles and zone_plate cannot "
                                     "be combined with a domain whose sides differ")
    return {**options, "box": sides}


def is_of_squares(options):
    """Returns true if options request measures that sets in regions do not have."""
    return any(options.get(key) is not None for key in ("window", "tiles", "zone_plate"))


def window_options(sets, options):
    """The options by which sets that are not periodic are measured, as `poissonlab analyze --periodic no` does."""
    is_planar = bool(sets) and sets[0].ndim == 2 and sets[0].shape[1] == 2
    return {"region": "rectangle 0 0 1 1"} if is_planar and not is_of_squares(options) else {"window": True}


def analyze(points: Points, *, label: str = "points", domain: Domain | None = None,
            box: float | Sequence[float] | None = None, periodic: bool | None = None, particles: int | None = None,
            **options: Any) -> Analysis:
    """Measure point sets, wherever they come from, as `poissonlab analyze` does.

    points: one set, an array of shape (n, d); several, of shape (k, n, d) or a list of arrays; or the name of a point
        file or of several. All sets must have the same number of points.
    label: the name for readers, and for messages.
    domain: (low, high), the range of all coordinates, or its upper end alone where they begin at 0, such as domain=10;
        default: (0, 1), or what a file says. Or such a range for each axis: where sides differ, the sets lie in a periodic
        rectangle or box, and lengths of results are in roots of its area (volume), frequencies in cycles over that.
    box: the sides of such a rectangle or box alone, in the unit of the points: coordinates are from 0 to these.
    periodic: whether the sets go on across their border as on a torus. False: they are measured within the square
        (cube). Default: as on a torus, with a warning where the closest pairs meet across the border.
    particles: the type of the particles of a snapshot, 0 for PartType0; default: its only one.
    options: keys of a config's [analysis], such as region="park.geojson" (the sets lie in that region, in its units;
        GeoJSON as a dict, or anything with a `__geo_interface__`), spectrum="exact" or "none", window=True (the sets
        are windows, not tori), tiles=8 (the sets are made of 8 x 8 tiles), spectrum_size=2048, measures="distances".
    Returns an Analysis. Raises InputError.
    """
    if options.get("region") is not None:
        for name, value in (("domain", domain), ("box", box)):
            if value is not None:
                raise _poissonlab.InputError(f"analyze: {name}: cannot be combined with region: points are then in the "
                                             "region's units")
        domain = [(-numpy.inf, numpy.inf)]  # as they are
    if box is not None:
        if domain is not None:
            raise _poissonlab.InputError("analyze: box: cannot be combined with domain, which has sides of its own")
        sides = numpy.atleast_1d(numpy.asarray(box, dtype=float))  # one of a square or cube
        domain = [(0, side) for side in sides.tolist()]
        if sides.ndim != 1 or len(domain) not in (1, 2, 3) or not all(0 < side < numpy.inf for side in sides):
            raise _poissonlab.InputError("analyze: box: must be a side, (width, height), or in 3D (width, height, "
                                         "depth), numbers above 0")
    ranges = ranges_of(domain)
    if periodic is False and not is_of_squares(options) and ranges is not None and len(ranges) == 2:
        corners = " ".join(f"{end!r}" for end in numpy.transpose(ranges).ravel().tolist())
        options, periodic = {**options, "region": f"rectangle {corners}"}, None  # as the program does
        ranges = [(-numpy.inf, numpy.inf)]
    sets = sets_of(points, ranges, particles, label)
    options = box_options(ranges, periodic, options)
    if periodic is not None and options.get("region") is not None:
        raise _poissonlab.InputError("analyze: periodic: cannot be combined with region: nothing goes around a torus there")
    if periodic is False:
        options = {**options, **window_options(sets, options)}
    changes = [f"analysis.{key}={toml.value_of(value)}" for key, value in options.items() if value is not None]
    source = _poissonlab.AnalysedSets(sets, label, changes, periodic is True)
    for text in source.warnings:
        warnings.warn(text, stacklevel=2)
    return Analysis(source)
