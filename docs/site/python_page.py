"""Prints the page that lists every public name of the Python package with its docstring: python_page.py PACKAGE

Reads the sources, so that the page is made where the package is not built.
"""

import ast
import sys
from pathlib import Path


def summary(node):
    text = ast.get_docstring(node) or ""
    return " ".join(text.split("\n\n")[0].split()).replace("|", "\\|")


def public(body):
    return [node for node in body
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and not node.name.startswith("_")]


def exported(package):
    """The names that the package imports from its modules: others of these are not public."""
    tree = ast.parse((package / "__init__.py").read_text(encoding="utf-8"))
    return {alias.asname or alias.name for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names}


def signature(function):
    of = function.args
    arguments = [argument.arg for argument in of.posonlyargs + of.args if argument.arg not in ("self", "cls")]
    arguments += ["*" + of.vararg.arg] if of.vararg else []
    arguments += [argument.arg for argument in of.kwonlyargs]
    return f"{function.name}({', '.join(arguments)})"


def print_module(package, module, title):
    tree = ast.parse((package / module).read_text(encoding="utf-8"))
    print(f"## {title}\n\n| name | |\n| --- | --- |")
    for node in public(tree.body):
        if node.name not in exported(package) | {"Sampler", "Made"}:
            continue
        if isinstance(node, ast.FunctionDef):
            print(f"| `pl.{signature(node)}` | {summary(node)} |")
            continue
        where = "pl.distribute" if node.name == "Made" else "pl"
        print(f"| **`{where}.{node.name}`** | {summary(node)} |")
        for name, words in attributes(node).items():
            print(f"| `{node.name}.{name}` | {words} |")
        for part in public(node.body):
            print(f"| `{node.name}.{part.name if is_property(part) else signature(part)}` | {summary(part)} |")
    print()


def is_property(node):
    return any(isinstance(decorator, ast.Name) and decorator.id in ("property", "cached_property")
               for decorator in node.decorator_list)


def attributes(node):
    """The attributes of a class that have no code of their own, with what its docstring says of each: lines that begin
    with their names, and go on where the next line is indented."""
    declared = [part.target.id for part in node.body if isinstance(part, ast.AnnAssign)]
    said = {}
    for line in (ast.get_docstring(node) or "").splitlines():
        names, colon, words = line.partition(": ")
        if colon and all(name.isidentifier() for name in names.split(", ")):
            current = [name for name in names.split(", ") if name in declared]
            said |= {name: words for name in current}
        elif line.startswith("    ") and said:
            said |= {name: f"{said[name]} {line.strip()}" for name in current}
        else:
            current = []
    return {name: said.get(name, "").replace("|", "\\|") for name in declared}


def main():
    package = Path(sys.argv[1])
    print("# Python: every name\n\n`import poissonlab as pl`; `help(pl.NAME)` says more, with shapes and units. What to do "
          "with them: [Python](python.md).\n")
    print_module(package, "samplers.py", "Making sets")
    print_module(package, "analysis.py", "Measuring")
    print_module(package, "results.py", "Runs and their results")
    print_module(package, "tiles.py", "Tile sets")
    print_module(package, "points.py", "Point files")
    print_module(package, "kinds.py", "Distributions, tilings, textures")
    print("Every method is a class with what `Sampler` has, named on its page under Methods. `pl.distribute`, `pl.tilings`,\n"
          "`pl.texture.build()` and `pl.tiles.build()` make the [kinds of work](kinds.md), whose keys are their arguments,\n"
          "and return `Made`.\n\n`pl.InputError`, `pl.DeviceError` and `pl.StorageError` are raised where something is wrong.")


main()
