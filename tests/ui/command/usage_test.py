#!/usr/bin/env python3
"""Help and wrong usage: nothing here opens a data directory."""

import unittest

from hallux_command import DONE, NO_DISPLAY, WRONG_USAGE, CommandTest

OPTIONS = {
    ("attempt",): ("scenario", "--hand", "--seed", "--pacing"),
    ("attempts",): (),
    ("replay",): ("attempt",),
    ("score",): ("attempt",),
    ("rescore",): ("scenario", "--with-version", "--dry-run"),
    ("report",): ("attempt", "--output"),
    ("cut",): ("MESH", "--plane", "--kerf", "--sweep", "--close", "--output"),
    ("scenario",): ("list", "check", "show"),
    ("scenario", "list"): (),
    ("scenario", "check"): ("FILE",),
    ("scenario", "show"): ("NAME",),
    ("user",): ("add", "list", "passwd", "disable", "erase", "recover"),
    ("user", "add"): ("login", "--name", "--administrator"),
    ("user", "list"): (),
    ("user", "passwd"): ("login", "--code"),
    ("user", "recover"): ("login",),
    ("user", "disable"): ("login", "--enable"),
    ("user", "erase"): ("login", "--reason", "--with-recordings"),
    ("backup",): ("--to", "--list"),
    ("restore",): ("backup", "--erasures", "--even-damaged"),
    ("retention",): ("--dry-run", "--practice-days", "--assessment-days", "--account-days", "--cache-days"),
    ("export-person",): ("login", "--output"),
    ("export",): ("attempt", "--person", "--cohort", "--all", "--output"),
    ("import",): ("folder",),
    ("origins",): ("--accept", "--unaccept"),
    ("demo",): ("--attempts",),
    ("verify",): ("--anchor",),
    ("anchor",): (),
}

WRONG = [
    ["--json"],
    ["--as", "ada"],
    ["attempts", "--ui-map", "map.json"],
    ["operate"],
    ["--loud", "attempts"],
    ["attempt"],
    ["attempt", "silver", "--seed", "one"],
    ["attempt", "silver", "--seed", "-1"],
    ["attempt", "silver", "--seed", "1.5"],
    ["attempt", "silver", "--pacing", "slow"],
    ["attempt", "silver", "--hand"],
    ["attempt", "silver", "gold"],
    ["demo", "--attempts", "0"],
    ["demo", "--attempts", "7"],
    ["demo", "course"],
    ["attempts", "verify"],
    ["restore"],
    ["retention", "--practice-days"],
    ["export-person", "ada"],
    ["export-person", "-o", "out"],
    ["user", "erase", "ada"],
    ["replay"],
    ["score"],
    ["rescore"],
    ["rescore", "silver", "--with-version", "0"],
    ["report", "some-attempt"],
    ["report", "-o", "page.html"],
    ["cut", "bone.ply", "-o", "out"],
    ["cut", "bone.ply", "-o", "out", "--plane", "1,0,0,0"],
    ["cut", "bone.ply", "-o", "out", "--plane", "1,0,0", "--kerf", "0.5"],
    ["cut", "bone.ply", "--plane", "1,0,0,0", "--kerf", "0.5"],
    ["scenario"],
    ["scenario", "check"],
    ["scenario", "show"],
    ["user"],
    ["user", "add"],
    ["user", "add", "ann", "--password", "a long enough password"],
    ["user", "disable"],
]


class Usage(CommandTest):
    def tearDown(self):
        self.assertFalse(self.data.exists(), "a data directory was made for nothing")
        super().tearDown()

    def test_help_of_each_verb_names_its_options(self):
        for verb, options in OPTIONS.items():
            with self.subTest(verb=verb):
                answer = self.hallux(*verb, "--help")
                self.assertEqual(answer.code, DONE, answer)
                self.assertEqual(answer.err, "")
                for option in options:
                    self.assertIn(option, answer.out)

    def test_help_of_the_command_names_its_verbs_and_the_options_of_all(self):
        answer = self.hallux("--help")
        self.assertEqual(answer.code, DONE)
        for verb in OPTIONS:
            self.assertIn(verb[0], answer.out)
        for option in ("--data", "--as", "--json", "--quiet", "--version"):
            self.assertIn(option, answer.out)

    def test_wrong_usage_is_said_on_stderr_and_as_json_where_that_is_asked_for(self):
        for arguments in WRONG:
            with self.subTest(arguments=arguments):
                answer = self.hallux(*arguments)
                self.assertEqual(answer.code, WRONG_USAGE, answer)
                if "--json" in arguments:
                    self.assertEqual(answer.json()["error"]["code"], WRONG_USAGE)
                else:
                    self.assertEqual(answer.out, "")
                self.assertNotEqual(answer.err, "")

    def test_no_verb_opens_the_window_which_needs_a_display(self):
        self.expect_refusal(NO_DISPLAY, ["display"])

    def test_the_version_names_the_engine(self):
        answer = self.hallux("--version")
        self.assertEqual(answer.code, DONE)
        self.assertRegex(answer.out, r"engine version \d+")


if __name__ == "__main__":
    unittest.main()
