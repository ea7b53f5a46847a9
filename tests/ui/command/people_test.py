#!/usr/bin/env python3
"""People and their passwords: from stdin only, never from the arguments, and never shown."""

import subprocess
import time
import unittest

from hallux_command import BAD_INPUT, DONE, REFUSED, WRONG_USAGE, CommandTest, RecordedTest

ADMINISTRATOR, TRAINEE, LATER = "saw bone hinge wire", "medial eminence off", "dorsal to plantar cut"


def lines(*passwords):
    return "".join(password + "\n" for password in passwords)


def places_in_memory(process, secret):
    """At how many places of a running process's writable memory the text stands."""
    places = 0
    with open(f"/proc/{process}/maps") as maps, open(f"/proc/{process}/mem", "rb", buffering=0) as memory:
        for line in maps:
            span, rights = line.split()[:2]
            begin, end = (int(number, 16) for number in span.split("-"))
            if rights.startswith("rw"):
                memory.seek(begin)
                places += memory.read(end - begin).count(secret.encode())
    return places


class People(CommandTest):
    def setUp(self):
        super().setUp()
        self.ask("user", "add", "ada", "--administrator", "--name", "Ada Müller", stdin=lines(ADMINISTRATOR))

    def tearDown(self):
        for file in self.data.rglob("*"):
            if file.is_file():
                for password in (ADMINISTRATOR, TRAINEE, LATER):
                    self.assertNotIn(password.encode(), file.read_bytes(), file)
        super().tearDown()

    def as_ada(self, *arguments, more=(), code=DONE):
        return self.ask(*arguments, "--as", "ada", stdin=lines(ADMINISTRATOR, *more), code=code)

    def add_ben(self):
        return self.as_ada("user", "add", "ben", more=[TRAINEE])

    def expect_signs_in(self, login, password):
        self.assertEqual(self.ask("attempts", "--as", login, stdin=lines(password)), [])

    def expect_refused(self, *arguments, stdin="", says=()):
        self.expect_refusal(REFUSED, says, *arguments, stdin=stdin)

    def test_the_list_shows_people_and_no_secret(self):
        self.assertEqual(self.add_ben(), {"login": "ben", "done": "added"})
        rows = self.as_ada("user", "list")
        self.assertEqual([(row["login"], row["administrator"], row["disabled"]) for row in rows],
                         [("ada", True, False), ("ben", False, False)])
        self.assertEqual(rows[0]["name"], "Ada Müller")
        self.assertNotIn("argon2", str(rows))

    def test_an_administrator_corrects_a_name(self):
        self.add_ben()
        self.assertEqual(self.as_ada("user", "rename", "ben", "--name", "Ben Ångström"), {"login": "ben", "done": "renamed"})
        self.assertEqual([row["name"] for row in self.as_ada("user", "list")], ["Ada Müller", "Ben Ångström"])
        self.assertEqual(self.query("SELECT action FROM audit WHERE action = 'name_corrected'"), [("name_corrected",)])
        self.assertEqual(self.query("SELECT kind FROM notice"), [("name_corrected",)])
        self.expect_refused("user", "rename", "ada", "--name", "Eve", "--as", "ben", stdin=lines(TRAINEE), says=["administrator"])
        self.expect_refusal(BAD_INPUT, ["ben", "already"], "user", "rename", "ben", "--name", "Ben Ångström", "--as", "ada",
                            stdin=lines(ADMINISTRATOR))

    def test_an_answer_never_holds_a_password(self):
        said = self.hallux("user", "add", "ben", "--as", "ada", stdin=lines(ADMINISTRATOR, TRAINEE))
        self.assertEqual(said.code, DONE, said)
        for password in (ADMINISTRATOR, TRAINEE):
            self.assertNotIn(password, said.out + said.err)

    def test_a_wrong_password_and_an_unknown_login_are_refused_in_the_same_words(self):
        wrong = self.hallux("user", "list", "--as", "ada", stdin=lines("not the password"))
        unknown = self.hallux("user", "list", "--as", "eve", stdin=lines("not the password"))
        self.assertEqual((wrong.code, unknown.code), (REFUSED, REFUSED))
        self.assertEqual(wrong.err.replace("ada", "eve"), unknown.err)

    def test_after_wrong_passwords_the_next_try_waits_and_says_how_long(self):
        for _ in range(3):
            self.expect_refused("attempts", "--as", "ada", stdin=lines("not the password"), says=["wrong"])
        # As after nine: starting a program may take longer than the first waits.
        self.alter("UPDATE sign_in_guard SET failures = 9")
        self.expect_refused("attempts", "--as", "ada", stdin=lines(ADMINISTRATOR), says=["try again in", "seconds"])
        self.alter("UPDATE sign_in_guard SET failed_utc = strftime('%Y-%m-%dT%H:%M:%fZ', failed_utc, '-61 seconds')")
        self.expect_signs_in("ada", ADMINISTRATOR)

    def test_the_owner_of_the_directory_recovers_an_administrator(self):
        recovered = self.ask("user", "recover", "ada")
        self.expect_signs_in("ada", ADMINISTRATOR)
        said = self.hallux("user", "passwd", "ada", "--code", stdin=lines(recovered["code"], LATER))
        self.assertEqual(said.code, DONE, said)
        self.expect_signs_in("ada", LATER)
        self.expect_refused("attempts", "--as", "ada", stdin=lines(ADMINISTRATOR))
        self.assertEqual(self.query("SELECT kind FROM notice WHERE person_id IS NULL"), [("recovered",)])

    def test_only_an_administrator_is_recovered(self):
        self.add_ben()
        self.expect_refusal(BAD_INPUT, ["ben", "administrator"], "user", "recover", "ben")
        self.expect_refusal(BAD_INPUT, ["eve"], "user", "recover", "eve")

    def test_a_password_stands_in_memory_in_one_place_only(self):
        process = subprocess.Popen(self.line(["user", "passwd", "--as", "ada"]), stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, cwd=self.untouched[2], env=self.environment())
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        process.stdin.write(lines(ADMINISTRATOR).encode())
        process.stdin.flush()
        signed_in = "SELECT count(*) FROM audit WHERE action = 'signed_in'"
        for _ in range(600):
            if self.query(signed_in) == [(1,)]:
                break
            time.sleep(0.05)
        time.sleep(0.2)
        # It waits for the new one; the old one is still needed, and held in its locked page.
        self.assertEqual(places_in_memory(process.pid, ADMINISTRATOR), 1)
        out, err = process.communicate(lines(LATER).encode(), timeout=60)
        self.assertEqual(process.returncode, DONE, err)
        self.expect_signs_in("ada", LATER)

    def test_no_password_at_all_is_refused(self):
        self.expect_refused("user", "list", "--as", "ada", says=["stdin"])

    def test_managing_people_needs_someone_who_signed_in(self):
        self.expect_refused("user", "list", says=["--as"])
        self.expect_refused("user", "add", "ben", stdin=lines(TRAINEE), says=["--as"])
        self.expect_refused("user", "disable", "ada", says=["--as"])

    def test_a_trainee_manages_nobody(self):
        self.add_ben()
        for verb in (["list"], ["add", "cyd"], ["disable", "ada"], ["passwd", "ada"]):
            self.expect_refused("user", *verb, "--as", "ben", stdin=lines(TRAINEE, LATER), says=["ben", "administrator"])

    def test_a_disabled_person_cannot_sign_in_until_enabled(self):
        self.add_ben()
        self.as_ada("user", "disable", "ben")
        self.assertIs(self.as_ada("user", "list")[1]["disabled"], True)
        self.expect_refused("attempts", "--as", "ben", stdin=lines(TRAINEE))
        self.as_ada("user", "disable", "ben", "--enable")
        self.expect_signs_in("ben", TRAINEE)

    def test_the_last_administrator_cannot_be_disabled(self):
        self.expect_refused("user", "disable", "ada", "--as", "ada", stdin=lines(ADMINISTRATOR), says=["last administrator"])
        self.expect_signs_in("ada", ADMINISTRATOR)

    def test_people_change_their_own_password(self):
        self.add_ben()
        self.ask("user", "passwd", "--as", "ben", stdin=lines(TRAINEE, LATER))
        self.expect_refused("attempts", "--as", "ben", stdin=lines(TRAINEE))
        self.expect_signs_in("ben", LATER)

    def test_an_administrator_sets_the_password_of_another(self):
        self.add_ben()
        self.as_ada("user", "passwd", "ben", more=[LATER])
        self.expect_signs_in("ben", LATER)

    def test_a_wrong_old_password_changes_nothing(self):
        self.expect_refused("user", "passwd", "--as", "ada", stdin=lines("not the password", LATER))
        self.expect_signs_in("ada", ADMINISTRATOR)

    def test_a_password_that_is_too_short_or_a_login_that_is_taken_is_bad_input(self):
        self.expect_refusal(BAD_INPUT, [], "user", "add", "ben", "--as", "ada", stdin=lines(ADMINISTRATOR, "short"))
        self.expect_refusal(BAD_INPUT, ["ada"], "user", "add", "ada", "--as", "ada", stdin=lines(ADMINISTRATOR, LATER))
        self.expect_refusal(BAD_INPUT, [], "user", "add", "../ben", "--as", "ada", stdin=lines(ADMINISTRATOR, LATER))
        self.assertEqual(len(self.as_ada("user", "list")), 1)

    def test_an_unknown_person_is_bad_input(self):
        self.expect_refusal(BAD_INPUT, ["eve"], "user", "disable", "eve", "--as", "ada", stdin=lines(ADMINISTRATOR))

    def test_a_person_sees_none_of_the_robots_attempts_as_their_own(self):
        self.assertEqual(self.as_ada("attempts"), [])

    def test_the_audit_keeps_numbers_only(self):
        self.add_ben()
        rows = self.query("SELECT action, subject_kind, subject_id, outcome FROM audit")
        self.assertNotIn("ben", str(rows))
        self.assertIs(self.ask("verify")["whole"], True)


