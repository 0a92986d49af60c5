# SPDX-License-Identifier: MIT-0
"""Poisson disk points without end for Blender's geometry nodes, from a tile set file (.ptiles).

As an add-on (Preferences, Add-ons, Install): Add, Mesh, Poisson Points asks for a file, and adds a mesh of vertices on
which geometry nodes place an object. As a module, in Blender's Python or any other that has NumPy:

    tiles = TileSet(open("corner-c4-n64-r075.ptiles", "rb").read())
    points = tiles.points([0, 0], [16, 9], seed=1, density=0.5)    # points.position: (n, 2) in tiles

Points are those of poisson_tiles.h, to the last bit. docs/tile-set-file.md describes the file, docs/drop-ins.md the
use.
"""

import struct
from collections import namedtuple

import numpy

try:
    import bpy
except ImportError:  # some other Python: the look-ups alone
    bpy = None

bl_info = {
    "name": "Poisson Points",
    "author": "the authors of the Poisson disk laboratory",
    "version": (0, 2, 0),
    "blender": (3, 4, 0),
    "location": "Add > Mesh > Poisson Points",
    "description": "Points with a proven minimum distance, of any density, for geometry nodes",
    "category": "Add Mesh",
}

#: Arrays with an item or row a point: position (in tiles), tile (the place of its tile), index (in its tile), id (random
#: bits that stay with it), level (the density, from 0 to 1, above which it is there), kind (its class).
Points = namedtuple("Points", "position tile index id level kind")

#: The tiles of a window may have so many points: more take minutes and gigabytes.
MOST_POINTS = 10**7


