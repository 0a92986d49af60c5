"""Sections about devices stay apart, and the newest of a device is the one that stays."""

from device_section import device_sections, with_section

PAGE = "# Performance\n\nWords.\n\n## Others\n\n| a | 1 |\n"

once = with_section(PAGE, "## On card A\n\nfirst\n")
twice = with_section(once, "## On card B\n\nof B\n\n")
again = with_section(twice, "## On card A\n\nsecond\n")

assert once == PAGE + "\n## On card A\n\nfirst\n", once
assert again == PAGE + "\n## On card A\n\nsecond\n\n## On card B\n\nof B\n", again
assert list(device_sections(again)) == ["## On card A", "## On card B"]
assert device_sections(PAGE) == {}