class Cohort(CommandTest):
    """An instructor lists the attempts of the trainees of their cohort, and of nobody else."""

    PEOPLE = {"ada": 1, "ben": 2, "cyd": 3, "kim": 4}

    def setUp(self):
        super().setUp()
        self.ask("user", "add", "ada", "--administrator", stdin=lines(ADMINISTRATOR))
        for login in ("ben", "cyd", "kim"):
            self.ask("user", "add", login, "--as", "ada", stdin=lines(ADMINISTRATOR, TRAINEE))
        self.alter("INSERT INTO cohort (cohort_id, name, created_utc) VALUES (1, 'autumn', '')")
        self.enrol("ben", "trainee")
        self.enrol("kim", "instructor")
        self.alter("INSERT INTO scenario_version VALUES (1, 'silver', 1, '{}', zeroblob(32), 0, '')")
        self.alter("INSERT INTO asset VALUES (1, zeroblob(32), 'bone', 0, x'')")
        for login in ("ben", "cyd", "kim"):
            self.alter("INSERT INTO attempt (uuid, scenario_version_id, person_id, hand, seed, device_class, pacing, "
                       "stereo_mode, bone_digest, engine_version, started_utc, state) "
                       "VALUES (?, 1, ?, '', 0, 'mouse', 'real_time', 'none', zeroblob(32), 2, ?, 'interrupted')",
                       (f"0000{login}", self.PEOPLE[login], f"2026-03-0{self.PEOPLE[login]}"))

    def enrol(self, login, role):
        self.alter("INSERT INTO membership (cohort_id, person_id, role) VALUES (1, ?, ?)", (self.PEOPLE[login], role))

    def listed_for(self, login, password=TRAINEE):
        return [row["person"] for row in self.ask("attempts", "--as", login, stdin=lines(password))]

    def test_is_listed_for_its_instructor_beside_their_own(self):
        self.assertEqual(self.listed_for("kim"), ["kim", "ben"])

    def test_is_not_listed_for_its_trainees_nor_for_an_administrator(self):
        self.assertEqual(self.listed_for("ben"), ["ben"])
        self.assertEqual(self.listed_for("cyd"), ["cyd"])
        self.assertEqual(self.listed_for("ada", ADMINISTRATOR), [])

    def test_is_not_listed_any_more_for_an_instructor_who_left(self):
        self.alter("DELETE FROM membership WHERE role = 'instructor'")
        self.assertEqual(self.listed_for("kim"), ["kim"])


