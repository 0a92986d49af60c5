"""Turns the output of `./lab bench` into the page docs/performance.md: performance_page.py OUTPUT MESSAGES FORMER > PAGE

OUTPUT is what the benchmarks print; MESSAGES is what they say beside it, where the machine and the date are. FORMER is the
page as it was, whose sections about devices stay.
"""

import re
import sys
from pathlib import Path

from device_section import device_sections

HEAD = """# Performance

Made by `./lab bench --page`, on {date}, on {machine}, without a graphics card: kernels run
on the processor, by PoCL. Run it on your own machine to get its numbers; ratios vary less between machines than times. Benchmarks that miss their
target are marked.

Kernels are compared with programs that do without them: a plain sequential loop, the laboratory's own reference, CGAL, voro++ and
FFTW. A ratio of 5 means that the other program takes five times as long.

`./lab bench --device NAME --short` tests another device and adds a section about it at the end of this page, in at most eight
minutes. The section compares the methods with the bandwidth and arithmetic that simple kernels reach on that device.
"""

# A heading, and the words by which its ratios are known; the first that fits has a ratio.
SECTIONS = [
    ("Spectra, beside FFTW", "FFTW"),
    ("Voronoi centroids, beside CGAL and voro++", "CGAL|voro|double precision"),
    ("Lloyd relaxation of small sets: ten side by side, beside one of 16,384 points", "Lloyd iterations"),
    ("Memory", "peak, MiB"),
    ("Points that follow densities", "warping|objects in|lights|stippling|search of 20"),
    ("Dart throwing", "darts|saturation|at 0.75|after 1"),
    ("Gaussian blue noise", "Gaussian"),
    ("Aperiodic tilings", "table 8|periods|Kari|Culik|tiles as SVG"),
    ("Building tile sets", "ms$|corner set of 8|one by one"),
    ("What chains and joint relaxation gain", "chains: |excess share|mean peak|second moments"),
    ("Points of tilings", "window of|nearest point|filling"),
    ("Look-ups of tiles: other kinds beside corner tiles with the same hash", "stream_rows|look_up"),
    ("Textures: one picture again and again, beside tiles that differ", "repeated /"),
    ("Runs that are stored, and shared by processes", "unit stored|ranks"),
    ("Others", ""),
]

RATIO = re.compile(r"^  (\S.*?) {2,}(-?[\d.]+)(?:  \((?:target: )(.*)\))?$")
SCALE = re.compile(r"^(.+?) +(\d+) +([\d.]+) s +([\d.]+) s of processors +(\d+) points/s +(\d+) MiB(?:  exponent ([\d.]+))?")
ENDED = re.compile(r"^(.+?) +(\d+) (ended after .*|failed)$")


def plain(path):
    text = re.sub(r"\x1b\[[0-9;]*m", "", Path(path).read_text(encoding="utf-8", errors="replace"))
    return text.splitlines()


def machine(messages):
    text = "\n".join(messages)
    found = re.search(r"Run on \((\d+) X ([\d.]+) MHz", text)
    date = re.search(r"^(\d{4}-\d\d-\d\d)T", text, re.M)
    return (date.group(1) if date else "an unknown day",
            f"{found.group(1)} processors of {float(found.group(2)) / 1000:.1f} GHz" if found else "an unknown machine")


def sections_of(output):
    """The ratios that programs end with, by the headings that they come under."""
    sections = {heading: [] for heading, _ in SECTIONS}
    for line in output:
        if found := RATIO.match(line):
            heading = next(heading for heading, words in SECTIONS if re.search(words, found.group(1)))
            sections[heading].append(found.groups())
    return sections


def ratio_row(name, value, target):
    number = f"{float(value):,.2f}" if abs(float(value)) < 100 else f"{float(value):,.0f}"
    words = (target or "").replace(", MISSED", "").replace(".00", "")
    return f"| {name.replace('|', '/')} | {number} | {words}{', **missed**' if 'MISSED' in (target or '') else ''} |"


def scale_rows(output):
    for line in output:
        if found := SCALE.match(line):
            name, size, _, busy, _, memory, exponent = found.groups()
            yield f"| {name} | {int(size):,} | {float(busy):.2f} s | {int(memory):,} | {exponent or ''} |"
        elif found := ENDED.match(line):
            yield f"| {found.group(1)} | {int(found.group(2)):,} | {found.group(3)} | | |"


def main():
    output, messages = plain(sys.argv[1]), plain(sys.argv[2])
    date, name = machine(messages)
    print(HEAD.format(date=date, machine=name))
    rows = list(scale_rows(output))
    if rows:
        print("## What a set costs, by its size\n\nSeconds of all processors together, for one set. Methods that move "
              "points make few moves here, which is no finished set: their time is proportional to the moves. The exponent is that of processor "
              "time between the last two sizes; in proportion to N log N it is 1.08. A million points of "
              "Gaussian blue noise that are even at all distances, made coarse to fine, take some 35 s of one processor "
              "([million-points.toml](../configs/million-points.toml)); with the defaults, 1,000 moves at full size, "
              "some 200 s. Sizes to 10^7, with tilings: [sizes](scale.md).\n")
        print("| method | points | processor time | MiB | exponent |")
        print("| --- | --- | --- | --- | --- |\n" + "\n".join(rows))
    for heading, ratios in sections_of(output).items():
        if ratios:
            print(f"\n## {heading}\n\n| | | target |\n| --- | --- | --- |")
            print("\n".join(ratio_row(*ratio) for ratio in ratios))
    for section in device_sections(Path(sys.argv[3]).read_text(encoding="utf-8")).values():
        print("\n" + section, end="")


main()
