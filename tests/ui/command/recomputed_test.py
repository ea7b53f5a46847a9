#!/usr/bin/env python3
"""An outsider checks a score: metrics, points and score computed again from exported files alone are the program's.

Metrics agree to 1e-6 of their unit, to which the program rounds them; points and scores to the thousandth. Every metric that
the program measured is either computed again (`outsider/`) or has a reason by `outsider.recompute.why_left_out`. The
operations are those that are shipped, and the last ones of format 1.
"""

import json
import unittest

from hallux_command import DONE, SHIPPED, SILVER, CommandTest
from outsider.export import Export
from outsider.points import Score
from outsider.recompute import recomputed, why_left_out

ROUNDED_TO = 1e-6
# Of format 1.
AKIN = SILVER.with_name("akin.json")


def milli(points):
    return round(1000 * points)


def about(measurement):
    subjects = [measurement[key] for key in ("cut", "hinge", "zone", "fragment", "implant")]
    return measurement["metric"], next(filter(None, subjects), "")


class Recomputed(CommandTest):
    def exported(self, operation, hand, seed):
        """The program's answer about a score, and the files of that attempt as an outsider has them."""
        attempt = self.ask("attempt", operation, "--hand", hand, "--seed", seed)["attempt"]
        answer = self.ask("score", attempt)
        folder = self.folder / "exported"
        done = self.hallux("export", attempt, "-o", folder)
        self.assertEqual(done.code, DONE, done)
        return answer, Export(folder / attempt)

    def expect_metrics(self, answer, export):
        """Returns the values by metric and subject."""
        found = recomputed(export)
        program = {about(each): each for each in answer["measurements"]}
        self.assertEqual(len(program), len(answer["measurements"]))
        self.assertEqual(set(found) - set(program), set(), "the program does not measure these")
        for key, measurement in program.items():
            with self.subTest(metric=key[0], about=key[1]):
                value = measurement["value"]
                if key not in found and not why_left_out(export, *key):
                    self.assertIsNone(value, "nothing was made that an outsider could measure")
                elif key in found and (value is None or found[key] is None):
                    self.assertEqual(found[key], value)
                elif key in found:
                    self.assertLessEqual(abs(found[key] - value), ROUNDED_TO, f"{found[key]} and {value}")
        return found

    def expect_score(self, answer, export):
        """By the knots of the scenario that was exported."""
        score = Score(export.scenario["rubric"], answer["measurements"], export.manifest["attempt"]["device_class"])
        ledger = [(line["item"], line["group"], milli(line["rubric_points_lost"])) for line in answer["ledger"]]
        self.assertEqual(score.lines, ledger)
        self.assertEqual(score.shown, [milli(line["points_lost"]) for line in answer["ledger"]])
        self.assertEqual(sum(score.shown), 100_000 - score.score)
        self.assertEqual(score.triggered, {gate["name"]: gate["triggered"] for gate in answer["gates"]})
        self.assertEqual(score.earned, {group["name"]: milli(group["earned"]) for group in answer["groups"]})
        self.assertEqual(score.measured, {group["name"]: milli(group["measured_weight"]) for group in answer["groups"]})
        self.assertEqual(score.score, milli(answer["score"]))
        card = next(each["card"] for each in export.manifest["scores"] if each["is_in_force"])
        self.assertEqual([score.score, score.left, score.whole],
                         [card[key] for key in ("score_milli", "earned_milli", "measured_milli")])
        return score

    def expect_all(self, operation, hand, seed):
        answer, export = self.exported(operation, hand, seed)
        return self.expect_metrics(answer, export), self.expect_score(answer, export)

    def coarse(self, operation, edge_mm, change=lambda scenario: None):
        """The shipped operation on a bone that is built in a moment."""
        scenario = json.loads((SHIPPED / f"{operation}.json").read_text())
        scenario["patient"]["bones"][0]["edge_mm"] = edge_mm
        change(scenario)
        return self.write(f"{operation}.json", scenario)


class Shipped(Recomputed):
    """What is operated now."""

    def test_shipped_silver_by_an_expert(self):
        metrics, score = self.expect_all("silver", "expert", 1)
        self.assertGreater(metrics["depth_mm", "eminence"], 0)
        self.assertGreater(metrics["overhang_mm", "eminence"], 0)
        self.assertEqual(metrics["step_order", ""], 1)
        self.assertGreater(score.score, 80_000)


