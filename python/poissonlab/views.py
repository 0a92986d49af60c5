"""Draws results with Matplotlib and makes DataFrames of them, where Matplotlib and pandas are installed."""

import importlib

import numpy

AXES = ("x", "y", "z")


def needed(module, what):
    """Imports a module that the package does without; `what` needs it."""
    try:
        return importlib.import_module(module)
    except ImportError:
        package = module.partition(".")[0]
        raise ImportError(f"{what}: needs {package}: python3-{package} in Debian, or pip install {package}") from None


def axes_of(ax, **options):
    """Returns the given axes, or those of a new figure."""
    return needed("matplotlib.pyplot", "plot").subplots(subplot_kw=options)[1] if ax is None else ax


def plot_curve(ax, x, y, spread, labels, style):
    """Draws a line, in a band from low to high where `spread` has both. Returns the axes."""
    ax = axes_of(ax)
    (line,) = ax.plot(x, y, **style)
    low, high = spread
    if numpy.any(low < high):
        ax.fill_between(x, low, high, color=line.get_color(), alpha=0.2, linewidth=0)
    ax.set_xlabel(labels[0])
    ax.set_ylabel(labels[1])
    return ax


def plot_points(ax, points, style):
    """Draws dots in equal scales; axes of the plane show x and y of points in space. Returns the axes."""
    ax = axes_of(ax, **({"projection": "3d"} if points.shape[1] == 3 else {}))
    dimension = min(points.shape[1], 3 if getattr(ax, "name", "") == "3d" else 2)
    ax.scatter(*points.T[:dimension], **{"s": 4, "linewidths": 0, **style})
    ax.set_aspect("equal")
    for axis in AXES[:dimension]:
        getattr(ax, f"set_{axis}label")(axis)
    return ax


def plot_image(ax, values, style):
    """Draws pixels, row after row from the top. Returns the axes."""
    ax = axes_of(ax)
    grey = {"cmap": "gray"} if values.ndim == 2 or values.shape[2] == 1 else {}
    ax.imshow(values.squeeze(), **{**grey, "interpolation": "nearest", **style})
    ax.set_axis_off()
    return ax


def table_of(columns, index=None):
    """Returns a DataFrame. Columns of shape (n, 2) or (n, 3) become one of each axis: positions x, y and z, others with the axis
    behind their name. None is left out."""
    flat = {}
    for name, values in columns.items():
        if values is None:
            continue
        if numpy.ndim(values) == 2:
            for axis, part in zip(AXES, numpy.transpose(values)):
                flat[axis if name == "position" else f"{name}_{axis}"] = part
        else:
            flat[name] = values
    return needed("pandas", "to_dataframe").DataFrame(flat, index=index)


def to_dataframe(columns):
    """Return a DataFrame of pandas with the same columns; needs pandas."""
    return table_of(columns._asdict())
