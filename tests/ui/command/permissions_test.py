#!/usr/bin/env python3
"""No verb tells anybody what they may not know: each verb is run by each kind of person, in a course where secrets of each
kind were planted, and no secret may be in its answer, its sentences or its files.

Verbs are read from `hallux --help`: one that is not listed here fails the test until somebody decided what it may tell.
"""

import re
import shutil
import unittest

from hallux_command import BAD_INPUT, DONE, WRONG_USAGE, RecordedTest

PASSWORD = "saw bone hinge wire"
#: ada's attempt is looked at by: nobody signed in, ada, another trainee of her cohort, the instructor of it, an instructor of
#: another cohort, the administrator.
ACTORS = (None, "ada", "bob", "kim", "lee", "root")
ABSENT = "00000000-0000-4000-8000-000000000000"

#: Each secret, and who may come to know it.
CANARIES = {
    "Canary-Name-of-Ada": {"ada", "kim", "root"},
    "Canary-Name-of-Eve": {"lee", "root"},
    "canary-login-eve": {"lee", "root"},
    "Canary-open-note": {"ada", "kim"},
    "Canary-private-note": {"kim"},
    "Canary-question": {"ada", "kim"},
    "Canary-cohort": {"ada", "bob", "kim", "root"},
    "Canary-setting": {"root"},
}

#: verb -> its command lines; {attempt} is ada's, {out} a file or folder that is not there yet, {robot} the robot's attempt.
LINES = {
    "attempts": [["attempts"]],
    "replay": [["replay", "{attempt}"]],
    "score": [["score", "{attempt}"]],
    "what-if": [["what-if", "{attempt}"], ["what-if", "{attempt}", "--change", "time_s=60"]],
    "report": [["report", "{attempt}", "-o", "{out}"]],
    "verify": [["verify"]],
    "anchor": [["anchor"]],
    "user list": [["user", "list"]],
    "user add": [["user", "add", "new-one"]],
    "user passwd": [["user", "passwd", "canary-login-eve"]],
    "user rename": [["user", "rename", "canary-login-eve", "--name", "Another Name"]],
    "user disable": [["user", "disable", "canary-login-eve"]],
    "user recover": [["user", "recover", "bob"]],
    "user erase": [["user", "erase", "canary-login-eve", "--reason", "asked"]],
    "sql": [["sql", "SELECT login, display_name FROM person_detail"], ["sql", "SELECT text FROM note"],
            ["sql", "SELECT question FROM help_request"], ["sql", "SELECT * FROM setting"], ["sql", "SELECT * FROM password"]],
    "rescore": [["rescore", "silver", "--dry-run"], ["rescore", "silver"]],
    "export": [["export", "{attempt}", "-o", "{out}"], ["export", "--all", "-o", "{out}"],
               ["export", "--person", "ada", "-o", "{out}"], ["export", "--cohort", "Canary-cohort", "-o", "{out}"]],
    "import": [["import", "{out}"]],
    "origins": [["origins"]],
    "export-person": [["export-person", "ada", "-o", "{out}"], ["export-person", "canary-login-eve", "-o", "{out}"]],
    "retention": [["retention", "--dry-run", "--practice-days", "1"]],
    "backup": [["backup", "--list"], ["backup", "--to", "{out}"]],
    "restore": [["restore", "{out}"]],
}
#: Verbs that open no database of people, or none that is there.
WITHOUT_PEOPLE = {"attempt", "cut", "scenario", "metrics", "demo", "foot", "devices"}
#: Where the line itself names the login, the sentence may say it back.
SAID_BY_THE_LINE = {"user passwd": {"canary-login-eve"}, "user rename": {"canary-login-eve"},
                    "user disable": {"canary-login-eve"},
                    "user erase": {"canary-login-eve"}, "export-person": {"canary-login-eve"}, "export": {"Canary-cohort"}}
#: A copy of all that is kept, and what a person may read of their own handed on: an administrator's acts, which are audited.
MORE = {("backup", "root"): set(CANARIES), ("export-person", "root"): {"Canary-open-note", "Canary-question"}}


def verbs_of(help_text):
    """The subcommands that a help names, in its last part."""
    part = help_text.split("Subcommands:", 1)[1] if "Subcommands:" in help_text else ""
    return re.findall(r"^  ([a-z][a-z-]*)", part, re.MULTILINE)