class Others(Recomputed):
    """The other operations, attempts that went otherwise, and those of format 1: minutes."""

    def test_shipped_akin_held_by_a_screw(self):
        metrics, score = self.expect_all("akin", "expert", 2)
        self.assertEqual(metrics["fixed", "toe"], 1)
        self.assertGreater(metrics["shift_error_mm", "toe"], 0)
        self.assertGreater(metrics["tip_to_joint_mm", "screw"], 0)
        self.assertEqual(metrics["entry_mm", "fixation"], metrics["entry_mm", "screw"])
        self.assertIsNone(metrics["entry_mm", "medial_wire"])
        self.assertGreater(score.score, 80_000)

    def test_chevron(self):
        """Both of its wires are taken out again, and one of two blades saws the arms."""
        metrics, score = self.expect_all(self.coarse("chevron", 0.9), "perfect", 1)
        self.assertGreater(metrics["shift_mm", "head"], 4)
        self.assertEqual(metrics["fixed", "head"], 1)
        self.assertEqual(metrics["right_tool", "dorsal_arm"], 1)
        self.assertNotIn(("entry_mm", "holding_wire"), metrics)
        self.assertGreater(score.score, 90_000)

    def test_akin_with_its_wedge_closed(self):
        metrics, _ = self.expect_all(AKIN, "novice", 7)
        self.assertGreater(metrics["gap_mm", "lateral_hinge"], 0)
        self.assertGreater(metrics["idle_s", ""], 0)

    def test_silver_by_an_expert(self):
        metrics, score = self.expect_all(SILVER, "expert", 1)
        self.assertGreater(metrics["air_cutting_s", ""], 2)
        self.assertGreater(metrics["breakthrough_newton", "eminence"], 0)
        self.assertGreater(score.score, 80_000)

    def test_silver_past_its_landmarks(self):
        metrics, score = self.expect_all(SILVER, "novice", 11)
        self.assertGreater(metrics["notch_mm", "eminence"], 0)
        self.assertGreater(metrics["past_landmark_mm", "eminence"], 0)
        self.assertTrue(score.triggered["past_sulcus"])

    def test_akin_with_its_hinge_cut_through(self):
        metrics, score = self.expect_all(AKIN, "novice", 3)
        self.assertEqual(metrics["wedge_closed", "lateral_hinge"], 0)
        self.assertGreater(metrics["danger_depth_mm", ""], 0)
        self.assertGreater(dict((item, lost) for item, _, lost in score.lines)["damping"], 0)

    def test_akin_with_one_cut_alone(self):
        metrics, score = self.expect_all(AKIN, "novice", 8)
        self.assertNotIn(("angle_deg", "distal_face"), metrics)
        self.assertGreater(metrics["restarts_count", ""], 0)
        self.assertEqual(dict((item, lost) for item, _, lost in score.lines)["A3"], 6000)

    def test_shipped_akin_with_its_hinge_cut_through(self):
        metrics, score = self.expect_all("akin", "novice", 3)
        self.assertEqual(metrics["wedge_closed", "lateral_hinge"], 0)
        self.assertEqual(metrics["shift_mm", "toe"], 0)
        self.assertLess(metrics["step_order", ""], 1)
        self.assertTrue(score.triggered["hinge_cut"])

    def test_akin_held_by_two_wires(self):
        """The hand takes the first of alternative steps."""

        def wires_first(scenario):
            scenario["steps"].sort(key=lambda step: step.get("implants") == ["screw"])
        metrics, _ = self.expect_all(self.coarse("akin", 1, wires_first), "novice", 7)
        self.assertEqual(metrics["fixed", "toe"], 1)
        self.assertGreater(metrics["protrusion_mm", "fixation"], 0)
        self.assertEqual(metrics["direction_deg", "fixation"],
                         max(metrics["direction_deg", wire] for wire in ("medial_wire", "lateral_wire")))
        self.assertIsNone(metrics["entry_mm", "screw"])


if __name__ == "__main__":
    unittest.main()
