#!/usr/bin/env python3
"""A program that is stopped or killed while it records keeps what it had, and never harms an older attempt."""

import signal
import unittest

from hallux_command import DONE, INTERRUPTED, STORAGE, RecordedTest, coarse_silver

MOTION_S = 4.0
LOST_AT_MOST_TICKS = 600


def motion():
    """Down beside the bone and back up, four seconds of hand."""
    heights_mm = ((0.0, 90.0), (MOTION_S / 2, 60.0), (MOTION_S, 90.0))
    return {"keys": [{"time_s": time_s, "tip_mm": [0, 0, height_mm], "direction": [1, 0, 0], "normal": [0, 0, 1],
                      "saw": True} for time_s, height_mm in heights_mm]}


class Killed(RecordedTest):
    def setUp(self):
        super().setUp()
        self.process = self.start("attempt", self.write("coarse.json", coarse_silver()), "--pacing", "real-time",
                                  "--hand", self.write("hand.json", motion()))

    def wait_for_half(self):
        """Reads progress until half of the motion was operated; returns the ticks that were surely done by then."""
        for said in self.process.stderr:
            words = said.split()
            if words[:1] == ["Operating"] and int(words[1]) >= 50:
                return int(int(words[1]) / 100 * 1000 * MOTION_S)
        self.fail("the attempt ended before half of it was operated")

    def newest(self):
        return self.ask("attempts")[0]

    def ticks_kept(self, attempt):
        [(ticks,)] = self.query("SELECT MAX(first_tick + row_count) FROM chunk JOIN attempt USING (attempt_id) "
                                "WHERE uuid = ? AND stream = 1", (attempt,))
        return ticks

    def expect_interrupted(self, ticks_done):
        """The newest attempt is interrupted, kept up to 0.6 s, whole and provable; the older one is untouched."""
        rows = self.ask("attempts")
        self.assertEqual([row["state"] for row in rows], ["interrupted", "closed"])
        self.assertEqual(rows[1]["attempt"], self.attempt)
        self.assertIsNone(rows[0]["score"])
        broken = rows[0]["attempt"]
        self.assertGreaterEqual(self.ticks_kept(broken), ticks_done - LOST_AT_MOST_TICKS)
        self.assertIs(self.ask("verify")["whole"], True)
        for attempt in (broken, self.attempt):
            self.assertIs(self.ask("replay", attempt)["identical"], True)
        self.assertEqual(self.ask("score", self.attempt)["score"], self.recorded.json()["score"])
        self.assertEqual(self.newest()["state"], "interrupted", "it is never sealed later")

    def test_kill_nine_loses_at_most_the_last_moments(self):
        ticks_done = self.wait_for_half()
        self.process.send_signal(signal.SIGKILL)
        self.process.wait(timeout=10)
        self.assertEqual(self.process.returncode, -signal.SIGKILL)
        self.expect_interrupted(ticks_done)

    def test_control_c_ends_it_in_order(self):
        ticks_done = self.wait_for_half()
        self.process.send_signal(signal.SIGINT)
        out, err = self.process.communicate(timeout=20)
        self.assertEqual(self.process.returncode, INTERRUPTED, err)
        self.assertEqual(out, "")
        self.assertIn(self.newest()["attempt"], err)
        self.assertIn("interrupted", err)
        self.expect_interrupted(ticks_done)

    def test_while_it_records_others_can_read(self):
        self.wait_for_half()
        self.assertEqual(self.newest()["state"], "recording")
        self.assertIs(self.ask("replay", self.attempt)["identical"], True)
        self.assertIs(self.ask("verify")["whole"], True)
        self.process.communicate(timeout=30)
        self.assertEqual(self.process.returncode, DONE)
        self.assertEqual(self.newest()["state"], "closed")
        self.assertIs(self.ask("replay", self.newest()["attempt"])["identical"], True)


class KilledBetween(RecordedTest):
    def test_control_c_while_the_bone_is_built_stores_nothing(self):
        before = self.stored()
        process = self.start("attempt", "silver")
        for said in process.stderr:
            if said.startswith("Building the bone"):
                break
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=20)
        self.assertEqual(process.returncode, INTERRUPTED)
        self.assertEqual(self.stored(), before)
        self.assertEqual([row["state"] for row in self.ask("attempts")], ["closed"])

    def test_a_directory_that_is_full_ends_the_attempt_and_spares_the_older(self):
        answer = self.run_with_room(self.database().stat().st_size + 200_000, "attempt",
                                    self.write("coarse.json", coarse_silver()), "--seed", "2", "--quiet")
        self.assertEqual(answer.code, STORAGE, answer)
        self.assertEqual((answer.out, len(answer.err.splitlines())), ("", 1), answer)
        self.assertIn("hallux.db", answer.err)
        rows = self.ask("attempts")
        self.assertEqual([row["state"] for row in rows], ["interrupted", "closed"])
        self.assertIs(self.ask("verify")["whole"], True)
        for row in rows:
            self.assertIs(self.ask("replay", row["attempt"])["identical"], True)


if __name__ == "__main__":
    unittest.main()
