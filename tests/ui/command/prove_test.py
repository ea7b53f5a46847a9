"""What proves a rubric, and what another performance would have earned: by the program itself."""

import json
import unittest

from hallux_command import BAD_INPUT, CHECK_FAILED, DONE, CommandTest, coarse_silver


def silver_proven_by(*faults):
    scenario = coarse_silver()
    scenario["proof"] = list(faults)
    return scenario


DRY = {"fault": "dry", "items": ["T5"]}


class Proof(CommandTest):
    def prove(self, scenario, code=DONE):
        return self.ask("scenario", "prove", self.write("operation.json", scenario), code=code)

    def test_a_fault_costs_what_the_scenario_says(self):
        answer = self.prove(silver_proven_by({"fault": "skip:remove", "items": ["P2"], "gates": ["piece_out"]}))
        self.assertIs(answer["passed"], True)
        self.assertGreaterEqual(answer["perfect"]["score"], 97.0)
        for loss in answer["perfect"]["lost"]:
            self.assertGreater(loss["points_lost"], 0.0)
            self.assertTrue(loss["text"])
        (performance,) = answer["performances"]
        self.assertEqual(performance["name"], "skip:remove")
        self.assertEqual(performance["expected"], ["P2", "piece_out"])
        self.assertIs(performance["ok"], True)
        self.assertLessEqual(performance["score"], 39.0)

    def test_a_changed_knot_is_noticed(self):
        scenario = silver_proven_by(DRY)
        (water,) = (item for item in scenario["rubric"]["items"] if item["id"] == "T5")
        water["full"], water["zero"] = 0.9, -0.9
        # A share has no sign.
        self.expect_refusal(BAD_INPUT, ["rubric.items", "zero"], "scenario", "prove",
                            self.write("signed.json", scenario))
        water["metric"], water["full"], water["zero"] = "time_s", 10, 20
        answer = self.prove(scenario, CHECK_FAILED)
        self.assertIs(answer["passed"], False)
        self.assertTrue(any(each["differences"] for each in answer["performances"]))

    def test_unknown_names_are_refused_with_the_list(self):
        self.expect_refusal(BAD_INPUT, ["wobble", "tilt", "restarts"], "scenario", "prove",
                            self.write("fault.json", silver_proven_by({"fault": "wobble", "items": ["A1"]})))
        self.expect_refusal(BAD_INPUT, ["proof[0].items", "Z9", "is no item"], "scenario", "prove",
                            self.write("item.json", silver_proven_by({"fault": "dry", "items": ["Z9"]})))
        self.expect_refusal(BAD_INPUT, ["proof[0].gates", "is no gate"], "scenario", "prove",
                            self.write("gate.json", silver_proven_by(dict(DRY, gates=["drought"]))))
        self.expect_refusal(BAD_INPUT, ["proof[0].items", "is empty"], "scenario", "prove",
                            self.write("none.json", silver_proven_by({"fault": "dry", "items": []})))


class WhatIf(CommandTest):
    def test_each_proposed_change_gives_exactly_its_gain(self):
        scenario = self.write("coarse.json", coarse_silver())
        attempt = self.ask("attempt", scenario, "--hand", "novice", "--seed", 1)["attempt"]
        before = self.ask("score", attempt)
        answer = self.ask("what-if", attempt)
        self.assertEqual(answer["score"], before["score"])
        self.assertTrue(answer["changes"])
        self.assertLessEqual(len(answer["changes"]), 3)
        gains = [change["gain"] for change in answer["changes"]]
        self.assertEqual(gains, sorted(gains, reverse=True))
        self.assertGreater(min(gains), 0.0)
        together = []
        for change in answer["changes"]:
            asked = f"{change['change']}={change['to']!r}"
            together += ["--change", asked]
            changed = self.ask("what-if", attempt, "--change", asked)
            self.assertEqual(round(1000 * changed["score"]), round(1000 * (answer["score"] + change["gain"])))
            self.assertAlmostEqual(sum(line["points_lost"] for line in changed["ledger"]), 100.0 - changed["score"],
                                   delta=1e-9)
        self.assertEqual(self.ask("what-if", attempt, *together)["score"], answer["all"]["score"])
        self.assertEqual(self.ask("score", attempt)["score"], before["score"], "nothing was stored")
        self.expect_refusal(BAD_INPUT, ["wobble", "tilt:eminence"], "what-if", attempt, "--change", "wobble=1")
        self.expect_refusal(BAD_INPUT, ["CUT=0"], "what-if", attempt, "--change", "tilt:eminence=much")

    def test_measurements_and_their_metrics_have_the_keys_of_the_contract(self):
        metrics = {metric["id"]: metric for metric in self.ask("metrics")}
        for metric in metrics.values():
            self.assertEqual(set(metric), {"id", "unit", "about", "better", "formula", "source"})
            self.assertIn(metric["about"], ("cut", "hinge", "zone", "fragment", "implant", "step", "attempt"))
            self.assertIn(metric["better"], ("lower", "higher", "band"))
        attempt = self.ask("attempt", self.write("coarse.json", coarse_silver()))["attempt"]
        for measured in self.ask("score", attempt)["measurements"]:
            self.assertEqual(measured["unit"], metrics[measured["metric"]]["unit"])
            self.assertEqual(measured["value"] is None, measured["not_measured_because"] is not None)
            self.assertTrue(0.0 <= measured["done_fraction"] <= 1.0)


if __name__ == "__main__":
    unittest.main()
