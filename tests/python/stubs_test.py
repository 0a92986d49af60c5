"""The stubs of types that are in the tree are those of the methods that there are."""

import pathlib
import subprocess
import sys
import unittest

from support import SOURCE


class Stubs(unittest.TestCase):
    def test_are_written_anew_when_methods_change(self):
        printed = subprocess.run([sys.executable, "-B", SOURCE / "python/tools/write_stubs.py"], capture_output=True,
                                 text=True, check=True).stdout
        stored = pathlib.Path(SOURCE / "python/poissonlab/samplers.pyi").read_text()
        self.assertEqual(stored, printed, "write them: python/tools/write_stubs.py > python/poissonlab/samplers.pyi")
        compile(printed, "samplers.pyi", "exec")


if __name__ == "__main__":
    unittest.main()
