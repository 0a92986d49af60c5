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
    arguments = [argument.arg for argument in function.args.posonlyargs + function.args.args
                 + function.args.kwonlyargs if argument.arg not in ("self", "cls")]
    return f"{function.name}({', '.join(arguments)})"


def print_module(package, module, title):
    tree = ast.parse((package / module).read_text(encoding="utf-8"))
    print(f"## {title}\n\n| name | |\n| --- | --- |")
    for node in public(tree.body):
        if node.name not in exported(package):
            continue
        if isinstance(node, ast.FunctionDef):
            print(f"| `pl.{signature(node)}` | {summary(node)} |")
            continue
        print(f"| **`pl.{node.name}`** | {summary(node)} |")
        for part in public(node.body):
            print(f"| `{node.name}.{part.name if is_property(part) else signature(part)}` | {summary(part)} |")
    print()


def is_property(node):
    return any(isinstance(decorator, ast.Name) and decorator.id == "property" for decorator in node.decorator_list)


def main():
    package = Path(sys.argv[1])
    print("# Python: every name\n\n`import poissonlab as pl`; `help(pl.NAME)` says more, with shapes and units. What to do "
          "with them: [Python](python.md).\n")
    print_module(package, "analysis.py", "Measuring")
    print_module(package, "results.py", "Runs and their results")
    print_module(package, "tiles.py", "Tile sets")
    print_module(package, "points.py", "Point files")
    print("Every method is a class, named on its page under Methods, and every kind of distribution a function of\n"
          "`pl.distribute`: [keys of configs](kinds.md) are their arguments.\n\n"
          "`pl.InputError`, `pl.DeviceError` and `pl.StorageError` are what goes wrong.")


main()