class TileSet:
    """The tiles of a file: `data`, all of its bytes. Throws ValueError, which says what is wrong."""

    def __init__(self, data):
        problem = self._read(bytes(data))
        if problem:
            raise ValueError(problem)

    def _read(self, data):
        if len(data) < 128:
            return "shorter than the header of a tile set file"
        if data[:8] != b"PTILES\r\n":
            return "not a tile set file"
        words = struct.unpack("<32I", data[:128])
        version = words[2]
        if not 1 <= version <= 3 or words[3] != 128:
            return "an unknown version of the file format"
        self.shape, self.dimension, self.colors, self.tiles, self.points_per_tile = words[4:9]
        chains, self.below, self.above, ranked = (words[22], *words[25:28]) if version > 1 else (0, 0, 0, 0)
        if ranked > 1 or chains > 1 or self.below > 32768 or self.above > 32768:
            return "an unknown kind of borders or ranks"
        if self.shape > 2 or self.dimension not in (2, 3) or (self.dimension == 3 and self.shape != 0):
            return "an unknown kind of tiles"
        digits = 12 if self.shape == 1 else 2**self.dimension
        if 0 in (self.colors, self.tiles, self.points_per_tile) or self.points_per_tile > 65536 or (
                self.shape != 2 and self.tiles != self.colors**digits):
            return "numbers of colours, tiles and points that do not fit together"
        #: No two points of any tiling are nearer, in tiles; 0: the file has no proof.
        self.min_distance = (words[10] + words[11] * 2.0**32)**0.5 / 65536
        #: Power goes to 0 with this power of the frequency, at least.
        self.exponent = 2 * ((words[28] if version > 1 else 0) + 1)
        return self._read_points(data, chains, ranked, words[9] if version > 2 else None)

    def _read_points(self, data, chains, ranked, classes):
        count = self.tiles * self.points_per_tile
        before_ranks = count * self.dimension + (2 * self.colors**2 if chains else 0)
        end = 128 + 2 * (before_ranks + (count if ranked else 0))
        c = classes or 0
        if c > 32 or classes == 0 or len(data) != end + 4 * c + 8 * c * (c + 1):
            return "too short or too long for its points"
        numbers = numpy.frombuffer(data, "<u2", (end - 128) // 2, 128)
        coordinates = numbers[:count * self.dimension].reshape(self.tiles, self.points_per_tile, self.dimension)
        #: Of each tile's points, in tiles from its lowest corner.
        self.coordinates = ((2.0 * coordinates - 32768) if chains else coordinates) / 65536
        self.ranks = numbers[before_ranks:].reshape(self.tiles, -1) if ranked else None
        self.class_points = numpy.frombuffer(data, "<u4", c, end)
        if c and int(self.class_points.sum()) != self.points_per_tile:
            return "classes that have not all points of a tile"
        return ""

    def points(self, low, high, seed=1, density=1.0):
        """All points with low <= position < high along each axis and a level below `density`: Points. Rows of tiles from
        south to north (3D: layers from the bottom), in each from west to east. Throws ValueError if the tiles there have
        more than MOST_POINTS."""
        low, high = numpy.array(low, float), numpy.array(high, float)
        first, last = numpy.floor(low - self.above / 65536), numpy.floor(high + self.below / 65536)
        count = numpy.prod(numpy.maximum(last - first + 1, 0)) * self.points_per_tile
        if not count <= MOST_POINTS:
            raise ValueError(f"{count:,.0f} points in the tiles there: must be at most {MOST_POINTS:,}")
        first, last = first.astype(int), last.astype(int)
        row = numpy.arange(first[0], last[0] + 1)
        layers = range(first[2], last[2] + 1) if self.dimension == 3 else [0]
        rows = [self._row(row, j, k, low, high, seed, density) for k in layers for j in range(first[1], last[1] + 1)]
        return Points(*map(numpy.concatenate, zip(*rows))) if rows else self._row(row[:0], 0, 0, low, high, seed, 1.0)

    def _row(self, row, j, k, low, high, seed, density):
        place = numpy.stack([row, numpy.full_like(row, j), numpy.full_like(row, k)], axis=-1)
        number = self.tile(*place.T, seed)
        place = place[:, :self.dimension]
        position = place[:, None, :] + self.coordinates[number]
        keys = _hash(seed, *numpy.pad(place, ((0, 0), (0, 3 - self.dimension))).T)
        index = numpy.arange(self.points_per_tile, dtype=numpy.uint32)
        ids = _mix(keys[:, None] + numpy.uint32(1) + index)
        level = ids / 2.0**32 if self.ranks is None else (self.ranks[number] + 0.5) / self.points_per_tile
        inside = ((position >= low) & (position < high)).all(axis=-1)
        if density < 1:
            inside &= level < density
        tile, at = numpy.nonzero(inside)
        kind = numpy.searchsorted(numpy.cumsum(self.class_points)[:-1], at, side="right")
        return Points(position[inside], place[tile].astype(numpy.int32), at.astype(numpy.uint32), ids[inside],
                      level[inside], kind.astype(numpy.int32))

    def tile(self, i, j, k, seed=1):
        """The numbers of the tiles at places, arrays of integers; k is 0 in 2D."""
        if self.shape == 2:
            return (_hash(seed, i, j, 0) % self.tiles).astype(int)
        if self.shape == 1:
            edges = [(i, j + 1, 0), (i + 1, j, 1), (i, j, 0), (i, j, 1), (i + 1, j + 1, 0), (i + 1, j + 1, 1),
                     (i + 1, j, 0), (i + 1, j - 1, 1), (i - 1, j, 0), (i, j - 1, 1), (i - 1, j + 1, 0), (i, j + 1, 1)]
        else:
            edges = [(x, y, z) for z in ([k + 1, k] if self.dimension == 3 else [0])
                     for x, y in ((i + 1, j + 1), (i + 1, j), (i, j), (i, j + 1))]
        number = 0
        for edge in edges:  # the digits of the tile's number: colours of edges, or of corners
            number = number * self.colors + (_hash(seed, *edge) % self.colors).astype(int)
        return number


def _words(values):
    """Integers, negative ones too, as words of 32 bits."""
    return (numpy.asarray(values, dtype=numpy.int64) & 0xffffffff).astype(numpy.uint32)


def _mix(v):
    v = (v ^ v >> numpy.uint32(16)) * numpy.uint32(0x21f0aaad)
    v = (v ^ v >> numpy.uint32(15)) * numpy.uint32(0xd35a2d97)
    return v ^ v >> numpy.uint32(15)


def _hash(seed, x, y, z):
    result = _mix(_words([seed]))
    for word in (x, y, z):
        result = _mix(result + _words(word))
    return result


# What is below needs Blender.

def add_points(tiles, *, size, min_distance, seed=1, density=1.0, offset=(0.0, 0.0, 0.0), name="Poisson points"):
    """A new object in the scene: a mesh of vertices, none of which are nearer than `min_distance`, in the box of `size`
    around its origin. Each has the attributes "level", "id" (which nodes take for their random numbers) and "class".
    `offset` of the box in the tiling: boxes of one seed and distance fit together. Throws ValueError, also for more than
    MOST_POINTS."""
    if tiles.min_distance == 0:
        raise ValueError("the file has no proven distance")
    if not min_distance > 0:
        raise ValueError("the least distance must be above 0")
    side = min_distance / tiles.min_distance
    axes = tiles.dimension
    middle, half = numpy.array(offset[:axes], float), numpy.array(size[:axes], float) / 2
    points = tiles.points((middle - half) / side, (middle + half) / side, seed, density)
    position = numpy.zeros((len(points.level), 3), numpy.float32)
    position[:, :axes] = points.position * side - middle
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(position))
    mesh.vertices.foreach_set("co", position.ravel())
    for attribute, kind, values in (("level", "FLOAT", points.level.astype(numpy.float32)),
                                    ("id", "INT", points.id.view(numpy.int32)), ("class", "INT", points.kind)):
        mesh.attributes.new(attribute, kind, "POINT").data.foreach_set("value", numpy.ascontiguousarray(values))
    mesh.update()
    added = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(added)
    return added


def add_scatter(points, instance=None, density=1.0):
    """A modifier of the points: geometry nodes that place `instance` on the part `density` of them, each turned by random
    numbers of its own. More density adds instances and moves none."""
    modifier = points.modifiers.new("Poisson scatter", "NODES")
    modifier.node_group = _scatter_nodes()
    set_input(modifier, "Density", density)
    set_input(modifier, "Instance", instance)
    return modifier


