#!/usr/bin/env python3
"""`hallux scenario`, and the scenarios that are refused."""

import json
import unittest

from hallux_command import BAD_INPUT, SHIPPED, CommandTest, coarse_silver


class Scenarios(CommandTest):
    def tearDown(self):
        self.assertFalse(self.data.exists(), "looking at scenarios opens no database")
        super().tearDown()

    def test_the_list_says_whether_a_surgeon_reviewed(self):
        rows = self.ask("scenario", "list")
        self.assertEqual([row["name"] for row in rows], ["akin", "chevron", "silver"])
        self.assertEqual(rows[0]["title"], "Akin osteotomy, right hallux")
        self.assertEqual(rows[2]["title"], "Silver exostectomy")
        for row in rows:
            self.assertIs(row["reviewed"], False)
        self.assertIn("not surgeon-reviewed", self.hallux("scenario", "list").out)

    def test_show_gives_the_scenario_as_it_is_kept(self):
        shown = self.ask("scenario", "show", "silver")
        for key, value in json.loads((SHIPPED / "silver.json").read_text()).items():
            self.assertEqual(shown[key], value)
        self.assertIn("not surgeon-reviewed", self.hallux("scenario", "show", "silver").out)

    def test_a_dull_blade_is_shown_and_one_out_of_range_is_refused(self):
        scenario = coarse_silver()
        self.assertNotIn("sharpness", self.hallux("scenario", "show", "silver").out)
        scenario["blade"]["sharpness"] = 0.5
        self.assertEqual(self.ask("scenario", "check", self.write("dull.json", scenario))["name"], "silver")
        scenario["blade"]["sharpness"] = 3
        self.expect_refusal(BAD_INPUT, ["blunt.json", "blade.sharpness", "from 0.2 to 1"], "scenario", "check",
                            self.write("blunt.json", scenario))

    def test_a_file_cannot_review_itself(self):
        file = self.write("signed.json", {**coarse_silver(), "reviewed": True, "reviewed_by": "A. Surgeon"})
        for verb in (["scenario", "check"], ["attempt"]):
            self.expect_refusal(BAD_INPUT, ["signed.json", "a file cannot review itself"], *verb, file)

    def test_check_lays_the_planes_on_the_patient(self):
        checked = self.ask("scenario", "check", SHIPPED / "silver.json")
        self.assertEqual(checked["name"], "silver")
        self.assertIs(checked["reviewed"], False)
        cut = checked["cuts"][0]
        self.assertEqual(cut["name"], "eminence")
        self.assertAlmostEqual(sum(part * part for part in cut["normal"]), 1.0, delta=1e-9)
        self.assertGreater(cut["depth_mm"], 0.0)

    def test_an_unknown_scenario_is_refused_with_those_there_are(self):
        for verb in (["scenario", "show"], ["attempt"]):
            self.expect_refusal(BAD_INPUT, ["gold", "silver"], *verb, "gold")

    def test_an_unknown_key_is_named_with_its_place(self):
        scenario = coarse_silver(tilt=5)
        file = self.write("tilted.json", scenario)
        for verb in (["scenario", "check"], ["attempt"]):
            self.expect_refusal(BAD_INPUT, ["tilted.json", "cuts[0].face", "tilt"], *verb, file)

    def test_a_plane_that_misses_the_bone_is_refused(self):
        file = self.write("beside.json", coarse_silver(offset_mm=20))
        self.expect_refusal(BAD_INPUT, ["silver", "eminence"], "scenario", "check", file)

    def test_check_measures_what_the_start_view_shows(self):
        for name in ("silver", "akin"):
            file = SHIPPED / f"{name}.json"
            seen = self.ask("scenario", "check", file)["start_view"]
            for share in ("tooth_line_share", "kerf_share"):
                self.assertGreaterEqual(seen[share], 0.8, name)
            self.assertTrue(25 <= seen["blade_angle_deg"] <= 45, name)
            self.assertIs(seen["saw_inside"], True, name)
            self.assertIs(seen["saw_from_lower_corner"], True, name)
            self.assertIs(seen["good"], True, name)
            self.assertIs(seen["default"], False, name)
        self.assertIn("Its start view shows ", self.hallux("scenario", "check", SHIPPED / "silver.json").out)

    def test_a_start_view_that_hides_its_own_cut_is_refused(self):
        scenario = coarse_silver()
        scenario["start"]["eye_in_bone"] = [-part for part in scenario["start"]["eye_in_bone"]]
        file = self.write("behind.json", scenario)
        self.expect_refusal(BAD_INPUT, ["behind.json: start: this view hides its own cut", "the bone hides the most",
                                        "eye_in_bone"], "scenario", "check", file)

    def test_the_default_view_of_a_scenario_without_a_start_is_judged_too(self):
        scenario = coarse_silver()
        del scenario["start"]
        file = self.write("plain.json", scenario)
        self.expect_refusal(BAD_INPUT, ["plain.json: no start is said, and the default view hides the cut",
                                        "the bone hides the most", "say a start"], "scenario", "check", file)

    def test_a_file_that_is_no_scenario_is_refused(self):
        for name, text in (("empty.json", ""), ("prose.json", "a saw and a bone"), ("list.json", "[]")):
            self.expect_refusal(BAD_INPUT, [name], "scenario", "check", self.write(name, text))
        self.expect_refusal(BAD_INPUT, ["nowhere.json"], "scenario", "check", self.folder / "nowhere.json")


if __name__ == "__main__":
    unittest.main()
