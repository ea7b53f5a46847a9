#!/usr/bin/env python3
"""The verbs that write most are killed (`kill -9`) at random moments: what was there is there, `verify` finds the directory whole,
and the same once more completes it. HALLUX_KILLS says how often each; the moments follow from its seed."""

import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from hallux_command import DONE, PROGRAM, CommandTest, coarse_silver

KILLS = int(os.environ.get("HALLUX_KILLS", "2"))
COURSE = pathlib.Path(os.environ["HALLUX_DEMO_COURSE"])
PASSWORD = "saw bone hinge wire"
ATTEMPTS = 4


class Killed(CommandTest):
    """`original` is copied before each kill; a test says what it does and what must hold after a kill."""

    def setUp(self):
        super().setUp()
        self.original = self.folder / "original"
        self.random = random.Random(19)

    def fresh(self):
        shutil.rmtree(self.data, ignore_errors=True)
        if self.original.exists():
            shutil.copytree(self.original, self.data)

    def keep_as_original(self):
        shutil.rmtree(self.original)
        shutil.copytree(self.data, self.original)

    def run_whole(self, arguments, stdin=""):
        """How long it takes when nobody kills it [s]."""
        self.fresh()
        begin = time.monotonic()
        answer = self.hallux(*arguments, "--quiet", stdin=stdin)
        self.assertEqual(answer.code, DONE, answer)
        return time.monotonic() - begin

    def run_and_kill(self, arguments, stdin, after_s):
        """True where it was still at work."""
        process = subprocess.Popen(self.line([*arguments, "--quiet"]), stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, text=True, cwd=self.untouched[2], env=self.environment())
        process.stdin.write(stdin)
        process.stdin.close()
        time.sleep(after_s)
        process.kill()
        return process.wait() != DONE

    def kill_again_and_again(self, arguments, check, stdin="", longest_s=None):
        """`check` is called after each kill and once more when the same has completed."""
        whole_s = longest_s or self.run_whole(arguments, stdin)
        killed = 0
        for _ in range(KILLS):
            self.fresh()
            killed += self.run_and_kill(arguments, stdin, self.random.uniform(0.0, whole_s))
            check()
        print(f"{arguments[0]}: killed {killed} of {KILLS} times within {whole_s:.2f} s")
        return killed

    def expect_whole(self):
        self.assertIs(self.ask("verify")["whole"], True)

    def count(self, table):
        return self.query(f"SELECT count(*) FROM {table}")[0][0]


class KilledInACourse(Killed):
    """Of the simulated course."""

    def setUp(self):
        super().setUp()
        shutil.copytree(COURSE / "data", self.original)
        self.password = json.loads((COURSE / "answer.json").read_text())["password"] + "\n"

    def as_administrator(self, *arguments):
        return self.ask(*arguments, "--as", "administrator", stdin=self.password)

    def test_a_person_is_erased_or_there(self):
        arguments = ["user", "erase", "trainee-3", "--with-recordings", "--reason", "left", "--as", "administrator"]

        def names_them():
            return [file for file in self.data.rglob("*") if file.is_file() and b"trainee-3" in file.read_bytes()]

        def check():
            self.expect_whole()
            self.assertEqual(self.count("attempt"), 8)
            if ("trainee-3",) in self.query("SELECT login FROM person_detail"):
                self.assertEqual(self.hallux(*arguments, stdin=self.password).code, DONE)
            else:
                # Whoever comes next clears what the killed one left in the log.
                self.assertEqual(self.hallux("attempts", "--as", "administrator", stdin=self.password).code, DONE)
            self.assertEqual(names_them(), [])
            self.expect_whole()

        self.kill_again_and_again(arguments, check, stdin=self.password)

    def test_a_recording_goes_wholly_or_stays(self):
        """The course is of the past, so that a day is enough."""
        self.fresh()
        self.as_administrator("retention", "--practice-days", "1", "--assessment-days", "1")
        self.keep_as_original()

        def check():
            self.expect_whole()
            self.assertEqual(self.count("attempt"), 8)
            self.as_administrator("retention")
            self.assertEqual(self.as_administrator("retention", "--dry-run")["pieces"], [])
            self.expect_whole()

        self.kill_again_and_again(["retention", "--as", "administrator"], check, stdin=self.password)

    def test_a_simulated_course_is_there_or_not(self):
        """Its moments: the first seconds, in which people and the first attempts are made."""
        shutil.rmtree(self.original)

        def check():
            if self.database().exists():
                self.expect_whole()
                self.assertEqual(self.count("simulated_course"), 1)

        self.kill_again_and_again(["demo", "--attempts", "1"], check, longest_s=4.0 if KILLS < 10 else None)
        # What the last one left is in nobody's way.
        self.run_and_kill(["demo", "--attempts", "1"], "", 2.0)
        process = self.start("demo", "--attempts", "1")
        for line in process.stderr:
            if line.startswith("Operating"):
                break
        process.send_signal(signal.SIGINT)
        process.wait(timeout=60)
        self.assertEqual([file for file in self.data.rglob("*") if file.is_file()], [])


class KilledInADirectory(Killed):
    """Of the robot's attempts at two versions of an operation."""

    @classmethod
    def setUpClass(cls):
        shelf = tempfile.TemporaryDirectory(prefix="hallux-kills-")
        cls.addClassCleanup(shelf.cleanup)
        cls.shelf = pathlib.Path(shelf.name)
        later = coarse_silver()
        later["version"] += 1
        cls.later_version = str(later["version"])
        for number, scenario in enumerate([coarse_silver()] * (ATTEMPTS - 1) + [later]):
            file = cls.shelf / "scenario.json"
            file.write_text(json.dumps(scenario))
            subprocess.run([PROGRAM, "attempt", str(file), "--seed", str(number + 1), "--quiet", "--data",
                            str(cls.shelf / "data")], check=True, stdout=subprocess.DEVNULL)

    def setUp(self):
        super().setUp()
        shutil.copytree(self.shelf / "data", self.original)

    def test_each_attempt_has_its_old_score_and_perhaps_the_new_one(self):
        arguments = ["rescore", "silver", "--with-version", self.later_version]

        def check():
            self.expect_whole()
            self.assertEqual(self.count("score WHERE superseded_by IS NULL"), ATTEMPTS)
            self.assertIn(self.count("score"), range(ATTEMPTS, 2 * ATTEMPTS))
            self.assertEqual(self.hallux(*arguments).code, DONE)
            self.assertEqual(self.count("score"), 2 * ATTEMPTS - 1)
            self.expect_whole()

        self.kill_again_and_again(arguments, check)

    def test_each_attempt_is_taken_in_wholly_or_not_at_all(self):
        self.fresh()
        out = self.folder / "out"
        self.ask("export", "--all", "-o", out)
        shutil.rmtree(self.data)
        self.ask("user", "add", "administrator", "--administrator", stdin=PASSWORD + "\n")
        self.keep_as_original()
        arguments = ["import", str(out), "--as", "administrator"]

        def check():
            self.expect_whole()
            self.assertIn(self.count("attempt"), range(ATTEMPTS + 1))
            self.assertEqual(self.count("attempt WHERE seal IS NULL"), 0)
            self.assertEqual(self.hallux(*arguments, stdin=PASSWORD + "\n").code, DONE)
            self.assertEqual(self.count("attempt"), ATTEMPTS)
            self.expect_whole()

        self.kill_again_and_again(arguments, check, stdin=PASSWORD + "\n")


if __name__ == "__main__":
    unittest.main()
