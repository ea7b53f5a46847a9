#!/usr/bin/env python3
"""Attempts leave as files that other programs read, come in elsewhere, and leave there as they came."""

import csv
import hashlib
import json
import math
import pathlib
import unittest

import jsonschema

from hallux_command import BAD_INPUT, DONE, REFUSED, SHIPPED, STORAGE, WRONG_USAGE, RecordedTest

PASSWORD = "saw bone hinge wire"
BLADE = ("width_mm", "depth_mm", "thickness_mm", "kerf_mm")
SCHEMAS = pathlib.Path(__file__).resolve().parents[3] / "docs" / "schemas"


def check_schema(value, name):
    jsonschema.Draft202012Validator(json.loads((SCHEMAS / f"{name}.schema.json").read_text())).validate(value)


def dot(one, other):
    return math.fsum(a * b for a, b in zip(one, other, strict=True))


def numbers_in(value):
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        return [number for each in value for number in numbers_in(each)]
    return [value] if isinstance(value, (int, float)) else []


def bytes_below(folder):
    return {str(file.relative_to(folder)): file.read_bytes() for file in sorted(folder.rglob("*")) if file.is_file()}


def older_seal(manifest):
    """Of the facts in a manifest, as programs sealed before kind and simulation were in it."""
    digest = hashlib.blake2b(digest_size=32)
    attempt = manifest["attempt"]

    def integer(value):
        digest.update(int(value).to_bytes(8, "little", signed=True))

    def text(value):
        integer(len(value.encode()))
        digest.update(value.encode())

    digest.update(bytes.fromhex(manifest["last_link"]))
    text(attempt["uuid"])
    digest.update(bytes.fromhex(manifest["scenario"]["digest"]))
    text(attempt["hand"])
    integer(attempt["seed"])
    for key in ("device_class", "pacing", "stereo_mode"):
        text(attempt[key])
    digest.update(bytes.fromhex(attempt["bone"]))
    integer(attempt["engine_version"])
    text(attempt["started_utc"])
    integer(attempt["duration_ticks"])
    text(attempt["quality"])
    if attempt["guidance"] != "none":
        text(attempt["guidance"])
    return digest.hexdigest()


