#!/usr/bin/env python3
"""A directory that the program of engine version 6 made: its attempts are whole, keep their scores, and are not replayed."""

import json
import pathlib
import tarfile
import unittest

from hallux_command import CommandTest

OLD = pathlib.Path(__file__).parent / "old" / "engine_6.tar.xz"


class AnOldDirectory(CommandTest):
    def setUp(self):
        super().setUp()
        self.data.mkdir(mode=0o700)
        with tarfile.open(OLD) as packed:
            packed.extract("hallux.db", self.data)
        self.kept = dict(self.query("SELECT uuid, card_json FROM score JOIN attempt USING (attempt_id)"))

    def test_keeps_every_score_and_every_loss_of_it(self):
        self.assertEqual(len(self.kept), 2)
        self.assertIs(self.ask("verify", "--no-backup")["whole"], True)
        for attempt, card_json in self.kept.items():
            card = json.loads(card_json)
            scored = self.ask("score", attempt)
            self.assertEqual(scored["engine"], 6)
            self.assertEqual(round(1000 * scored["score"]), card["score_milli"])
            self.assertEqual([(line["item"], line["value"], line["rubric_points_lost"]) for line in scored["ledger"]],
                             [(line["item"], line["value"], line["points_lost_milli"] / 1000) for line in card["ledger"]])

    def test_says_that_a_replay_proves_nothing(self):
        self.ask("verify", "--no-backup")
        for attempt in self.kept:
            answer = self.ask("replay", attempt)
            self.assertIsNone(answer["identical"])
            self.assertEqual(answer["attempt_engine"], 6)


if __name__ == "__main__":
    unittest.main()
