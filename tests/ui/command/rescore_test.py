#!/usr/bin/env python3
"""All attempts of an operation scored anew: what would change is said first, old scores stay, and nobody scores their own."""

import json
import signal
import unittest

from hallux_command import BAD_INPUT, CHECK_FAILED, INTERRUPTED, REFUSED, RecordedTest, coarse_silver


class Rescored(RecordedTest):
    def put_old_score(self):
        """As if an earlier version of the program had scored the attempt otherwise."""
        [(attempt, card)] = self.query("SELECT attempt_id, card_json FROM score WHERE superseded_by IS NULL")
        old = json.loads(card)
        old["score_milli"] = 12_000
        old["rubric_version"] = 0
        self.alter("UPDATE score SET superseded_by = score_id")
        self.alter("INSERT INTO score (attempt_id, scenario_version, rubric_version, engine_version, score_milli, "
                   "measured_weight_milli, card_json, stored_utc) VALUES (?, 1, 0, 1, 12000, 100000, ?, '2026-01-01')",
                   (attempt, json.dumps(old)))

    def scores(self):
        return self.query("SELECT score_milli, superseded_by IS NULL FROM score ORDER BY score_id")

    def test_nothing_changes_where_the_program_is_the_same(self):
        before = self.scores()
        answer = self.ask("rescore", "silver")
        self.assertEqual((answer["attempts"], answer["changed"], answer["stored"]), (1, 0, 0))
        self.assertEqual(answer["rows"][0]["attempt"], self.attempt)
        self.assertIsNone(answer["rows"][0]["login"], "the robot has none")
        self.assertEqual(self.scores(), before)

    def test_a_dry_run_says_what_would_change_and_stores_nothing(self):
        self.put_old_score()
        before = self.scores()
        answer = self.ask("rescore", "silver", "--dry-run")
        self.assertEqual((answer["changed"], answer["stored"]), (1, 0))
        [row] = answer["rows"]
        self.assertEqual(row["before"]["score"], 12.0)
        self.assertEqual(row["after"]["score"], self.recorded.json()["score"])
        self.assertEqual(self.scores(), before)
        self.assertIn("would be stored", self.hallux("rescore", "silver", "--dry-run").out)

    def test_the_new_score_stands_beside_the_old_ones_and_is_audited(self):
        self.put_old_score()
        before = self.scores()
        audited = self.query("SELECT count(*) FROM audit WHERE action = 'score_stored'")
        answer = self.ask("rescore", "silver")
        self.assertEqual((answer["changed"], answer["stored"]), (1, 1))
        after = self.scores()
        self.assertEqual([milli for milli, _ in after[:-1]], [milli for milli, _ in before])
        self.assertEqual([in_force for _, in_force in after], [0] * len(before) + [1])
        self.assertEqual(self.query("SELECT count(*) FROM audit WHERE action = 'score_stored'")[0][0], audited[0][0] + 1)
        self.assertEqual(self.ask("rescore", "silver")["stored"], 0)

    def forget_measurements(self):
        """As in a directory of an older program, which kept none."""
        for table in ("measurement", "measurement_set"):
            [(name, sql)] = self.query("SELECT name, sql FROM sqlite_schema WHERE type = 'trigger' AND tbl_name = ? AND name "
                                       "LIKE '%deleted'", (table,))
            self.alter(f"DROP TRIGGER {name}")
            self.alter(f"DELETE FROM {table}")
            self.alter(sql)

    def otherwise_weighted(self):
        """The next version of the coarse scenario: two items of a group have changed weights."""
        scenario = coarse_silver()
        scenario["version"] += 1
        scenario["rubric"]["version"] += 1
        accuracy = [item for item in scenario["rubric"]["items"] if item["group"] == "accuracy"]
        first, second = accuracy[0], next(item for item in accuracy if item["weight"] != accuracy[0]["weight"])
        first["weight"], second["weight"] = second["weight"], first["weight"]
        return scenario

    def test_other_weights_score_what_was_measured_without_the_recording(self):
        scenario = self.otherwise_weighted()
        self.ask("attempt", self.write("other.json", scenario), "--seed", 2)
        again = ["rescore", "silver", "--with-version", scenario["version"], "--dry-run"]
        kept = self.ask(*again)["rows"]
        self.assertEqual(kept[0]["after"]["rubric_version"], scenario["rubric"]["version"])
        self.forget_measurements()
        self.assertEqual(self.ask(*again)["rows"], kept, "measured again from the recordings")
        self.ask(*[word for word in again if word != "--dry-run"])
        self.alter("DELETE FROM chunk")
        self.assertEqual([row["after"] for row in self.ask(*again)["rows"]], [row["after"] for row in kept])

    def test_an_attempt_that_cannot_be_read_is_named_and_the_answer_says_so(self):
        self.forget_measurements()
        self.alter("DELETE FROM chunk WHERE seq = 3")
        answer = self.ask("rescore", "silver", code=CHECK_FAILED)
        self.assertEqual(answer["not_scored"], 1)
        self.assertIn("restore a backup", answer["rows"][0]["fault"])

    def test_it_tells_how_far_it_is_and_stops_when_asked(self):
        for seed in range(2, 5):
            self.ask("attempt", self.write("coarse.json", coarse_silver()), "--seed", seed)
        self.forget_measurements()
        before = self.scores()
        process = self.start("rescore", "silver", "--dry-run")
        for said in process.stderr:
            words = said.split()
            if words[:1] == ["Scoring"] and int(words[1]) > 0:
                break
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (INTERRUPTED, ""), err)
        self.assertRegex(err, "the scoring was stopped after [1-3] of 4 attempts; 0 new scores were stored")
        self.assertEqual(self.scores(), before)

    def test_what_is_not_there_is_refused(self):
        self.expect_refusal(BAD_INPUT, ["no attempt of 'gold'", "hallux attempts"], "rescore", "gold")
        self.expect_refusal(BAD_INPUT, ["no version 9 of 'silver'"], "rescore", "silver", "--with-version", "9")
        self.assertEqual(self.ask("rescore", "silver", "--with-version", "3")["attempts"], 1)

    def test_nobody_scores_their_own_with_another_rubric(self):
        self.hallux("user", "add", "administrator", "--administrator", stdin="saw bone hinge wire\n")
        added = self.ask("user", "add", "trainee-1", "--as", "administrator", stdin="saw bone hinge wire\nplate screw wire saw\n")
        self.assertEqual(added["login"], "trainee-1")
        self.expect_refusal(REFUSED, ["only instructors and administrators"], "rescore", "silver", "--as", "trainee-1",
                            stdin="plate screw wire saw\n")
        answer = self.ask("rescore", "silver", "--as", "administrator", stdin="saw bone hinge wire\n")
        self.assertEqual(answer["attempts"], 1, "the robot's")


if __name__ == "__main__":
    unittest.main()
