#!/usr/bin/python3
"""Writes the meshes that configs/surfaces.toml and docs/surfaces.md use: a torus (OBJ, quads), a bumpy sphere (OFF),
a vase with texture coordinates (OBJ), a chair and two rings of cubes (OBJ, quads in whose corners 3, 4 and 5 meet), and a
ring of triangles beside the same triangles on cubes (OBJ).

    /usr/bin/python3 configs/surfaces/make_meshes.py [FOLDER]
"""
import math
import pathlib
import sys


def torus(around=48, across=24, radius=1.0, tube=0.4):
    """Vertices and quads of a torus around the z axis."""
    vertices, faces = [], []
    for i in range(around):
        for j in range(across):
            u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
            distance = radius + tube * math.cos(v)
            vertices.append((distance * math.cos(u), distance * math.sin(u), tube * math.sin(v)))
            right, up = (i + 1) % around, (j + 1) % across
            faces.append((i * across + j, right * across + j, right * across + up, i * across + up))
    return vertices, faces


def icosphere(halvings):
    """Vertices on the unit sphere and triangles: an icosahedron whose triangles are divided into four, again and
    again."""
    g = (1 + math.sqrt(5)) / 2
    vertices = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
                (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    vertices = [tuple(c / math.hypot(*v) for c in v) for v in vertices]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    for _ in range(halvings):
        middles, divided = {}, []

        def middle(a, b):
            key = min(a, b), max(a, b)
            if key not in middles:
                sums = [p + q for p, q in zip(vertices[a], vertices[b])]
                vertices.append(tuple(c / math.hypot(*sums) for c in sums))
                middles[key] = len(vertices) - 1
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            divided += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = divided
    return vertices, faces


def bumpy_sphere():
    """A sphere with waves."""
    vertices, faces = icosphere(3)
    waved = []
    for x, y, z in vertices:
        r = 1 + 0.18 * math.sin(4 * x + 1) * math.sin(5 * y) + 0.12 * math.cos(6 * z)
        waved.append((r * x, r * y, r * z))
    return waved, faces


def vase(around=32, rings=20):
    """Vertices, texture coordinates and quads of a vase around the z axis, open above and below. u goes around it, from 0
    to 1, v is the length of its profile in parts of the mean circle. One seam runs from below to above: its vertices are
    there once, its texture coordinates twice."""
    def profile(t):
        return 0.45 + 0.2 * math.sin(2 * math.pi * (0.9 * t + 0.05)), 1.6 * t

    lengths, radii = [0.0], []
    for i in range(rings):
        here, there = profile(i / rings), profile((i + 1) / rings)
        step = math.dist(here, there)
        lengths.append(lengths[-1] + step)
        radii.append((here[0] + there[0]) / 2 * step)
    circle = 2 * math.pi * sum(radii) / lengths[-1]
    vertices, texture, faces = [], [], []
    for i in range(rings + 1):
        radius, height = profile(i / rings)
        for j in range(around + 1):
            angle = 2 * math.pi * j / around
            if j < around:
                vertices.append((radius * math.cos(angle), radius * math.sin(angle), height))
            texture.append((j / around, lengths[i] / circle))
    for i in range(rings):
        for j in range(around):
            right = (j + 1) % around
            corners = (i * around + j, i * around + right, (i + 1) * around + right, (i + 1) * around + j)
            first = i * (around + 1) + j
            faces.append(tuple(zip(corners, (first, first + 1, first + around + 2, first + around + 1))))
    return vertices, texture, faces


def polycube(cubes, parts=1):
    """Returns vertices and quads of the surface of unit cubes, each square divided into parts x parts."""
    there, numbers, vertices, faces = set(cubes), {}, [], []
    for cube in sorted(there):
        for axis in range(3):
            for upper in (0, 1):
                beside = list(cube)
                beside[axis] += 2 * upper - 1
                if tuple(beside) in there:
                    continue
                u, v = ((axis + 1) % 3, (axis + 2) % 3) if upper else ((axis + 2) % 3, (axis + 1) % 3)
                for i in range(parts):
                    for j in range(parts):
                        quad = []
                        for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                            corner = [c * parts for c in cube]
                            corner[axis] += upper * parts
                            corner[u] += i + di
                            corner[v] += j + dj
                            number = numbers.setdefault(tuple(corner), len(vertices))
                            if number == len(vertices):
                                vertices.append(tuple(c / parts for c in corner))
                            quad.append(number)
                        faces.append(tuple(quad))
    return vertices, faces


def chair():
    """Returns the cubes of a seat with a back, at whose corners 3, 4 and 5 squares meet."""
    return [(x, y, 0) for x in range(2) for y in range(2)] + [(x, 1, 1) for x in range(2)]


def two_rings():
    """Returns the cubes of a figure of eight, whose surface has genus 2."""
    return [(x, y, 0) for x in range(5) for y in range(3) if y != 1 or x % 2 == 0]


def relaxed(vertices, faces, rounds):
    """Moves each vertex to the mean of its neighbours, so many rounds."""
    near = [set() for _ in vertices]
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            near[a].add(b)
            near[b].add(a)
    for _ in range(rounds):
        vertices = [tuple(sum(vertices[n][k] for n in sorted(ns)) / len(ns) for k in range(3)) for ns in near]
    return vertices


def ring_and_its_cubes():
    """Returns the vertices of a ring with a bump, of genus 1, those on the surface of nine cubes, and the triangles of both."""
    cubes = [(x, y, 0) for x in range(3) for y in range(3) if (x, y) != (1, 1)] + [(0, 0, 1)]
    vertices, quads = polycube(cubes, 4)
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    return relaxed(vertices, quads, 6), vertices, triangles


def write_obj(path, vertices, faces, texture=()):
    """Corners of faces are numbers of vertices, or, with texture coordinates, pairs."""
    with open(path, "w", encoding="ascii") as file:
        for v in vertices:
            file.write("v %.6g %.6g %.6g\n" % v)
        for t in texture:
            file.write("vt %.6g %.6g\n" % t)
        for face in faces:
            corners = ("/".join(str(i + 1) for i in corner) if texture else str(corner + 1) for corner in face)
            file.write("f " + " ".join(corners) + "\n")


def write_off(path, vertices, faces):
    with open(path, "w", encoding="ascii") as file:
        file.write("OFF\n%d %d 0\n" % (len(vertices), len(faces)))
        for v in vertices:
            file.write("%.6g %.6g %.6g\n" % v)
        for face in faces:
            file.write(" ".join(str(i) for i in (len(face), *face)) + "\n")


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    write_obj(folder / "torus.obj", *torus())
    vertices, texture, faces = vase()
    write_obj(folder / "vase.obj", vertices, faces, texture)
    write_off(folder / "bumpy-sphere.off", *bumpy_sphere())
    write_obj(folder / "chair.obj", *polycube(chair()))
    write_obj(folder / "two-rings.obj", *polycube(two_rings()))
    ring, cubes, triangles = ring_and_its_cubes()
    write_obj(folder / "ring.obj", ring, triangles)
    write_obj(folder / "ring-on-cubes.obj", cubes, triangles)


if __name__ == "__main__":
    main()
