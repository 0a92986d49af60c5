"""Reads glTF files of instances, with code of its own: glTF 2.0 and EXT_mesh_gpu_instancing as their texts define them.

Usage: gltf_instances.py PROGRAM
"""
import csv
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1]
TILE_SETS = pathlib.Path(__file__).resolve().parents[3] / "runtime" / "tile_sets"
FLOAT = 2.0**-24  # half of the last place of a float of 1
EXTENSION = "EXT_mesh_gpu_instancing"

# Normals of a box along all axes, up and down exactly, and of a roof.
BOX = """v 0 0 0
v 2 0 0
v 2 1 0
v 0 1 0
v 0 0 3
v 2 0 3
v 2 1 3
v 0 1 3
v 1 2 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 1 5 8 4
f 2 3 7 6
f 4 8 9
f 8 7 9
f 7 3 9
f 3 4 9
"""
WEDGE = "v -2 0 0\nv 2 0 0\nv 0 3 1\nvn 0 0 5\nf 1//1 2//1 3//1\n"


def floats(data, accessor):
    json_part, binary = data
    described = json_part["accessors"][accessor]
    view = json_part["bufferViews"][described["bufferView"]]
    width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[described["type"]]
    assert described["componentType"] == 5126 and view["buffer"] == 0
    begin = view.get("byteOffset", 0)
    assert begin % 4 == 0 and view["byteLength"] == 4 * width * described["count"]
    values = struct.unpack_from(f"<{width * described['count']}f", binary, begin)
    rows = [values[i:i + width] for i in range(0, len(values), width)]
    if "min" in described:
        assert list(map(min, zip(*rows))) == [struct.unpack("<f", struct.pack("<f", c))[0] for c in described["min"]]
        assert list(map(max, zip(*rows))) == [struct.unpack("<f", struct.pack("<f", c))[0] for c in described["max"]]
    return rows


def read_glb(file):
    data = file.read_bytes()
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    json_length, json_name = struct.unpack_from("<I4s", data, 12)
    assert json_name == b"JSON" and json_length % 4 == 0
    described = json.loads(data[20:20 + json_length])
    length, name = struct.unpack_from("<I4s", data, 20 + json_length)
    assert name == b"BIN\0" and 28 + json_length + length == len(data)
    assert length == described["buffers"][0]["byteLength"]
    assert described["extensionsUsed"] == described["extensionsRequired"] == [EXTENSION]
    assert described["scenes"][described["scene"]]["nodes"] == list(range(len(described["nodes"])))
    return described, data[28 + json_length:]


def rotated(q, v):
    """v + 2 u x (u x v + w v), for the quaternion (u, w)."""
    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    inner = [a + q[3] * b for a, b in zip(cross(q[:3], v), v)]
    return [a + 2 * b for a, b in zip(v, cross(q[:3], inner))]


def is_near(a, b, tolerance):
    return all(abs(x - y) <= tolerance for x, y in zip(a, b))


def run(folder, *words):
    subprocess.run([PROGRAM, "distribute", *words, "--engine", "reference", "--quiet"], cwd=folder, check=True)
    with open(folder / "a.csv") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def rows_of_node(data, node):
    """Checks a node's types, and returns its attributes and the triangles of its mesh."""
    primitives = data[0]["meshes"][node["mesh"]]["primitives"]
    assert len(primitives) == 1 and primitives[0].get("mode", 4) == 4
    assert primitives[0]["material"] < len(data[0]["materials"])
    model = {name: floats(data, accessor) for name, accessor in primitives[0]["attributes"].items()}
    assert "min" in data[0]["accessors"][primitives[0]["attributes"]["POSITION"]]
    attributes = node["extensions"][EXTENSION]["attributes"]
    rows = {name: floats(data, accessor) for name, accessor in attributes.items()}
    assert len({len(values) for values in rows.values()}) == 1
    return rows, model


