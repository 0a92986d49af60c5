"""The Dockerfile installs what ./lab installs to build everything, and nothing that ./lab does not name: dockerfile.py SOURCE"""

import re
import sys
from pathlib import Path

# These make the Debian package and the Python package in it; the table of tests has them among others.
OF_PACKAGES = {"dpkg-dev", "file", "pybind11-dev", "python3-dev", "python3-numpy"}


def tables(lab):
    """Returns the names of packages in the tables of ./lab, by the table's name."""
    found = {}
    for name, body in re.findall(r"^(\w+)_packages=['\"]\n(.*?)['\"]$", lab, re.M | re.S):
        found[name] = {line.split()[0] for line in body.splitlines() if line and line[0] != "$"}
    return found


def main():
    source = Path(sys.argv[1])
    by_table = tables((source / "lab").read_text(encoding="utf-8"))
    needed = set().union(*(by_table[name] for name in ("run", "regions", "textures", "particles"))) | OF_PACKAGES
    assert len(needed) > 30 and OF_PACKAGES <= by_table["test"], "the tables of ./lab are not what this test knows"
    dockerfile = (source / "Dockerfile").read_text(encoding="utf-8").replace("\\\n", " ")
    build, final = dockerfile.split("\nFROM ")[1:]
    installed = set(re.search(r"--no-install-recommends (.*)", build)[1].split())
    assert build.startswith("debian:12-slim AS build\n") and final.startswith("debian:12-slim\n"), "another Debian than ./lab's"
    assert installed == needed, f"missing: {sorted(needed - installed)}; too many: {sorted(installed - needed)}"
    print(f"{len(installed)} packages")


main()
