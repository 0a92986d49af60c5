"""Looks for idioms in the words for users: idioms.py SOURCE. idioms.tsv lists them, with what to write instead.

It reads pages without their code, and the strings in double quotes of sources.
"""

import re
import sys
from pathlib import Path

PAGES = ("README.md", "CONTRIBUTING.md", "docs/*.md", "docs/tutorials/*.md", "docs/gallery/*.md", "runtime/*.md",
         "runtime/tile_sets/*.md", "configs/*/*.md")
SOURCES = ("app", "analysis", "base", "experiment", "host", "reports", "results", "tiles", "python/poissonlab", "lab")
HELP = re.compile(r'(?:^|[ {(,])"((?:What|Which|Whose|Of|Who) [a-z][^"]*)"', re.M)  # of options
STRING = re.compile(r'"((?:[^"\\\n]|\\.)*)"')


def idioms(table):
    """Returns the expressions of a table, each with its advice."""
    lines = table.read_text(encoding="utf-8").splitlines()
    return [(re.compile(line.split("\t")[0]), line.split("\t")[1]) for line in lines if line and line[0] != "#"]


def words_of_page(text):
    """Returns the lines of a page without its code: blocks in fences become empty, so that numbers of lines stay."""
    text = re.sub(r"^(```|~~~).*?^\1", lambda block: "\n" * block[0].count("\n"), text, flags=re.M | re.S)
    return re.sub(r"`[^`\n]*`", "``", text)


def words_of_source(text):
    """Returns the strings of a source file in the places of their lines; comments become empty."""
    lines = (re.sub(r"^\s*(//|\*|#).*", "", line) for line in text.splitlines())
    return "\n".join(" ".join(STRING.findall(line)) for line in lines)


def texts(source):
    """Yields every file with words for users, and these words."""
    for pattern in PAGES:
        for path in sorted(source.glob(pattern)):
            yield path, words_of_page(path.read_text(encoding="utf-8"))
    for name in SOURCES:
        place = source / name
        for path in sorted(place.rglob("*")) if place.is_dir() else [place]:
            if path.suffix in (".cpp", ".hpp", ".py", ""):
                if path.is_file() and (path.suffix or path == place):
                    yield path, words_of_source(path.read_text(encoding="utf-8"))


def found(text, table):
    """Yields idioms in a text: number of line, the words, the advice. An idiom may go on in the next line."""
    joined = re.sub(r"\n[ \t]*", "\n", text)
    for expression, advice in table:
        for match in re.compile(expression.pattern.replace(" ", r"\s+")).finditer(joined):
            yield joined.count("\n", 0, match.start()) + 1, " ".join(match[0].split()), advice


def main():
    source = Path(sys.argv[1])
    table = idioms(Path(__file__).with_name("idioms.tsv"))
    assert list(found("words\nWho has\nfiles", table)), "an idiom over two lines is not found"
    read, wrong = 0, []
    for path, text in texts(source):
        read += 1
        wrong += [f"{path.relative_to(source)}:{line}: \"{words}\": write: {advice}"
                  for line, words, advice in found(text, table)]
    for path in sorted((source / "app/commands").rglob("*.cpp")):
        wrong += [f"{path.relative_to(source)}: \"{words}\": write: begin with what it is: The folder ..., For pictures: ..."
                  for words in HELP.findall(path.read_text(encoding="utf-8"))]
    print(*wrong, f"{read} files, {len(wrong)} idioms", sep="\n")
    sys.exit(1 if wrong or read < 100 else 0)


main()
