"""Checks that every page and package names the version of project() in CMakeLists.txt, wherever it names one; the newest
section of CHANGELOG.md does: version.py SOURCE."""

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
    def all_in(name, pattern):
        return re.findall(pattern, (source / name).read_text(encoding="utf-8"), re.M)

    versions = all_in("CMakeLists.txt", r"project\(\w+ VERSION (\S+)")
    others = {name: all_in(name, pattern) for name, pattern in PLACES.items()}
    others["CHANGELOG.md"] = others["CHANGELOG.md"][:1]
    wrong = {name: found for name, found in others.items() if len(versions) != 1 or set(found) != set(versions)}
    for name, found in wrong.items():
        print(f"{name}: names version {' and '.join(found) or 'none'}, CMakeLists.txt {' and '.join(versions) or 'none'}")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
