#!/usr/bin/env python3
"""The evidence check refuses each planted row that names no test, and names its place."""

import unittest

from planted import PlantedTree

HEAD = "# What is protected\n\n| what | test |\n|---|---|\n"


class EvidenceCheck(PlantedTree):
    def setUp(self):
        super().setUp()
        self.plant("tests/database/people_test.cpp", "")

    def refuse(self, place, what):
        self.expect_violation(place, what, "evidence_check.py")

    def test_lets_rows_that_name_a_test_pass(self):
        self.plant("docs/security.md", HEAD + "| a | `people_test` |\n| b | `people_test.cpp`, `tests/database` |\n")
        self.plant("docs/reliability.md", "no table\n")
        self.expect_clean("evidence_check.py")

    def test_refuses_a_row_without_one(self):
        self.plant("docs/security.md", HEAD + "| a | people_test |\n")
        self.refuse("docs/security.md:5", "names no test")

    def test_refuses_a_test_that_is_not_there(self):
        self.plant("docs/reliability.md", HEAD + "| a | `people_test`, `gone_test` |\n")
        self.refuse("docs/reliability.md:5", "there is no test gone_test")

    def test_refuses_a_table_without_the_column(self):
        self.plant("docs/security.md", "| a | b |\n|---|---|\n| c | `people_test` |\n")
        self.refuse("docs/security.md:1", "is not `test`")


if __name__ == "__main__":
    unittest.main()
