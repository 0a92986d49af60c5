#!/usr/bin/env python3
"""Draws two sets of Wang tiles in the spirit of figure 3 of Cohen and others, 2003, which has line patterns.

    python3 draw_tiles.py lines > lines.json      # or leaves
    poissonlab texture design wang --colors 2 --size 64 --out design.html

The page takes the file up by "Open drawing", and saves a texture set, which `poissonlab texture verify` proves to fit."""
import json
import math
import random
import sys

SIZE, RING, RADIUS = 64, 4, 2.2
STUB = RING + RADIUS + 3.3  # so far from a border marks belong to one tile alone
CROSSINGS = {"n": ((20, 44), (28, 36)), "e": ((14, 40), (24, 50))}  # of both colours along horizontal and vertical edges


def mark(tile, x, y, radius, color, shape="disk", turn=0.0):
    return {"tile": tile, "x": round(16 * x) / 16, "y": round(16 * y) / 16, "radius": radius, "shape": shape,
            "color": color, "turn": round(turn, 3)}


def line(tile, points, color):
    marks, (x, y) = [], points[0]
    marks.append(mark(tile, x, y, RADIUS, color))
    for end in points[1:]:
        if math.hypot(end[0] - x, end[1] - y) >= 1.2:
            x, y = end
            marks.append(mark(tile, x, y, RADIUS, color))
    return marks


def curve(a, b):
    """From one end of a stub to another: a cubic that leaves both at a right angle to their edges."""
    (ax, ay, au, av), (bx, by, bu, bv) = a, b
    pull = 0.45 * math.hypot(bx - ax, by - ay) + 3
    xs, ys = (ax, ax + pull * au, bx + pull * bu, bx), (ay, ay + pull * av, by + pull * bv, by)
    weights = lambda t: ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
    return [tuple(sum(w * p for w, p in zip(weights(i / 60), ps)) for ps in (xs, ys)) for i in range(61)]


def ends(tile):
    """The ends of the eight stubs of a tile, clockwise from the north-west, with directions inwards."""
    north, east, south, west = (tile >> shift & 1 for shift in (3, 2, 1, 0))
    return ([(p, STUB, 0, 1) for p in CROSSINGS["n"][north]] + [(SIZE - STUB, p, -1, 0) for p in CROSSINGS["e"][east]] +
            [(p, SIZE - STUB, 0, -1) for p in CROSSINGS["n"][south][::-1]] + [(STUB, p, 1, 0) for p in CROSSINGS["e"][west][::-1]])


def lines():
    dark, strokes = [40, 52, 84], []
    for color in (0, 1):  # the stubs of each colour, from a tile that has it in the north and the west
        tile = 9 * color
        for p in CROSSINGS["n"][color]:
            strokes.append(line(tile, [(p, i * 0.6) for i in range(int(STUB / 0.6) + 1)], dark))
            strokes.append(line(2 * color, [(p, SIZE - i * 0.6) for i in range(int(STUB / 0.6) + 1)], dark))
        for p in CROSSINGS["e"][color]:
            strokes.append(line(tile, [(i * 0.6, p) for i in range(int(STUB / 0.6) + 1)], dark))
            strokes.append(line(4 * color, [(SIZE - i * 0.6, p) for i in range(int(STUB / 0.6) + 1)], dark))
    pairings = ([(1, 2), (3, 4), (5, 6), (7, 0)], [(0, 5), (1, 4), (2, 7), (3, 6)], [(0, 1), (2, 7), (3, 6), (4, 5)],
                [(0, 5), (1, 2), (3, 4), (6, 7)])
    for tile in range(16):
        at = ends(tile)
        for a, b in pairings[(5 * tile + tile // 4) % 4]:
            strokes.append(line(tile, curve(at[a], at[b]), dark))
    return [236, 228, 206], strokes


def leaves():
    numbers = random.Random(3)
    greens, strokes = ([58, 104, 52], [96, 140, 66], [150, 168, 80], [182, 120, 52]), []
    leaf = lambda tile, x, y, radius: strokes.append(
        [mark(tile, x, y, radius, numbers.choice(greens), "leaf", numbers.uniform(-3, 3))])
    for color in (0, 1):
        for i in range(4):  # leaves on both sides of an edge: in a tile north or south, east or west of it
            along, off, radius = 20 + 8 * i + numbers.uniform(-3, 3), numbers.uniform(-9, 9), numbers.uniform(6, 9)
            leaf(8 * color if off >= 0 else 2 * color, along, off % SIZE, radius)
            along, off, radius = 20 + 8 * i + numbers.uniform(-3, 3), numbers.uniform(-9, 9), numbers.uniform(6, 9)
            leaf(color if off >= 0 else 4 * color, off % SIZE, along, radius)
    for x, y in ((2, 3), (SIZE - 9, 1), (1, SIZE - 7)):
        leaf(0, x, y, 7)
    for tile in range(16):
        for _ in range(13):
            radius = numbers.uniform(5, 9)
            low = RING + radius + 1.2
            leaf(tile, numbers.uniform(low, SIZE - low), numbers.uniform(low, SIZE - low), radius)
    return [232, 222, 198], strokes


drawings = {"lines": lines, "leaves": leaves}
if sys.argv[1:] not in [[name] for name in drawings]:
    sys.exit(f"draw_tiles.py: needs the name of one drawing: {' or '.join(drawings)}")
background, strokes = drawings[sys.argv[1]]()
firsts, marks = [], []
for stroke in strokes:
    firsts.append(len(marks))
    marks += stroke
print(json.dumps({"format": "poissonlab drawn tiles", "kind": "wang", "colors": 2, "size": SIZE, "ring": RING,
                  "background": background, "strokes": firsts, "marks": marks}))
