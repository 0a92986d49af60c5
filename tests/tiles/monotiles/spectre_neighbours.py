"""Counts the neighbourhoods of spectres, in a tiling made by the rules of its authors and without the program's code.

Smith, Myers, Kaplan and Goodman-Strauss, A chiral aperiodic monotile, 2024 (arXiv 2305.17743): nine marked hexagons,
of which Gamma is a Mystic of two spectres, and the table of their parts. The script counts the pairs of marked
spectres that touch each other, as seen from the first one, and the coronas of marked spectres; it ends with status 1
if the numbers differ from those that tests/host/tile_sampling/monotiles expects of the program.
"""
import cmath
import collections
import math
import sys

EXPECTED = {"pairs": 119, "coronas": 42}

R = math.sqrt(3) / 2
SHAPE = [complex(*p) for p in (
    (0, 0), (1, 0), (1.5, -R), (1.5 + R, 0.5 - R), (1.5 + R, 1.5 - R), (2.5 + R, 1.5 - R), (3 + R, 1.5), (3, 2),
    (3 - R, 1.5), (2.5 - R, 1.5 + R), (1.5 - R, 1.5 + R), (0.5 - R, 1.5 + R), (-R, 1.5), (0, 1))]
QUAD = [SHAPE[3], SHAPE[5], SHAPE[7], SHAPE[11]]
PARTS = {
    "Gamma": "Pi Delta - Theta Sigma Xi Phi Gamma", "Delta": "Xi Delta Xi Phi Sigma Pi Phi Gamma",
    "Theta": "Psi Delta Pi Phi Sigma Pi Phi Gamma", "Lambda": "Psi Delta Xi Phi Sigma Pi Phi Gamma",
    "Xi": "Psi Delta Pi Phi Sigma Psi Phi Gamma", "Pi": "Psi Delta Xi Phi Sigma Psi Phi Gamma",
    "Sigma": "Xi Delta Xi Phi Sigma Pi Lambda Gamma", "Phi": "Psi Delta Psi Phi Sigma Pi Phi Gamma",
    "Psi": "Psi Delta Psi Phi Sigma Psi Phi Gamma"}
STEPS = [(60, 3, 1), (0, 2, 0), (60, 3, 1), (60, 3, 1), (0, 2, 0), (60, 3, 1), (-120, 3, 3)]
DEPTH = 4


def moved(motion, z):
    """A motion is (at, turn, mirrored): z goes to at + turn z, or to at + turn conj(z)."""
    at, turn, mirrored = motion
    return at + turn * (z.conjugate() if mirrored else z)


def after(second, first):
    return (moved(second, first[0]), second[1] * (first[1].conjugate() if second[2] else first[1]), second[2] != first[2])


def inverse(motion):
    at, turn, mirrored = motion
    back = turn if mirrored else turn.conjugate()  # turns have length 1
    return (-back * (at.conjugate() if mirrored else at), back, mirrored)


def supertile(quad):
    """Returns the motions of the eight parts, and the four key points of the whole."""
    motions, angle = [(0j, 1 + 0j, False)], 0
    for turn, of_last, of_next in STEPS:
        angle += turn
        rotation = cmath.rect(1, math.radians(angle))
        motions.append((moved(motions[-1], quad[of_last]) - rotation * quad[of_next], rotation, False))
    motions = [after((0j, -1 + 0j, True), m) for m in motions]  # x becomes -x
    keys = [moved(motions[i], quad[k]) for i, k in ((6, 2), (5, 1), (3, 2), (0, 1))]
    return motions, keys


def tiling():
    """Returns the spectres of a Delta after some divisions: (label, motion)."""
    tiles = {name: [(name, (0j, 1 + 0j, False))] for name in PARTS}
    tiles["Gamma"].append(("upper", (SHAPE[8], cmath.rect(1, math.pi / 6), False)))
    quad = QUAD
    for _ in range(DEPTH):
        motions, keys = supertile(quad)
        tiles = {name: [(label, after(motion, own)) for motion, part in zip(motions, parts.split()) if part != "-"
                        for label, own in tiles[part]] for name, parts in PARTS.items()}
        quad = keys
    return tiles["Delta"]


def rounded(z):
    return (round(z.real * 1000), round(z.imag * 1000))


def angles():
    """Returns the inner angles of the spectre's corners, in twelfths of a turn."""
    sides = [(SHAPE[(i + 1) % 14] - SHAPE[i]) / (SHAPE[i - 1] - SHAPE[i]) for i in range(14)]
    return [round(-cmath.phase(side) / (math.pi / 6)) % 12 for side in sides]


def main():
    tiles = tiling()
    around, sums = collections.defaultdict(set), collections.Counter()
    corners = []
    for number, (_, motion) in enumerate(tiles):
        corners.append([rounded(moved(motion, p)) for p in SHAPE])
        for corner, angle in zip(corners[-1], angles()):
            around[corner].add(number)
            sums[corner] += angle
    if max(sums.values()) > 12:
        sys.exit("spectres overlap")
    pairs, coronas = set(), set()
    for number, (label, motion) in enumerate(tiles):
        back = inverse(motion)
        corona = set()
        for other in {n for corner in corners[number] for n in around[corner]} - {number}:
            at, turn, _ = after(back, tiles[other][1])
            corona.add((tiles[other][0], rounded(at), rounded(turn)))
        pairs |= {(label, *seen) for seen in corona}
        if all(sums[corner] == 12 for corner in corners[number]):
            coronas.add((label, frozenset(corona)))
    found = {"pairs": len(pairs), "coronas": len(coronas)}
    print(len(tiles), "spectres:", found)
    if found != EXPECTED:
        sys.exit(f"expected {EXPECTED}")


main()
