#!/usr/bin/env python3
"""Somebody without our program reads an attempt: with sqlite3, zstandard, hashlib, and what docs/data_format.md says.

The functions that unpack a chunk are taken from that page as they stand there.
"""

import hashlib
import pathlib
import re
import sqlite3
import unittest

import zstandard

from hallux_command import RecordedTest

PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs" / "data_format.md"
COLUMNS = {0: 23, 1: 13, 2: 11}


def functions_of_the_page():
    names = {}
    for block in re.findall(r"```python\n(.*?)```", PAGE.read_text(), re.DOTALL):
        exec(compile(block, PAGE.name, "exec"), names)
    return names


READ = functions_of_the_page()


class Digest:
    """What is digested, as "Conventions" says."""

    def __init__(self):
        self.state = hashlib.blake2b(digest_size=32)

    def bytes(self, value):
        self.state.update(value)
        return self

    def integer(self, value):
        return self.bytes(value.to_bytes(8, "little", signed=True))

    def text(self, value):
        return self.integer(len(value.encode())).bytes(value.encode())

    def finish(self):
        return self.state.digest()


def payload_of(table):
    payload = bytearray()
    for column in table:
        before = 0
        for value in column:
            step = value - before
            step = (step + 2**63) % 2**64 - 2**63
            number = (step << 1) ^ (step >> 63)
            while number >= 128:
                payload.append(number & 127 | 128)
                number >>= 7
            payload.append(number)
            before = value
    return bytes(payload)


class Attempt:
    """Reads an attempt and its chain from a file that it knows nothing else about."""

    def __init__(self, file):
        self.connection = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
        self.connection.row_factory = sqlite3.Row
        self.facts = self.connection.execute(
            "SELECT a.*, s.digest AS scenario_digest FROM attempt a JOIN scenario_version s USING (scenario_version_id)").fetchone()
        self.streams, self.formats, self.link = {0: [], 1: [], 2: []}, set(), bytes(32)
        tape = None
        for chunk in self.connection.execute("SELECT * FROM chunk WHERE attempt_id = ? ORDER BY seq, stream",
                                             (self.facts["attempt_id"],)):
            table = self.table_of(chunk, tape)
            if chunk["stream"] == 0:
                tape = table
            self.streams[chunk["stream"]] += list(zip(*table))
            self.link = (Digest().bytes(self.link).text(self.facts["uuid"]).integer(chunk["stream"]).integer(chunk["seq"])
                         .integer(chunk["first_tick"]).integer(chunk["row_count"]).bytes(payload_of(table)).finish())
            if self.link != chunk["link"]:
                raise AssertionError(f"the link of chunk {chunk['chunk_id']} does not fit")
        self.connection.close()

    def table_of(self, chunk, tape):
        content = zstandard.ZstdDecompressor().decompress(chunk["bytes"][1:])
        self.formats.add(chunk["bytes"][0])
        count = COLUMNS[chunk["stream"]]
        if chunk["bytes"][0] == 1:
            return READ["columns"](content, chunk["row_count"], count)
        return READ["coded"](content, chunk["row_count"], count, tape)

    def seal(self):
        facts, digest = self.facts, Digest()
        digest.bytes(self.link).text(facts["uuid"]).bytes(facts["scenario_digest"]).text(facts["hand"]).integer(facts["seed"])
        for name in ("device_class", "pacing", "stereo_mode"):
            digest.text(facts[name])
        digest.bytes(facts["bone_digest"]).integer(facts["engine_version"]).text(facts["started_utc"])
        digest.integer(facts["duration_ticks"]).text(facts["quality_json"])
        return digest.text(facts["guidance"]).text(facts["kind"]).integer(facts["is_simulated"]).finish()


class Stranger(RecordedTest):
    def rows(self, table):
        return [tuple(row) for row in self.ask("sql", f"SELECT * FROM {table}('{self.attempt}')")["rows"]]

    def test_reads_what_the_program_reads(self):
        attempt = Attempt(self.database())
        self.assertEqual(attempt.facts["uuid"], self.attempt)
        self.assertEqual(len(attempt.streams[1]), self.recorded.json()["samples"])
        self.assertEqual(attempt.streams[1], self.rows("pose_samples"))
        self.assertEqual(attempt.streams[2], self.rows("cut_events"))
        lines = [row[:8] + (row[8] & 0xFFFFFFFF, row[8] >> 32 & 0xFFFFFFFF) + row[9:] for row in attempt.streams[0]]
        self.assertEqual(lines, self.rows("tape_lines"))
        self.assertIn(2, attempt.formats)

    def test_follows_the_audit_and_what_each_act_says_of_its_rows(self):
        nothing, before = bytes(32), bytes(32)
        acts = self.query("SELECT audit_id, at_utc, actor_person_id, action, subject_kind, subject_id, outcome, detail_digest, "
                          "link FROM audit ORDER BY audit_id")
        self.assertEqual(acts[0][3], "baseline_taken")
        for number, at, actor, action, kind, subject, outcome, detail, link in acts:
            rows = Digest()
            for table, key, digest in self.query("SELECT table_name, row_key, row_digest FROM audit_row WHERE audit_id = ? "
                                                 "ORDER BY place", (number, )):
                rows.text(table).text(key).integer(1 if digest else 0).bytes(digest or nothing)
            whole = Digest().bytes(before).integer(number).text(at).integer(actor or 0).text(action).text(kind).text(subject)
            before = whole.text(outcome).bytes(detail or nothing).bytes(rows.finish()).finish()
            self.assertEqual(before, link, number)

    def test_computes_what_a_row_must_be(self):
        [row] = self.query("SELECT directory_id, uuid, made_utc FROM directory")
        digest = Digest().text("directory")
        digest.text("directory_id").integer(1).integer(row[0])
        for name, value in (("uuid", row[1]), ("made_utc", row[2])):
            digest.text(name).integer(3).text(value)
        self.assertEqual(self.query("SELECT row_digest FROM audit_row WHERE table_name = 'directory'"), [(digest.finish(), )])

    def test_finds_the_chain_and_the_seal_as_they_are_stored(self):
        attempt = Attempt(self.database())
        self.assertEqual(attempt.seal(), attempt.facts["seal"])

    def test_notices_an_altered_number(self):
        self.alter("UPDATE chunk SET first_tick = first_tick + 1 WHERE seq = 1 AND stream = 1")
        with self.assertRaises(AssertionError):
            Attempt(self.database())


if __name__ == "__main__":
    unittest.main()
