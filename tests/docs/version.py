"""Checks that every page and package names the version of project() in CMakeLists.txt: version.py SOURCE."""

import re
import sys
from pathlib import Path

PLACES = {
    "CHANGELOG.md": r"^## (\S+), \d{4}-\d\d-\d\d$",
    "CITATION.cff": r"^version: (\S+)$",
    "README.md": r"version = \{(\S+)\}",
    "docs/drop-ins.md": r"poissonlab-runtime-(\d+\.\d+\.\d+)\.tgz",
    "runtime/package.json": r'"version": "([^"]+)"',
}


def main(source):
    def first(name, pattern):
        found = re.search(pattern, (source / name).read_text(encoding="utf-8"), re.M)
        return found and found[1]

    version = first("CMakeLists.txt", r"project\(\w+ VERSION (\S+)")
    others = {name: first(name, pattern) for name, pattern in PLACES.items()}
    for name, other in others.items():
        if other != version:
            print(f"{name}: names version {other}, CMakeLists.txt {version}")
    return any(other != version for other in others.values())


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
