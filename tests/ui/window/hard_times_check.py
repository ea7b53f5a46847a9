#!/usr/bin/env python3
"""What happens to windows: a storm of sizes, one pixel, unmapped and mapped again, and the display that goes away.

usage: hard_times_check.py HALLUX
"""

import pathlib
import subprocess
import sys
import time

from window_check import opened_course, wait_until

NO_DISPLAY = 7
STORM = [(1280, 720), (640, 360), (333, 777), (1, 1), (1500, 40), (40, 900), (1599, 999), (2, 2), (900, 600)]


def memory_kib(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1])
    raise SystemExit("the window's memory cannot be read")


def window_of(person):
    words = ["xdotool", "search", "--onlyvisible", "--name", "Hallux"]
    found = subprocess.run(words, env=person.environment, stdout=subprocess.PIPE, text=True, check=False).stdout.split()
    return found[-1] if found else None


def memory_when_steady(person, window, number):
    """At one size, once it stayed for four seconds: pictures have that size then, and the bones are built."""
    person.xdotool("windowsize", "--sync", number, "1280", "720")
    seen, since = memory_kib(window.pid), time.monotonic()
    while time.monotonic() - since < 4.0:
        time.sleep(0.2)
        now = memory_kib(window.pid)
        if abs(now - seen) > 1024:
            seen, since = now, time.monotonic()
    return seen


def storm(person, window, number, rounds):
    for width, height in STORM * rounds:
        person.xdotool("windowsize", number, str(width), str(height))
        if window.poll() is not None:
            raise SystemExit(f"the window ended with {window.returncode} in a storm of sizes")


def resize_often(person, window, number):
    """What a storm takes is given back. Pictures that were lost in each of its ninety steps would be near a gigabyte; what
    the allocators keep for themselves goes up and down by some ten megabytes."""
    memory_when_steady(person, window, number)
    storm(person, window, number, 3)
    before = memory_when_steady(person, window, number)
    storm(person, window, number, 10)
    after = memory_when_steady(person, window, number)
    wait_until("the form again", lambda: person.widgets().get("entry.begin", {}).get("w", 0) > 100)
    print(f"storm: {before} KiB after three rounds, {after} KiB after ten more")
    if after > before + 128 * 1024:
        raise SystemExit("memory grows with every size")


def hide_and_show(person, number):
    person.xdotool("windowunmap", "--sync", number)
    time.sleep(0.5)
    person.xdotool("windowmap", "--sync", number)
    person.click("entry.login")
    person.type("still-here")


def lose_display(server, window):
    server.kill()
    server.wait()
    try:
        code = window.wait(timeout=30)
    except subprocess.TimeoutExpired:
        raise SystemExit("the window does not notice that its display is gone") from None
    said = window.stderr.read()
    if code != NO_DISPLAY or "the display is gone" not in said:
        raise SystemExit(f"after its display was gone the window ended with {code} and said: {said}")


def main():
    with opened_course(sys.argv[1], "1600x1000x24") as course:
        person, window = course.person, course.window
        wait_until("the first screen", lambda: "entry.begin" in person.widgets())
        number = wait_until("the window", lambda: window_of(person))
        resize_often(person, window, number)
        hide_and_show(person, number)
        lose_display(course.server, window)
    print("hard times: passed")


if __name__ == "__main__":
    main()