class FirstPerson(CommandTest):
    def test_the_first_person_must_be_an_administrator(self):
        self.expect_refusal(BAD_INPUT, ["--administrator"], "user", "add", "ada", stdin=lines(ADMINISTRATOR))
        self.assertFalse(self.data.exists())

    def test_a_password_is_never_an_argument(self):
        answer = self.hallux("user", "add", "ada", ADMINISTRATOR, "--administrator", stdin=lines(ADMINISTRATOR))
        self.assertEqual(answer.code, WRONG_USAGE, answer)
        self.assertFalse(self.data.exists())

    def test_nobody_is_added_without_a_password(self):
        self.expect_refusal(REFUSED, ["stdin"], "user", "add", "ada", "--administrator")
        self.assertFalse(self.data.exists())


class MistypedDirectory(CommandTest):
    """Where there is no database, only the first person and a recorded attempt make one."""

    def test_no_verb_about_people_makes_one(self):
        for verb in (["list"], ["passwd"], ["passwd", "ada"], ["disable", "ada"], ["disable", "ada", "--enable"],
                     ["add", "ben"]):
            for sign_in in ([], ["--as", "ada"]):
                if (verb[0], sign_in) != ("add", []):
                    with self.subTest(verb=verb, sign_in=sign_in):
                        self.expect_refusal(BAD_INPUT, ["no database", str(self.data), "--data"], "user", *verb, *sign_in,
                                            stdin=lines(ADMINISTRATOR, LATER))
                        self.assertFalse(self.data.exists())

    def test_nobody_signs_in_to_it(self):
        self.expect_refusal(BAD_INPUT, ["no database", str(self.data)], "attempt", "silver", "--as", "ada",
                            stdin=lines(ADMINISTRATOR))
        self.assertFalse(self.data.exists())


