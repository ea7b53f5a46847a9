#!/usr/bin/env python3
"""`hallux demo`: a simulated course, marked as such, in a directory where nobody is; all of it or nothing."""

import contextlib
import json
import os
import pathlib
import shutil
import signal
import sqlite3
import unittest

from hallux_command import INTERRUPTED, REFUSED, WRONG_USAGE, CommandTest

TRAINEES = [f"trainee-{number}" for number in range(1, 9)]
INSTRUCTORS = ["instructor-1", "instructor-2"]


COURSE = pathlib.Path(os.environ["HALLUX_DEMO_COURSE"])


class Demo(CommandTest):
    """The course was made once, with one attempt of each trainee; each test looks at a copy."""

    @classmethod
    def setUpClass(cls):
        cls.course = json.loads((COURSE / "answer.json").read_text())
        cls.said = (COURSE / "said.txt").read_text()

    def setUp(self):
        super().setUp()
        shutil.copytree(COURSE / "data", self.data)

    def as_(self, login, *arguments):
        return self.ask(*arguments, "--as", login, stdin=self.course["password"] + "\n")

    def test_it_says_who_there_is_and_the_password_once(self):
        roles = {account["login"]: account["role"] for account in self.course["accounts"]}
        self.assertEqual(roles, {"administrator": "administrator", **dict.fromkeys(INSTRUCTORS, "instructor"),
                                 **dict.fromkeys(TRAINEES, "trainee")})
        self.assertIs(self.course["simulated"], True)
        self.assertGreaterEqual(len(self.course["password"]), 12)
        self.assertNotIn(self.course["password"], self.said)
        for file in self.data.rglob("*"):
            if file.is_file():
                self.assertNotIn(self.course["password"].encode(), file.read_bytes(), file)

    def test_everything_in_it_is_marked(self):
        self.assertEqual(self.query("SELECT count(*) FROM simulated_course"), [(1,)])
        self.assertEqual(self.query("SELECT count(*), min(is_simulated) FROM attempt"), [(8, 1)])
        names = [name for (name,) in self.query("SELECT display_name FROM person_detail")]
        self.assertEqual(len(names), 11)
        for name in names:
            self.assertRegex(name, r"^(Administrator|Instructor [12]|Trainee [1-8])$", "nobody is named")

    def test_every_kind_of_row_is_there(self):
        for table, count in (("note", self.course["notes"]), ("note_reply", self.course["replies"]),
                             ("help_request", self.course["help_requests"]), ("decision", self.course["decisions"])):
            self.assertEqual(self.query(f"SELECT count(*) FROM {table}"), [(count,)])
            self.assertGreater(count, 0)
        kinds = {kind for (kind,) in self.query("SELECT kind FROM decision")}
        self.assertEqual(kinds, {"confirmed", "overridden", "voided"})
        states = {state for (state,) in self.query("SELECT state FROM scenario_state")}
        self.assertEqual(states, {"draft", "published", "retired"})
        self.assertEqual({hidden for (hidden,) in self.query("SELECT is_private FROM note")}, {0, 1})
        [(open_ones, answered)] = self.query("SELECT sum(answered_utc IS NULL), count(answered_utc) FROM help_request")
        self.assertGreater(open_ones, 0)
        self.assertGreater(answered, 0)

    def test_its_chains_are_whole_and_its_attempts_can_be_proved(self):
        self.assertIs(self.ask("verify")["whole"], True)
        attempt = self.as_("trainee-1", "attempts")[0]["attempt"]
        self.assertIs(self.as_("trainee-1", "replay", attempt)["identical"], True)
        again = self.as_("trainee-1", "score", attempt)
        kept = self.as_("trainee-1", "attempts")[0]
        self.assertEqual(again["score"], kept["score"], "the score that the demo kept follows from its recording")

    def test_every_score_is_whole_and_somebody_passes(self):
        results = [row["result"] for login in INSTRUCTORS for row in self.as_(login, "attempts") if row["result"]]
        self.assertEqual({result["measured_weight"] for result in results}, {100.0})
        self.assertTrue(any(result["passed"] for result in results))
        self.assertTrue(any(not result["passed"] for result in results))

    def test_a_trainee_sees_their_own_and_an_instructor_their_cohort(self):
        self.assertEqual([row["person"] for row in self.as_("trainee-2", "attempts")], ["trainee-2"])
        of_first = {row["person"] for row in self.as_("instructor-1", "attempts")}
        self.assertEqual(of_first, set(TRAINEES[:5]))
        of_second = {row["person"] for row in self.as_("instructor-2", "attempts")}
        self.assertEqual(of_second, set(TRAINEES[5:]))
        self.assertEqual(self.as_("administrator", "attempts"), [])
        for row in self.as_("instructor-1", "attempts"):
            self.assertIs(row["simulated"], True)

    def test_an_override_keeps_the_machines_score(self):
        [row] = self.as_("trainee-1", "attempts")
        self.assertEqual(row["decision"], "overridden")
        self.assertEqual(row["decided_score"], min(100, round(row["score"] + 5, 3)))
        self.assertEqual(row["result"]["score"], row["decided_score"])
        self.assertIs(row["signed_for_score_in_force"], True)

    def test_a_signature_stays_with_its_score_and_is_no_grade_for_another(self):
        signed = "attempt_id = (SELECT attempt_id FROM decision WHERE kind = 'overridden' LIMIT 1)"
        self.alter(f"UPDATE attempt SET is_simulated = 0, is_valid = 1, hand = '', kind = 'assessment' WHERE {signed}")
        [before] = self.as_("trainee-1", "attempts")
        self.assertIs(before["grade"], True)
        self.alter(f"UPDATE score SET superseded_by = 9999 WHERE superseded_by IS NULL AND {signed}")
        self.alter("INSERT INTO score SELECT 9999, attempt_id, scenario_version, rubric_version + 1, engine_version, 99000, 100000, card_json, "
                   "stored_utc, NULL, rubric_milli, 1, safety_measured_milli, safety_earned_milli FROM score WHERE superseded_by = 9999")
        [after] = self.as_("trainee-1", "attempts")
        self.assertEqual((after["score"], after["grade"], after["signed_for_score_in_force"]), (99.0, False, False))
        self.assertEqual(after["result"], before["result"], "points, rubric, verdict and gates of what was signed")

    def alter(self, statement):
        """As another program may: nobody asks the audit."""
        with contextlib.closing(sqlite3.connect(self.data / "hallux.db")) as database, database:
            database.execute(statement)

    def test_it_is_told_of_the_past_in_the_order_of_the_audit(self):
        """But for the first act, which is of the day on which the directory was made."""
        times = [time for (time,) in self.query("SELECT at_utc FROM audit WHERE action <> 'baseline_taken' ORDER BY audit_id")]
        self.assertEqual(times, sorted(times))
        self.assertGreater(times[-1][:10], times[0][:10])
        self.assertEqual(self.query("SELECT count(*) FROM audit WHERE outcome = 'refused'"), [(1,)])

    def test_it_is_made_once(self):
        before = self.stored()
        self.expect_refusal(REFUSED, ["people", str(self.data)], "demo")
        self.assertEqual(self.stored(), before)


class Refused(CommandTest):
    def test_where_people_are_nothing_is_simulated(self):
        self.ask("user", "add", "ada", "--administrator", stdin="saw bone hinge wire\n")
        before = self.stored()
        self.expect_refusal(REFUSED, ["people", str(self.data)], "demo")
        self.assertEqual(self.stored(), before)
        self.assertEqual(self.query("SELECT count(*) FROM simulated_course"), [(0,)])

    def test_nobody_signs_in_to_make_it(self):
        self.expect_refusal(WRONG_USAGE, ["--as"], "demo", "--as", "ada")
        self.assertFalse(self.data.exists())

    def test_stopped_it_leaves_nothing(self):
        process = self.start("demo")
        for line in process.stderr:
            if line.startswith("Operating"):
                break
        process.send_signal(signal.SIGINT)
        process.wait(timeout=60)
        self.assertEqual(process.returncode, INTERRUPTED)
        self.assertFalse(self.data.exists())


if __name__ == "__main__":
    unittest.main()
