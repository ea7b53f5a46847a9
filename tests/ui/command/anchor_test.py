#!/usr/bin/env python3
"""An anchor that somebody keeps elsewhere shows what a chain without a secret cannot: acts cut off, or all written anew."""

import unittest

from hallux_command import BAD_INPUT, CHECK_FAILED, DONE, RecordedTest, coarse_silver


class Anchors(RecordedTest):
    def anchor_file(self, text=None):
        return self.write("anchor.txt", text or self.ask("anchor")["anchor"] + "\n")

    def act(self):
        """More acts of the audit; the newest stores measurements."""
        self.ask("attempt", self.write("coarse.json", coarse_silver()), "--seed", 2)

    def cut_off_the_newest_act(self):
        [(newest, )] = self.query("SELECT max(audit_id) FROM audit")
        made = self.query("SELECT name, sql FROM sqlite_schema WHERE type = 'trigger'")
        for name, _ in made:
            self.alter(f"DROP TRIGGER {name}")
        self.alter("DELETE FROM audit_row WHERE audit_id = ?", (newest, ))
        self.alter("DELETE FROM audit WHERE audit_id = ?", (newest, ))
        for table in ("measurement", "measurement_set"):
            self.alter(f"DELETE FROM {table} WHERE measurement_set_id = (SELECT max(measurement_set_id) FROM measurement_set)")
        for _, sql in made:
            self.alter(sql)

    def test_it_is_held_as_long_as_acts_are_only_added(self):
        file = self.anchor_file()
        self.act()
        found = self.ask("verify", "--anchor", file)
        self.assertEqual((found["whole"], found["anchors"]), (True, 1))

    def test_acts_that_were_cut_off_are_seen_by_it_alone(self):
        self.act()
        file = self.anchor_file()
        self.cut_off_the_newest_act()
        self.assertIs(self.ask("verify")["whole"], True)
        found = self.ask("verify", "--anchor", file, code=CHECK_FAILED)
        self.assertIn("is missing", found["first_damage"])

    def test_another_history_is_seen(self):
        line = self.ask("anchor")["anchor"].split()
        line[3] = "00" * 32
        found = self.ask("verify", "--anchor", self.anchor_file(" ".join(line)), code=CHECK_FAILED)
        self.assertIn("was another", found["first_damage"])

    def test_reports_and_backups_carry_one(self):
        page = self.folder / "page.html"
        self.assertEqual(self.hallux("report", self.attempt, "-o", page).code, DONE)
        self.assertEqual(self.ask("verify", "--anchor", page)["anchors"], 1)
        backed_up = self.ask("backup", "--to", self.folder / "kept")
        self.assertEqual(self.ask("verify", "--anchor", self.anchor_file(backed_up["anchor"]))["anchors"], 1)

    def test_what_is_no_anchor_is_bad_input(self):
        for text in ("my thesis", "hallux-anchor", "hallux-anchor x 1 2 3"):
            self.expect_refusal(BAD_INPUT, ["anchor"], "verify", "--anchor", self.anchor_file(text))
        line = self.ask("anchor")["anchor"].split()
        line[1] = "0" * 32
        self.expect_refusal(BAD_INPUT, ["another directory"], "verify", "--anchor", self.anchor_file(" ".join(line)))


if __name__ == "__main__":
    unittest.main()