def check_rows(rows, points, scale, origin=(0, 0, 0)):
    """Each instance stands on its point, with its y axis along the normal. Returns by how much they are turned."""
    turns = []
    for place, q, size, (number,) in zip(rows["TRANSLATION"], rows["ROTATION"], rows["SCALE"], rows["_ID"]):
        point = points[int(number)]
        assert is_near([a + b for a, b in zip(origin, place)], (point["x"], point["y"], point["z"]), 4 * FLOAT)
        assert is_near(size, [scale] * 3, 2 * FLOAT * scale)
        assert abs(sum(c * c for c in q) - 1) <= 8 * FLOAT
        normal = (point["nx"], point["ny"], point["nz"])
        # Each number of q is off by FLOAT at most, and each of its products by twice that: 4 of them in a sum, doubled.
        assert is_near(rotated(q, (0, 1, 0)), normal, 16 * FLOAT), (q, normal)
        turns.append(2 * math.atan2(q[1], q[3]) % (2 * math.pi))
    return turns


def check_even(turns):
    """Each mean of cos and sin has the deviation 1 / sqrt(2 N), where angles are uniform."""
    for function in (math.cos, math.sin):
        assert abs(sum(map(function, turns))) <= 4.5 * math.sqrt(len(turns) / 2)
    assert len(set(turns)) > 0.99 * len(turns)


def area_of_box():
    roof = 0
    top = ((0, 1, 0), (0, 1, 3), (2, 1, 3), (2, 1, 0))
    for a, b in zip(top, top[1:] + top[:1]):
        u, v = [[p - q for p, q in zip(end, (1, 2, 1))] for end in (a, b)]
        roof += math.sqrt((u[1] * v[2] - u[2] * v[1])**2 + (u[2] * v[0] - u[0] * v[2])**2 +
                          (u[0] * v[1] - u[1] * v[0])**2) / 2
    return 2 + 2 + 6 + 3 + 3 + roof


def check_surface(folder):
    for count in (1, 2, 3, 400):
        points = run(folder, "surface", "box.obj", "--points", str(count), "--instances", "cone", "--out", "a.glb",
                     "--out", "a.csv")
        data = read_glb(folder / "a.glb")
        assert len(points) == count and len(data[0]["nodes"]) == 1
        rows, model = rows_of_node(data, data[0]["nodes"][0])
        assert set(rows) == {"TRANSLATION", "ROTATION", "SCALE", "_ID"}
        assert [row[0] for row in rows["_ID"]] == list(range(count))
        spacing = math.sqrt(area_of_box() / count)
        origin = data[0]["nodes"][0].get("translation", (0, 0, 0))
        assert (origin == (0, 0, 0)) == (count > 1)  # a single one stands where its node is
        turns = check_rows(rows, points, 0.35 * spacing / 0.5, origin)  # the cone has a radius of 1/2
        assert max(math.hypot(x, z) for x, _, z in model["POSITION"]) == 0.5
        assert {y for _, y, _ in model["POSITION"]} == {0, 1}
    check_even(turns)
    downwards = [q for q, point in zip(rows["ROTATION"], points) if point["ny"] == -1]
    assert len(downwards) > 10  # y is turned around there
    # Quaternions the other way round do not lead to the normals, but by chance: this test can fail.
    sides = [(q, (p["nx"], p["ny"], p["nz"])) for q, p in zip(rows["ROTATION"], points) if abs(p["ny"]) < 0.5]
    assert len(sides) > 100
    assert sum(is_near(rotated([-c for c in q[:3]] + [q[3]], (0, 1, 0)), n, 0.01) for q, n in sides) < 10
    before = (folder / "a.glb").read_bytes()
    again = ("surface", "box.obj", "--points", "400", "--instances", "cone", "--out", "a.glb", "--out", "a.csv")
    run(folder, *again)
    assert (folder / "a.glb").read_bytes() == before
    run(folder, *again, "--seed", "7")
    other = rows_of_node(read_glb(folder / "a.glb"), data[0]["nodes"][0])[0]
    assert other["ROTATION"] != rows["ROTATION"]


