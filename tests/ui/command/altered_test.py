#!/usr/bin/env python3
"""Databases that were altered, damaged, or made by another version: noticed, named, and left as they are."""

import hashlib
import json
import sqlite3
import unittest

from hallux_command import BAD_INPUT, CHECK_FAILED, DONE, STORAGE, RecordedTest


def seal_of(row):
    """An attempt's seal, from docs/data_format.md."""
    digest = hashlib.blake2b(digest_size=32)

    def integer(value):
        digest.update(value.to_bytes(8, "little", signed=True))

    def text(value):
        integer(len(value.encode()))
        digest.update(value.encode())

    digest.update(row["link"])
    text(row["uuid"])
    digest.update(row["scenario_digest"])
    text(row["hand"])
    integer(row["seed"])
    for column in ("device_class", "pacing", "stereo_mode"):
        text(row[column])
    digest.update(row["bone_digest"])
    integer(row["engine_version"])
    text(row["started_utc"])
    integer(row["duration_ticks"])
    for column in ("quality_json", "guidance", "kind"):
        text(row[column])
    integer(row["is_simulated"])
    return digest.digest()


class Altered(RecordedTest):
    def expect_damage(self, *says):
        """verify names the damage and exits 1; what reads the attempt refuses; nothing is mended silently."""
        before = self.stored()
        found = self.ask("verify", code=CHECK_FAILED)
        self.assertIs(found["whole"], False)
        for text in says:
            self.assertIn(text, found["first_damage"])
        for verb in (["replay", self.attempt], ["score", self.attempt],
                     ["report", self.attempt, "-o", self.folder / "page.html"]):
            self.expect_refusal(STORAGE, [self.attempt, "restore a backup"], *verb)
        self.assertFalse((self.folder / "page.html").exists())
        self.assertEqual(self.stored(), before)

    def flip_byte(self, stream, at):
        [(chunk, content)] = self.query("SELECT chunk_id, bytes FROM chunk WHERE stream = ? ORDER BY seq LIMIT 1 OFFSET 3",
                                        (stream,))
        altered = bytearray(content)
        altered[at] ^= 1
        self.assertEqual(self.alter("UPDATE chunk SET bytes = ? WHERE chunk_id = ?", (bytes(altered), chunk)), 1)

    def test_one_bit_of_the_tape(self):
        self.flip_byte(0, -9)
        self.expect_damage(self.attempt)

    def test_one_bit_of_the_samples(self):
        self.flip_byte(1, 20)
        self.expect_damage(self.attempt)

    def test_a_chunk_that_is_gone(self):
        self.alter("DELETE FROM chunk WHERE chunk_id = (SELECT chunk_id FROM chunk WHERE stream = 1 ORDER BY seq LIMIT 1 OFFSET 5)")
        self.expect_damage(self.attempt)

    def test_the_last_chunks_that_are_gone(self):
        self.alter("DELETE FROM chunk WHERE seq >= 50")
        self.expect_damage(self.attempt)

    def test_a_fact_of_the_attempt(self):
        self.alter("UPDATE attempt SET hand = 'surgeon'")
        self.expect_damage(self.attempt)

    def test_the_bone(self):
        [(packed,)] = self.query("SELECT zstd FROM asset")
        altered = bytearray(packed)
        altered[len(altered) // 2] ^= 1
        self.alter("UPDATE asset SET zstd = ?", (bytes(altered),))
        found = self.ask("verify", code=CHECK_FAILED)
        self.assertIn("asset", found["first_damage"])
        self.expect_refusal(STORAGE, ["restore a backup"], "score", self.attempt)

    def test_whether_it_may_be_graded(self):
        [(valid, quality)] = self.query("SELECT is_valid, quality_json FROM attempt")
        self.assertEqual(bool(valid), json.loads(quality)["valid"])
        self.alter("UPDATE attempt SET is_valid = 1 - is_valid")
        found = self.ask("verify", code=CHECK_FAILED)
        self.assertIn("whether attempt " + self.attempt + " is valid", found["first_damage"])

    def test_a_score_that_is_gone(self):
        self.alter("DELETE FROM score")
        found = self.ask("verify", code=CHECK_FAILED)
        self.assertIn("which is missing", found["first_damage"])

    def test_an_attempt_that_no_audit_row_explains(self):
        columns = ("scenario_version_id, hand, seed, device_class, pacing, stereo_mode, bone_digest, engine_version, "
                   "started_utc")
        another = "00000000-0000-4000-8000-000000000000"
        self.alter(f"INSERT INTO attempt (uuid, state, {columns}) SELECT '{another}', 'interrupted', {columns} FROM attempt")
        found = self.ask("verify", code=CHECK_FAILED)
        self.assertIn(f"the beginning of attempt {another}", found["first_damage"])
        self.alter("UPDATE attempt SET uuid = 'another' WHERE state = 'interrupted'")
        found = self.ask("verify", code=CHECK_FAILED)
        self.assertIn("the uuid of attempt another", found["first_damage"])

    def test_a_stored_score_and_the_audit_defend_themselves(self):
        for statement in ("UPDATE score SET score_milli = 100000", "UPDATE audit SET outcome = 'refused'",
                          "DELETE FROM audit"):
            with self.assertRaises(sqlite3.IntegrityError):
                self.alter(statement)
        self.assertIs(self.ask("verify")["whole"], True)

    def test_a_score_altered_without_its_trigger(self):
        self.alter("DROP TRIGGER score_is_superseded_not_overwritten")
        self.alter("UPDATE score SET score_milli = 100000, card_json = replace(card_json, 'silver', 'golden')")
        found = self.ask("verify", code=CHECK_FAILED)
        self.assertIn("score", found["first_damage"])


class Resealed(RecordedTest):
    """An owner of the file who recomputes the seal is not noticed by the chain; the replay still proves."""

    def reseal(self):
        connection = sqlite3.connect(self.database())
        connection.row_factory = sqlite3.Row
        row = connection.execute("SELECT a.*, v.digest AS scenario_digest, "
                                 "(SELECT link FROM chunk WHERE attempt_id = a.attempt_id ORDER BY seq DESC, stream DESC "
                                 "LIMIT 1) AS link FROM attempt a JOIN scenario_version v USING (scenario_version_id)"
                                 ).fetchone()
        connection.execute("UPDATE attempt SET seal = ?", (seal_of(row),))
        connection.commit()
        connection.close()

    def test_the_seal_is_what_the_specification_says(self):
        [(before,)] = self.query("SELECT seal FROM attempt")
        self.reseal()
        self.assertEqual(self.query("SELECT seal FROM attempt"), [(before,)])

    def test_a_replay_with_another_blade_differs_and_names_the_tick(self):
        [(text,)] = self.query("SELECT json FROM scenario_version")
        scenario = json.loads(text)
        scenario["blade"]["cycles_per_minute"] = 6000
        altered = json.dumps(scenario)
        digest = hashlib.blake2b(altered.encode(), digest_size=32).digest()
        self.alter("UPDATE scenario_version SET json = ?, digest = ?", (altered, digest))
        self.reseal()
        answer = self.ask("replay", self.attempt, code=CHECK_FAILED)
        self.assertIs(answer["identical"], False)
        self.assertGreater(answer["first_difference_tick"], 0)
        self.assertLess(answer["first_difference_tick"], answer["samples"])
        said = self.hallux("replay", self.attempt)
        self.assertEqual(said.code, CHECK_FAILED)
        self.assertIn(f"tick {answer['first_difference_tick']}", said.out)

    def test_an_attempt_of_another_engine_is_scored_but_proves_nothing(self):
        self.alter("UPDATE attempt SET engine_version = engine_version + 1")
        self.reseal()
        answer = self.ask("replay", self.attempt)
        self.assertIsNone(answer["identical"])
        self.assertIsNone(answer["bone_hash"])
        self.assertEqual(answer["samples"], self.recorded.json()["samples"])
        self.assertEqual(self.ask("score", self.attempt)["score"], self.recorded.json()["score"])


class Unreadable(RecordedTest):
    """Every verb refuses the file in the same words, and leaves each byte of it."""

    def expect_untouched(self, code, says):
        before = self.stored()
        for verb in (["attempts"], ["verify"], ["replay", self.attempt], ["score", self.attempt],
                     ["user", "list"], ["attempt", "silver", "--hand", self.write("idle.json", self.idle())]):
            with self.subTest(verb=verb[0]):
                self.expect_refusal(code, ["hallux.db", *says], *verb)
        self.assertEqual(self.stored(), before)

    @staticmethod
    def idle():
        return {"keys": [{"time_s": 0.0, "tip_mm": [0, 0, 90], "direction": [1, 0, 0], "normal": [0, 0, 1]}]}

    def test_a_database_of_a_newer_version(self):
        self.alter("PRAGMA user_version = 9999")
        self.expect_untouched(STORAGE, ["9999"])

    def test_a_database_of_another_program(self):
        self.alter("PRAGMA application_id = 7")
        self.expect_untouched(STORAGE, [])

    def test_a_truncated_database(self):
        with self.database().open("r+b") as stream:
            stream.truncate(20_000)
        self.expect_untouched(STORAGE, ["damaged"])

    def test_a_file_that_is_no_database(self):
        self.database().write_text("my notes of the course\n" * 100)
        self.expect_untouched(STORAGE, ["not a database"])

    def test_a_data_directory_that_is_a_file(self):
        self.data = self.write("notes.txt", "my notes")
        for verb in (["attempts"], ["verify"], ["user", "list"]):
            self.expect_refusal(STORAGE if verb != ["verify"] else BAD_INPUT, ["notes.txt", "--data"], *verb)
        self.assertEqual(self.data.read_text(), "my notes")

    def test_an_answer_that_cannot_be_written_is_a_storage_error(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            code, said = self.run_into(full, "attempts", "--json")
        self.assertEqual(code, STORAGE)
        self.assertIn("stdout", said)
        self.assertEqual(self.hallux("verify").code, DONE)


if __name__ == "__main__":
    unittest.main()
