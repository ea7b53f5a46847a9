#!/usr/bin/env python3
"""Backup, restore and retention as a script meets them: what is kept comes back whole, or not at all."""

import json
import os
import shutil
import signal
import time
import unittest

from hallux_command import BAD_INPUT, CHECK_FAILED, DONE, REFUSED, STORAGE, WRONG_USAGE, RecordedTest

PASSWORD = "saw bone hinge wire"


class Keeping(RecordedTest):
    def setUp(self):
        super().setUp()
        self.kept = self.folder / "kept"

    def back_up(self, code=DONE):
        return self.ask("backup", "--to", self.kept, code=code)

    def into(self, directory):
        """From now on the verbs work on that data directory."""
        self.data = directory
        return directory

    def restore(self, source=None, name="again"):
        self.into(self.folder / name)
        return self.ask("restore", source or self.kept)

    def manifest(self):
        [file] = self.kept.glob("*.json")
        return file

    def recording(self):
        return self.kept / "recordings" / f"{self.attempt}.recording"

    def expect_not_restored(self, code, *says):
        before = sorted(self.folder.iterdir())
        self.into(self.folder / "again")
        self.expect_refusal(code, says, "restore", self.kept)
        self.assertEqual(sorted(self.folder.iterdir()), before, "something was left")

    def test_what_was_kept_comes_back(self):
        listed = self.ask("attempts")
        made = self.back_up()
        self.assertEqual((made["recordings"], made["damaged"]), (1, 0))
        restored = self.restore()
        self.assertEqual((restored["attempts"], restored["recordings"], restored["erased_again"]), (1, 1, 0))
        self.assertEqual(self.ask("attempts"), listed)
        self.assertIs(self.ask("verify")["whole"], True)
        self.assertIs(self.ask("replay", self.attempt)["identical"], True)

    def test_a_second_backup_costs_what_is_new(self):
        self.back_up()
        written = self.recording().stat().st_mtime_ns
        again = self.back_up()
        self.assertEqual(self.recording().stat().st_mtime_ns, written)
        self.assertLess(again["new_bytes"], again["bytes"])
        self.assertEqual(len(list(self.kept.glob("hallux-*.json"))), 2)

    def test_backups_are_for_their_owner_only(self):
        self.back_up()
        for file in [self.kept, *self.kept.rglob("*")]:
            self.assertEqual(file.stat().st_mode & 0o077, 0, file)

    def test_the_list_is_of_the_directory_itself(self):
        self.assertEqual(self.ask("backup", "--list"), [])
        self.ask("backup")
        [only] = self.ask("backup", "--list")
        self.assertEqual(only["recordings"], 1)
        self.assertTrue(only["backup"].startswith(str(self.data / "backups")))

    def test_damage_is_kept_as_it_is_and_said(self):
        self.alter("UPDATE chunk SET link = zeroblob(32) WHERE chunk_id = (SELECT min(chunk_id) FROM chunk)")
        self.assertEqual(self.back_up(code=CHECK_FAILED)["damaged"], 1)
        self.expect_not_restored(STORAGE, self.attempt)
        restored = self.ask("restore", self.kept, "--even-damaged", code=CHECK_FAILED)
        self.assertIn(self.attempt, restored["first_damage"])
        self.assertEqual(len(self.ask("attempts")), 1)

    def test_a_directory_that_holds_something_is_not_touched(self):
        self.back_up()
        before = self.stored()
        self.expect_refusal(REFUSED, ["holds something"], "restore", self.kept)
        self.assertEqual(self.stored(), before)

    def test_restoring_needs_nobody_who_signs_in(self):
        self.back_up()
        self.into(self.folder / "again")
        self.expect_refusal(REFUSED, ["--as"], "restore", self.kept, "--as", "ada")

    def test_what_is_no_backup_is_said(self):
        self.into(self.folder / "again")
        self.expect_refusal(BAD_INPUT, ["no complete backup"], "restore", self.folder / "here")
        self.expect_refusal(BAD_INPUT, ["nowhere"], "restore", self.folder / "nowhere.json")
        self.expect_refusal(BAD_INPUT, ["no manifest"], "restore", self.write("other.json", {"kind": "else"}))

    def test_a_cut_recording_is_named(self):
        self.back_up()
        content = self.recording().read_bytes()
        self.recording().write_bytes(content[:-40])
        self.expect_not_restored(STORAGE, self.recording().name)
        restored = self.ask("restore", self.kept, "--even-damaged", code=CHECK_FAILED)
        self.assertIn(self.recording().name, restored["first_damage"])
        self.assertIsNotNone(self.ask("attempts")[0]["score"])

    def test_a_flipped_bit_is_named(self):
        self.back_up()
        content = bytearray(self.recording().read_bytes())
        content[len(content) // 2] ^= 4
        self.recording().write_bytes(content)
        self.expect_not_restored(STORAGE, self.recording().name)

    def test_links_and_paths_are_not_followed(self):
        self.back_up()
        content = self.recording().read_bytes()
        secret = self.write("secret", "of another")
        self.recording().unlink()
        self.recording().symlink_to(secret)
        self.expect_not_restored(BAD_INPUT, self.recording().name)
        self.recording().unlink()
        self.recording().write_bytes(content)
        manifest = json.loads(self.manifest().read_text())
        manifest["recordings"][0]["attempt"] = "../../secret"
        self.manifest().write_text(json.dumps(manifest))
        self.expect_not_restored(STORAGE, self.manifest().name)

    def test_a_full_disk_leaves_no_backup_and_no_directory(self):
        answer = self.run_with_room(4096, "backup", "--to", str(self.kept), "--quiet")
        self.assertEqual(answer.code, STORAGE, answer)
        self.assertEqual(list(self.kept.glob("*.json")), [])
        self.back_up()
        self.into(self.folder / "again")
        answer = self.run_with_room(200_000, "restore", str(self.kept), "--quiet")
        self.assertEqual(answer.code, STORAGE, answer)
        self.assertFalse(self.data.exists())
        self.assertEqual(self.ask("restore", self.kept)["attempts"], 1)

    def test_a_killed_backup_is_none_or_whole(self):
        for wait_s in (0.0, 0.02, 0.05, 0.1, 0.2):
            process = self.start("backup", "--to", self.kept, "--quiet")
            time.sleep(wait_s)
            os.kill(process.pid, signal.SIGKILL)
            process.wait()
        self.back_up()
        for number, manifest in enumerate(sorted(self.kept.glob("*.json"))):
            self.assertEqual(self.restore(manifest, f"again-{number}")["attempts"], 1)

    def test_a_killed_restore_is_none_or_whole(self):
        self.back_up()
        for number, wait_s in enumerate((0.0, 0.02, 0.05, 0.1, 0.2)):
            target = self.into(self.folder / f"again-{number}")
            process = self.start("restore", self.kept, "--quiet")
            time.sleep(wait_s)
            os.kill(process.pid, signal.SIGKILL)
            process.wait()
            if not target.exists():
                self.ask("restore", self.kept)
            self.assertIs(self.ask("verify")["whole"], True)
            self.assertFalse((self.folder / f".again-{number}.unfinished").exists())

    def test_interrupted_politely_it_leaves_nothing(self):
        self.back_up()
        target = self.into(self.folder / "again")
        process = self.start("restore", self.kept, "--quiet")
        process.send_signal(signal.SIGINT)
        process.wait()
        self.assertIn(process.returncode, (DONE, 5, -signal.SIGINT))
        self.assertEqual(target.exists(), process.returncode == DONE)

    def test_with_people_only_an_administrator_backs_up(self):
        self.ask("user", "add", "ada", "--administrator", stdin=PASSWORD + "\n")
        self.ask("user", "add", "ben", "--as", "ada", stdin=f"{PASSWORD}\n{PASSWORD}\n")
        for verb in (["backup", "--to", self.kept], ["retention"], ["retention", "--dry-run"]):
            self.expect_refusal(REFUSED, ["--as"], *verb)
            self.expect_refusal(REFUSED, ["administrator"], *verb, "--as", "ben", stdin=PASSWORD + "\n")
        self.assertFalse(self.kept.exists())
        self.ask("backup", "--to", self.kept, "--as", "ada", stdin=PASSWORD + "\n")
        self.restore()
        self.assertEqual(self.ask("attempts", "--as", "ben", stdin=PASSWORD + "\n")[0]["attempt"], self.attempt)

    def test_retention_says_first_and_takes_then(self):
        self.assertEqual(self.ask("retention"), {"recordings": 0, "accounts": 0, "cached": 0, "bytes": 0})
        self.alter("UPDATE attempt SET started_utc = '2020-01-01T00:00:00.000Z'")
        planned = self.ask("retention", "--practice-days", "30")
        self.assertEqual(planned["rules"]["practice_days"], 30)
        self.assertIsNone(planned["rules"]["assessment_days"])
        [piece] = planned["pieces"]
        self.assertEqual((piece["kind"], piece["name"]), ("practice", self.attempt))
        self.assertEqual(self.ask("retention", "--dry-run")["pieces"], [piece])
        self.assertEqual(self.query("SELECT count(*) FROM chunk WHERE attempt_id = 1")[0][0] > 0, True)
        went = self.ask("retention")
        self.assertEqual((went["recordings"], went["bytes"]), (1, piece["bytes"]))
        self.assertEqual(self.query("SELECT count(*) FROM chunk"), [(0,)])
        self.expect_refusal(BAD_INPUT, [self.attempt, "erased"], "replay", self.attempt)
        self.assertIsNotNone(self.ask("attempts")[0]["score"])

    def test_days_are_numbers_or_ever(self):
        for text in ("-1", "soon", "", "1e9"):
            self.assertEqual(self.hallux("retention", "--practice-days", text).code, WRONG_USAGE)
        self.assertIsNone(self.ask("retention", "--practice-days", "ever")["rules"]["practice_days"])

    def test_an_older_database_is_copied_before_it_is_migrated(self):
        old = self.folder / "old"
        old.mkdir()
        stored = os.path.join(os.path.dirname(__file__), "..", "..", "database", "old", "schema_2.db")
        shutil.copy(stored, old / "hallux.db")
        self.into(old)
        self.ask("attempts")
        [copy] = (old / "backups").glob("hallux-*.db")
        self.into(self.folder / "again")
        self.assertGreater(self.ask("restore", copy)["attempts"], 0)

    def test_it_is_migrated_without_a_copy_where_that_is_asked_for(self):
        old = self.folder / "old"
        old.mkdir()
        stored = os.path.join(os.path.dirname(__file__), "..", "..", "database", "old", "schema_2.db")
        shutil.copy(stored, old / "hallux.db")
        (old / "backups").write_text("a file stands in its place")
        self.into(old)
        self.expect_refusal(STORAGE, ["not migrated", "--no-backup"], "attempts")
        self.ask("attempts", "--no-backup")


if __name__ == "__main__":
    unittest.main()
