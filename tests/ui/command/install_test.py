#!/usr/bin/env python3
"""What `cmake --install` puts in place: the program, which runs from there, and the rules that let people open devices."""

import os
import pathlib
import subprocess
import tempfile
import unittest

BUILD = pathlib.Path(os.environ["HALLUX_BUILD"])
RULES = pathlib.Path(os.environ["HALLUX_UDEV_RULES"])


class Installed(unittest.TestCase):
    def test_program_and_rules_lie_where_the_system_looks(self):
        with tempfile.TemporaryDirectory() as folder:
            prefix = pathlib.Path(folder) / "usr"
            subprocess.run(["cmake", "--install", BUILD, "--prefix", prefix], check=True, capture_output=True)
            files = sorted(str(path.relative_to(prefix)) for path in prefix.rglob("*") if path.is_file())
            self.assertEqual(files, ["bin/hallux", "lib/udev/rules.d/70-hallux-haptics.rules"])
            self.assertEqual((prefix / files[1]).read_bytes(), RULES.read_bytes())
            said = subprocess.run([prefix / files[0], "devices", "rules"], check=True, capture_output=True).stdout
            self.assertEqual(said, RULES.read_bytes())


if __name__ == "__main__":
    unittest.main()
