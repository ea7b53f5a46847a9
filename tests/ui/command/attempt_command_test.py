#!/usr/bin/env python3
"""An attempt from its recording to its report, as a script asks for it."""

import html.parser
import math
import shutil
import subprocess
import unittest

from hallux_command import (ATTEMPT_KIB_AT_MOST, BAD_INPUT, DONE, PROGRAM, WRONG_USAGE, CommandTest, RecordedTest,
                            coarse_scenario, coarse_silver, greatest_kib)

CARD_KEYS = {"score", "groups", "gates"}
LEDGER_KEYS = {"metric", "value", "target", "unit", "points_lost", "start_us", "end_us", "text"}
NO_MOTION = {"keys": [{"time_s": time_s, "tip_mm": [0, 0, 90], "direction": [1, 0, 0], "normal": [0, 0, 1]}
                      for time_s in (0, 0.2)]}


class Page(html.parser.HTMLParser):
    """What a page is made of, and where it would look for more."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.add(tag)
        self.links += [value for name, value in attrs if name in ("src", "href", "xlink:href", "action")]
        self.links += [name for name, _ in attrs if name.startswith("on")]


class Attempt(RecordedTest):
    def test_the_answer_has_the_keys_of_the_contract(self):
        answer = self.recorded.json()
        self.assertLessEqual({"attempt", "scenario", "measured_weight", "samples", "duration_s", "quality"} | CARD_KEYS,
                             answer.keys())
        self.assertIsInstance(answer["attempt"], str)
        self.assertEqual(answer["scenario"], "silver")
        self.assertTrue(0.0 <= answer["score"] <= 100.0)
        self.assertEqual(answer["measured_weight"], 100.0)
        self.assertIs(answer["partial"], False)
        self.assertEqual(answer["samples"], round(1000 * answer["duration_s"]))
        self.assertIs(answer["quality"]["complete"], True)
        self.assertIs(answer["quality"]["valid"], True)
        self.assertEqual(answer["quality"]["not_valid_because"], [])
        self.assertEqual(answer["quality"]["received_samples"], answer["samples"])

    def test_every_group_is_measured_whole(self):
        groups = {group["name"]: group for group in self.recorded.json()["groups"]}
        self.assertEqual(sum(group["weight"] for group in groups.values()), 100.0)
        for group in groups.values():
            self.assertEqual(group["measured_weight"], group["weight"], group["name"])

    def test_stdout_is_one_json_value_and_progress_is_on_stderr(self):
        self.assertIsInstance(self.recorded.json(), dict)
        for stage in ("Building the bone", "Operating", "Scoring"):
            self.assertIn(stage, self.recorded.err)
            self.assertNotIn(stage, self.recorded.out)

    def test_the_list_has_the_keys_of_the_contract(self):
        rows = self.ask("attempts")
        self.assertEqual(len(rows), 1)
        row = rows[0]
        self.assertLessEqual({"attempt", "scenario", "person", "started", "state", "score"}, row.keys())
        self.assertEqual((row["attempt"], row["scenario"], row["state"]), (self.attempt, "silver", "closed"))
        self.assertIsNone(row["person"], "a scripted attempt is the robot's")
        self.assertEqual(row["score"], self.recorded.json()["score"])
        self.assertRegex(row["started"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z$")

    def test_replay_is_identical(self):
        answer = self.ask("replay", self.attempt)
        self.assertIs(answer["identical"], True)
        self.assertRegex(answer["bone_hash"], r"^[0-9a-f]{64}$")
        self.assertEqual(answer["samples"], self.recorded.json()["samples"])
        self.assertGreater(answer["seconds"], 0.0)
        self.assertEqual(self.ask("replay", self.attempt)["bone_hash"], answer["bone_hash"])

    def test_a_guided_attempt_is_listed_as_such_and_replays_identical(self):
        scenario = self.write("coarse.json", coarse_silver())
        guided = self.ask("attempt", scenario, "--hand", self.write("still.json", NO_MOTION), "--guidance", "slot")
        self.assertIs(self.ask("replay", guided["attempt"])["identical"], True)
        rows = {row["attempt"]: row["guidance"] for row in self.ask("attempts")}
        self.assertEqual(rows, {guided["attempt"]: "slot", self.attempt: "none"})
        self.assertIn("guided: slot", self.hallux("attempts").out)
        report = self.folder / "guided.html"
        self.assertEqual(self.hallux("report", guided["attempt"], "-o", report).code, DONE)
        self.assertIn("like a slot", report.read_text())

    def test_an_arm_says_what_it_was_made_to_feel_and_replays_identical(self):
        scenario, hand = self.write("coarse.json", coarse_silver()), self.write("still.json", NO_MOTION)
        for law in ("simulated", "historic"):
            felt = self.ask("attempt", scenario, "--hand", hand, "--device", "arm", "--force-law", law)
            self.assertEqual(felt["quality"]["force_law"], law)
            self.assertAlmostEqual(felt["quality"]["force_scale"], 0.24)
            self.assertIs(self.ask("replay", felt["attempt"])["identical"], True)
        self.assertEqual(self.recorded.json()["quality"]["force_scale"], 1.0, "nothing pushes a scripted hand")

    def test_a_law_or_an_arm_that_nothing_would_feel_is_wrong_usage(self):
        hand = self.write("still.json", NO_MOTION)
        for wrong in (("--force-law", "historic", "--hand", hand), ("--device", "arm"), ("--device", "arm", "--hand", "novice"),
                      ("--device", "falcon", "--hand", hand), ("--device", "arm", "--hand", hand, "--force-law", "of nature")):
            answer = self.hallux("attempt", "silver", *wrong)
            self.assertEqual(answer.code, WRONG_USAGE, wrong)
            self.assertIn("--", answer.err)
        self.assertEqual([row["attempt"] for row in self.ask("attempts")], [self.attempt])

    def test_a_guide_that_nobody_knows_is_wrong_usage(self):
        self.assertEqual(self.hallux("attempt", "silver", "--guidance", "laser").code, WRONG_USAGE)
        self.assertEqual([row["attempt"] for row in self.ask("attempts")], [self.attempt])

    def test_losses_of_the_ledger_add_up_to_what_is_missing(self):
        answer = self.ask("score", self.attempt)
        self.assertLessEqual(CARD_KEYS | {"ledger"}, answer.keys())
        for key in CARD_KEYS | {"measured_weight"}:
            self.assertEqual(answer[key], self.recorded.json()[key])
        for line in answer["ledger"]:
            self.assertLessEqual(LEDGER_KEYS, line.keys())
            self.assertNotEqual(line["text"], "")
            self.assertLessEqual(0, line["start_us"])
            self.assertLessEqual(line["start_us"], line["end_us"])
            self.assertLessEqual(line["end_us"], 1e6 * self.recorded.json()["duration_s"])
        lost = math.fsum(line["points_lost"] for line in answer["ledger"])
        self.assertAlmostEqual(lost, 100.0 - answer["score"], delta=1e-9)

    def test_the_score_names_no_deed_that_was_done(self):
        words = " ".join(self.hallux("score", self.attempt).out.split())
        self.assertIn("The eminence was never freed and taken out: no.", words)
        self.assertNotIn("taken out, so the score is capped", words)

    def test_scoring_again_gives_the_same_card(self):
        self.assertEqual(self.hallux("score", self.attempt, "--json").out, self.hallux("score", self.attempt, "--json").out)

    def test_the_first_characters_of_an_id_name_it(self):
        self.assertEqual(self.ask("score", self.attempt[:8])["attempt"], self.attempt)

    def test_the_report_is_one_page_that_loads_nothing(self):
        file = self.folder / "page.html"
        answer = self.ask("report", self.attempt, "-o", file)
        text = file.read_text(encoding="utf-8")
        self.assertEqual(answer["bytes"], len(text.encode("utf-8")))
        page = Page(text)
        self.assertIn("svg", page.tags)
        self.assertFalse({"script", "link", "iframe", "img", "object"} & page.tags)
        self.assertEqual([link for link in page.links if not link.startswith("#")], [])
        self.assertNotIn("url(", text)
        self.assertNotIn("@import", text)
        self.assertIn("not surgeon-reviewed", text)
        self.assertEqual(sorted(place.name for place in self.folder.iterdir()), ["data", "here", "home", "page.html", "xdg"])

    def test_what_would_have_earned_more_is_told_by_the_report_and_by_its_verb(self):
        proposed = self.ask("what-if", self.attempt)["changes"]
        self.assertGreater(len(proposed), 0)
        told = self.hallux("what-if", self.attempt).out
        for change in proposed:
            self.assertIn(f"--change {change['change']}=", told)
        first, second = self.folder / "first.html", self.folder / "second.html"
        for file in (first, second):
            self.ask("report", self.attempt, "-o", file)
        text = first.read_text(encoding="utf-8")
        self.assertIn("What would have earned more", text)
        self.assertEqual(text.count('class="gain"'), len(proposed) + (len(proposed) > 1))
        of_both = [file.read_text(encoding="utf-8").split("What would have earned more")[1].split("</section>")[0]
                   for file in (first, second)]
        self.assertEqual(of_both[0], of_both[1])

    def test_a_report_that_cannot_be_written_leaves_nothing(self):
        self.expect_refusal(BAD_INPUT, ["page.html"], "report", self.attempt, "-o", self.folder / "nowhere" / "page.html")
        self.assertFalse((self.folder / "nowhere").exists())

    def test_verify_counts_what_is_whole(self):
        answer = self.ask("verify")
        self.assertIs(answer["whole"], True)
        self.assertIsNone(answer["first_damage"])
        self.assertEqual((answer["attempts"], answer["scores"], answer["assets"]), (1, 1, 1))
        self.assertGreater(answer["chunks"], 100)

    def test_an_unknown_attempt_is_refused_and_nothing_changes(self):
        before = self.stored()
        for verb in (["replay"], ["score"], ["report", "-o", self.folder / "page.html"]):
            self.expect_refusal(BAD_INPUT, ["no-such", "hallux attempts"], *verb, "no-such")
        self.assertEqual(self.stored(), before)
        self.assertFalse((self.folder / "page.html").exists())

    def test_quiet_leaves_only_the_answer(self):
        for verb in (["replay", self.attempt], ["score", self.attempt], ["attempts"], ["verify"],
                     ["report", self.attempt, "-o", self.folder / "page.html"]):
            with self.subTest(verb=verb):
                loud, silent = self.hallux(*verb), self.hallux(*verb, "--quiet")
                self.assertEqual(silent.code, DONE, silent)
                self.assertEqual(silent.err, "")
                self.assertNotEqual(loud.out, "")
                self.assertNotEqual(silent.out, "")

    def test_an_attempt_that_cannot_be_made_is_not_begun(self):
        before = self.stored()
        beside = self.write("beside.json", coarse_silver(offset_mm=20))
        self.expect_refusal(BAD_INPUT, ["eminence"], "attempt", beside)
        self.expect_refusal(BAD_INPUT, ["gold"], "attempt", "gold")
        self.assertEqual(self.stored(), before)


class FreshDirectory(CommandTest):
    def test_the_shipped_scenario_is_operated_scored_and_proved(self):
        answer = self.ask("attempt", "silver", "--hand", "novice", "--seed", "7")
        self.assertLess(greatest_kib(), ATTEMPT_KIB_AT_MOST)
        self.assertEqual((answer["hand"], answer["seed"]), ("novice", 7))
        self.assertIs(self.ask("replay", answer["attempt"])["identical"], True)

    def test_the_same_hand_and_seed_give_the_same_and_others_differ(self):
        scenario = self.write("coarse.json", coarse_silver())
        first, again, other_seed, other_hand = (
            self.ask("attempt", scenario, "--hand", hand, "--seed", seed)
            for hand, seed in (("expert", 1), ("expert", 1), ("expert", 2), ("novice", 1)))
        for key in ("score", "groups", "gates", "samples"):
            self.assertEqual(first[key], again[key])
        self.assertNotEqual(first["attempt"], again["attempt"])
        self.assertEqual(len({answer["score"] for answer in (first, other_seed, other_hand)}), 3)
        self.assertEqual(self.ask("verify")["assets"], 1, "the same bone is stored once")
        self.assertEqual(*(self.ask("replay", answer["attempt"])["bone_hash"] for answer in (first, again)))

    def test_faults_are_named_in_answer_and_record(self):
        scenario = self.write("coarse.json", coarse_silver())
        plain = self.ask("attempt", scenario, "--hand", "perfect")
        self.assertEqual((plain["hand"], plain["faults"]), ("perfect", []))
        faulty = self.ask("attempt", scenario, "--hand", "perfect", "--fault", "tilt:eminence=6", "--fault", "dry")
        self.assertEqual(faulty["hand"], "perfect with tilt:eminence=6, dry")
        self.assertEqual(faulty["faults"], ["tilt:eminence=6", "dry"])
        self.assertLess(faulty["score"], plain["score"])
        self.assertEqual([row["hand"] for row in self.ask("attempts")], [faulty["hand"], "perfect"])
        self.assertIs(self.ask("replay", faulty["attempt"])["identical"], True)

    def test_a_fault_that_there_is_not_is_refused_with_those_there_are(self):
        for fault, words in (("wobble", ["tilt[:CUT]", "over_cut", "skip:STEP", "touch_zone:ZONE"]),
                             ("tilt:proximal_face", ["silver", "eminence"]), ("tilt=steep", ["-45 to 45", "degrees"]),
                             ("press=200", ["0 to 20"]), ("skip", ["verify", "take_eminence"]),
                             ("skip:close", ["verify", "take_eminence"]), ("touch_zone", ["tibial_sesamoid_cartilage"]),
                             ("swap", ["two"]), ("dry=3", ["dry"])):
            with self.subTest(fault=fault):
                self.expect_refusal(BAD_INPUT, [fault, *words], "attempt", "silver", "--hand", "perfect", "--fault", fault)
        self.assertFalse(self.data.exists(), "and nothing was begun")

    def test_a_fault_of_no_hand_with_a_name_is_wrong_usage(self):
        hand = self.write("still.json", NO_MOTION)
        for wrong in (("--hand", hand, "--fault", "dry"), ("--device", "falcon", "--seconds", "1", "--fault", "dry")):
            answer = self.hallux("attempt", "silver", *wrong)
            self.assertEqual(answer.code, WRONG_USAGE, wrong)
            self.assertIn("--fault", answer.err)
        self.assertFalse(self.data.exists())

    def test_an_attempt_that_cuts_nothing_scores_nothing_and_is_kept(self):
        scenario, hand = self.write("coarse.json", coarse_silver()), self.write("idle.json", NO_MOTION)
        answer = self.ask("attempt", scenario, "--hand", hand)
        self.assertEqual(answer["score"], 0.0)
        ledger = self.ask("score", answer["attempt"])["ledger"]
        self.assertAlmostEqual(math.fsum(line["points_lost"] for line in ledger), 100.0, delta=1e-9)
        self.assertIs(self.ask("replay", answer["attempt"])["identical"], True)
        self.assertEqual(self.ask("attempts")[0]["state"], "closed")

    def test_the_score_names_what_was_not_done(self):
        hand = self.write("idle.json", NO_MOTION)
        for name, undone in (("silver", ["The eminence was never freed and taken out"]),
                             ("akin", ["The wedge was never freed and taken out", "The wedge was never closed"])):
            attempt = self.ask("attempt", self.write(f"{name}.json", coarse_scenario(name)), "--hand", hand)["attempt"]
            said = self.hallux("score", attempt)
            self.assertEqual(said.code, DONE, said)
            words = " ".join(said.out.split())
            for deed in undone:
                self.assertIn(f"x {deed}: yes; the score is capped at 39.", words)
                self.assertIn(f"{deed}, so the score is capped at 39", words, "and its line in the ledger")

    def test_reading_verbs_make_nothing_where_there_is_nothing(self):
        self.assertEqual(self.ask("attempts"), [])
        for verb in (["replay", "some-attempt"], ["score", "some-attempt"],
                     ["report", "some-attempt", "-o", self.folder / "page.html"]):
            self.expect_refusal(BAD_INPUT, [str(self.data), "hallux attempt", "--data"], *verb)
            self.assertFalse(self.data.exists())

    def test_a_fresh_directory_is_made_for_its_owner_only(self):
        self.ask("user", "add", "ada", "--administrator", stdin="saw bone hinge wire\n")
        self.assertEqual(self.ask("attempts"), [])
        self.assertEqual(self.data.stat().st_mode & 0o777, 0o700)
        self.assertEqual((self.data / "hallux.db").stat().st_mode & 0o777, 0o600)

    def test_without_data_the_directory_is_that_of_the_environment(self):
        """The one run without --data; what it makes is taken away before the check that all stayed empty."""
        subprocess.run([PROGRAM, "user", "add", "ada", "--administrator"], input="saw bone hinge wire\n", text=True,
                       stdout=subprocess.DEVNULL, cwd=self.untouched[2], env=self.environment(), check=True)
        made = self.untouched[1] / "hallux"
        self.assertTrue((made / "hallux.db").is_file())
        shutil.rmtree(made)

    def test_nothing_is_verified_where_there_is_nothing(self):
        self.expect_refusal(BAD_INPUT, [str(self.data), "--data"], "verify")
        self.assertFalse(self.data.exists())

    def test_a_scenario_file_that_is_gone_later_changes_nothing(self):
        file = self.write("coarse.json", coarse_silver())
        made = self.ask("attempt", file, "--seed", "3")
        file.unlink()
        self.assertEqual(self.ask("score", made["attempt"])["score"], made["score"])


if __name__ == "__main__":
    unittest.main()
