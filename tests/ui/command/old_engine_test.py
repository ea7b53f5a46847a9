#!/usr/bin/env python3
"""Directories that the programs of older engine versions made: attempts are whole, keep their scores, and are not replayed."""

import json
import pathlib
import tarfile
import unittest

from hallux_command import CommandTest

OLD = pathlib.Path(__file__).parent / "old"


class AnOldDirectory:
    engine = 0

    def setUp(self):
        super().setUp()
        self.data.mkdir(mode=0o700)
        with tarfile.open(OLD / f"engine_{self.engine}.tar.xz") as packed:
            packed.extract("hallux.db", self.data)
        # Brings the schema up, as whoever opens it next does.
        self.ask("attempts")
        self.kept = dict(self.query("SELECT uuid, card_json FROM score JOIN attempt USING (attempt_id)"))

    def test_keeps_every_score_and_every_loss_of_it(self):
        self.assertEqual(len(self.kept), 2)
        self.assertIs(self.ask("verify", "--no-backup")["whole"], True)
        for attempt, card_json in self.kept.items():
            card = json.loads(card_json)
            scored = self.ask("score", attempt)
            self.assertEqual(scored["engine"], self.engine)
            self.assertEqual(round(1000 * scored["score"]), card["score_milli"])
            self.assertEqual([(line["item"], line["value"], line["rubric_points_lost"]) for line in scored["ledger"]],
                             [(line["item"], line["value"], line["points_lost_milli"] / 1000) for line in card["ledger"]])

    def test_says_that_a_replay_proves_nothing(self):
        self.ask("verify", "--no-backup")
        for attempt in self.kept:
            answer = self.ask("replay", attempt)
            self.assertIsNone(answer["identical"])
            self.assertEqual(answer["attempt_engine"], self.engine)


class ADirectoryOfEngine6(AnOldDirectory, CommandTest):
    engine = 6


class ADirectoryOfEngine7(AnOldDirectory, CommandTest):
    engine = 7

    def test_measures_the_same_from_the_recordings(self):
        for (trigger,) in self.query("SELECT name FROM sqlite_master WHERE type = 'trigger' AND tbl_name LIKE 'measurement%'"):
            self.alter(f"DROP TRIGGER {trigger}")
        self.assertGreater(self.alter("DELETE FROM measurement"), 0)
        self.alter("DELETE FROM measurement_set")
        for operation in ("akin", "silver"):
            answer = self.ask("rescore", operation, "--dry-run")
            self.assertEqual(answer["attempts"], 1)
            for row in answer["rows"]:
                self.assertEqual(row["before"]["score"], row["after"]["score"], row)


if __name__ == "__main__":
    unittest.main()