class Exchange(RecordedTest):
    """The robot's attempt of this directory, and another directory with an administrator."""

    def setUp(self):
        super().setUp()
        self.here, self.there = self.data, self.folder / "there"
        self.out = self.folder / "out"
        self.ask("export", self.attempt, "-o", self.out)
        self.exported = self.out / self.attempt
        self.data = self.there
        self.ask("user", "add", "ada", "--administrator", stdin=PASSWORD + "\n")

    def as_ada(self, *arguments, code=DONE):
        return self.ask(*arguments, "--as", "ada", stdin=PASSWORD + "\n", code=code)

    def manifest(self):
        return json.loads((self.exported / "manifest.json").read_text())

    def alter_file(self, name, old, new):
        file = self.exported / name
        content = file.read_bytes()
        self.assertIn(old, content)
        file.write_bytes(content.replace(old, new, 1))

    def test_the_manifest_keeps_its_schema_and_tells_the_truth(self):
        manifest = self.manifest()
        check_schema(manifest, "attempt_manifest")
        self.assertEqual({entry["name"] for entry in manifest["files"]} | {"manifest.json"},
                         {file.name for file in self.exported.iterdir()})
        for entry in manifest["files"]:
            content = (self.exported / entry["name"]).read_bytes()
            self.assertEqual(len(content), entry["bytes"], entry["name"])
            self.assertEqual(hashlib.blake2b(content, digest_size=32).hexdigest(), entry["blake2b_256"], entry["name"])
        self.assertGreaterEqual(len(list(self.exported.glob("piece-*.ply"))), 2, "the eminence and what is left")

    def test_the_plan_is_told_in_the_frame_of_the_bone(self):
        self.expect_plan(self.exported)

    def test_so_is_one_with_fragments_and_implants(self):
        scenario = json.loads((SHIPPED / "akin.json").read_text())
        scenario["patient"]["bones"][0]["edge_mm"] = 1
        self.data = self.here
        attempt = self.ask("attempt", self.write("akin.json", scenario), "--hand", "novice", "--seed", 3)["attempt"]
        self.ask("export", attempt, "-o", self.folder / "akin")
        plan = self.expect_plan(self.folder / "akin" / attempt)
        self.assertEqual([fragment["name"] for fragment in plan["fragments"]],
                         [fragment["name"] for fragment in scenario["fragments"]])
        self.assertEqual([implant["name"] for implant in plan["implants"]],
                         [implant["name"] for implant in scenario["wires"] + scenario["screws"]])
        for fragment in plan["fragments"]:
            self.expect_pose(fragment["pose"])
        for implant in plan["implants"]:
            self.assertAlmostEqual(dot(implant["direction"], implant["direction"]), 1.0, delta=1e-12)

    def expect_plan(self, folder):
        """Of a scenario of either format."""
        plan = json.loads((folder / "plan.json").read_text())
        check_schema(plan, "plan")
        manifest = json.loads((folder / "manifest.json").read_text())
        self.assertEqual((plan["scenario"], plan["scenario_version"]),
                         (manifest["scenario"]["name"], manifest["scenario"]["version"]))
        scenario = json.loads(manifest["scenario"]["text"])
        self.assertEqual([cut["name"] for cut in plan["cuts"]], [cut["name"] for cut in scenario["cuts"]])
        self.assertEqual([zone["name"] for zone in plan["danger_zones"]],
                         [zone["name"] for zone in scenario["danger_zones"]])
        for number in numbers_in(plan):
            self.assertTrue(math.isfinite(number))
        for cut in plan["cuts"]:
            for direction in (cut["normal"], cut["axis"]):
                self.assertAlmostEqual(dot(direction, direction), 1.0, delta=1e-12)
            self.assertAlmostEqual(dot(cut["normal"], cut["axis"]), 0.0, delta=1e-12)
            self.assertAlmostEqual(dot(cut["normal"], cut["entry_in_bone_mm"]), cut["offset_mm"], delta=1e-9)
        self.expect_pose(plan["world_from_bone"])
        self.expect_blades(plan, scenario)
        return plan

    def expect_pose(self, rows):
        for i in range(3):
            for j in range(3):
                self.assertAlmostEqual(dot(rows[i][:3], rows[j][:3]), float(i == j), delta=1e-9)
        self.assertEqual(rows[3], [0, 0, 0, 1])

    def expect_blades(self, plan, scenario):
        blades = scenario.get("blades") or [scenario["blade"]]
        self.assertEqual(len(plan["blades"]), len(blades))
        for told, blade in zip([plan["blade"], *plan["blades"]], [blades[0], *blades]):
            self.assertEqual([told[key] for key in BLADE], [blade[key] for key in BLADE])
        self.assertEqual([cut["blade"] for cut in plan["cuts"]], [cut.get("blade") for cut in scenario["cuts"]])

    def test_an_export_without_a_plan_is_taken_in_and_leaves_as_it_came(self):
        """Older programs wrote none; and whoever lost the file can import all the same."""
        (self.exported / "plan.json").unlink()
        manifest = self.manifest()
        manifest["files"] = [entry for entry in manifest["files"] if entry["name"] != "plan.json"]
        self.write_manifest(manifest)
        self.assertEqual(self.as_ada("import", self.out)["imported"], [self.attempt])
        self.as_ada("export", "--all", "-o", self.folder / "again")
        self.assertEqual(bytes_below(self.folder / "again"), bytes_below(self.out))

    def test_a_plan_that_was_lost_is_made_again(self):
        whole = bytes_below(self.out)
        (self.exported / "plan.json").unlink()
        self.assertEqual(self.as_ada("import", self.out)["imported"], [self.attempt])
        self.as_ada("export", "--all", "-o", self.folder / "again")
        self.assertEqual(bytes_below(self.folder / "again"), whole)

    def test_a_plan_is_never_believed(self):
        """One that fits its digest and tells something else changes no score and does not leave again."""
        self.as_ada("import", self.out)
        honest = self.ask("score", self.attempt)["score"]
        self.data = self.folder / "elsewhere"
        self.ask("user", "add", "ada", "--administrator", stdin=PASSWORD + "\n")
        plan = json.loads((self.exported / "plan.json").read_text())
        plan["cuts"][0]["offset_mm"] += 5.0
        content = json.dumps(plan).encode()
        (self.exported / "plan.json").write_bytes(content)
        manifest = self.manifest()
        for entry in manifest["files"]:
            if entry["name"] == "plan.json":
                entry["bytes"], entry["blake2b_256"] = len(content), hashlib.blake2b(content, digest_size=32).hexdigest()
        self.write_manifest(manifest)
        self.assertEqual(self.as_ada("import", self.out)["imported"], [self.attempt])
        self.assertEqual(self.ask("score", self.attempt)["score"], honest)
        self.as_ada("export", "--all", "-o", self.folder / "again")
        self.assertFalse((self.folder / "again" / self.attempt / "plan.json").exists())

    def test_a_spreadsheet_reads_the_tables(self):
        ticks = self.manifest()["attempt"]["duration_ticks"]
        for name in ("tape", "samples", "events"):
            with open(self.exported / f"{name}.csv", newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            self.assertTrue(all(int(value) is not None for row in rows for value in row.values()))
            if name == "samples":
                self.assertLessEqual(abs(len(rows) - ticks), 1)

    def test_out_in_and_out_again_is_the_same_to_the_byte(self):
        self.assertEqual(self.as_ada("import", self.out), {"imported": [self.attempt], "known": [], "refused": [], "not_all": []})
        self.as_ada("export", "--all", "-o", self.folder / "again")
        self.assertEqual(bytes_below(self.folder / "again"), bytes_below(self.out))
        self.assertEqual(self.as_ada("import", self.out), {"imported": [], "known": [self.attempt], "refused": [], "not_all": []})
        self.ask("verify")
        self.assertIs(self.ask("replay", self.attempt)["identical"], True)

    def test_it_counts_once_its_origin_is_accepted(self):
        self.as_ada("import", self.out)
        directory = self.manifest()["directory"]
        self.assertIs(self.as_ada("origins")[0]["accepted"], False)
        self.assertEqual(self.as_ada("origins", "--accept", directory)[0]["directory"], directory)
        self.assertIs(self.as_ada("origins")[0]["accepted"], True)
        self.assertIs(self.as_ada("origins", "--unaccept", directory)[0]["accepted"], False)

    def write_manifest(self, manifest):
        (self.exported / "manifest.json").write_text(json.dumps(manifest, indent=1))

    def test_what_an_older_program_exported_is_taken_as_practice_without_decisions(self):
        """Neither its kind was sealed, nor its person and decisions bound to an act: both could be rewritten at will."""
        manifest = self.manifest()
        attempt = manifest["attempt"]
        attempt["kind"], attempt["person"], attempt["hand"], attempt["is_simulated"] = "assessment", "person-77", "", False
        manifest["decisions"] = [{"kind": "overridden", "about_score": 0, "score_milli": 100_000, "decided_by": "person-1",
                                  "decided_utc": "2026-03-10T08:00:00.000Z"}]
        manifest["format_version"] = 1
        del manifest["audit"]
        attempt["seal"] = older_seal(manifest)
        self.write_manifest(manifest)
        report = self.as_ada("import", self.out)
        self.assertEqual(report["imported"], [self.attempt])
        self.assertIn("taken as practice", report["not_all"][0])
        self.assertEqual(self.query("SELECT kind FROM attempt"), [("practice", )])
        self.assertEqual(self.query("SELECT count(*) FROM decision"), [(0, )])
        self.assertIs(self.ask("verify")["whole"], True)

    def test_kind_person_and_decisions_cannot_be_rewritten_alone(self):
        before = (self.exported / "manifest.json").read_text()
        for key, value in (("kind", "assessment"), ("is_simulated", True), ("person", "person-77")):
            manifest = json.loads(before)
            manifest["attempt"][key] = value
            self.write_manifest(manifest)
            self.assertEqual(len(self.as_ada("import", self.out, code=BAD_INPUT)["refused"]), 1, key)
        self.assertEqual(self.query("SELECT count(*) FROM attempt"), [(0, )])

    def test_what_was_altered_is_refused_and_named_and_nothing_is_kept(self):
        for name, old, new in (("samples.csv", b"\r\n0,1,", b"\r\n0,1,1"), ("tape.csv", b"\r\n0,1,", b"\r\n0,=1,"),
                               ("bone.bin", self.exported.joinpath("bone.bin").read_bytes()[:40], b"x" * 40),
                               ("plan.json", b'"format": 1', b'"format": 2'),
                               ("manifest.json", b'"state": "closed"', b'"state": "void"')):
            before = (self.exported / name).read_bytes()
            self.alter_file(name, old, new)
            report = self.as_ada("import", self.out, code=BAD_INPUT)
            self.assertEqual(len(report["refused"]), 1)
            self.assertIn(name, report["refused"][0]["reason"])
            self.assertEqual(self.query("SELECT count(*) FROM attempt"), [(0,)])
            (self.exported / name).write_bytes(before)
        self.assertEqual(self.as_ada("import", self.out)["imported"], [self.attempt])

    def test_only_an_administrator_takes_in(self):
        self.ask("user", "add", "bob", "--as", "ada", stdin=f"{PASSWORD}\n{PASSWORD}\n")
        for line in (["import", self.out], ["origins"]):
            self.expect_refusal(REFUSED, ["administrator"], *line, "--as", "bob", stdin=PASSWORD + "\n")
            self.expect_refusal(REFUSED, ["--as"], *line)

    def test_a_folder_is_new_and_complete_or_not_there(self):
        self.data = self.here
        self.expect_refusal(REFUSED, ["holds something"], "export", self.attempt, "-o", self.out)
        nowhere = self.folder / "file"
        nowhere.write_text("a file")
        self.expect_refusal(BAD_INPUT, ["a file is where"], "export", self.attempt, "-o", nowhere / "out")
        full = self.folder / "full"
        answer = self.run_with_room(20_000, "export", self.attempt, "-o", full)
        self.assertEqual(answer.code, STORAGE, answer)
        self.assertEqual([place.name for place in self.folder.iterdir() if "full" in place.name], [])

    def test_one_says_what_to_export(self):
        self.data = self.here
        for line in ([], ["--all", "--person", "ada"], [self.attempt, "--all"]):
            self.expect_refusal(WRONG_USAGE, ["say what to export"], "export", *line, "-o", self.folder / "x")
        self.expect_refusal(BAD_INPUT, ["may export"], "export", "--person", "nobody", "-o", self.folder / "x")


if __name__ == "__main__":
    unittest.main()
