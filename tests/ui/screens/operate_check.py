#!/usr/bin/env python3
"""Operates Silver in the command's window under Xvfb, by keyboard, and looks into the database for what was kept.

usage: operate_check.py HALLUX [PICTURE_FOLDER]
"""

import json
import pathlib
import subprocess
import sys
import time

from novice import KeyboardHand, Novice
from window_check import check_idle, opened_course, rows_of, wait_until
from window_memory import WINDOW_KIB_AT_MOST, peak_kib

LOGIN, PASSWORD = "admin-1", "a long enough phrase"
PATIENCE_S = 150.0
# An event of simulator/record/record.h: a kerf has its plane.
PLANE_FROZEN = 4


def is_enabled_soon(person, name):
    end = time.monotonic() + 10.0
    while time.monotonic() < end and not person.widgets().get(name, {}).get("enabled"):
        time.sleep(0.1)
    return person.widgets().get(name, {}).get("enabled")


def come_in(person):
    wait_until("the first screen", lambda: "entry.begin" in person.widgets(), PATIENCE_S)
    # A window that has just come may not have the keyboard yet: what was typed is looked after, and typed again.
    for _ in range(5):
        for field, words in (("entry.login", LOGIN), ("entry.password", PASSWORD), ("entry.password_again", PASSWORD)):
            person.click(field)
            person.press("ctrl+a")
            person.type(words)
        if is_enabled_soon(person, "entry.begin"):
            break
    person.click("entry.begin")


def begin(person, take_picture, scenario="silver", while_ready=None):
    """From the list of operations through the briefing into the operation, as practice; while_ready() before it runs."""
    for name in ("nav.operations", f"operations.card.{scenario}", "brief.begin"):
        wait_until(name, lambda name=name: person.widgets().get(name, {}).get("enabled"), PATIENCE_S)
        person.click(name)
    wait_until("the operation", lambda: "operate.begin" in person.widgets(), PATIENCE_S)
    take_picture("ready")
    if while_ready:
        while_ready()
    view = person.widgets()["operate.view"]
    person.xdotool("mousemove", str(view["x"] + view["w"] // 2), str(view["y"] + view["h"] // 2))
    person.press("Return")
    wait_until("the running operation", lambda: "operate.pause" in person.widgets(), PATIENCE_S)


def recorded_ticks(place):
    """How far the samples in the database reach."""
    rows = rows_of(place, "SELECT max(first_tick + row_count) FROM chunk WHERE stream = 1")
    return rows[0][0] or 0


def kerfs(program, place):
    """How many kerfs are on the record so far."""
    words = f"SELECT count(*) FROM attempt, cut_events(attempt.uuid) WHERE cut_events.kind = {PLANE_FROZEN}"
    asked = subprocess.run([program, "--json", "--data", place / "course", "--as", LOGIN, "sql", words], input=PASSWORD + "\n",
                           capture_output=True, text=True, check=False, timeout=PATIENCE_S)
    if asked.returncode != 0:
        sys.exit(f"the record cannot be asked: {asked.stdout}{asked.stderr}")
    return json.loads(asked.stdout)["rows"][0][0]


def has_cut(program, place):
    """The start and an ended step are events, so is a gap of the loop: only where there are more is it worth to ask for kerfs."""
    return rows_of(place, "SELECT total(row_count) FROM chunk WHERE stream = 2")[0][0] >= 4 and kerfs(program, place) > 0


def saw(program, person, place):
    """As the hints say, until teeth are in bone for a second."""
    novice = Novice(person, KeyboardHand(person))
    if not novice.operate(lambda _screen: has_cut(program, place), PATIENCE_S, PATIENCE_S):
        sys.exit("the hints led to no kerf")
    so_far = recorded_ticks(place)
    wait_until("another second on the record", lambda: recorded_ticks(place) >= so_far + 1000, PATIENCE_S)


def answer(person, name):
    """The display may still put the pointer back that had led the saw: whoever sees the question stay presses again."""
    end = time.monotonic() + PATIENCE_S
    while name in person.widgets() and time.monotonic() < end:
        person.click(name)
        soon = time.monotonic() + 3.0
        while name in person.widgets() and time.monotonic() < soon:
            time.sleep(0.1)


def finish(person, place, take_picture):
    take_picture("operating")
    person.press("End")
    wait_until("the question", lambda: "operate.ask_finish.act" in person.widgets(), PATIENCE_S)
    take_picture("question")
    answer(person, "operate.ask_finish.act")
    wait_until("a score", lambda: rows_of(place, "SELECT score_id FROM score"), PATIENCE_S)


def check_record(place):
    attempts = rows_of(place, "SELECT attempt_id, state, person_id IS NOT NULL, hand, device_class, pacing, duration_ticks,"
                              " kind, quality_json FROM attempt")
    if len(attempts) != 1:
        sys.exit(f"{len(attempts)} attempts are stored")
    number, state, is_persons, hand, device, pacing, ticks, kind, quality = attempts[0]
    if (state, is_persons, hand, device, pacing, kind) != ("closed", 1, "", "mouse", "real_time", "practice"):
        sys.exit(f"the attempt is kept as {attempts[0]}")
    if ticks < 2000 or not json.loads(quality)["complete"]:
        sys.exit(f"{ticks} ticks, {quality}")
    scores = rows_of(place, f"SELECT score_milli, measured_weight_milli, card_json FROM score WHERE attempt_id = {number}")
    if len(scores) != 1:
        sys.exit(f"{len(scores)} scores are stored")
    print(f"operate check: {ticks} ticks, score {scores[0][0]} of {scores[0][1]} measured, {quality}")


def rest(window):
    """A picture at rest is refined; then it takes no processor."""
    check_idle(window)


def operate(program, course):
    person, place, take_picture = course.person, course.place, course.take_picture
    come_in(person)
    begin(person, take_picture, while_ready=lambda: rest(course.window))
    saw(program, person, place)
    finish(person, place, take_picture)
    check_record(place)
    take_picture("after")


def check_memory(window):
    """Of all it did since it was opened."""
    taken_kib = peak_kib(window.pid)
    print(f"operate check: {taken_kib} KiB at most")
    if taken_kib > WINDOW_KIB_AT_MOST:
        sys.exit(f"the window takes {taken_kib} KiB, where {WINDOW_KIB_AT_MOST} are what it may take")


def main():
    """From the first administrator to a scored attempt, in the memory that is left to it."""
    pictures = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    with opened_course(sys.argv[1], pictures=pictures) as course:
        operate(sys.argv[1], course)
        if course.window.poll() is not None:
            sys.exit(f"the window ended with {course.window.returncode} and said: {course.window.stderr.read()}")
        check_memory(course.window)
    print("operate check: passed")


if __name__ == "__main__":
    main()
