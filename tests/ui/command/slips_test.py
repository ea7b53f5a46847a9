#!/usr/bin/env python3
"""Slips of a hand at the command: what is meant otherwise, too long, or of somebody else is said, and nothing is lost."""

import contextlib
import json
import os
import pathlib
import resource
import subprocess
import tempfile
import time
import unittest

from hallux_command import (BAD_INPUT, DONE, REFUSED, STORAGE, WRONG_USAGE, Answer, CommandTest, RecordedTest, coarse_silver)

PASSWORD = "saw bone hinge wire"


class EmptiedDatabase(RecordedTest):
    """An empty file is damage: no verb fills it with tables, after which anybody could make themself administrator."""

    def expect_damage(self, *arguments, stdin=""):
        before = self.database().read_bytes()
        answer = self.hallux(*arguments, stdin=stdin)
        self.assertEqual(answer.code, STORAGE, (arguments, answer))
        self.assertIn("restore a backup", answer.err, arguments)
        self.assertEqual(self.database().read_bytes(), before, arguments)

    def test_it_is_damage_for_every_verb(self):
        for left in (b"", b"x"):
            self.database().write_bytes(left)
            for name in ("-wal", "-shm"):
                (self.data / f"hallux.db{name}").unlink(missing_ok=True)
            for line in (["attempts"], ["verify"], ["attempt", "silver"], ["replay", self.attempt], ["score", self.attempt],
                         ["rescore", "silver"], ["report", self.attempt, "-o", self.folder / "page.html"],
                         ["export", self.attempt, "-o", self.folder / "out"], ["import", self.folder], ["origins"],
                         ["backup"], ["retention"], ["sql", "SELECT 1"], ["user", "list"], ["user", "recover", "eve"],
                         ["user", "add", "eve", "--administrator"], ["user", "passwd", "eve"], ["user", "disable", "eve"],
                         ["export-person", "eve", "-o", self.folder / "eve"]):
                self.expect_damage(*line, stdin=f"{PASSWORD}\n{PASSWORD}\n")


class FileSizeLimit(CommandTest):
    def test_it_is_a_full_disk(self):
        """As the shell sets it: the signal is not ignored for the program."""
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))
        scenario = self.write("coarse.json", coarse_silver())
        answer = Answer(subprocess.run(self.line(["attempt", scenario]), stdin=subprocess.DEVNULL, capture_output=True,
                                       text=True, timeout=120, cwd=self.untouched[2], env=self.environment(),
                                       preexec_fn=limit))
        self.assertEqual(answer.code, STORAGE, answer)
        self.assertIn("the disk is full", answer.err)
        self.assertEqual(self.hallux("attempt", scenario).code, DONE)