class Permissions(RecordedTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.course = None

    def setUp(self):
        super().setUp()
        if type(self).course is None:
            self.make_course()
            type(self).course = self.shelf_folder / "course"
            shutil.copytree(self.data, type(self).course)
        else:
            shutil.rmtree(self.data)
            shutil.copytree(type(self).course, self.data)

    def make_course(self):
        """ada and bob are trainees of kim's cohort, eve of lee's; the recorded attempt becomes ada's."""
        self.ask("user", "add", "root", "--administrator", stdin=PASSWORD + "\n")
        names = {"ada": "Canary-Name-of-Ada", "bob": "Bob", "kim": "Kim", "lee": "Lee", "canary-login-eve": "Canary-Name-of-Eve"}
        for login, name in names.items():
            self.ask("user", "add", login, "--name", name, "--as", "root", stdin=f"{PASSWORD}\n{PASSWORD}\n")
        person = dict(self.query("SELECT login, person_id FROM person_detail"))
        now = "2026-03-10T08:00:00.000Z"
        for number, cohort in ((1, "Canary-cohort"), (2, "spring")):
            self.alter("INSERT INTO cohort VALUES (?, ?, ?)", (number, cohort, now))
        for cohort, login, role in ((1, "ada", "trainee"), (1, "bob", "trainee"), (1, "kim", "instructor"),
                                    (2, "canary-login-eve", "trainee"), (2, "lee", "instructor")):
            self.alter("INSERT INTO membership (cohort_id, person_id, role) VALUES (?, ?, ?)", (cohort, person[login], role))
        self.alter("UPDATE attempt SET person_id = ? WHERE uuid = ?", (person["ada"], self.attempt))
        for is_private, text in ((0, "Canary-open-note"), (1, "Canary-private-note")):
            self.alter("INSERT INTO note (attempt_id, author_person_id, is_private, moment_us, text, written_utc) "
                       "SELECT attempt_id, ?, ?, 0, ?, ? FROM attempt WHERE uuid = ?",
                       (person["kim"], is_private, text, now, self.attempt))
        self.alter("INSERT INTO help_request (attempt_id, asker_person_id, moment_us, question, asked_utc) "
                   "SELECT attempt_id, person_id, 0, 'Canary-question', ? FROM attempt WHERE uuid = ?", (now, self.attempt))
        self.alter("INSERT INTO setting VALUES ('canary', 'Canary-setting', ?)", (now,))

    def run_as(self, actor, line, out):
        words = [word.format(attempt=self.attempt, out=out) for word in line]
        signed_in = [] if actor is None else ["--as", actor]
        return self.hallux(*words, *signed_in, stdin=f"{PASSWORD}\nanother long phrase\n")

    def secrets_in(self, answer, out):
        texts = [answer.out.encode(), answer.err.encode()]
        files = [out] if out.is_file() else sorted(out.rglob("*")) if out.is_dir() else []
        texts += [file.read_bytes() for file in files if file.is_file()]
        return {canary for canary in CANARIES if any(canary.encode() in text for text in texts)}

    def test_every_verb_was_decided_about(self):
        known = {line.split()[0] for line in LINES} | WITHOUT_PEOPLE
        self.assertEqual(set(verbs_of(self.hallux("--help").out)) - known, set(),
                         "decide what these verbs may tell whom: LINES, or WITHOUT_PEOPLE")
        known_of_user = {line.split()[1] for line in LINES if line.startswith("user ")}
        self.assertEqual(set(verbs_of(self.hallux("user", "--help").out)) - known_of_user, set())

    def lines_there_are(self):
        there = set(verbs_of(self.hallux("--help").out))
        return {verb: lines for verb, lines in LINES.items() if verb.split()[0] in there}

    def test_no_verb_tells_anybody_what_they_may_not_know(self):
        for verb, lines in self.lines_there_are().items():
            for actor in ACTORS:
                for as_json in ([], ["--json"]):
                    for line in lines:
                        with self.subTest(verb=verb, actor=actor, json=bool(as_json)):
                            out = self.folder / "out"
                            answer = self.run_as(actor, line + as_json, out)
                            self.assertNotEqual(answer.code, WRONG_USAGE, answer)
                            allowed = {canary for canary, knowing in CANARIES.items() if actor in knowing}
                            allowed |= MORE.get((verb, actor), set())
                            told = self.secrets_in(answer, out) - SAID_BY_THE_LINE.get(verb, set())
                            self.assertEqual(told - allowed, set(), answer)
                            shutil.rmtree(out, ignore_errors=True)
                            out.unlink(missing_ok=True)
                if verb.startswith("user ") or verb in ("rescore", "import"):
                    # What one of these changed must not decide what the next one may.
                    shutil.rmtree(self.data)
                    shutil.copytree(type(self).course, self.data)

    def test_an_attempt_that_is_not_theirs_is_answered_as_if_it_were_not_there(self):
        for actor in (None, "bob", "lee", "root"):
            for verb in (["replay"], ["score"], ["report", "-o", self.folder / "page.html"]):
                with self.subTest(actor=actor, verb=verb[0]):
                    answers = []
                    for attempt in (self.attempt, ABSENT):
                        signed_in = [] if actor is None else ["--as", actor]
                        answer = self.hallux(verb[0], attempt, *verb[1:], *signed_in, stdin=PASSWORD + "\n")
                        answers.append((answer.code, answer.out, answer.err.replace(attempt, "?")))
                    self.assertEqual(answers[0], answers[1])
                    self.assertEqual(answers[0][0], BAD_INPUT)
                    self.assertFalse((self.folder / "page.html").exists())

    def test_those_it_concerns_see_the_attempt(self):
        for actor in ("ada", "kim"):
            answer = self.hallux("replay", self.attempt, "--as", actor, stdin=PASSWORD + "\n")
            self.assertEqual(answer.code, DONE, answer)

    def test_the_audit_tells_who_asked_for_what(self):
        self.hallux("replay", self.attempt, "--as", "bob", stdin=PASSWORD + "\n")
        [(login, text)] = self.query("SELECT d.login, t.text FROM audit a JOIN person_detail d ON d.person_id = a.actor_person_id "
                                     "JOIN audit_text t USING (audit_id) WHERE a.outcome = 'refused' AND a.action = 'view_attempt'")
        self.assertEqual(login, "bob")
        self.assertIn(self.attempt, text)


if __name__ == "__main__":
    unittest.main()
