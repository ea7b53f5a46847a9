#!/usr/bin/env python3
"""The style check refuses each planted lapse and names its place."""

import unittest

from planted import PlantedTree

HEADER = "/// What this is for.\n#pragma once\n"


class StyleCheck(PlantedTree):
    def test_lets_good_code_pass(self):
        self.plant("simulator/base/good.h", HEADER + "namespace hallux {\nstruct A {\n  int b{0};\n};\n}\n")
        self.plant("simulator/base/good.cpp", "namespace hallux {\nvoid f() { a(); }\n}  // namespace hallux\n")
        self.expect_clean("style_check.py")

    def test_refuses_a_name_that_is_not_snake_case(self):
        self.plant("simulator/mesh/SolidMesh.cpp", "")
        self.expect_violation("simulator/mesh/SolidMesh.cpp", "snake_case", "style_check.py")

    def test_refuses_a_macro_of_our_own(self):
        self.plant("simulator/mesh/a.cpp", "\n#define SQUARE(x) x* x\n")
        self.expect_violation("simulator/mesh/a.cpp:2", "SQUARE", "style_check.py")

    def test_refuses_a_header_without_purpose_or_guard(self):
        self.plant("simulator/mesh/a.h", "int f();\n")
        self.expect_violation("simulator/mesh/a.h:1", "purpose", "style_check.py")
        self.expect_violation("simulator/mesh/a.h", "#pragma once", "style_check.py")

    def test_refuses_a_path_of_one_machine(self):
        self.plant("docs/a.md", "see /home/somebody/notes\n")
        self.expect_violation("docs/a.md:1", "a path of one machine", "style_check.py")

    def test_refuses_unfinished_work(self):
        self.plant("assessment/a.cpp", "\n// TODO: later\n")
        self.expect_violation("assessment/a.cpp:2", "unfinished", "style_check.py")


if __name__ == "__main__":
    unittest.main()
