"""The numbers of docs/monotile-points.md: how points in hats and spectres fall off at low frequencies, and where their power is.

    PYTHONPATH=build/release/python python3 python/examples/monotile_numbers.py [eigenvalues|exponents|disks|directions] ...

Without words it makes all. Windows are at random places up to 2^38 edges away from the origin; errors are standard errors of
means. --windows says how many windows there are of each set; the page has those of the default.
"""

import argparse

import numpy

import poissonlab as pl

GOLDEN = (1 + 5**0.5) / 2
GROWTH = {"hat": GOLDEN**4, "spectre": 4 + 15**0.5}  # of the number of tiles in a division, by the papers
SETS = [("hat", 1, 0), ("hat", 1, 1), ("hat", 4, 0), ("spectre", 1, 0), ("spectre", 2, 1), ("spectre", 4, 0)]


def built(kind, points, levels):
    return pl.tiles.build(kind, points=points, levels=levels)


def name_of(kind, points, levels, part=1):
    ancestors = ["no ancestors", "one ancestor"][levels]
    return f"{kind}s, {points} point{'s' * (points > 1)}, {ancestors}" + (", a quarter by rank" if part < 1 else "")


class Substitution:
    """The tables of a file, read by NumPy alone: docs/tile-set-file.md."""

    def __init__(self, file):
        data = open(file, "rb").read()
        word = lambda at: int.from_bytes(data[at:at + 4], "little")
        states, points, parts, starts = word(28), word(32), word(48), word(52)
        self.kind, self.flips, self.states = ["hat", "spectre"][word(24)], word(56), states
        record = numpy.dtype([("state", "<u4"), ("place", "<i2", 4), ("turn", "<u2"), ("order", "<u2")])
        at = 128 + 16 * (points + starts)
        self.parts = numpy.frombuffer(data, record, parts, at)
        rows = numpy.frombuffer(data, numpy.dtype([("first", "<u4"), ("count", "<u2"), ("own", "<u2")]), states, at + 16 * parts)
        self.whole = numpy.repeat(numpy.arange(states), rows["count"])

    def moduli(self, turns):
        """The moduli, per division, of the eigenvalues by which sums over the tiles of a tile grow that turn with it so many
        times: 0 for numbers, 1 for vectors, 2 for quadrupoles. Where divisions mirror, two of them are one linear map."""
        matrix = numpy.zeros((self.states, self.states), complex)
        numpy.add.at(matrix, (self.whole, self.parts["state"]), numpy.exp(1j * numpy.pi / 3 * turns * self.parts["turn"]))
        twice = (matrix.conj() if self.flips else matrix) @ matrix
        return numpy.sort(abs(numpy.linalg.eigvals(twice)))[::-1]**0.5


def print_eigenvalues(_):
    print("\n| | numbers | the next one | dipoles | the next one | quadrupoles |\n| --- | --- | --- | --- | --- | --- |")
    for kind, points, levels in SETS:
        made = pl.tiles.keys(kind=kind, points=points, levels=levels)
        numbers, dipoles, quadrupoles = (Substitution(made.files[0]).moduli(turns) for turns in range(3))
        print(f"| {name_of(kind, points, levels)} | {numbers[0]:.6f} | {numbers[1]:.4f} | {dipoles[0]:.6f} | {dipoles[1]:.4f} "
              f"| {quadrupoles[0]:.4f} |")


def windows(tiles, half, count, random, density=1.0):
    """Yields positions in squares around random places of the tiling."""
    for _ in range(count):
        origin = tuple(int(v) for v in random.integers(-2**38, 2**38, 2))
        middle = random.uniform(0, 1, 2)  # any place is as likely as others
        yield tiles.window(*(middle - half), 2 * half, 2 * half, origin=origin, density=density,
                           seed=int(random.integers(2**32))) - middle


def mean_and_error(values):
    values = numpy.asarray(values)
    return values.mean(axis=0), values.std(axis=0, ddof=1) / len(values)**0.5


def exponent_of(kind, tiles, part, count, least=3.0, groups=8, steps=8):
    """The power by which the variance of points weighted by Gaussians, over that of random points, falls with their width: from
    widths of two divisions to those two divisions wider, as a mean over these, since it goes up and down with that period.
    Returns the power, its error by the jackknife, the variance in the widest Gaussian, its error, and the least and largest
    width in mean spacings."""
    random = numpy.random.default_rng(1)
    density = tiles.density * part
    spacing = density**-0.5
    widths = least * spacing * GROWTH[kind]**(numpy.arange(2 * steps) / steps)
    reach = 6.2  # weights beyond it are below 10^-8
    squares = []
    for points in windows(tiles, reach * widths[-1], count, random, part):
        distances = numpy.sort((points**2).sum(axis=1))
        ends = numpy.searchsorted(distances, (reach * widths)**2)
        sums = [numpy.exp(distances[:end] / (-2 * width**2)).sum() for width, end in zip(widths, ends)]
        expected = 2 * numpy.pi * density * widths**2 * (1 - numpy.exp(-reach**2 / 2))
        squares.append((numpy.array(sums) - expected)**2 / (numpy.pi * density * widths**2))
    squares = numpy.array(squares)
    power = lambda rows: -numpy.log(rows.mean(axis=0)[steps:] / rows.mean(axis=0)[:steps]).mean() / numpy.log(GROWTH[kind])
    group = numpy.arange(count) % groups
    others = numpy.array([power(squares[group != left_out]) for left_out in range(groups)])
    error = ((groups - 1) * others.var())**0.5
    return power(squares), error, *(v[-1] for v in mean_and_error(squares)), widths[0] / spacing, widths[-1] / spacing