class Slips(RecordedTest):
    def add(self, login, *more):
        return self.hallux("user", "add", login, *more, stdin=f"{PASSWORD}\n{PASSWORD}\n")

    def test_recovering_takes_nobodys_name(self):
        self.assertEqual(self.add("anna", "--administrator").code, DONE)
        self.expect_refusal(REFUSED, ["--as"], "user", "recover", "anna", "--as", "anna", stdin="wrong\n")
        self.assertEqual(self.hallux("user", "recover", "anna").code, DONE)

    def test_an_unknown_attempt_is_answered_alike_with_people_and_without(self):
        without = self.hallux("replay", "ffffffff")
        self.assertEqual(self.add("anna", "--administrator").code, DONE)
        with_people = self.hallux("replay", "ffffffff")
        signed_in = self.hallux("replay", "ffffffff", "--as", "anna", stdin=f"{PASSWORD}\n")
        self.assertEqual([answer.code for answer in (without, with_people, signed_in)], [BAD_INPUT] * 3)

    def test_a_seed_that_does_not_fit_is_refused(self):
        for seed in ("18446744073709551616", "-1", "1.5", "1e3", ""):
            answer = self.hallux("attempt", "silver", "--seed", seed)
            self.assertEqual(answer.code, WRONG_USAGE, answer)
            self.assertIn("18446744073709551615", answer.err)

    def test_names_are_short_and_can_be_read(self):
        self.assertEqual(self.add("anna", "--administrator").code, DONE)
        for name in ("x" * 100_000, "Anna\u202ereelluM", "Anna\x1b[2J", "Anna\nMueller"):
            answer = self.hallux("user", "add", "ben", "--name", name, "--as", "anna", stdin=f"{PASSWORD}\n{PASSWORD}\n")
            self.assertEqual(answer.code, BAD_INPUT, answer)

    def test_a_scenario_that_turns_its_writing_round_is_refused(self):
        scenario = coarse_silver()
        scenario["title"] = "Silver \u202eytisop"
        file = self.write("turned.json", scenario)
        self.expect_refusal(BAD_INPUT, ["turned.json", "/title"], "scenario", "check", file)
        self.expect_refusal(BAD_INPUT, ["turned.json", "/title"], "attempt", file)

    def test_a_hands_file_is_kept_by_name_and_content(self):
        folder = self.folder / "anna-mueller-home"
        folder.mkdir()
        hand = folder / "stroke.json"
        hand.write_text(json.dumps({"keys": [
            {"time_s": 0, "tip_mm": [0, 0, 90], "direction": [1, 0, 0], "normal": [0, 0, 1]},
            {"time_s": 0.2, "tip_mm": [0, 0, 91], "direction": [1, 0, 0], "normal": [0, 0, 1]}]}))
        made = self.ask("attempt", self.write("coarse.json", coarse_silver()), "--hand", hand)
        self.assertRegex(made["hand"], r"^stroke\.json [0-9a-f]{16}$")
        self.assertEqual(self.query("SELECT count(*) FROM attempt WHERE hand LIKE '%anna%'"), [(0, )])
        hand.write_text(hand.read_text().replace("91", "92"))
        again = self.ask("attempt", self.write("coarse.json", coarse_silver()), "--hand", hand)
        self.assertNotEqual(made["hand"], again["hand"])

    def test_an_origin_is_accepted_or_not(self):
        self.assertEqual(self.hallux("origins", "--accept", "x", "--unaccept", "y").code, WRONG_USAGE)

    def test_with_json_there_is_always_one_value(self):
        for line, code in ((["replay", "ffffffff"], BAD_INPUT), (["user", "erase", "eve", "--reason", "x"], REFUSED),
                           (["attempt", "no-such"], BAD_INPUT), (["attempt"], WRONG_USAGE), (["no-such-verb"], WRONG_USAGE),
                           ([], WRONG_USAGE)):
            answer = self.hallux(*line, "--json")
            self.assertEqual(answer.code, code, answer)
            error = answer.json()["error"]
            self.assertEqual(error["code"], code)
            self.assertTrue(error["message"], answer)
        self.assertIn("engine version", self.ask("--version")["text"])
        self.assertIn("attempts", self.ask("--help")["text"])


class ReadOnlyDirectory(RecordedTest):
    """A medium that cannot be written is read all the same."""

    @contextlib.contextmanager
    def read_only(self):
        """To the superuser permissions mean nothing: then the program runs as nobody."""
        if os.geteuid() == 0:
            nobody = 65534
            for file in (self.folder, *self.folder.rglob("*")):
                os.chown(file, nobody, nobody)
            self.program_user = {"user": nobody, "group": nobody, "extra_groups": []}
        self.data.chmod(0o500)
        try:
            yield
        finally:
            self.data.chmod(0o700)
            self.program_user = {}

    def expect_readable(self):
        self.assertIs(self.ask("verify")["whole"], True)
        self.assertEqual(len(self.ask("attempts")), 1)
        self.assertIs(self.ask("replay", self.attempt)["identical"], True)
        self.assertEqual(self.ask("sql", "SELECT count(*) FROM attempt")["rows"], [[1]])
        self.assertEqual(self.hallux("report", self.attempt, "-o", self.folder / "page.html").code, DONE)
        self.assertEqual(self.hallux("attempt", "silver").code, STORAGE)

    def test_it_can_be_read_and_verified(self):
        with self.read_only():
            self.expect_readable()

    def test_it_can_be_read_with_what_lies_in_its_log(self):
        """As a killed writer left it; where the log was, a private copy is read, and gone afterwards."""
        writer = self.start("attempt", "silver", "--pacing", "real-time")
        end = time.monotonic() + 60
        while time.monotonic() < end and self.query("SELECT count(*) FROM attempt") != [(2, )]:
            time.sleep(0.1)
        writer.kill()
        writer.wait()
        (self.data / "hallux.db-shm").unlink()
        before = set(pathlib.Path(tempfile.gettempdir()).glob("hallux-read-*"))
        with self.read_only():
            self.assertIs(self.ask("verify")["whole"], True)
            self.assertEqual(len(self.ask("attempts")), 2)
        self.assertEqual(set(pathlib.Path(tempfile.gettempdir()).glob("hallux-read-*")) - before, set())


if __name__ == "__main__":
    unittest.main()
