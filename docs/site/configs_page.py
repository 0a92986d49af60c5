"""Prints the page that lists the configs which ship, by their titles and first comments: configs_page.py FOLDER"""

import re
import sys
import tomllib
from pathlib import Path

HEADINGS = {".": "Experiments", "dissertation": "Figures of the dissertation", "papers": "Figures of articles",
            "peers": "Samplers of others"}


def first_sentence(text):
    """The first sentence of the comment that a config opens with."""
    lines = []
    for line in text.splitlines():
        if not line.startswith("#") or line.strip() == "#":
            break
        lines.append(line.lstrip("# "))
    found = re.match(r"(.*?[.:])(?= [A-Z]|$)", " ".join(lines))
    return found.group(1).rstrip(":") if found else ""


def rows_of(folder, root):
    for config in sorted(folder.glob("*.toml" if folder == root else "**/*.toml")):
        text = config.read_text(encoding="utf-8")
        name = config.relative_to(root.parent)
        title = tomllib.loads(text).get("title", "")
        yield f"| [`{name}`](../{name}) | {title} | {first_sentence(text).replace('|', '/')} |"


def main():
    root = Path(sys.argv[1])
    print("# Configs that ship\n\n`./lab run CONFIG` makes the report of each; figure 6.20 of the dissertation, for "
          "example, is\n\n    ./lab run configs/dissertation/fig-6-20.toml\n")
    for name, heading in HEADINGS.items():
        print(f"## {heading}\n\n| config | title | |\n| --- | --- | --- |")
        print("\n".join(rows_of(root / name, root)) + "\n")


main()
