"""Derives the aperiodic set of 24 Wang tiles over 24 colours from Ammann's set A2, without the program's code.

Gruenbaum and Shephard, Tilings and Patterns, 1986, chapters 10 and 11: Ammann's A2 has two L-shaped tiles, and the
larger one is cut into a smaller copy of itself and the other one. All coordinates are exact: lengths along x are
p + q g, with the golden ratio g, and lengths along y are such numbers times the root of g.

Tiles of A2 are a square grid once the edges that end at two junctions of three tiles, between two large tiles, are
shrunk to one of their ends: an edge of length 1 to its end at a corner of the tile with its short side there, an L-shaped
one to the end of its part along y. A Wang tile is what a tile of A2 looks like then, with long sides upright. Sides have the same colour
where they meet somewhere in the tiling, and no other reason makes two colours one.

The script prints the tiles, and ends with status 1 if they are not the list in tiles/aperiodic/aperiodic_sets.cpp.
"""
import collections
import pathlib
import re
import sys

STEPS = 14
GOLD = (1 + 5 ** 0.5) / 2  # orders lengths only
ZERO, ONE, G, G2, INV = (0, 0), (1, 0), (0, 1), (1, 1), (-1, 1)
LARGE = [(ZERO, ZERO), (G2, ZERO), (G2, ONE), (G, ONE), (G, G), (ZERO, G)]
SMALL = [(ZERO, ZERO), (G, ZERO), (G, ONE), (ONE, ONE), (ONE, G), (ZERO, G)]
DIRECTIONS = [(1, 0), (0, 1), (-1, 0), (0, -1)]


def plus(a, b, sign=1):
    return a[0] + sign * b[0], a[1] + sign * b[1]


def value(a):
    return a[0] + a[1] * GOLD


def vector(u, v):
    return plus(v[0], u[0], -1), plus(v[1], u[1], -1)


def substituted(tiles):
    """Enlarges by the root of g and reflects in a diagonal, so that long sides stay along x: (x, y) -> (g y, x)."""
    def moved(x, y):
        return (y[1], y[0] + y[1]), x

    for is_large, (x, y), sx, sy in tiles:
        if is_large:
            yield True, moved(x, plus(y, G, sy)), -sy, sx
            yield False, moved(plus(x, G2, sx), y), sy, -sx
        else:
            yield True, moved(x, y), sy, sx


def corners(tile):
    is_large, (x, y), sx, sy = tile
    points = [(plus(x, u, sx), plus(y, v, sy)) for u, v in (LARGE if is_large else SMALL)]
    return points if sx * sy > 0 else points[::-1]  # counterclockwise


def outlines(tiles):
    """The corners of all tiles on the outline of each, counterclockwise."""
    on_line = [collections.defaultdict(list), collections.defaultdict(list)]
    for point in {p for t in tiles for p in corners(t)}:
        for axis in (0, 1):
            on_line[axis][point[axis]].append(point)
    for points in map(corners, tiles):
        outline = []
        for p, q in zip(points, points[1:] + points[:1]):
            fixed = 0 if p[0] == q[0] else 1
            low, high = sorted((value(p[1 - fixed]), value(q[1 - fixed])))
            between = [z for z in on_line[fixed][p[fixed]] if low <= value(z[1 - fixed]) <= high]
            between.sort(key=lambda z: value(z[1 - fixed]), reverse=low == value(q[1 - fixed]))
            outline += between[:-1]
        yield outline


def boundaries(tiles):
    """Each tile's list of (path, neighbour) between junctions, and the number of edges at each point."""
    all_outlines = list(outlines(tiles))
    owner = {(u, v): i for i, o in enumerate(all_outlines) for u, v in zip(o, o[1:] + o[:1])}
    ends = collections.Counter(u for e in {frozenset(e) for e in owner} for u in e)
    result = []
    for outline in all_outlines:
        first = [k for k, p in enumerate(outline) if ends[p] > 2]
        paths = [(outline + outline)[a:b + 1] for a, b in zip(first, first[1:] + [first[0] + len(outline)])]
        result.append([(path, owner.get((path[1], path[0]))) for path in paths])
    return result, ends


