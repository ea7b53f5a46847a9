#!/usr/bin/env python3
"""The rubrics that the program ships with tell a good performance from a bad one."""

import unittest

from hallux_command import CommandTest


class ShippedProof(CommandTest):
    patience_s = 1200

    def expect_proven(self, operation):
        answer = self.ask("scenario", "prove", operation)
        self.assertIs(answer["passed"], True)
        self.assertGreaterEqual(answer["perfect"]["score"], 97.0)
        self.assertGreaterEqual(len(answer["performances"]), 5)

    def test_silver(self):
        self.expect_proven("silver")

    def test_akin(self):
        self.expect_proven("akin")


if __name__ == "__main__":
    unittest.main()
