"""runtime/blender/poisson_points.py in Blender without a screen, as blender.sh starts it:

    blender --background --factory-startup --python-exit-code 1 --python scatter.py -- MODULE_FOLDER TILE_SETS
"""

import pathlib
import sys

import bpy
import numpy

MODULE_FOLDER, TILE_SETS = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, MODULE_FOLDER)
import poisson_points  # noqa: E402: where it is has just been said

FILE = pathlib.Path(TILE_SETS) / "corner-c4-n64-r075.ptiles"


def attribute(mesh, name, kind):
    values = numpy.zeros(len(mesh.vertices), kind)
    mesh.attributes[name].data.foreach_get("value", values)
    return values


def vertices(mesh):
    values = numpy.zeros(3 * len(mesh.vertices), numpy.float32)
    mesh.vertices.foreach_get("co", values)
    return values.reshape(-1, 3)


def instances_of(added):
    """Places and turns of what the nodes place, as Blender evaluates them."""
    graph = bpy.context.evaluated_depsgraph_get()
    graph.update()
    matrices = [numpy.array(item.matrix_world) for item in graph.object_instances
                if item.is_instance and item.parent and item.parent.name == added.name]
    return numpy.array(matrices).reshape(-1, 4, 4)


def expect(holds, what):
    if not holds:
        raise AssertionError(what)


poisson_points.register()
bpy.ops.mesh.primitive_cone_add()
cone = bpy.context.active_object
done = bpy.ops.mesh.poisson_points_add(filepath=str(FILE), size=(12, 8, 1), min_distance=0.5, seed=7, density=0.4,
                                       offset=(100, -20, 0))
expect(done == {"FINISHED"}, done)
added = bpy.context.active_object

# The vertices are the points of the window, with their attributes.
tiles = poisson_points.TileSet(FILE.read_bytes())
side = 0.5 / tiles.min_distance
points = tiles.points(numpy.array([94, -24]) / side, numpy.array([106, -16]) / side, 7)
found = vertices(added.data)
expect(len(found) == len(points.level) > 200, len(found))
expect(numpy.abs(found[:, :2] - (points.position * side - [100, -20])).max() < 1e-6, "other places")
level = attribute(added.data, "level", numpy.float32)
expect((level == points.level.astype(numpy.float32)).all(), "other levels")
expect((attribute(added.data, "id", numpy.int32).view(numpy.uint32) == points.id).all(), "other bits")
gaps = found[:, None, :] - found
gaps = numpy.sqrt((gaps**2).sum(axis=-1)) + numpy.eye(len(found)) * 9
expect(0.5 - 1e-5 <= gaps.min() < 0.55, gaps.min())

# The nodes place cones on those with a level below the density, each turned by its own.
modifier = added.modifiers[0]
for density in (0.4, 0.8, 1.0, 0.0):
    poisson_points.set_input(modifier, "Density", density)
    matrices = instances_of(added)
    wanted = found[level < numpy.float32(density)]
    expect(len(matrices) == len(wanted), f"{len(matrices)} instances, expected {len(wanted)} at {density}")
    expect(len(wanted) == 0 or numpy.abs(matrices[:, :3, 3] - wanted).max() < 1e-6, "instances at other places")
    if density == 0.4:
        turns = {index: matrix[:2, :2] for index, matrix in zip(numpy.nonzero(level < density)[0], matrices)}
    if density == 0.8:
        for index, matrix in zip(numpy.nonzero(level < numpy.float32(density))[0], matrices):
            expect(index not in turns or numpy.abs(turns[index] - matrix[:2, :2]).max() < 1e-6, "an instance has turned")
expect(len({round(float(turn[0, 0]), 4) for turn in turns.values()}) > 0.9 * len(turns), "all are turned alike")

# The add-on makes points in a box in space.
bpy.context.view_layer.objects.active = cone
bpy.ops.mesh.poisson_points_add(filepath=str(FILE.with_name("sphere-c2-n128-r085.ptiles")), size=(3, 3, 3),
                                min_distance=0.4)
cloud = vertices(bpy.context.active_object.data)
expect(len(cloud) > 200 and cloud.min() >= -1.5 and cloud.max() <= 1.5 and numpy.ptp(cloud[:, 2]) > 2, "no box")

# What is no tile set is refused, and adds nothing.
before = len(bpy.data.objects)
for name, words in (("README.md", "not a tile set file"), ("none.ptiles", "No such file")):
    try:
        bpy.ops.mesh.poisson_points_add(filepath=str(FILE.with_name(name)))
        expect(False, f"{name} was taken")
    except RuntimeError as problem:
        expect(words in str(problem), problem)
try:
    bpy.ops.mesh.poisson_points_add(filepath=str(FILE), size=(1e4, 1e4, 0), min_distance=1e-3)
    expect(False, "too many points were made")
except RuntimeError as problem:
    expect("must be at most 10,000,000" in str(problem), problem)
expect(len(bpy.data.objects) == before, "something was added")
poisson_points.unregister()
print(f"DONE: {len(found)} points, {len(cloud)} in space")
