#!/usr/bin/env python3
"""What the window takes while somebody operates Silver for minutes, after the expert was watched at each operation: as the hints
say until both steps are done, then on with the saw.

usage: operate_memory_check.py HALLUX MINUTES
"""

import sys
import time

from novice import KeyboardHand, Novice
from operate_check import PATIENCE_S, begin, come_in, recorded_ticks
from window_check import opened_course, wait_until
from window_memory import WINDOW_KIB_AT_MOST, forget_peak, peak_kib, resident_kib

WATCHED_S = 600.0
# Pauses and questions take some of them.
TICKS_A_MINUTE_AT_LEAST = 40_000
# Of the last minute over the minute after the second: what is opened by then is opened.
GROWTH_KIB_AT_MOST = 8 * 1024


def is_there(person, name):
    return lambda: person.widgets().get(name, {}).get("enabled")


def watch(person, scenario):
    """The expert at that operation, and back to its briefing."""
    for name in ("nav.operations", f"operations.card.{scenario}", "brief.watch"):
        wait_until(name, is_there(person, name), PATIENCE_S)
        person.click(name)
    wait_until("the expert's replay", is_there(person, "replay.play"), WATCHED_S)
    time.sleep(2.0)
    person.click("replay.back")
    wait_until("the briefing", is_there(person, "brief.watch"), PATIENCE_S)


class Peaks:
    """The most of each minute."""

    def __init__(self, pid):
        self.pid, self.of_minutes, self.begun = pid, [], time.monotonic()
        forget_peak(pid)

    def look(self):
        """Takes a minute that is over."""
        if time.monotonic() < self.begun + 60.0 * (len(self.of_minutes) + 1):
            return
        self.of_minutes.append(peak_kib(self.pid))
        print(f"minute {len(self.of_minutes)}: {resident_kib(self.pid)} KiB, {self.of_minutes[-1]} at most", flush=True)
        forget_peak(self.pid)

    def minutes(self):
        return (time.monotonic() - self.begun) / 60.0


def push_and_draw_back(person):
    """Whatever is asked is answered by its safe side."""
    if any(name.endswith(".keep") for name in person.widgets()):
        person.press("Escape")
        time.sleep(0.5)
    elif "operate.pause" not in person.widgets():
        sys.exit("the operation does not go on")
    else:
        person.press_slowly(*["Prior"] * 6, *["Next"] * 6)


def operate(person, minutes, peaks):
    """The first minutes of it lead to the question at the end, the others to and from the bone."""
    def is_over(screen):
        peaks.look()
        return "operate.ask_finish.act" in screen.widgets or peaks.minutes() >= minutes

    Novice(person, KeyboardHand(person), say=lambda _words: None).operate(is_over, 60.0 * minutes, 60.0 * minutes)
    while peaks.minutes() < minutes:
        push_and_draw_back(person)
        peaks.look()


def main():
    program, minutes = sys.argv[1], float(sys.argv[2])
    with opened_course(program) as course:
        come_in(course.person)
        for scenario in ("silver", "akin"):
            watch(course.person, scenario)
        begin(course.person, lambda _name: None)
        peaks = Peaks(course.window.pid)
        operate(course.person, minutes, peaks)
        ticks = recorded_ticks(course.place)
        if ticks < TICKS_A_MINUTE_AT_LEAST * minutes:
            sys.exit(f"{ticks} ticks in {minutes} minutes: it was not operated all the time")
        if course.window.poll() is not None:
            sys.exit(f"the window ended with {course.window.returncode}")
    if len(peaks.of_minutes) < int(minutes) - 1 or max(peaks.of_minutes) > WINDOW_KIB_AT_MOST:
        sys.exit(f"the window takes {peaks.of_minutes} KiB, minute by minute; {WINDOW_KIB_AT_MOST} are what it may take")
    if len(peaks.of_minutes) > 3 and peaks.of_minutes[-1] > peaks.of_minutes[2] + GROWTH_KIB_AT_MOST:
        sys.exit(f"the window grows: {peaks.of_minutes} KiB, minute by minute")
    print(f"operate memory check: {max(peaks.of_minutes)} KiB at most")


if __name__ == "__main__":
    main()
