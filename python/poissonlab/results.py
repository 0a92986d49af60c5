"""Output folders: running configs, and results as arrays."""

from __future__ import annotations

import html
import math
import os
import warnings
from collections.abc import Iterator, Mapping
from typing import Any

from . import _poissonlab, toml, views
from .analysis import Analysis


class Results(Mapping[str, Analysis]):
    """The results of a run, or of the runs of a collection: each series an Analysis, by its folder's name.

    Of a collection, names have the folder of their run before them: "fig-6-26/lloyd-i-16".
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self._folder = os.fspath(folder)
        self._runs = _poissonlab.open(folder)
        self._series = {}
        for run in self._runs:
            prefix = f"{os.path.basename(run.folder)}/" if len(self._runs) > 1 else ""
            for series in run.series():
                self._series[prefix + series.name] = Analysis(series)

    @property
    def folder(self) -> str:
        """The output folder."""
        return self._folder

    @property
    def title(self) -> str:
        """The title of the run; of a collection, those of its runs."""
        return "; ".join(run.title for run in self._runs)

    @property
    def config(self) -> str:
        """The text of the config; empty for sets that were made elsewhere, and for collections."""
        return self._runs[0].config if len(self._runs) == 1 else ""

    def report(self, out: str | os.PathLike[str] | None = None) -> str:
        """Write the report again, into the output folder or into another one. Returns the path of its first page."""
        out = self._folder if out is None else os.fspath(out)
        _poissonlab.report(self._folder, out)
        return os.path.join(out, "index.html")

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw the radial power of all series in one picture, with Matplotlib: on axes or in a new figure. style: keywords
        of Axes.plot(). Returns the axes."""
        ax = views.axes_of(ax)
        for series in self._series.values():
            series.plot(ax, **style)
        ax.legend()
        return ax

    def to_dataframe(self) -> Any:
        """Return the measures as a DataFrame of pandas: a row a series, by its name, with label, points,
        realizations, and a column for each measure's value."""
        keys = dict.fromkeys(key for series in self._series.values() for key in series.measures)
        columns = {name: [getattr(series, name) for series in self._series.values()]
                   for name in ("label", "points", "realizations")}
        for key in keys:
            columns[key] = [series.measures[key].value if key in series.measures else math.nan
                            for series in self._series.values()]
        return views.table_of(columns, index=list(self._series))

    def __getitem__(self, name: str) -> Analysis:
        return self._series[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._series)

    def __len__(self) -> int:
        return len(self._series)

    def __repr__(self):
        return f"<poissonlab.Results {self.title!r}: {', '.join(self._series)}>"

    def _repr_html_(self):
        rows = []
        for name, series in self._series.items():
            radius = series.measures.get("relative_radius")
            shown = f"{radius.value:.4f}" if radius else ""
            rows.append(f"<tr><td>{html.escape(name)}</td><td>{html.escape(series.label)}</td>"
                        f"<td>{series.realizations} × {series.points:,}</td><td>{shown}</td></tr>")
        return (f"<p><b>{html.escape(self.title)}</b></p><table><tr><th>name</th><th>series</th><th>sets</th>"
                f"<th>relative radius</th></tr>{''.join(rows)}</table>")


def open(folder: str | os.PathLike[str]) -> Results:
    """Read an output folder of `poissonlab run` or `analyze`, or of a collection. Raises InputError."""
    return Results(folder)


def run(config: str | os.PathLike[str], out: str | os.PathLike[str] | None = None, *,
        changes: dict[str, Any] | None = None, device: str | int | None = None, threads: int = 0,
        report: bool = True) -> Results:
    """Run the experiment of a config, or those of a collection, as `poissonlab run` does.

    config: the name of the .toml file.
    out: the output folder; default: out/ and the config's name. Finished work is kept in there: a run that was
        interrupted goes on where it was.
    changes: keys with other values, such as {"seed": 2, "analysis.points": 4096}; `--set` of the program.
    device: part of an OpenCL device's name, or its number. threads: 0 for all.
    report: whether to write the report, out/index.html, as well, which needs gnuplot.
    Returns Results. Raises InputError, DeviceError, StorageError. Warns of series that were left out, as this machine
    cannot make them.
    """
    settings = [f"{key}={toml.value_of(value)}" for key, value in (changes or {}).items()]
    folder, left_out = _poissonlab.run(os.fspath(config), "" if out is None else out, settings,
                                       "" if device is None else str(device), threads, report)
    for words in left_out:
        warnings.warn(words, stacklevel=2)
    return Results(folder)
