#!/usr/bin/env python3
"""Operates Akin in the command's window under Xvfb, by keyboard, to its closed hinge: four minutes of sawing.

The way is known beforehand: from where the saw is held at the beginning to the two planned faces, each in two strokes, as
tests/ui/screens/operating/akin_by_mouse_test.cpp finds it by looking. Seen from medial: to the right is proximal, up is
dorsal, deeper is lateral.

usage: operate_akin_check.py HALLUX [PICTURE_FOLDER]
"""

import json
import sys

from operate_check import PATIENCE_S, recorded_ticks, run_check
from window_check import rows_of, wait_until

# Millimetres: before the bone, through it to the line at which to stop, and what a push needs beyond to come that far.
HOVER, TO_THE_LINE, PUSH, HARD_PUSH = 10.0, 15.0, 2.0, 5.0
HARD_PUSH_TICKS, PUSH_TICKS = 20000, 25000
KEY_MM, FINE_SHARE, KEY_DEGREE = 1.0, 0.2, 1.0027


def steps(person, amount, of_key, key, opposite, modifiers=""):
    """Whole key presses, and finer ones with Shift for the rest."""
    name = key if amount >= 0.0 else opposite
    coarse = int(abs(amount) / of_key)
    fine = round((abs(amount) - coarse * of_key) / (FINE_SHARE * of_key))
    presses = [modifiers + name] * coarse + [modifiers + "shift+" + name] * fine
    if presses:
        person.press_slowly(*presses)


def move(person, proximal=0.0, dorsal=0.0, lateral=0.0):
    steps(person, proximal, KEY_MM, "Right", "Left")
    steps(person, dorsal, KEY_MM, "Up", "Down")
    steps(person, lateral, KEY_MM, "Prior", "Next")


def wait_ticks(person, place, ticks):
    so_far = recorded_ticks(place)
    wait_until(f"{ticks} ticks of sawing", lambda: recorded_ticks(place) >= so_far + ticks, ticks / 1000.0 + PATIENCE_S)


def feed(person, way, across):
    """Along the blade; `across` is what a millimetre deeper goes proximal: never far from the plane."""
    presses, proximal = [], 0.0
    for _ in range(round(abs(way) / KEY_MM)):
        presses.append("Prior" if way > 0.0 else "Next")
        proximal += across * KEY_MM
        while proximal >= FINE_SHARE * KEY_MM:
            presses.append("shift+Right" if way > 0.0 else "shift+Left")
            proximal -= FINE_SHARE * KEY_MM
    person.press_slowly(*presses)


def stroke(person, place, across):
    """First with a push, then until it stops by itself."""
    feed(person, HOVER + TO_THE_LINE + HARD_PUSH, across)
    wait_ticks(person, place, HARD_PUSH_TICKS)
    feed(person, PUSH - HARD_PUSH, across)
    wait_ticks(person, place, PUSH_TICKS)
    feed(person, -(HOVER + TO_THE_LINE + PUSH), across)
    wait_ticks(person, place, 3000)


def cut(person, place, across, between_strokes):
    person.press_slowly("space")
    stroke(person, place, across)
    move(person, **between_strokes)
    stroke(person, place, across)
    person.press_slowly("space")


def step_says(person, words):
    step = person.widgets().get("operate.step", {})
    return step.get("label") == words and step.get("enabled")


def saw(person, place, take_picture):
    person.press_slowly("Return", "3")
    move(person, proximal=-0.8, dorsal=3.6, lateral=20.0)
    cut(person, place, 0.0, {"proximal": 1.0, "dorsal": -6.6})
    take_picture("first-cut")
    person.press_slowly("Return")
    steps(person, -10.1, KEY_DEGREE, "ctrl+Right", "ctrl+Left")
    steps(person, -1.6, KEY_DEGREE, "ctrl+Up", "ctrl+Down")
    move(person, proximal=-4.8, dorsal=6.0, lateral=0.8)
    cut(person, place, 0.179, {"proximal": 1.0, "dorsal": -6.4})
    take_picture("second-cut")
    person.press_slowly("Return")
    wait_until("a wedge that is free", lambda: step_says(person, "Take it out"), PATIENCE_S)
    person.press_slowly("Return")
    wait_until("the wedge taken out", lambda: step_says(person, "Close the wedge"), PATIENCE_S)
    person.press_slowly("Return")
    wait_until("the closed hinge", lambda: step_says(person, "Finish"), PATIENCE_S)


def check_record(place):
    rows = rows_of(place, "SELECT state, duration_ticks, quality_json, score_milli, card_json FROM attempt JOIN score USING (attempt_id)")
    if len(rows) != 1 or rows[0][0] != "closed":
        sys.exit(f"the attempt is kept as {rows}")
    _, ticks, quality, score, card = rows[0]
    unmeasured = [line["text"] for line in json.loads(card)["ledger"] if not line["is_measured"]]
    print(f"operate check: Akin, {ticks} ticks, score {score}, {quality}")
    for line in json.loads(card)["ledger"]:
        print("  " + line["text"])
    if unmeasured or score < 60000:
        sys.exit(f"not measured: {unmeasured}; score {score}")


if __name__ == "__main__":
    run_check("akin", saw, check_record)
