"""The notebook runs, cell after cell, and shows its figures."""

import json
import os
import unittest

from support import SOURCE, FolderTest


class Notebook(FolderTest):
    def test_runs(self):
        notebook = json.loads((SOURCE / "python/examples/poisson_disk_sets.ipynb").read_text())
        self.assertEqual(notebook["nbformat"], 4)
        cells = ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]
        self.assertGreater(len(cells), 4)
        for cell in notebook["cells"]:
            self.assertEqual(cell.get("outputs", []), [], "results are not stored")
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        names = {"tile_sets": str(SOURCE / "runtime/tile_sets")}
        for number, cell in enumerate(cells):
            with self.subTest(cell=number):
                exec(compile(cell, f"cell {number}", "exec"), names)  # pylint: disable=exec-used
        self.assertEqual(names["analysis"]._repr_html_().count("<img"), 4)


if __name__ == "__main__":
    unittest.main()
