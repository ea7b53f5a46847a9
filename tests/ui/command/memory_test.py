#!/usr/bin/env python3
"""What memory a scripted attempt takes, from the bone to its score, however long somebody saws.

HALLUX_MINUTES of sawing, and one: strokes into three kerfs one after the other, each stroke a little deeper than the one before and out
of the bone in between. Where they lie is taken from the expert's recording.
"""

import csv
import math
import os
import unittest

from hallux_command import ATTEMPT_KIB_AT_MOST, CommandTest, greatest_kib

STROKE_S = 3.0
PLANE_FROZEN = 4
# A sample takes 56 bytes; the tape with its lines would be 112 more.
SCORED_BYTES_A_TICK_AT_MOST = 110


def axes(w, x, y, z):
    """The first and the third column of a rotation: the feed, and the blade's normal."""
    length = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / length, x / length, y / length, z / length
    return ([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
            [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])


def tool_at(rows, tick):
    """Place of the teeth, feed and normal."""
    row = next(row for row in rows if int(row["tick_ms"]) == tick)
    place = [int(row[f"tool_{axis}_um"]) * 1e-3 for axis in "xyz"]
    return place, *axes(*(int(row[f"tool_q{part}_micro"]) for part in "wxyz"))


def strokes(place, feed, normal, minutes):
    keys = []

    def go_to(time_s, deep_mm, beside_mm):
        tip = [place[i] + deep_mm * feed[i] + beside_mm * normal[i] for i in range(3)]
        keys.append({"time_s": round(time_s, 3), "tip_mm": tip, "direction": feed, "normal": normal, "saw": True})

    go_to(0.0, -8.0, 0.0)
    count = int(minutes * 60 / STROKE_S)
    for stroke in range(count):
        start_s = 0.5 + STROKE_S * stroke
        beside_mm = -1.2 * (stroke * 3 // count)
        deep_mm = 0.6 + 13.0 * (stroke * 3 / count % 1.0)
        for after_s, there_mm in ((0.0, -6.0), (0.5, -1.0), (2.0, deep_mm + 0.5), (2.4, deep_mm), (2.8, -6.0)):
            go_to(start_s + after_s, there_mm, beside_mm)
    return {"keys": keys}


class Memory(CommandTest):
    patience_s = 3000

    def exported(self, attempt):
        """Its samples and its events."""
        self.ask("export", attempt, "-o", self.folder / f"of-{attempt}")
        tables = []
        for name in ("samples", "events"):
            with open(self.folder / f"of-{attempt}" / attempt / f"{name}.csv", encoding="utf-8", newline="") as file:
                tables.append(list(csv.DictReader(file)))
        return tables

    def sawn_for(self, minutes, tool):
        answer = self.ask("attempt", "silver", "--hand", self.write("strokes.json", strokes(*tool, minutes)))
        self.assertGreater(answer["duration_s"], 60.0 * minutes - 2 * STROKE_S)
        self.assertTrue(answer["quality"]["complete"])
        return answer

    def test_minutes_of_sawing_take_less_than_300_megabytes_with_their_score(self):
        samples, events = self.exported(self.ask("attempt", "silver")["attempt"])
        tool = tool_at(samples, next(int(row["tick_ms"]) for row in events if int(row["kind"]) == PLANE_FROZEN))

        minutes = float(os.environ["HALLUX_MINUTES"])
        answer = self.sawn_for(minutes, tool)
        taken_kib = greatest_kib()
        print(f"{minutes:g} minutes: {taken_kib} KiB at most")
        self.assertLess(taken_kib, ATTEMPT_KIB_AT_MOST)
        short = self.sawn_for(1.0, tool)
        more_kib = self.kib_at_most("score", answer["attempt"]) - self.kib_at_most("score", short["attempt"])
        bytes_a_tick = 1024 * more_kib / (answer["samples"] - short["samples"])
        print(f"scoring: {bytes_a_tick:.0f} bytes more for each tick")
        self.assertLess(bytes_a_tick, SCORED_BYTES_A_TICK_AT_MOST)
        _, events = self.exported(answer["attempt"])
        self.assertEqual([int(row["kind"]) for row in events].count(PLANE_FROZEN), 3)


if __name__ == "__main__":
    unittest.main()
