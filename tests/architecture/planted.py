"""A small tree with one violation, and what a check says about it."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent


class PlantedTree(unittest.TestCase):
    """Each test plants files in a fresh tree that uses the project's own arrow table."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.plant("tests/architecture/arrows.txt", (HERE / "arrows.txt").read_text())

    def plant(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def run_check(self, check, *arguments):
        done = subprocess.run([sys.executable, str(HERE / check), str(self.root), *map(str, arguments)],
                              capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def expect_clean(self, check, *arguments):
        code, said = self.run_check(check, *arguments)
        self.assertEqual(code, 0, said)

    def expect_violation(self, place, what, check, *arguments):
        code, said = self.run_check(check, *arguments)
        self.assertEqual(code, 1, said)
        naming = [line for line in said.splitlines() if line.startswith(place)]
        self.assertTrue(naming, f"{place} is not named in:\n{said}")
        self.assertIn(what, "\n".join(naming))