def check_far(folder):
    """In metres of UTM, floats are half a metre apart: the node is moved there, and instances count from it."""
    move = (500000, 5400000, 100)
    moved = [" ".join(["v"] + [str(float(c) + d) for c, d in zip(line.split()[1:], move)]) if line.startswith("v ") else line
             for line in BOX.splitlines()]
    (folder / "far.obj").write_text("\n".join(moved) + "\n")
    points = run(folder, "surface", "far.obj", "--points", "400", "--instances", "cone", "--out", "a.glb", "--out", "a.csv")
    data = read_glb(folder / "a.glb")
    origin = data[0]["nodes"][0]["translation"]
    rows, _ = rows_of_node(data, data[0]["nodes"][0])
    assert all(abs(c) <= 2 for place in rows["TRANSLATION"] for c in place)
    check_rows(rows, points, 0.35 * math.sqrt(area_of_box() / 400) / 0.5, origin)
    (folder / "thin.obj").write_text("v 0 0 0\nv 0 1 0\nv 0 2 0\nf 1 2 3\n")
    for words, said in ((("--instances", "thin.obj"), "thin.obj"), (("--instances", "cone", "--instance-scale", "1e-60"), "scale")):
        failed = subprocess.run([PROGRAM, "distribute", "surface", "box.obj", "--points", "3", *words, "--out", "no.glb"],
                                cwd=folder, capture_output=True, text=True)
        assert failed.returncode == 2 and said in failed.stderr and failed.stderr.count("\n") <= 2, failed.stderr
        assert not (folder / "no.glb").exists()


def check_classes(folder):
    words = ("surface-classes", "box.obj", "--points", "30", "300", "--out", "a.glb", "--out", "a.csv")
    points = run(folder, *words, "--instances", "wedge.obj", "--instances", "cone", "--instance-scale", "0.125")
    data = read_glb(folder / "a.glb")
    assert [node["name"] for node in data[0]["nodes"]] == ["class_0", "class_1"]
    numbers = []
    for own, node in enumerate(data[0]["nodes"]):
        rows, model = rows_of_node(data, node)
        assert set(rows["_CLASS"]) == {(own,)}
        check_rows(rows, points, 0.125)
        assert all(points[int(number)]["class"] == own for (number,) in rows["_ID"])
        numbers += [number for (number,) in rows["_ID"]]
        if own == 0:
            assert model["POSITION"] == [(-2, 0, 0), (2, 0, 0), (0, 3, 1)]
            assert model["NORMAL"] == [(0, 0, 1)] * 3  # that of the file, of length 1
    assert sorted(numbers) == list(range(330))
    assert data[0]["materials"][0] != data[0]["materials"][1]
    points = run(folder, *words, "--instances", "wedge.obj")  # one model for all, 2 wide to each side
    data = read_glb(folder / "a.glb")
    for node, count in zip(data[0]["nodes"], (30, 300)):
        check_rows(rows_of_node(data, node)[0], points, 0.35 * math.sqrt(area_of_box() / count) / 2)


def turned(point, v):
    """A vector of space, z up, turned about z and then tilted, by Rodrigues' formula about the axis across the tilt."""
    c, s = math.cos(point["turn"]), math.sin(point["turn"])
    x, y, z = c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]
    kx, ky = -math.sin(point["tilt_direction"]), math.cos(point["tilt_direction"])
    c, s, along = math.cos(point["tilt"]), math.sin(point["tilt"]), kx * x + ky * y
    return (x * c + ky * z * s + kx * along * (1 - c), y * c - kx * z * s + ky * along * (1 - c),
            z * c + (kx * y - ky * x) * s)


def upwards(v):
    """The axes of glTF, y up, of a vector whose z is up."""
    return v[0], v[2], -v[1]


