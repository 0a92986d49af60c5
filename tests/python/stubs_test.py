"""The stubs of types that the build wrote are Python, and have the classes and keywords that importing makes."""

import ast
import inspect
import pathlib
import unittest

import poissonlab

STUBS = pathlib.Path(poissonlab.__file__).parent / "samplers.pyi"


def keywords_of(stub):
    """The keywords of a class in the stubs, each with its type and default as text."""
    constructor = next(part for part in stub.body if isinstance(part, ast.FunctionDef) and part.name == "__init__")
    arguments = constructor.args
    return [(name.arg, inspect.Parameter.empty if default is None else ast.literal_eval(default),
             ast.unparse(name.annotation))
            for name, default in zip(arguments.kwonlyargs, arguments.kw_defaults)]


class Stubs(unittest.TestCase):
    def setUp(self):
        self.tree = ast.parse(STUBS.read_text(encoding="utf-8"))
        self.classes = {part.name: part for part in self.tree.body if isinstance(part, ast.ClassDef)}

    def test_have_every_class_that_importing_makes(self):
        methods = [name for name, value in vars(poissonlab.samplers).items()
                   if inspect.isclass(value) and issubclass(value, poissonlab.samplers.Sampler)]
        self.assertEqual(sorted(self.classes), sorted(methods))
        self.assertGreater(len(methods), 20)

    def test_have_the_keywords_of_every_class(self):
        for name, stub in self.classes.items():
            if name == "Sampler":
                continue
            signature = inspect.signature(getattr(poissonlab, name))
            # The text of a type is compared as Python prints it, which has quotes of its own.
            expected = [(key.name, key.default, ast.unparse(ast.parse(key.annotation, mode="eval")))
                        for key in signature.parameters.values()]
            self.assertEqual(keywords_of(stub), expected, name)

    def test_types_read_well_in_help(self):
        shown = str(inspect.signature(poissonlab.DartThrowing))
        self.assertIn("relative_radius: float | None = None, stop: str = 'points'", shown)
        self.assertIn("rng: int | numpy.random.Generator | None = None", shown)
        self.assertIn("(*, iterations: int, start: ", str(inspect.signature(poissonlab.Lloyd)))
        for value in (poissonlab.analyze, poissonlab.read_points, poissonlab.run, poissonlab.open, poissonlab.TileSet.points,
                      poissonlab.distribute.darts, poissonlab.tiles.build):
            shown = str(inspect.signature(value))
            self.assertNotRegex(shown, "numpy._|Union|ForwardRef|: '", value)
            self.assertIn("->", shown)
        self.assertNotRegex(poissonlab.distribute.darts.__doc__, "in quotes|true or false")

    def test_the_base_has_what_its_class_has(self):
        stub = self.classes["Sampler"]
        named = {part.name for part in stub.body if isinstance(part, ast.FunctionDef)}
        public = {name for name in vars(poissonlab.samplers.Sampler) if not name.startswith("_")}
        self.assertEqual(named - {"__init__"}, public)

    def test_types_are_those_that_the_file_imports(self):
        known = {"int", "float", "str", "bool", "dict", "list", "tuple", "None", "Sampler"}
        for part in self.tree.body:
            if isinstance(part, (ast.Import, ast.ImportFrom)):
                known |= {(alias.asname or alias.name).split(".")[0] for alias in part.names}
        for node in ast.walk(self.tree):
            if isinstance(node, ast.arg) and node.annotation is not None:
                for name in ast.walk(node.annotation):
                    if isinstance(name, ast.Name):
                        self.assertIn(name.id, known, ast.unparse(node.annotation))


if __name__ == "__main__":
    unittest.main()
