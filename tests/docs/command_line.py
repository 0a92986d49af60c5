"""Checks that docs/command-line.md has the commands and options that the program has, as its completion lists them, and no
others: command_line.py SOURCE."""

import re
import sys
from pathlib import Path


def options_of_program(completion):
    """The options of each command: the completion's words behind it, of which --help is one."""
    options = {}
    for name, words in re.findall(r"\['([^']+)'\]='([^']*)'", completion):
        if "--help" in words.split():
            options[name] = {word for word in words.split() if word.startswith("--")} - {"--help"}
    return options


def options_of_page(page, commands):
    """The options that the page's indented lines have of each command."""
    options, command = {}, None
    for line in page.splitlines():
        begins = re.match(r"    ([a-z]\S*)( \S+)?", line)
        if begins or not line.startswith("    "):
            command = begins and next((name for name in ("".join(begins.groups("")), begins[1]) if name in commands), None)
        if command:
            options.setdefault(command, set()).update(re.findall(r"--[a-z][a-z-]*", line))
    return options


def main(source):
    program = options_of_program((source / "app/stored/completion.bash").read_text(encoding="utf-8"))
    page = options_of_page((source / "docs/command-line.md").read_text(encoding="utf-8"), program)
    problems = [f"lacks {name}" for name in program.keys() - page.keys()]
    for name in program.keys() & page.keys():
        problems += [f"{name}: lacks {option}" for option in program[name] - page[name]]
        problems += [f"{name}: {option} is no option" for option in page[name] - program[name]]
    for problem in sorted(problems):
        print("docs/command-line.md:", problem)
    if len(program) < 30:
        problems.append("")
        print(f"app/stored/completion.bash: only {len(program)} commands were found, of 30 or more")
    return bool(problems)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
