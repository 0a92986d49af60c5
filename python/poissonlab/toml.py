"""Values of Python as TOML, the language of configs."""

import json
import os

import numpy


def text_of(text):
    """A string in quotes. Control characters are escaped as TOML wants them."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}" for c in escaped) + '"'


def table_of(items):
    """A table in a line."""
    return "{ " + ", ".join(f"{key_of(key)} = {value_of(value)}" for key, value in items.items()) + " }"


def key_of(key):
    """A key, in quotes where it needs them."""
    plain = key and all(c.isascii() and (c.isalnum() or c in "_-") for c in key)
    return key if plain else text_of(key)


def geojson_of(value):
    """The GeoJSON of what has a `__geo_interface__`, such as polygons of shapely, or is such an object as a dict; None
    of everything else."""
    system = getattr(value, "crs", None)  # of geopandas
    value = getattr(value, "__geo_interface__", value)
    is_geojson = isinstance(value, dict) and isinstance(value.get("type"), str) \
        and not value.keys().isdisjoint(("coordinates", "geometry", "geometries", "features"))
    if is_geojson and "crs" not in value and hasattr(system, "to_string"):
        value = {**value, "crs": {"type": "name", "properties": {"name": system.to_string()}}}
    return json.dumps(value) if is_geojson else None


def value_of(value):
    """A value as it would be typed. Objects with a method `to_toml` say it themselves, and GeoJSON is a region."""
    if hasattr(value, "to_toml"):
        return value.to_toml()
    if (geojson := geojson_of(value)) is not None:
        return text_of(geojson)
    if isinstance(value, numpy.generic):
        value = value.item()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return text_of(os.fspath(value))
    if isinstance(value, dict):
        return table_of(value)
    if isinstance(value, (list, tuple, numpy.ndarray)):
        return "[" + ", ".join(value_of(item) for item in value) + "]"
    raise TypeError(f"{value!r}: must be a number, a text, a path, or a list or dict of these")
