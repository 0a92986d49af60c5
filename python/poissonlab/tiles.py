"""Poisson disk tile sets, hats and spectres: endless point sets with a proven minimum distance, looked up anywhere."""

from __future__ import annotations

import operator
import os
from collections.abc import Callable
from typing import Any, NamedTuple, Union

import numpy
from numpy.typing import ArrayLike

from . import _poissonlab, views
from . import hints as _hints
from . import kinds as _kinds
from ._poissonlab import InputError
from .toml import geojson_of


class TilePoints(NamedTuple):
    """Points of a tiling, arrays with one item or row a point.

    position: in tiles (hats and spectres: in edges), shape (n, d), float64
    tile: the place of its tile, shape (n, d), int32; hats and spectres have no such places: shape (n, 0)
    index: its number in the tile, uint32
    id: random bits that stay with the point, such as for its looks, uint32
    level: the density, from 0 to 1, above which the point is there, float64
    """

    position: numpy.ndarray
    tile: numpy.ndarray
    index: numpy.ndarray
    id: numpy.ndarray
    level: numpy.ndarray

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw the points with Matplotlib, on axes or in a new figure. style: keywords of scatter(). Returns the axes."""
        return views.plot_points(ax, self.position, style)

    to_dataframe = views.to_dataframe


class NearestPoints(NamedTuple):
    """The nearest points of positions, arrays with one item or row a position.

    distance: in the unit of positions, float64
    position, tile, index, id, level: of the nearest point, see TilePoints
    """

    distance: numpy.ndarray
    position: numpy.ndarray
    tile: numpy.ndarray
    index: numpy.ndarray
    id: numpy.ndarray
    level: numpy.ndarray

    plot = TilePoints.plot
    to_dataframe = views.to_dataframe


class Certificate(NamedTuple):
    """The proof of a tile set, in exact integers: it holds for every tiling.

    min_distance: no two points of any tiling are nearer, in tiles (hats and spectres: in edges)
    squared_min_distance: its square, in units of 1/65536 tile or edge, rounded down
    relative_radius: of that distance
    largest_empty_radius: no circle (ball) that is empty in any tiling has a larger radius, in tiles; nan for hats and
        spectres, of which it is not proven
    tiles, points_per_tile: the size of the set
    class_distances: the minimum distance of each pair of classes, in tiles, shape (classes, classes)
    """

    min_distance: float
    squared_min_distance: int
    relative_radius: float
    largest_empty_radius: float
    tiles: int
    points_per_tile: int
    class_distances: numpy.ndarray


def checked_seed(seed):
    """A seed of 32 bits."""
    if not 0 <= operator.index(seed) < 2**32:
        raise InputError(f"seed = {seed}: must be an integer from 0 to {2**32 - 1}")
    return operator.index(seed)


#: A part of all points, or a function of coordinates that says it for each place.
Density = Union[float, Callable[..., ArrayLike]]


class TileSet:
    """A tile set of a file (.ptiles or JSON), which `poissonlab tiles build` makes; some ship in runtime/tile_sets.

    Every seed is another tiling of all the plane (3D: of space). Lengths are in tiles. The points are those of
    runtime/poisson_tiles.h and of `poissonlab tiles points`, bit for bit. No OpenCL is needed.

    Sets of hats and spectres (docs/monotile-points.md) have the points of runtime/monotile_points.h. Lengths are in edges,
    and the seed changes no point: it chooses those that a density leaves.

    kind: "corner", "edge", "template", "sphere", "hat" or "spectre".
    dimension: 2 or 3.
    colors, tiles, points_per_tile: how many there are; 1 colour and 1 tile where one tile never repeats.
    density: the number of points per unit of area (3D: of volume).
    unit: of lengths, "tiles" or "edges".
    relative_radius: of the least distance that was asked for when the set was built; of hats and spectres that of the
        distance that the file promises.
    min_distance: the least distance between points of any tiling that the file promises, which verify() proves; 0: none.
    exponent: power goes to 0 with this power of the frequency, at least; see docs/chain-tiles.md.
    ranked: whether any density is spread evenly.
    class_points: the points of each class in a tile; empty where points have no classes.
    """

    kind: str
    dimension: int
    colors: int
    tiles: int
    points_per_tile: int
    density: float
    unit: str
    relative_radius: float
    min_distance: float
    exponent: int
    ranked: bool
    class_points: list[int]

    def __init__(self, file: str | os.PathLike[str]) -> None:
        opened = _poissonlab.MonotileSet if _poissonlab.is_monotile_set(file) else _poissonlab.TileSet
        self._set = opened(file)
        for name, value in self._set.parameters().items():
            setattr(self, name, value)

    def window(self, *window: float, seed: int = 1, density: Density = 1.0, origin: tuple[int, int] = (0, 0)) -> numpy.ndarray:
        """The positions of all points in a window.

        window: x, y, width, height; in 3D x, y, z, width, height, depth. Points at the lower borders are
            inside, those at the upper ones are not.
        seed: which tiling, 32 bits. Windows of the same seed fit together.
        density: the part of the points that is there, above 0 and at most 1; or a function of the coordinates (arrays
            x, y and, in 3D, z) that says it for each place. More density adds points and moves none; ranked sets are
            spread evenly at any density.
        origin: of hats and spectres: two integers from -2**40 to 2**40, the place from which the window and positions are
            seen, (X, Y) for spectres and (X, sqrt(3) Y) for hats. Windows reach up to 2**20 edges from there.
        Returns a float64 array of shape (n, d). Rows of tiles from south to north, in each from west to east; hats and
        spectres in the order of their divisions.
        """
        return self.points(*window, seed=seed, density=density, origin=origin).position

    def points(self, *window: float, seed: int = 1, density: Density = 1.0, origin: tuple[int, int] = (0, 0)) -> TilePoints:
        """The same points with their tiles, numbers, random bits and levels: TilePoints."""
        axes = self.dimension
        if len(window) != 2 * axes:
            names = "x, y, width, height" if axes == 2 else "x, y, z, width, height, depth"
            raise InputError(f"window: must be {names}, in {self.unit}")
        low = [float(value) for value in window[:axes]]
        high = [start + float(size) for start, size in zip(low, window[axes:])]
        number = 1.0 if callable(density) else float(density)
        if not 0 < number <= 1:
            raise InputError(f"window: density = {density}: must be a number above 0 and at most 1, or a function")
        padding = [0.0] * (3 - axes if self.unit == "tiles" else 0)
        found = TilePoints(**self._set.window(low + padding, high + padding, checked_seed(seed), number,
                                              *self._origin("window", origin)))
        if not callable(density):
            return found
        kept = found.level < numpy.asarray(density(*found.position.T), dtype=float)
        return TilePoints(*(column[kept] for column in found))

    def in_region(self, region, *, min_distance: float | None = None, points: int | None = None, seed: int = 1,
                  density: Density = 1.0, planar: bool = False, crs: str = "", overlap: str = "union",
                  buffer: float = 0) -> TilePoints:
        """The points in a region of the plane, in its own coordinates: those of `poissonlab tiles points --region`.

        region: a file or a text, as distribute.darts takes them, GeoJSON as a dict, or an object with a `__geo_interface__`.
        min_distance: in the region's units, which the proven distance of the tiles becomes.
        points: instead, how many there are; a number is found that is nearest to it where chance lets none be exact.
        seed: which tiling. Regions beside each other fit together at the same min_distance and seed. Hats and spectres lie
            where the region's coordinates are: move these for other points.
        density: as in window(), of coordinates of the region; a function needs min_distance.
        planar: whether coordinates that look like longitude and latitude are lengths.
        crs: the system of the region's coordinates, such as "EPSG:4326"; default: what the region says. Longitudes and
            latitudes are mapped to a plane of metres, and points are mapped back.
        overlap: what becomes of polygons that overlap or share edges: their "union", or "refuse".
        buffer: the region is what lies within this distance of its lines, points and polygons; 0: what is in these.
        """
        if (min_distance is None) == (points is None):
            raise InputError("in_region: needs min_distance or points, and not both")
        if min_distance is not None and not 1e-12 <= min_distance <= 1e12:
            raise InputError(f"in_region: min_distance = {min_distance}: must be from 1e-12 to 1e12")
        if points is not None and not 1 <= operator.index(points) < 2**27:
            raise InputError(f"in_region: points = {points}: must be from 1 to {2**27 - 1}")
        if callable(density) and points is not None:
            raise InputError("in_region: density: a function needs min_distance")
        number = 1.0 if callable(density) else float(density)
        if not 0 < number <= 1:
            raise InputError(f"in_region: density = {density}: must be a number above 0 and at most 1, or a function")
        text = geojson_of(region) or os.fspath(region)
        found = self._set.in_region(text, bool(planar), crs, overlap, float(buffer), float(min_distance or 0),
                                    int(points or 0), checked_seed(seed), number)
        columns = TilePoints(**found)
        if not callable(density):
            return columns
        kept = columns.level < numpy.asarray(density(*columns.position.T), dtype=float)
        return TilePoints(*(column[kept] for column in columns))

    def nearest(self, positions: ArrayLike, *, seed: int = 1, origin: tuple[int, int] = (0, 0)) -> NearestPoints:
        """The nearest point of each position: a Worley texture without a table of its own.

        positions: shape (n, d), or (d,) for one.
        origin: of hats and spectres, as in window().
        Returns NearestPoints; of one position, arrays of one item.
        """
        return NearestPoints(**self._set.nearest(numpy.atleast_2d(positions), checked_seed(seed),
                                                 *self._origin("nearest", origin)))

    def _origin(self, function, origin):
        """What functions of hats and spectres are told of an origin; those of square tiles are told nothing."""
        numbers = [operator.index(number) for number in origin]
        if len(numbers) != 2:
            raise InputError(f"{function}: origin: must be two integers")
        if self.unit == "edges":
            return [[max(-2**62, min(2**62, number)) for number in numbers]]
        if any(numbers):
            raise InputError(f"{function}: origin: is for hats and spectres")
        return []

    def class_of(self, index: ArrayLike) -> numpy.ndarray:
        """The classes of points by their numbers in their tiles: tiles.class_of(tiles.points(0, 0, 9, 9).index).

        Sets built with class_points have them, such as trees, bushes and stones. Returns an array of uint32.
        """
        if not self.class_points:
            raise InputError("class_of: the points of these tiles have no classes")
        ends = numpy.cumsum(self.class_points)  # points come class after class
        index = numpy.asarray(index)
        if numpy.any((index < 0) | (index >= ends[-1])):
            raise InputError(f"class_of: index: must be from 0 to {ends[-1] - 1}")
        return numpy.searchsorted(ends, index, side="right").astype(numpy.uint32)

    def verify(self) -> Certificate:
        """Prove the minimum distance of every tiling. Returns a Certificate.

        Raises InputError where tiles do not fit together, or the file promises more than is proven.
        """
        return Certificate(**self._set.verify())

    def __repr__(self):
        if self.unit == "edges":
            return f"<poissonlab.TileSet {self.kind}: {self.points_per_tile} points in a tile, ranked>"
        return (f"<poissonlab.TileSet {self.kind}: {self.colors} colours, {self.tiles} tiles of {self.points_per_tile} "
                f"points{', ranked' if self.ranked else ''}>")


_build = _kinds.function_of_command("tiles build", "build")


def build(kind="corner", **keys):
    """Build a tile set, and prove its minimum distance: poissonlab.tiles.build("corner", colors=3, points=64).

    Returns a TileSet; rng, engine and device: see Sampler."""
    made = _build(kind=kind, **keys)  # its file is there as long as it is
    return TileSet(made.files[0])


_kinds.taking_kind(build, _build)
build.__signature__ = build.__signature__.replace(return_annotation=_hints.Hint("TileSet"))

#: The function that build() calls, which returns Made.
keys = _build
