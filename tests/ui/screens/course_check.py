#!/usr/bin/env python3
"""Opens the command's window on an empty folder under Xvfb: the first administrator comes in, signs out, and signs in again.

usage: course_check.py HALLUX [PICTURE_FOLDER]
"""

import pathlib
import signal
import sys

from window_check import end_by_the_system, opened_course, wait_until

PASSWORD = "a long enough phrase"


def add_trainee(person, take_picture):
    """The administrator's first errand, and a look at the other places."""
    person.click("nav.people")
    person.click("people.add")
    wait_until("the sheet", lambda: "people.add.login" in person.widgets())
    person.type("trainee-9")
    person.press("Return")
    wait_until("the code", lambda: "people.code.done" in person.widgets())
    person.click("people.code.done")
    wait_until("the new person", lambda: "people.row.trainee-9" in person.widgets())
    take_picture("people")
    for place, widget in (("nav.cohorts", "cohorts.add"), ("nav.scenarios", "scenarios.retire"),
                          ("nav.records", "records.backup")):
        person.click(place)
        wait_until(place, lambda: widget in person.widgets())
        take_picture(place.removeprefix("nav."))


def use_course(person, take_picture):
    """By mouse, then by keyboard alone."""
    wait_until("the first screen", lambda: "entry.begin" in person.widgets())
    take_picture("first_start")
    for field, words in (("entry.login", "admin-1"), ("entry.name", "Administrator"), ("entry.password", PASSWORD),
                         ("entry.password_again", PASSWORD)):
        person.click(field)
        person.type(words)
    person.click("entry.begin")
    wait_until("the attempts", lambda: "nav.attempts" in person.widgets())
    add_trainee(person, take_picture)
    person.click("nav.attempts")
    take_picture("attempts")
    person.click("nav.person")
    wait_until("the menu", lambda: "person.3" in person.widgets())
    person.click("person.3")
    wait_until("the way in", lambda: "entry.sign_in" in person.widgets())
    take_picture("sign_in")
    person.type("admin-1")
    person.press("Tab")
    person.type(PASSWORD)
    person.press("Return")
    wait_until("the attempts again", lambda: "nav.attempts" in person.widgets())


def use_course_and_read_map(person, place, take_picture):
    use_course(person, take_picture)
    if PASSWORD in (place / "map.json").read_text():
        sys.exit("a password is in the map")


def main():
    pictures = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    with opened_course(sys.argv[1], pictures=pictures) as course:
        use_course_and_read_map(course.person, course.place, course.take_picture)
        end_by_the_system(course.window, signal.SIGINT)
    print("course check: passed")


if __name__ == "__main__":
    main()
