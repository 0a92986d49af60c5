# Written by python/tools/write_stubs.py from the methods' own descriptions; a test compares.
import os
from typing import Any, Sequence

import numpy
import numpy.typing

class Sampler:
    d: int
    seed: int
    engine: str
    device: str | None
    parameters: dict[str, Any]
    def __init__(self, *, d: int = 2, rng: int | numpy.random.Generator | None = 1, engine: str = "opencl",
                 device: str | None = None, **parameters: Any) -> None: ...
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

class Random(Sampler):
    def __init__(self, *, d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class Regular(Sampler):
    def __init__(self, *, d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class Jittered(Sampler):
    def __init__(self, *, d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class Hexagonal(Sampler):
    def __init__(self, *, d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class Sobol(Sampler):
    def __init__(self, *, scrambling: str | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class Halton(Sampler):
    def __init__(self, *, scrambling: str | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class BestCandidate(Sampler):
    def __init__(self, *, candidates: int | None = None,
                 grows: bool | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class Bridson(Sampler):
    def __init__(self, *, min_distance: float | None = None,
                 attempts: int | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class DartThrowing(Sampler):
    def __init__(self, *, relative_radius: float | None = None,
                 stop: str | None = None,
                 min_distance: float | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class RelaxationDartThrowing(Sampler):
    def __init__(self, *, initial_radius: float | None = None,
                 factor: float | None = None,
                 attempts: int | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class VoronoiDarts(Sampler):
    def __init__(self, *, relative_radius: float | None = None,
                 stop: str | None = None,
                 min_distance: float | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class SectorDarts(Sampler):
    def __init__(self, *, variant: str | None = None,
                 min_distance: float | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class Lloyd(Sampler):
    def __init__(self, *, iterations: int | None = None,
                 start: Sampler | str | dict[str, Any] | None = None,
                 until_relative_radius: float | None = None,
                 keep: str | None = None,
                 repulsion: bool | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class SampleElimination(Sampler):
    def __init__(self, *, candidates: int | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class FarthestPoint(Sampler):
    def __init__(self, *, iterations: int | None = None,
                 start: Sampler | str | dict[str, Any] | None = None,
                 until_relative_radius: float | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class GaussianBlueNoise(Sampler):
    def __init__(self, *, iterations: int | None = None,
                 sigma: float | None = None,
                 step: float | None = None,
                 levels: int | None = None,
                 start: Sampler | str | dict[str, Any] | None = None,
                 density: str | None = None,
                 density_from: str | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class TargetSpectrum(Sampler):
    def __init__(self, *, target: str | None = None,
                 frequency: float | None = None,
                 peak: float | None = None,
                 curve: str | os.PathLike[str] | Sequence[str | os.PathLike[str]] | None = None,
                 curve_points: int | None = None,
                 iterations: int | None = None,
                 start: Sampler | str | dict[str, Any] | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class EqualAreas(Sampler):
    def __init__(self, *, iterations: int | None = None,
                 start: Sampler | str | dict[str, Any] | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class CornerTiles(Sampler):
    def __init__(self, *, colors: int | None = None,
                 points_per_tile: int | None = None,
                 relative_radius: float | None = None,
                 filling: str | None = None,
                 lloyd_iterations: int | None = None,
                 repulsion: bool | None = None,
                 ranked: bool | None = None,
                 density: float | None = None,
                 border: str | None = None,
                 joint_iterations: int | None = None,
                 null_peaks: bool | None = None,
                 equal_moments: int | None = None,
                 sets: int | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class EdgeTiles(Sampler):
    def __init__(self, *, colors: int | None = None,
                 points_per_tile: int | None = None,
                 relative_radius: float | None = None,
                 filling: str | None = None,
                 lloyd_iterations: int | None = None,
                 repulsion: bool | None = None,
                 ranked: bool | None = None,
                 density: float | None = None,
                 joint_iterations: int | None = None,
                 null_peaks: bool | None = None,
                 equal_moments: int | None = None,
                 sets: int | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class TemplateTiles(Sampler):
    def __init__(self, *, tiles: int | None = None,
                 points_per_tile: int | None = None,
                 relative_radius: float | None = None,
                 filling: str | None = None,
                 lloyd_iterations: int | None = None,
                 repulsion: bool | None = None,
                 ranked: bool | None = None,
                 density: float | None = None,
                 border: str | None = None,
                 joint_iterations: int | None = None,
                 null_peaks: bool | None = None,
                 equal_moments: int | None = None,
                 sets: int | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class SphereTiles(Sampler):
    def __init__(self, *, colors: int | None = None,
                 points_per_tile: int | None = None,
                 relative_radius: float | None = None,
                 filling: str | None = None,
                 lloyd_iterations: int | None = None,
                 repulsion: bool | None = None,
                 ranked: bool | None = None,
                 density: float | None = None,
                 joint_iterations: int | None = None,
                 null_peaks: bool | None = None,
                 equal_moments: int | None = None,
                 sets: int | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class ShadeTiles(Sampler):
    def __init__(self, *, points_per_tile: int | None = None,
                 relative_radius: float | None = None,
                 attempts: int | None = None,
                 sets: int | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class AveragedTiles(Sampler):
    def __init__(self, *, points_per_tile: int | None = None,
                 iterations: int | None = None,
                 variant: str | None = None,
                 sets: int | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class Penrose(Sampler):
    def __init__(self, *, density: str | None = None,
                 density_from: str | None = None,
                 random_window: bool | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class RecursiveWangTiles(Sampler):
    def __init__(self, *, points_per_tile: int | None = None,
                 base_tiles: int | None = None,
                 drawing: str | None = None,
                 density: str | None = None,
                 density_from: str | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class Polyominoes(Sampler):
    def __init__(self, *, variant: str | None = None,
                 seed_side: int | None = None,
                 density: str | None = None,
                 density_from: str | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class IsohedralTiles(Sampler):
    def __init__(self, *, type: int | None = None,
                 random_shape: bool | None = None,
                 points_per_tile: int | None = None,
                 relative_radius: float | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class File(Sampler):
    def __init__(self, *, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]] | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...

class Command(Sampler):
    def __init__(self, *, command: str | Sequence[str] | None = None,
                 time_limit: float | None = None,
                 needs: str | None = None,
                 d: int = 2,
                 rng: int | numpy.random.Generator | None = 1,
                 engine: str = "opencl",
                 device: str | None = None) -> None: ...
