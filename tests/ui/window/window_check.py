#!/usr/bin/env python3
"""Uses a real window under Xvfb as a person does, with xdotool, finding controls by the map of the window.

usage: window_check.py GALLERY_WINDOW [PICTURE]
"""

import argparse
import contextlib
import json
import os
import pathlib
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import types

IDLE_S = 10.0
MAX_IDLE_CPU_SHARE = 0.01
AT_REST_WITHIN_S = 90.0


def start_display(size):
    """(Xvfb process, display name); Xvfb itself finds a free number."""
    reader, writer = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", size, "-nolisten", "tcp"],
                              pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(writer)
    with os.fdopen(reader) as stream:
        number = stream.readline().strip()
    if not number:
        raise SystemExit("Xvfb did not start")
    return server, ":" + number


def wait_until(what, condition, timeout_s=30.0):
    end = time.monotonic() + timeout_s
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.05)
    raise SystemExit(f"not within {timeout_s:.0f} s: {what}")


def cpu_s(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Person:
    """Finds controls in the map of the window and uses mouse and keyboard through the X server."""

    def __init__(self, map_file, environment):
        self.map_file = map_file
        self.environment = environment

    def map(self):
        return json.loads(self.map_file.read_text()) if self.map_file.exists() else {"focus": "", "widgets": []}

    def widgets(self):
        return {each["id"]: each for each in self.map()["widgets"]}

    def focus(self):
        """The control that keys go to; "" for none."""
        return self.map()["focus"]

    def xdotool(self, *words):
        subprocess.run(["xdotool", *words], check=True, env=self.environment)

    def click(self, name):
        place = wait_until(f"control {name}", lambda: self.widgets().get(name))
        x, y = place["x"] + place["w"] // 2, place["y"] + place["h"] // 2
        self.xdotool("mousemove", str(x), str(y), "click", "1")

    def press(self, *keys):
        self.xdotool("key", "--delay", "0", *keys)

    def press_slowly(self, *keys):
        """As fast as fingers are: of two presses of a key in one millisecond GLFW hears the first."""
        self.xdotool("key", "--delay", "25", *keys)

    def type(self, letters, between_ms=2):
        self.xdotool("type", "--delay", str(between_ms), letters)


def rows_of(place, words):
    """What the course of an opened window answers to a query."""
    with sqlite3.connect(f"file:{place / 'course' / 'hallux.db'}?mode=ro", uri=True, timeout=10.0) as database:
        return database.execute(words).fetchall()


@contextlib.contextmanager
def opened_course(program, size="1440x900x24", pictures=None, prepare=None, within=None):
    """The command's window on an empty course, or on what prepare(folder) makes, with all that belongs to it: person, place, window and server (processes; what
    the window says on stderr is kept for who reads it), take_picture(name), and open_again() for another window where this one
    has ended. within(place) says the words of a command that runs it. All processes are gone afterwards."""
    server, display = start_display(size)
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        if prepare:
            prepare(place / "course")
        environment = dict(os.environ, DISPLAY=display)
        windows = []

        def open_window():
            before = within(place) if within else []
            windows.append(subprocess.Popen([*before, program, "--data", str(place / "course"), "--ui-map", str(place / "map.json")],
                                            env=environment, stderr=subprocess.PIPE, text=True))
            return windows[-1]

        def take_picture(name):
            if pictures:
                time.sleep(1.0)
                subprocess.run(["import", "-window", "root", str(pictures / f"{name}.png")], env=environment, check=True)

        try:
            yield types.SimpleNamespace(person=Person(place / "map.json", environment), place=place,
                                        window=open_window(), server=server, take_picture=take_picture,
                                        open_again=open_window)
        finally:
            for process in (*windows, server):
                if process.poll() is None:
                    process.kill()
                process.wait()


def use_course_window(program, pictures, use, prepare=None):
    """Opens the command's window on such a course: use(person, place, take_picture), which must leave it open."""
    with opened_course(program, pictures=pictures, prepare=prepare) as course:
        use(course.person, course.place, course.take_picture)
        if course.window.poll() is not None:
            sys.exit(f"the window ended with {course.window.returncode} and said: {course.window.stderr.read()}")


def end_by_the_system(window, number):
    """As a session manager ends a program, which waits for no answer: the exit code says so, and a sentence. Two seconds are
    the goal; a machine that does much else is given more."""
    window.send_signal(number)
    begun = time.monotonic()
    try:
        code = window.wait(timeout=30.0)
    except subprocess.TimeoutExpired:
        sys.exit(f"the window does not end on {number.name}")
    print(f"{number.name}: ended after {time.monotonic() - begun:.1f} s")
    said = window.stderr.read()
    if code != 5 or "closed by the system" not in said:
        sys.exit(f"after {number.name} the window ended with {code} and said: {said}")


@contextlib.contextmanager
def held_up(process):
    """The process makes no step meanwhile; what is done at its window waits for it."""
    process.send_signal(signal.SIGSTOP)
    try:
        yield
    finally:
        process.send_signal(signal.SIGCONT)


def use_window(person, window):
    """Presses, types as fast as the X server takes it, answers a question by keyboard. Each press meets what it was
    aimed at, also where the pointer has gone on before the window hears of it."""
    with held_up(window):
        person.click("gallery.search")
        person.type("Chevron 12.3, 0 ms between keys", between_ms=0)
        person.click("gallery.segment.2")
    person.click("gallery.failed.action")  # asks
    wait_until("the question", lambda: "gallery.question.keep" in person.widgets())
    if "gallery.search" in person.widgets():
        raise SystemExit("what lies below a question is in the map")
    person.press("Tab", "Return")          # the dangerous answer, by keyboard alone
    wait_until("the end of the question", lambda: "gallery.question.keep" not in person.widgets())
    before = person.widgets()["gallery.search"]["w"]
    person.press("ctrl+plus")
    wait_until("a larger scale", lambda: person.widgets()["gallery.search"]["w"] > before)


def idle_share(window):
    before = cpu_s(window.pid)
    time.sleep(IDLE_S)
    return (cpu_s(window.pid) - before) / IDLE_S


def check_idle(window):
    """However long a busy machine takes for what is still to be drawn: the window comes to rest."""
    time.sleep(1.0)
    end = time.monotonic() + AT_REST_WITHIN_S
    share = idle_share(window)
    while share > MAX_IDLE_CPU_SHARE and time.monotonic() < end:
        share = idle_share(window)
    print(f"idle: {share * 100.0:.2f} % of one processor over {IDLE_S:.0f} s")
    if share > MAX_IDLE_CPU_SHARE:
        raise SystemExit("an idle window takes too much of the processor")


def run(program, folder, display, picture):
    environment = dict(os.environ, DISPLAY=display)
    map_file, report = folder / "map.json", folder / "report.txt"
    command = [program, "--ui-map", str(map_file), "--report", str(report), "--picture", str(picture)]
    window = subprocess.Popen(command, env=environment)
    try:
        person = Person(map_file, environment)
        wait_until("the window", lambda: "gallery.search" in person.widgets())
        check_idle(window)
        use_window(person, window)
        person.press("F11")
        time.sleep(0.5)
        person.press("F11")
        time.sleep(0.5)
        person.press("F10")
        if window.wait(timeout=20) != 0:
            raise SystemExit(f"the window ended with {window.returncode}")
    finally:
        if window.poll() is None:
            window.kill()
    return dict(line.split("=", 1) for line in report.read_text().splitlines())


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("picture", nargs="?", type=pathlib.Path)
    arguments = parser.parse_args()
    server, display = start_display("1600x1000x24")
    try:
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            found = run(arguments.program, place, display, arguments.picture or place / "picture.png")
    finally:
        server.terminate()
        server.wait()
    wanted = {"search": "Chevron 12.3, 0 ms between keys", "segment": "2", "presses": "1", "scale": "1.1"}
    wrong = {key: found.get(key) for key, value in wanted.items() if found.get(key) != value}
    if wrong:
        sys.exit(f"wanted {wanted}, found {wrong}")
    print(f"window check: passed, {found['frames']} frames")


if __name__ == "__main__":
    main()
