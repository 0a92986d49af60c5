"""The examples of docs/python.md run, one after the other, and have the values that stand behind them."""

import ast
import contextlib
import os
import re
import unittest
import warnings

from support import SOURCE, FolderTest

PAGE = SOURCE / "docs/python.md"
VALUE = re.compile(r"^(\S.*?) {2,}# (.*)$")


def statements_of(block):
    """Yields the statements of a block, each with the comment behind it where it is an expression in one line, else None."""
    lines = block.splitlines()
    for node in ast.parse(block).body:
        comment = VALUE.match(lines[node.end_lineno - 1])
        is_value = isinstance(node, ast.Expr) and comment and node.lineno == node.end_lineno
        yield node, comment[2] if is_value else None


class Page(FolderTest):
    def run_block(self, block, names):
        for node, expected in statements_of(block):
            code = ast.unparse(node)
            if expected is None or not is_literal(expected):
                exec(compile(code, str(PAGE), "exec"), names)  # pylint: disable=exec-used
            else:
                value = eval(compile(code, str(PAGE), "eval"), names)  # pylint: disable=eval-used
                self.assertEqual(value, ast.literal_eval(expected), code)

    def test_runs(self):
        blocks = re.findall(r"^```python\n(.*?)^```$", PAGE.read_text(encoding="utf-8"), re.M | re.S)
        self.assertGreaterEqual(len(blocks), 20)
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        os.symlink(SOURCE / "runtime", "runtime")
        os.environ.setdefault("MPLBACKEND", "Agg")
        with warnings.catch_warnings(), contextlib.suppress(ImportError):  # of these themselves
            warnings.simplefilter("ignore")
            import matplotlib.pyplot, pandas  # noqa: F401, E401
        names = {}
        for block in blocks:
            with self.subTest(block):
                try:
                    self.run_block(block, names)
                except ModuleNotFoundError as missing:
                    if missing.name not in ("matplotlib", "pandas"):  # which the package does without
                        raise

    def test_notices_values_that_are_wrong(self):
        with self.assertRaises(AssertionError):
            self.run_block("1 + 1  # 3\n", {})


def is_literal(text):
    try:
        ast.literal_eval(text)
    except (SyntaxError, ValueError):
        return False
    return True


if __name__ == "__main__":
    unittest.main()
