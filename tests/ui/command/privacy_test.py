#!/usr/bin/env python3
"""Erasing a person and exporting what is kept of one, as an administrator does it at the command line."""

import csv
import json
import unittest

from hallux_command import BAD_INPUT, DONE, REFUSED, RecordedTest

PASSWORD, ANOTHER = "saw bone hinge wire", "medial eminence off"
LOGIN, NAME = "zelda", "Canary Zelda"


class Privacy(RecordedTest):
    """ada administers, zelda is in the course."""

    def setUp(self):
        super().setUp()
        self.ask("user", "add", "ada", "--administrator", stdin=PASSWORD + "\n")
        self.ask("user", "add", LOGIN, "--name", NAME, "--as", "ada", stdin=f"{PASSWORD}\n{ANOTHER}\n")
        self.hallux("attempts", "--as", LOGIN, stdin="a wrong password\n")

    def leave_words(self):
        """The recorded attempt becomes zelda's, with a note and a question; the audit knows better, and verify would say so."""
        person = dict(self.query("SELECT login, person_id FROM person_detail"))
        now = "2026-03-10T08:00:00.000Z"
        self.alter("UPDATE attempt SET person_id = ?", (person[LOGIN],))
        self.alter("INSERT INTO note (attempt_id, author_person_id, is_private, moment_us, text, written_utc) "
                   "VALUES (1, ?, 0, 0, 'well done, zelda', ?)", (person["ada"], now))
        self.alter("INSERT INTO help_request (attempt_id, asker_person_id, moment_us, question, asked_utc) "
                   "VALUES (1, ?, 0, 'zelda asks', ?)", (person[LOGIN], now))

    def as_ada(self, *arguments, code=DONE):
        return self.ask(*arguments, "--as", "ada", stdin=PASSWORD + "\n", code=code)

    def erase(self, *more):
        return self.as_ada("user", "erase", LOGIN, "--reason", "asked for it", *more)

    def files_that_name_them(self):
        return [file for file in self.data.rglob("*") if file.is_file()
                and (LOGIN.encode() in file.read_bytes() or b"Zelda" in file.read_bytes())]

    def test_no_byte_of_the_directory_names_them_afterwards(self):
        self.leave_words()
        self.assertNotEqual(self.files_that_name_them(), [])
        erased = self.erase()
        self.assertIs(erased["log_cleared"], True)
        self.assertEqual(erased["recordings"], 0)
        self.assertEqual(self.files_that_name_them(), [])
        self.assertEqual(self.hallux("attempts", "--as", LOGIN, stdin=ANOTHER + "\n").code, REFUSED)

    def test_the_score_stays_and_the_recording_where_nothing_else_was_said(self):
        self.leave_words()
        self.erase()
        self.assertEqual(self.query("SELECT count(*) FROM score WHERE superseded_by IS NULL"), [(1,)])
        self.assertGreater(self.query("SELECT count(*) FROM chunk")[0][0], 0)

    def test_recordings_go_where_that_is_asked_for(self):
        self.leave_words()
        self.assertEqual(self.erase("--with-recordings")["recordings"], 1)
        self.assertEqual(self.query("SELECT count(*) FROM chunk"), [(0,)])
        self.assertEqual(self.query("SELECT count(*) FROM score WHERE superseded_by IS NULL"), [(1,)])

    def test_an_old_backup_does_not_bring_them_back(self):
        kept = self.folder / "kept"
        self.as_ada("backup", "--to", kept)
        self.erase("--with-recordings")
        journal = self.data / "backups" / "erasures.jsonl"
        self.data = self.folder / "again"
        self.assertEqual(self.ask("restore", kept, "--erasures", journal)["erased_again"], 1)
        self.assertEqual(self.files_that_name_them(), [])

    def test_the_reason_must_not_name_them_and_nobody_erases_themselves(self):
        as_ada = ("--as", "ada")
        self.expect_refusal(BAD_INPUT, ["reason"], "user", "erase", LOGIN, "--reason", "Zelda asked", *as_ada,
                            stdin=PASSWORD + "\n")
        self.expect_refusal(REFUSED, ["erase_person"], "user", "erase", "ada", "--reason", "left", *as_ada,
                            stdin=PASSWORD + "\n")
        self.expect_refusal(REFUSED, ["administrator"], "user", "erase", "ada", "--reason", "left", "--as", LOGIN,
                            stdin=ANOTHER + "\n")
        self.assertNotEqual(self.files_that_name_them(), [])

    def test_everybody_gets_what_is_kept_of_them(self):
        self.leave_words()
        out = self.folder / "mine"
        done = self.ask("export-person", LOGIN, "-o", out, "--as", LOGIN, stdin=ANOTHER + "\n")
        self.assertEqual(done["directory"], str(out))
        everything = json.loads((out / "person.json").read_text())
        self.assertEqual(everything["person"][0]["display_name"], NAME)
        self.assertEqual(everything["attempts"][0]["attempt"], self.attempt)
        self.assertEqual(everything["questions"][0]["question"], "zelda asks")
        explanation = (out / "explanation.txt").read_text()
        for name, rows in everything.items():
            self.assertIn(f"{name}.csv", explanation)
            with open(out / f"{name}.csv", newline="", encoding="utf-8") as file:
                self.assertEqual(len(list(csv.DictReader(file))), len(rows), name)

    def test_of_others_only_an_administrator_exports(self):
        self.expect_refusal(REFUSED, ["administrator"], "export-person", "ada", "-o", self.folder / "out", "--as", LOGIN,
                            stdin=ANOTHER + "\n")
        self.assertFalse((self.folder / "out").exists())
        self.as_ada("export-person", LOGIN, "-o", self.folder / "out")
        self.assertTrue((self.folder / "out" / "explanation.txt").exists())
        self.expect_refusal(REFUSED, ["holds something"], "export-person", LOGIN, "-o", self.folder / "out", "--as", "ada",
                            stdin=PASSWORD + "\n")


if __name__ == "__main__":
    unittest.main()