def shrunk(tiles, sides, ends):
    """Paths to the point that an edge becomes, from each of its ends."""
    to_base = {}
    for i, around in enumerate(sides):
        for path, j in around:
            if j is None or not (tiles[i][0] and tiles[j][0]) or {ends[path[0]], ends[path[-1]]} != {3}:
                continue
            steps = [vector(u, v) for u, v in zip(path, path[1:])]
            absolute = sorted(max(s, plus(ZERO, s, -1), key=value) for v in steps for s in v if s != ZERO)
            if absolute == [ONE] and steps[0][1] == ZERO:
                base = [p for p in (path[0], path[-1]) if p[0] == tiles[i][1][0] and p[1] != tiles[i][1][1]]
            elif absolute == sorted([ONE, INV]):
                base = [p for p in (path[0], path[-1]) if p[0] == path[1][0]]
            else:
                continue
            if base:
                way = path if base[0] == path[-1] else path[::-1]
                to_base[way[0]], to_base[way[-1]] = way, way[-1:]
    return to_base


def shape(path, to_base):
    """The steps of a side from base to base, straight parts in one."""
    points = to_base.get(path[0], path[:1])[::-1] + path[1:-1] + to_base.get(path[-1], path[-1:])
    steps = []
    for step in (vector(u, v) for u, v in zip(points, points[1:])):
        if steps and (steps[-1][0] == ZERO) == (step[0] == ZERO):
            steps[-1] = plus(steps[-1][0], step[0]), plus(steps[-1][1], step[1])
        else:
            steps.append(step)
    return tuple(steps)


def grid(four):
    """Places of tiles with four known sides, from one of them on, and the side of each that is its east."""
    start = len(four) // 2
    while start not in four:
        start += 1
    east = max(range(4), key=lambda k: sum(value(p[0]) for p in four[start][k][0]) / len(four[start][k][0]))
    places, first, queue = {start: (0, 0)}, {start: east}, [start]
    for i in queue:
        for d, (dx, dy) in enumerate(DIRECTIONS):
            path, j = four[i][(first[i] + d) % 4]
            if j not in four:
                continue
            place = places[i][0] + dx, places[i][1] + dy
            side = next(k for k, s in enumerate(four[j]) if s[0] == path[::-1])
            turned = (side - d - 2) % 4
            if j not in places:
                places[j], first[j] = place, turned
                queue.append(j)
            assert places[j] == place and first[j] == turned, "the tiles are no grid"
    assert len(set(places.values())) == len(places), "two tiles have one place"
    return places, first


def wang_tiles():
    tiles = [(True, (ZERO, ZERO), 1, 1)]
    for _ in range(STEPS):
        tiles = list(substituted(tiles))
    sides, ends = boundaries(tiles)
    to_base = shrunk(tiles, sides, ends)
    inner = {i for i, s in enumerate(sides) if all(j is not None for _, j in s)}
    four = {}
    for i in inner:
        kept = [s for s in sides[i] if not (s[0][0] in to_base and to_base[s[0][0]][-1] == to_base.get(s[0][-1], [0])[-1])]
        assert len(kept) == 4, "a tile has no four sides"
        four[i] = kept
    places, first = grid(four)
    at = {p: i for i, p in places.items()}
    deep = {i for i in places if all(j in inner and all(k in inner for _, k in four[j]) for _, j in four[i])}
    look = {i: tuple(shape(four[i][(first[i] + d) % 4][0], to_base) for d in range(4)) for i in deep}
    parent = {}

    def root(x):
        while parent.setdefault(x, x) != x:
            x = parent[x]
        return x

    for i in deep:
        for d, (dx, dy) in enumerate(DIRECTIONS[:2]):
            j = at.get((places[i][0] + dx, places[i][1] + dy))
            if j in look:
                a, b = root((look[i], d)), root((look[j], d + 2))
                parent[max(a, b)] = min(a, b)
    looks = sorted(set(look.values()))
    numbers = [sorted({root((l, d)) for l in looks for d in pair}) for pair in ((0, 2), (1, 3))]
    digit = lambda l, d: "0123456789ab"[numbers[d % 2].index(root((l, d)))]
    return sorted("".join(digit(l, d) for d in (2, 3, 0, 1)) for l in looks), [len(n) for n in numbers]


found, colors = wang_tiles()
print(" ".join(found), colors)
source = pathlib.Path(__file__).resolve().parents[3] / "tiles/aperiodic/aperiodic_sets.cpp"
listed = re.search(r"robinson_tiles\(\)\n\{.*?\}", source.read_text(), re.S)
sys.exit(listed is None or sorted(re.findall(r'"(\w{4})"', listed.group())) != found)
