#!/usr/bin/env python3
"""The window is killed (`kill -9`) at random moments while somebody saws, again and again on one course: nothing that was on the
record is lost, each attempt is interrupted, and `verify` finds the course whole.

usage: operate_killed_check.py HALLUX [KILLS]
"""

import json
import random
import subprocess
import sys
import time

from operate_check import PASSWORD, PATIENCE_S, begin, come_in, is_enabled_soon
from window_check import opened_course, rows_of, wait_until

TICKS_OF_EACH = """SELECT a.attempt_id, max(c.first_tick + c.row_count) FROM attempt a JOIN chunk c USING (attempt_id)
                   WHERE c.stream = 1 GROUP BY a.attempt_id ORDER BY a.attempt_id"""


def sign_in(person):
    wait_until("the way in", lambda: "entry.sign_in" in person.widgets(), PATIENCE_S)
    for _ in range(5):
        for field, words in (("entry.login", "admin-1"), ("entry.password", PASSWORD)):
            person.click(field)
            person.press("ctrl+a")
            person.type(words)
        if is_enabled_soon(person, "entry.sign_in"):
            break
    person.click("entry.sign_in")


def check_whole(program, place):
    said = subprocess.run([program, "--json", "--data", str(place / "course"), "verify"], check=True, text=True,
                          stdout=subprocess.PIPE).stdout
    if not json.loads(said)["whole"]:
        sys.exit(f"after a kill verify says: {said}")


def operate_and_kill(course, window, after_s):
    """What of each attempt was on the record before."""
    begin(course.person, course.take_picture)
    number = len(rows_of(course.place, "SELECT attempt_id FROM attempt"))
    wait_until("the beginning of the record", lambda: len(rows_of(course.place, TICKS_OF_EACH)) == number, PATIENCE_S)
    course.person.press_slowly("space", *["Prior"] * 20)
    time.sleep(after_s)
    before = rows_of(course.place, TICKS_OF_EACH)
    window.kill()
    window.wait()
    return before


def check_kept(program, place, before):
    check_whole(program, place)
    kept = dict(rows_of(place, TICKS_OF_EACH))
    lost = [(attempt, ticks, kept.get(attempt)) for attempt, ticks in before if kept.get(attempt, 0) < ticks]
    if lost:
        sys.exit(f"lost of what was on the record (attempt, ticks, kept): {lost}")
    states = rows_of(place, "SELECT state, count(*) FROM attempt GROUP BY state")
    if states != [("interrupted", len(before))]:
        sys.exit(f"the states after {len(before)} kills: {states}")


def main():
    program, kills = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 3
    moments = random.Random(19)
    with opened_course(program) as course:
        window = course.window
        come_in(course.person)
        for number in range(kills):
            before = operate_and_kill(course, window, moments.uniform(0.0, 3.0))
            (course.place / "map.json").unlink()
            window = course.open_again()
            sign_in(course.person)
            check_kept(program, course.place, before)
            print(f"operating, killed {number + 1} times: {before[-1][1]} ticks kept of the last", flush=True)
        window.kill()
    print("operating, killed: passed")


if __name__ == "__main__":
    main()