class NobodyYet(RecordedTest):
    def test_the_password_of_as_is_never_taken_for_that_of_the_first_person(self):
        self.expect_refusal(REFUSED, ["ada"], "user", "add", "ben", "--administrator", "--as", "ada",
                            stdin=lines(ADMINISTRATOR, TRAINEE))
        self.assertEqual(self.ask("user", "list"), [])


class RobotsScore(RecordedTest):
    """The robot's attempt is everybody's to see; its score is kept by those whom the policy table lets."""

    def setUp(self):
        super().setUp()
        self.ask("user", "add", "ada", "--administrator", stdin=lines(ADMINISTRATOR))
        self.ask("user", "add", "ben", "--as", "ada", stdin=lines(ADMINISTRATOR, TRAINEE))
        self.alter("DELETE FROM score")

    def kept(self):
        return self.ask("attempts")[0]["score"]

    def test_an_administrator_keeps_it(self):
        answer = self.ask("score", self.attempt, "--as", "ada", stdin=lines(ADMINISTRATOR))
        self.assertIs(answer["stored"], True)
        self.assertEqual(self.kept(), self.recorded.json()["score"])
        [(actor,)] = self.query("SELECT actor_person_id FROM audit WHERE action = 'score_stored' "
                                "ORDER BY audit_id DESC LIMIT 1")
        self.assertEqual(actor, 1, "the first person there was")

    def test_a_trainee_sees_it_only(self):
        answer = self.ask("score", self.attempt, "--as", "ben", stdin=lines(TRAINEE))
        self.assertIs(answer["stored"], False)
        self.assertEqual(answer["score"], self.recorded.json()["score"])
        self.assertIsNone(self.kept())


if __name__ == "__main__":
    unittest.main()
