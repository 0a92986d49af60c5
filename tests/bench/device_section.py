"""Sections of docs/performance.md about devices: device_section.py PAGE SECTION puts one there, or in place of the former."""

import re
import sys
from pathlib import Path

START = re.compile(r"^(?=## On )", re.M)


def device_sections(page):
    """The sections about devices, which end the page, by their headings."""
    return {part.splitlines()[0]: part.rstrip() + "\n" for part in START.split(page)[1:]}


def with_section(page, section):
    sections = device_sections(page)
    sections[section.splitlines()[0]] = section.rstrip() + "\n"
    return START.split(page)[0].rstrip() + "\n\n" + "\n".join(sections.values())


if __name__ == "__main__":
    page = Path(sys.argv[1])
    page.write_text(with_section(page.read_text(encoding="utf-8"), Path(sys.argv[2]).read_text(encoding="utf-8")),
                    encoding="utf-8")
