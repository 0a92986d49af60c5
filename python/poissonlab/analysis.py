"""What is measured on point sets: spectra, curves over frequency and distance, and the catalogue of measures."""

import base64
import html
import os
import warnings
from collections.abc import Mapping, Sequence
from functools import cached_property
from types import MappingProxyType
from typing import Any, NamedTuple, Optional, Union

import numpy
import numpy.typing

from . import _poissonlab, toml
from .points import Domain, ranges_of

#: What becomes an array, the name of a point file, or several of either.
Points = Union[numpy.typing.ArrayLike, str, "os.PathLike[str]", list["str | os.PathLike[str]"]]


class Radial(NamedTuple):
    """Power over frequency: the spectrum in rings (3D: shells) around frequency zero. Arrays of shape (rings,).

    Lagae, Tile-Based Methods in Computer Graphics, 2007, equations 6.3 to 6.5.
    """

    frequency: numpy.ndarray      #: the middle of the ring, in cycles per unit length
    power: numpy.ndarray          #: mean power; 1 for white noise
    error: numpy.ndarray          #: standard error of the power over the realizations; 0 for a single one
    anisotropy_db: numpy.ndarray  #: variance over squared mean in the ring, in decibels
    samples: numpy.ndarray        #: frequencies in the ring (int64)


class PairCorrelation(NamedTuple):
    """Pairs of points over their distance, over those of independent points. Arrays of shape (bins,)."""

    distance: numpy.ndarray  #: the middle of the bin, in unit lengths
    value: numpy.ndarray     #: g; 1 for independent points
    error: numpy.ndarray     #: standard error over the realizations; 0 for a single one
    pairs: numpy.ndarray     #: pairs in the bin, mean over the sets


class NumberVariance(NamedTuple):
    """How much the number of points in a disk (3D: ball) varies from place to place. Arrays of shape (radii,).

    Torquato and Stillinger, Physical Review E 68, 041113, 2003. Independent points have points * (1 - V), V the volume.
    """

    radius: numpy.ndarray    #: in unit lengths
    points: numpy.ndarray    #: mean number of points in the ball
    variance: numpy.ndarray  #: of that number, mean over the sets
    error: numpy.ndarray     #: standard error over the realizations; 0 for a single one


class RegionCurves(NamedTuple):
    """Curves of points in a region over distance, in the region's units. Arrays of shape (distances,).

    Of each curve, `_low` and `_high` are the least and the largest of random sets of as many points in the region.
    """

    distance: numpy.ndarray               #: in units of the region
    k_isotropic: numpy.ndarray            #: Ripley's K with his isotropic correction, in squares of these units
    pair_correlation: numpy.ndarray       #: g by a kernel; 1 for independent points
    pair_correlation_low: numpy.ndarray
    pair_correlation_high: numpy.ndarray
    k: numpy.ndarray                      #: K with the translation correction; pi r^2 for independent points
    k_low: numpy.ndarray
    k_high: numpy.ndarray
    nearest: numpy.ndarray                #: G, the share of points with a neighbour that near
    nearest_low: numpy.ndarray
    nearest_high: numpy.ndarray
    empty_space: numpy.ndarray            #: F, the share of places with a point that near
    empty_space_low: numpy.ndarray
    empty_space_high: numpy.ndarray
    j: numpy.ndarray                      #: (1 - G) / (1 - F); nan where fewer than a thousandth of places are left
    j_low: numpy.ndarray
    j_high: numpy.ndarray


class Measure(NamedTuple):
    """One number that is measured on a series."""

    value: float
    error: Optional[float]  #: standard error over the realizations; None where it is not known
    each: numpy.ndarray     #: of each realization, shape (realizations,); empty where one number stands for all
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
    def spectrum(self) -> Optional[numpy.ndarray]:
        """The mean power of each frequency, shape (M, M), in 3D (M, M, M); None where it is not there.

        Row v, column u is the frequency (u - M/2, v - M/2) in cycles per unit length; in 3D the slice comes first. In
        a box these are cycles along its sides.
        White noise has power 1; frequency zero, in the middle, has the number of points. Results that were opened have
        float32 values, and of 3D spectra the planes only: see spectrum_planes.
        """
        return frozen_columns(self._source.spectra(False)).get("")

    @cached_property
    def spectrum_variance(self) -> Optional[numpy.ndarray]:
        """The variance of each power between realizations, like `spectrum`; None for one realization."""
        variance = frozen_columns(self._source.spectra(True)).get("")
        return None if variance is None or variance.size == 0 else variance

    @cached_property
    def spectrum_planes(self) -> dict[str, numpy.ndarray]:
        """Planes of an opened 3D spectrum by their names, such as "xy" and "xy_32", each of shape (M, M)."""
        return {name: plane for name, plane in frozen_columns(self._source.spectra(False)).items() if name}

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

    def report(self, folder: "str | os.PathLike[str]") -> None:
        """Write the output folder of `poissonlab analyze` for these sets, with the report, folder/index.html."""
        if not hasattr(self._source, "report"):
            raise _poissonlab.InputError("report: these results have a report of their own: Results.report()")
        self._source.report(folder)

    def __repr__(self):
        radius = self.measures.get("relative_radius")
        measured = f", relative radius {radius.value:.4f}" if radius else ""
        return f"<poissonlab.Analysis {self.label!r}: {self.realizations} x {self.points} points{measured}>"