def set_input(modifier, name, value):
    """Sets an input of a modifier's nodes by its name."""
    group = modifier.node_group
    sockets = group.interface.items_tree if hasattr(group, "interface") else group.inputs  # Blender 4, and before
    modifier[next(socket.identifier for socket in sockets if socket.name == name)] = value
    modifier.id_data.update_tag()


def _scatter_nodes(name="Poisson scatter"):
    """The group of nodes: instances on points whose level is below the density."""
    if name in bpy.data.node_groups:
        return bpy.data.node_groups[name]
    group = bpy.data.node_groups.new(name, "GeometryNodeTree")
    _add_socket(group, "Geometry", "NodeSocketGeometry", "INPUT")
    density = _add_socket(group, "Density", "NodeSocketFloat", "INPUT")
    density.min_value, density.max_value, density.default_value = 0.0, 1.0, 1.0
    _add_socket(group, "Instance", "NodeSocketObject", "INPUT")
    _add_socket(group, "Geometry", "NodeSocketGeometry", "OUTPUT")

    new = group.nodes.new
    inputs, outputs = new("NodeGroupInput"), new("NodeGroupOutput")
    level, compare = new("GeometryNodeInputNamedAttribute"), new("FunctionNodeCompare")
    random, instance = new("FunctionNodeRandomValue"), new("GeometryNodeObjectInfo")
    place = new("GeometryNodeInstanceOnPoints")
    level.data_type, level.inputs["Name"].default_value = "FLOAT", "level"
    compare.data_type, compare.operation = "FLOAT", "LESS_THAN"
    random.data_type = "FLOAT_VECTOR"
    random.inputs[0].default_value, random.inputs[1].default_value = (0, 0, 0), (0, 0, 6.2831853)
    for x, node in enumerate((inputs, level, compare, random, instance, place, outputs)):
        node.location = (180 * x, -120 * (x % 3))

    def link(source, target):
        group.links.new(source, target)

    link(_output(level, "VALUE"), compare.inputs[0])
    link(inputs.outputs["Density"], compare.inputs[1])
    link(inputs.outputs["Instance"], instance.inputs["Object"])
    link(inputs.outputs["Geometry"], place.inputs["Points"])
    link(compare.outputs[0], place.inputs["Selection"])
    link(instance.outputs["Geometry"], place.inputs["Instance"])
    link(_output(random, "VECTOR"), place.inputs["Rotation"])
    link(place.outputs[0], outputs.inputs[0])
    return group


def _add_socket(group, name, kind, direction):
    if hasattr(group, "interface"):  # Blender 4
        return group.interface.new_socket(name, in_out=direction, socket_type=kind)
    return (group.inputs if direction == "INPUT" else group.outputs).new(kind, name)


def _output(node, kind):
    """The output of a type, of nodes that have several of one name."""
    return next(socket for socket in node.outputs if socket.type == kind)


if bpy:
    class AddPoissonPoints(bpy.types.Operator):
        """Add points of a Poisson disk tile set, with nodes that place an object on them"""

        bl_idname = "mesh.poisson_points_add"
        bl_label = "Poisson Points"
        bl_options = {"REGISTER", "UNDO"}

        filepath: bpy.props.StringProperty(subtype="FILE_PATH")
        filter_glob: bpy.props.StringProperty(default="*.ptiles", options={"HIDDEN"})
        size: bpy.props.FloatVectorProperty(name="Size", size=3, default=(10, 10, 10), min=0, subtype="XYZ_LENGTH")
        min_distance: bpy.props.FloatProperty(name="Least distance", default=0.5, min=1e-4, subtype="DISTANCE")
        seed: bpy.props.IntProperty(name="Seed", default=1, min=0)
        density: bpy.props.FloatProperty(name="Density", default=1, min=0, max=1)
        offset: bpy.props.FloatVectorProperty(name="Offset in the tiling", size=3, subtype="XYZ_LENGTH")

        def invoke(self, context, _event):
            context.window_manager.fileselect_add(self)
            return {"RUNNING_MODAL"}

        def execute(self, context):
            instance = context.active_object
            try:
                with open(bpy.path.abspath(self.filepath), "rb") as file:
                    tiles = TileSet(file.read())
                added = add_points(tiles, size=self.size, min_distance=self.min_distance, seed=self.seed,
                                   offset=self.offset)
            except (OSError, ValueError) as problem:
                self.report({"ERROR"}, f"{self.filepath}: {problem}")
                return {"CANCELLED"}
            add_scatter(added, instance, self.density)
            for item in context.selected_objects:
                item.select_set(False)
            added.select_set(True)
            context.view_layer.objects.active = added
            return {"FINISHED"}


def _menu(self, _context):
    self.layout.operator(AddPoissonPoints.bl_idname, icon="POINTCLOUD_DATA")


def register():
    """Called by Blender when the add-on is switched on."""
    bpy.utils.register_class(AddPoissonPoints)
    bpy.types.VIEW3D_MT_mesh_add.append(_menu)


def unregister():
    """Called by Blender when the add-on is switched off."""
    bpy.types.VIEW3D_MT_mesh_add.remove(_menu)
    bpy.utils.unregister_class(AddPoissonPoints)
