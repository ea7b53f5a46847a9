#!/usr/bin/env python3
"""Reports in plain SQL: what they answer with, whom they answer, and what stays closed."""

import csv
import io
import unittest

from hallux_command import BAD_INPUT, DONE, REFUSED, STORAGE, WRONG_USAGE, CommandTest, RecordedTest

ADMINISTRATOR, TRAINEE = "saw bone hinge wire", "medial eminence off"


class Reports(RecordedTest):
    def sql(self, statement):
        return self.ask("sql", statement)

    def test_an_answer_has_columns_and_rows(self):
        self.assertEqual(self.sql("SELECT uuid, state, NULL AS none, 1.5 AS half, x'0aff' AS blob FROM attempt"),
                         {"columns": ["uuid", "state", "none", "half", "blob"],
                          "rows": [[self.attempt, "closed", None, 1.5, "0aff"]]})

    def test_samples_are_rows(self):
        (first, last, count), = self.sql("SELECT min(tick), max(tick), count(*) FROM pose_samples("
                                         f"'{self.attempt}')")["rows"]
        self.assertEqual((first, last, count), (0, count - 1, self.recorded.json()["samples"]))
        (x, ), = self.sql(f"SELECT tool_x_in_world_um FROM pose_samples('{self.attempt}') WHERE tick = 700")["rows"]
        self.assertIsInstance(x, int)
        (kind, ), = self.sql(f"SELECT kind FROM cut_events('{self.attempt}') ORDER BY tick LIMIT 1")["rows"]
        self.assertEqual(kind, 1)
        (command, ), = self.sql(f"SELECT command_0 FROM tape_lines('{self.attempt}') WHERE command_count > 0 "
                                "ORDER BY tick LIMIT 1")["rows"]
        self.assertEqual(command, 1)

    def test_csv_is_rfc_4180_without_formulas(self):
        answer = self.hallux("sql", "SELECT 'a,\"b\"' AS \"x, y\", '=1+1' AS f, -3 AS n, NULL AS e", "--csv")
        self.assertEqual(answer.code, DONE, answer)
        self.assertEqual(list(csv.reader(io.StringIO(answer.out, newline=""))),
                         [["x, y", "f", "n", "e"], ['a,"b"', "'=1+1", "-3", ""]])

    def test_people_read_lines(self):
        answer = self.hallux("sql", "SELECT 'a' AS one, 'b\x1b[2J' AS two")
        self.assertEqual(answer.out, "one\ttwo\na\tb\\x1b[2J\n")

    def test_it_only_reads(self):
        before = self.stored()
        for statement in ("DELETE FROM attempt", "UPDATE score SET score_milli = 1", "PRAGMA user_version = 9",
                          "ATTACH 'x.db' AS x", "VACUUM INTO 'copy.db'"):
            answer = self.hallux("sql", statement)
            self.assertIn(answer.code, (REFUSED, BAD_INPUT), answer)
        self.expect_refusal(REFUSED, ["prohibited"], "sql", "SELECT argon2id FROM password")
        self.expect_refusal(REFUSED, ["prohibited"], "sql", "SELECT login FROM person_detail")
        self.assertEqual(self.stored(), before)

    def test_wrong_sql_is_bad_input(self):
        self.expect_refusal(BAD_INPUT, ["syntax error"], "sql", "SELEC 1")
        self.expect_refusal(BAD_INPUT, ["more than one"], "sql", "SELECT 1; SELECT 2")
        self.expect_refusal(BAD_INPUT, ["no such table"], "sql", "SELECT * FROM shelf")
        self.expect_refusal(BAD_INPUT, ["longer than"], "sql",
                            "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT max(i) FROM n")
        self.expect_refusal(WRONG_USAGE, ["not both"], "sql", "SELECT 1", "--json", "--csv")

    def test_a_damaged_chunk_is_named(self):
        self.alter("UPDATE chunk SET bytes = x'0200' WHERE seq = 2 AND stream = 1")
        self.expect_refusal(STORAGE, ["samples of window 2"], "sql", f"SELECT count(*) FROM pose_samples('{self.attempt}')")


class ReportsOfACourse(CommandTest):
    def setUp(self):
        super().setUp()
        self.ask("user", "add", "ada", "--administrator", stdin=ADMINISTRATOR + "\n")
        self.ask("user", "add", "ben", "--as", "ada", stdin=f"{ADMINISTRATOR}\n{TRAINEE}\n")

    def test_are_an_administrators(self):
        self.expect_refusal(REFUSED, ["--as"], "sql", "SELECT 1")
        self.expect_refusal(REFUSED, ["administrator"], "sql", "SELECT 1", "--as", "ben", stdin=TRAINEE + "\n")
        self.assertEqual(self.ask("sql", "SELECT count(*) FROM person", "--as", "ada", stdin=ADMINISTRATOR + "\n"),
                         {"columns": ["count(*)"], "rows": [[2]]})

    def test_stand_in_the_audit_with_their_text(self):
        self.ask("sql", "SELECT 17", "--as", "ada", stdin=ADMINISTRATOR + "\n")
        self.assertEqual(self.query("SELECT text FROM audit JOIN audit_text USING (audit_id) WHERE action = 'report_run'"),
                         [("SELECT 17",)])


if __name__ == "__main__":
    unittest.main()