def check_scene(folder, scene, tiles, models, *words):
    words = ("instances", scene, "--tiles", str(TILE_SETS / tiles), "--models", str(models), *words, "--out", "a.csv")
    points = run(folder, *words, "--out", "a.glb")
    said = subprocess.run([PROGRAM, "distribute", *words, "--json"], cwd=folder, check=True, capture_output=True)
    radius = json.loads(said.stdout)["radius"]
    data = read_glb(folder / "a.glb")
    numbers = []
    for node in data[0]["nodes"]:
        rows, shape = rows_of_node(data, node)
        assert ("_CLASS" in rows) == ("class" in points[0])
        far = max(map(abs, sum(shape["POSITION"], ())))
        if scene == "asteroids":
            assert all(abs(math.hypot(*corner) - radius) <= 4 * FLOAT * radius for corner in shape["POSITION"])
        else:
            assert abs(max(math.hypot(x, z) for x, _, z in shape["POSITION"]) - radius) <= 4 * FLOAT * radius
            assert min(y for _, y, _ in shape["POSITION"]) == 0 and far > radius
        for k in range(0, len(shape["POSITION"]), 3):  # corners run counterclockwise, as seen from outside
            a, b, c = shape["POSITION"][k:k + 3]
            u, v = [[q - p for p, q in zip(a, end)] for end in (b, c)]
            normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            middle = [(p + q + r) / 3 - h for p, q, r, h in zip(a, b, c, (0, 0 if scene == "asteroids" else radius / 9, 0))]
            assert sum(p * q for p, q in zip(normal, middle)) > 0
            assert sum(p * q for p, q in zip(normal, shape["NORMAL"][k])) > 0
        origin = node.get("translation", (0, 0, 0))
        for i, (number,) in enumerate(rows["_ID"]):
            point = points[int(number)]
            assert node["name"] == f"model_{point['model']:.0f}"
            place = upwards((point["x"], point["y"], point["z"]))
            # Places count from an origin that is at most 16 extents away, and no window is more than 1 wide.
            assert is_near([a + b for a, b in zip(origin, rows["TRANSLATION"][i])], place, 32 * FLOAT)
            assert is_near(rows["SCALE"][i], [point["scale"]] * 3, FLOAT)
            if "class" in point:
                assert rows["_CLASS"][i] == (point["class"],)
            for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)):
                assert is_near(rotated(rows["ROTATION"][i], upwards(axis)), upwards(turned(point, axis)), 16 * FLOAT)
            numbers.append(int(number))
    assert sorted(numbers) == list(range(len(points)))
    return points


def check_scenes(folder):
    plane = "corner-c3-n64-r075.ptiles"
    assert len(check_scene(folder, "forest", plane, 5, "--density", "300", "--terrain", "x*y", "--terrain-area", "0", "0",
                           "1", "1")) > 200
    assert check_scene(folder, "sunflowers", plane, 1, "--window", "3000", "-2", "0.5", "0.5")[0]["x"] > 3000
    far = check_scene(folder, "forest", plane, 300, "--window", "900000", "0", "0.3", "0.3")
    counts = [[point["model"] for point in far].count(model) for model in range(300)]
    assert counts.count(1) > 50 and max(counts) > 1  # models of one instance stand beside others
    assert len(check_scene(folder, "asteroids", "sphere-c2-n128-r075.ptiles", 8, "--density", "1000")) > 100
    points = check_scene(folder, "forest", "corner-classes-c3-n8-16-40-r070.ptiles", 3, "--density", "300")
    assert len({point["class"] for point in points}) == 3
    few = check_scene(folder, "forest", plane, 65536, "--density", "10")  # models without instances have no node
    assert len(few) < 20


with tempfile.TemporaryDirectory() as name:
    place = pathlib.Path(name)
    (place / "box.obj").write_text(BOX)
    (place / "wedge.obj").write_text(WEDGE)
    check_surface(place)
    check_classes(place)
    check_far(place)
    check_scenes(place)
