#!/usr/bin/env python3
"""The size check refuses each planted excess and names its place."""

import unittest

from planted import PlantedTree

HEADER = "/// What this is for.\n#pragma once\n"


class SizeCheck(PlantedTree):
    def test_lets_what_is_just_within_the_limits_pass(self):
        body = "  a();\n" * 68
        self.plant("simulator/base/good.h", HEADER + "namespace hallux {\nstruct A {\n  int b{0};\n};\n}\n")
        self.plant("simulator/base/good.cpp", f"namespace hallux {{\nvoid f() {{\n{body}}}\n}}  // namespace hallux\n")
        self.plant("simulator/base/table.cpp", "constexpr int table[] = {\n" + "  1,\n" * 200 + "};\n")
        self.plant("simulator/base/long.cpp", "int a();\n" * 500)
        self.plant("simulator/base/wide.cpp", "// " + "a" * 97 + "\n")
        for number in range(45):
            self.plant(f"ui/jobs/job{number}.cpp", "")
        self.expect_clean("size_check.py")

    def test_refuses_a_long_function(self):
        body = "  if (a) { b(); }  // }\n" * 70
        self.plant("ui/jobs/long.cpp", f"namespace hallux {{\n\nvoid f() {{\n{body}}}\n\n}}\n")
        self.expect_violation("ui/jobs/long.cpp:3", "a function of 72 lines", "size_check.py")

    def test_refuses_a_long_member_function(self):
        body = '  use("}");\n' * 70
        self.plant("ui/jobs/long.h", HEADER + f"class A {{\n public:\n  void f() noexcept {{\n{body}  }}\n}};\n")
        self.expect_violation("ui/jobs/long.h:5", "a function of 72 lines", "size_check.py")

    def test_refuses_a_long_file(self):
        self.plant("ui/jobs/long.cpp", "int a();\n" * 501)
        self.expect_violation("ui/jobs/long.cpp", "501 lines", "size_check.py")

    def test_refuses_a_wide_line_of_code_or_comment(self):
        self.plant("tests/ui/wide.cpp", "int a();\n// " + "a" * 98 + "\n")
        self.expect_violation("tests/ui/wide.cpp:2", "101 columns", "size_check.py")

    def test_refuses_a_full_folder(self):
        for number in range(46):
            self.plant(f"ui/jobs/job{number}.cpp", "")
        self.expect_violation("ui/jobs", "46 files", "size_check.py")

    def test_prints_the_share_of_comments(self):
        self.plant("ui/jobs/half.cpp", "// one\nint two();\n\n")
        code, said = self.run_check("size_check.py")
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"1 +2 +50\.0 % +sources of ui")


if __name__ == "__main__":
    unittest.main()