def to_unit(points, ranges):
    """Coordinates of a domain in [0, 1). Those beyond its ends stay beyond."""
    if len(ranges) > 1 and points.ndim == 2 and points.shape[1] != len(ranges):
        raise _poissonlab.InputError(f"analyze: points have {points.shape[1]} coordinates where the domain has "
                                     f"{len(ranges)} ranges: must have one for each axis")
    low, high = numpy.asarray(ranges).T
    mapped = (points - low) / (high - low)
    return numpy.where(points < high, numpy.minimum(mapped, 1 - 2.0**-53), mapped)


def sets_of(points, ranges, particles):
    """The sets that an argument stands for, a list of arrays of shape (points, dimension)."""
    is_one = isinstance(points, (str, os.PathLike)) or (isinstance(points, numpy.ndarray) and points.ndim == 2)
    items = [points] if is_one else list(points)
    if items and all(isinstance(item, (str, os.PathLike)) for item in items):
        return _poissonlab.read_points(items, ranges, particles, True, 3)
    if particles is not None:
        raise _poissonlab.InputError(f"analyze: particles={particles}: is for files of snapshots")
    arrays = [numpy.asarray(item, dtype=float) for item in items]
    if arrays and arrays[0].ndim < 2:  # its items are points
        arrays = [numpy.asarray(items, dtype=float)]
    return arrays if ranges is None or numpy.isinf(ranges[0][0]) else [to_unit(array, ranges) for array in arrays]


def box_options(ranges, periodic, options):
    """The options of sets whose domain has a range for each axis: its sides may differ."""
    if ranges is None or len(ranges) == 1:
        return options
    sides = [high - low for low, high in ranges]
    if periodic is False and len(set(sides)) > 1:
        raise _poissonlab.InputError('analyze: periodic=False does not go with a domain whose sides differ: to measure '
                                     'points of the plane within it, give it as region, such as "rectangle 0 0 2 1"')
    return {**options, "box": sides}


def window_options(sets, options):
    """The options by which sets that are not periodic are measured, as `poissonlab analyze --periodic no` does."""
    is_of_squares = any(options.get(key) is not None for key in ("window", "tiles", "zone_plate"))
    is_planar = bool(sets) and sets[0].ndim == 2 and sets[0].shape[1] == 2
    return {"region": "rectangle 0 0 1 1"} if is_planar and not is_of_squares else {"window": True}


def analyze(points: Points, *, label: str = "points", domain: Optional[Domain] = None,
            box: Optional[Sequence[float]] = None, periodic: Optional[bool] = None, particles: Optional[int] = None,
            **options: Any) -> Analysis:
    """Measure point sets, wherever they come from, as `poissonlab analyze` does.

    points: one set, an array of shape (n, d); several, of shape (k, n, d) or a list of arrays; or the name of a point
        file or of several. All sets must have the same number of points.
    label: the name for readers, and for messages.
    domain: (low, high), the range of all coordinates; default: (0, 1), or what a file says. Or such a range for each
        axis: where sides differ, the sets lie in a periodic rectangle or box, and lengths of results are in roots of
        its area (volume), frequencies in cycles over that.
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
                raise _poissonlab.InputError(f"analyze: {name}: does not go with region, whose units points are in")
        domain = (-numpy.inf, numpy.inf)  # as they are
    if box is not None:
        if domain is not None:
            raise _poissonlab.InputError("analyze: box: does not go with domain, which has sides of its own")
        domain = [(0, side) for side in box]
        if len(domain) not in (2, 3) or not all(0 < side < numpy.inf for side in box):
            raise _poissonlab.InputError("analyze: box: must be (width, height), in 3D (width, height, depth), numbers "
                                         "above 0")
    ranges = ranges_of(domain)
    sets = sets_of(points, ranges, particles)
    options = box_options(ranges, periodic, options)
    if periodic is not None and options.get("region") is not None:
        raise _poissonlab.InputError("analyze: periodic: does not go with region: nothing goes around a torus there")
    if periodic is False:
        options = {**options, **window_options(sets, options)}
    changes = [f"analysis.{key}={toml.value_of(value)}" for key, value in options.items() if value is not None]
    source = _poissonlab.AnalysedSets(sets, label, changes, periodic is True)
    for text in source.warnings:
        warnings.warn(text, stacklevel=2)
    return Analysis(source)
