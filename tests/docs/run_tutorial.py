"""Runs the commands of a tutorial as a reader would: run_tutorial.py PAGE SOURCE PROGRAM FOLDER

A block after `<!-- save FILE -->` is written to the file, one after `<!-- run -->` is run, and has to end with status 0.
`<!-- run: OPTIONS -->` adds options to the command, which make it small, and
`<!-- run: WORDS -> OTHERS -->` puts other words in the place of its own. `./lab` is the program; configs and runtime
are those of the checkout.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

BLOCK = re.compile(r"<!-- (save|run)(?: (\S+?))?(?:: (.*?))? -->\n```(\w+)\n(.*?)```", re.S)


def main():
    page, source, program, folder = (Path(argument).resolve() for argument in sys.argv[1:5])
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("configs", "runtime"):
        (folder / name).symlink_to(source / name)
    (folder / "lab").symlink_to(program)
    environment = os.environ | {"PYTHONPATH": str(program.parent / "python")}
    ran = 0
    for action, name, options, language, text in BLOCK.findall(page.read_text(encoding="utf-8")):
        if action == "save":
            (folder / name).write_text(text, encoding="utf-8")
            continue
        if options and " -> " in options:
            own, _, others = options.partition(" -> ")
            assert own in text, f"{page.name}: there is no {own}"
            text = text.replace(own, others)
        elif options:
            text = text.rstrip("\n") + " " + options
        command = ["/usr/bin/python3", "-c", text] if language == "python" else ["bash", "-euo", "pipefail", "-c", text]
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
        ran += 1
        print(text, done.stdout[-2000:], sep="\n")
        if done.returncode != 0:
            print(f"{page.name}: status {done.returncode}\n{done.stderr[-4000:]}")
            return 1
    print(f"{ran} blocks ran")
    return 0 if ran > 0 else 1


sys.exit(main())