def print_exponents(count):
    print("\n| | exponent | variance in the widest Gaussian, over that of random points | from, to (mean spacings) |\n"
          "| --- | --- | --- | --- |")
    for kind, points, levels in SETS:
        tiles = built(kind, points, levels)
        for part in [1, 0.25] if points == 4 else [1]:
            value, error, widest, uncertain, first, last = exponent_of(kind, tiles, part, count)
            print(f"| {name_of(kind, points, levels, part)} | {value:.2f} ± {error:.2f} | {widest:.1e} ± {uncertain:.0e} "
                  f"| {first:.0f}, {last:.0f} |", flush=True)


def print_disks(count):
    """The variance of the number of points in disks."""
    print("\n| | power of the radius | variance in disks of 41 mean spacings |\n| --- | --- | --- |")
    random = numpy.random.default_rng(2)
    radii = numpy.geomspace(4, 41, 12)
    for kind in ["hat", "spectre"]:
        tiles = built(kind, 4, 0)
        spacing = tiles.density**-0.5
        counts = []
        for points in windows(tiles, 8 * 41 * spacing, max(8, count // 4), random):
            middles = random.uniform(-7 * 41, 7 * 41, (100, 2)) * spacing
            order = numpy.argsort(points[:, 0])
            points = points[order]
            for middle in middles:
                first, last = numpy.searchsorted(points[:, 0], middle[0] + numpy.array([-42, 42]) * spacing)
                squared = ((points[first:last] - middle)**2).sum(axis=1)
                counts.append([(squared < (radius * spacing)**2).sum() for radius in radii])
        squares = (numpy.array(counts) - numpy.pi * radii**2)**2
        variances = squares.reshape(8, -1, len(radii)).mean(axis=1)
        slopes = [numpy.polyfit(numpy.log(radii), numpy.log(row), 1)[0] for row in variances]
        mean, error = mean_and_error(slopes)
        largest, uncertain = mean_and_error(variances[:, -1])
        print(f"| {kind}s, 4 points | {mean:.2f} ± {error:.2f} | {largest:.1f} ± {uncertain:.1f} |", flush=True)


def print_directions(count):
    """The variance of the power on circles over its squared mean, and of means over turned windows."""
    print("\n| | power on circles | mean over sixths | mean over twelfths |\n| --- | --- | --- | --- |")
    random = numpy.random.default_rng(3)
    deviation, angles, between = 16, 360, 0.05
    frequencies = numpy.arange(0.5, 1.8, between)
    for kind in ["hat", "spectre"]:
        tiles = built(kind, 4, 0)
        spacing = tiles.density**-0.5
        found = []
        for points in windows(tiles, 6 * deviation * spacing, max(4, count // 16), random):
            points = points / spacing
            weights = numpy.exp((points**2).sum(axis=1) / (-2 * deviation**2))
            # Sums at opposite frequencies are conjugate: half of the circle has all powers. From one frequency of a
            # direction to the next one, all waves turn by the same factors.
            power = numpy.empty((len(frequencies), angles))
            for k, turn in enumerate(2 * numpy.pi * numpy.arange(angles // 2) / angles):
                phases = -2j * numpy.pi * (points @ [numpy.cos(turn), numpy.sin(turn)])
                waves, factors = weights * numpy.exp(frequencies[0] * phases), numpy.exp(between * phases)
                for row in power:
                    row[[k, k + angles // 2]] = abs(waves.sum())**2
                    waves *= factors
            ratio = lambda p: p.var() / p.mean()**2
            ratios = [[ratio(row)] + [ratio(row.reshape(n, -1).mean(axis=0)) for n in (6, 12)] for row in power]
            found.append(10 * numpy.log10(numpy.mean(ratios, axis=0)))
        mean, error = mean_and_error(found)
        print(f"| {kind}s, 4 points |" + "".join(f" {m:.1f} ± {e:.1f} dB |" for m, e in zip(mean, error)), flush=True)


if __name__ == "__main__":
    WORK = {"eigenvalues": print_eigenvalues, "exponents": print_exponents, "disks": print_disks, "directions": print_directions}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", metavar="WORD", help=", ".join(WORK))
    parser.add_argument("--windows", type=int, default=96, help="windows of each set, a multiple of 8")
    given = parser.parse_args()
    for word in given.words or WORK:
        if word not in WORK:
            parser.error(f"{word}: must be one of {', '.join(WORK)}")
        WORK[word](given.windows)
