#!/usr/bin/python3
"""Writes the meshes that configs/surfaces.toml and docs/surfaces.md use: a torus (OBJ, quads), a bumpy sphere (OFF),
and a vase with texture coordinates (OBJ).

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


if __name__ == "__main__":
    main()
