#!/usr/bin/env python3
"""What trainees, instructors and administrators do in the command's window under Xvfb, with the mouse or with the keyboard
alone. The course is a simulated one; what was done is looked up in its database.

usage: journeys_check.py HALLUX mouse|keyboard [PICTURE_FOLDER]
"""

import json
import pathlib
import subprocess
import sys
import time

from window_check import rows_of, use_course_window, wait_until

PATIENCE_S = 120.0
FOCUS_S = 2.0
STILL_S = 0.3
STEPS_AT_MOST = 200


def group_of(name):
    return name.rpartition(".")[0]


class Hand:
    """Someone at the window; how a control is reached is left to mouse and keyboard."""

    def __init__(self, person, place):
        self.person, self.place = person, place

    def wait_for(self, name):
        """Until it can be pressed and stays where it is: what is still being read may push it aside."""
        def stands():
            before = self.person.widgets().get(name, {})
            time.sleep(STILL_S)
            return before.get("enabled") and before == self.person.widgets().get(name)
        try:
            wait_until(name, stands, PATIENCE_S)
        except SystemExit as missing:
            sys.exit(f"{missing}; the focus is at '{self.person.focus()}' of {sorted(self.person.widgets())}")

    def wait_for_rows(self, what, words, count):
        wait_until(what, lambda: rows_of(self.place, words)[0][0] >= count, PATIENCE_S)

    def first(self, beginning):
        """The first row of a list that can be seen; its heads sort and are none."""
        def found():
            names = [name for name in self.person.widgets() if name.startswith(beginning) and ".sort." not in name]
            return names[0] if names else None
        return wait_until(beginning, found, PATIENCE_S)

    def write(self, name, words):
        self.reach(name)
        self.person.press("ctrl+a")
        self.person.type(words)


class MouseHand(Hand):
    def reach(self, name):
        self.wait_for(name)
        self.person.click(name)

    press = reach


class KeyboardHand(Hand):
    """Tab from control to control, arrows inside a group, Enter."""

    def step(self, key):
        before = self.person.focus()
        self.person.press(key)
        end = time.monotonic() + FOCUS_S
        while time.monotonic() < end and self.person.focus() == before:
            time.sleep(0.02)
        return self.person.focus() != before

    def reach(self, name):
        self.wait_for(name)
        for _ in range(STEPS_AT_MOST):
            focus = self.person.focus()
            if focus == name:
                return
            is_near = group_of(focus) == group_of(name)
            if not any(self.step(key) for key in (("Down", "Right", "Tab") if is_near else ("Tab",))):
                break
        sys.exit(f"the keyboard does not come to {name}; it is at '{self.person.focus()}'")

    def press(self, name):
        self.reach(name)
        self.person.press("Return")


def count(place, table, where="1"):
    return rows_of(place, f"SELECT count(*) FROM {table} WHERE {where}")[0][0]


def sign_in(hand, login, password):
    hand.write("entry.login", login)
    hand.write("entry.password", password)
    hand.press("entry.sign_in")


def sign_out(hand):
    hand.press("nav.person")
    hand.press("person.3")
    hand.wait_for("entry.login")


def train(hand, words):
    """Operations, briefing, history, a result with a question about it, its replay, one's questions."""
    asked = count(hand.place, "help_request")
    hand.press("nav.operations")
    hand.press("operations.card.silver")
    hand.wait_for("brief.begin")
    hand.press("nav.history")
    hand.press(hand.first("history.list."))
    hand.press("result.ask")
    hand.write("ask.words", words)
    hand.press("ask.act")
    hand.wait_for_rows("the question", "SELECT count(*) FROM help_request", asked + 1)
    hand.press("result.replay")
    hand.press("replay.next")
    hand.press("replay.play")
    hand.press("nav.questions")
    hand.first("questions.row.")


def teach(hand, words):
    """A trainee of the cohort, an attempt: confirmed with a reason, watched, a note pinned; a question answered."""
    decided, noted = count(hand.place, "decision"), count(hand.place, "note")
    answered = count(hand.place, "help_request", "answered_utc IS NOT NULL")
    hand.press("cohort.row.trainee-1")
    hand.press(hand.first("trainee.row."))
    hand.press("result.decide")
    hand.write("decide.reason", words)
    hand.press("decide.act")
    hand.wait_for_rows("the decision", "SELECT count(*) FROM decision", decided + 1)
    hand.press("result.replay")
    hand.press("replay.next")
    hand.press("replay.pin")
    hand.write("pin.words", words)
    hand.press("pin.act")
    hand.wait_for_rows("the note", "SELECT count(*) FROM note", noted + 1)
    hand.press("nav.inbox")
    hand.press(hand.first("inbox.row."))
    hand.write("inbox.answer", words)
    hand.press("inbox.send")
    hand.wait_for_rows("the answer", "SELECT count(*) FROM help_request WHERE answered_utc IS NOT NULL", answered + 1)


def administer(hand, login):
    """Somebody is added, disabled and enabled; a cohort; a version that stays; a backup; the audit; one's own account."""
    cohorts, backups = count(hand.place, "cohort"), hand.place / "course" / "backups"
    kept = set(backups.glob("*.json"))
    hand.press("nav.people")
    hand.press("people.add")
    hand.write("people.add.login", login)
    hand.press("people.add.act")
    hand.press("people.code.done")
    hand.press(f"people.row.{login}")
    hand.press("people.disable")
    hand.press("people.question.act")
    hand.press("people.enable")
    hand.press("nav.cohorts")
    hand.press("cohorts.add")
    hand.write("cohorts.new.name", "Cohort of " + login)
    hand.press("cohorts.new.act")
    hand.wait_for_rows("the cohort", "SELECT count(*) FROM cohort", cohorts + 1)
    hand.press("nav.scenarios")
    hand.press(hand.first("scenarios.row."))
    hand.press("scenarios.retire")
    hand.press("scenarios.question.keep")
    hand.press("nav.records")
    hand.press(hand.first("records.row."))
    hand.press("records.backup")
    # Of a day one is kept, so that there need not be more than before.
    wait_until("a backup", lambda: set(backups.glob("*.json")) - kept, PATIENCE_S)
    hand.press("nav.person")
    hand.press("person.2")
    hand.press("account.change_password")
    hand.press("account.password.keep")
    hand.wait_for("account.change_password")


def make_course(program, folder):
    done = subprocess.run([program, "demo", "--attempts", "1", "--json", "--data", str(folder)], capture_output=True,
                          text=True, check=True)
    return json.loads(done.stdout)["password"]


HANDS = {"mouse": MouseHand, "keyboard": KeyboardHand}


def use_course(person, place, take_picture, by, password):
    hand = HANDS[by](person, place)
    for login, journey, words in (("trainee-1", train, f"Why did I lose points here, by {by}?"),
                                  ("instructor-1", teach, f"Let the teeth do the work, by {by}."),
                                  ("administrator", administer, f"trainee-by-{by}")):
        begin = time.monotonic()
        sign_in(hand, login, password)
        journey(hand, words)
        take_picture(f"{by}-{login}")
        sign_out(hand)
        print(f"journeys check: {login} by {by}, {time.monotonic() - begin:.0f} s", flush=True)


def main():
    program, by = sys.argv[1:3]
    pictures = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
    passwords = []
    use_course_window(program, pictures,
                      lambda person, place, take_picture: use_course(person, place, take_picture, by, passwords[0]),
                      prepare=lambda folder: passwords.append(make_course(program, folder)))
    print("journeys check: passed")


if __name__ == "__main__":
    main()
