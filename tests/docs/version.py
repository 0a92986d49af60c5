"""Checks that every page and package names the version of project() in CMakeLists.txt, wherever it names one; the newest
section of CHANGELOG.md does; and that README.md says how many methods docs/samplers.md lists: version.py SOURCE."""

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

TENS = {20: "twenty", 30: "thirty", 40: "forty", 50: "fifty"}
ONES = ["", "-one", "-two", "-three", "-four", "-five", "-six", "-seven", "-eight", "-nine"]


def wrong_counts(source):
    """README's numbers of methods that are not that of the page of samplers, whose `file` and `command` make no sets."""
    names = re.findall(r"^\| \*\*`([a-z-]+)`", (source / "docs/samplers.md").read_text(encoding="utf-8"), re.M)
    count = len(set(names) - {"file", "command"})
    said = re.findall(r"([a-z-]+) methods", (source / "README.md").read_text(encoding="utf-8"))
    numbers = [word for word in said if word.split("-")[0] in TENS.values()]
    return [f"README.md: {word} methods, docs/samplers.md has {count}" for word in numbers
            if word != TENS[count - count % 10] + ONES[count % 10]] or ([] if numbers else ["README.md: no number of methods"])


def main(source):
    def all_in(name, pattern):
        return re.findall(pattern, (source / name).read_text(encoding="utf-8"), re.M)

    versions = all_in("CMakeLists.txt", r"project\(\w+ VERSION (\S+)")
    others = {name: all_in(name, pattern) for name, pattern in PLACES.items()}
    others["CHANGELOG.md"] = others["CHANGELOG.md"][:1]
    wrong = {name: found for name, found in others.items() if len(versions) != 1 or set(found) != set(versions)}
    for name, found in wrong.items():
        print(f"{name}: names version {' and '.join(found) or 'none'}, CMakeLists.txt {' and '.join(versions) or 'none'}")
    counts = wrong_counts(source)
    print("".join(line + "\n" for line in counts), end="")
    return bool(wrong or counts)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
