#!/usr/bin/env python3
"""What happens to the window while somebody saws: it loses the keyboard, it is asked to close, its display goes away,
the session ends.

usage: operate_hard_times_check.py HALLUX [PICTURE_FOLDER]
"""

import ctypes
import pathlib
import signal
import subprocess
import sys
import time

from hard_times_check import lose_display, window_of
from operate_check import PASSWORD, PATIENCE_S, begin, come_in, recorded_ticks
from window_check import end_by_the_system, opened_course, rows_of, wait_until


def is_shown(person, name):
    return lambda: person.widgets().get(name, {}).get("enabled")


def start_the_saw(person, place):
    person.press_slowly("space", *["Prior"] * 3)
    so_far = recorded_ticks(place)
    wait_until("a second with the saw on", lambda: recorded_ticks(place) >= so_far + 1000, PATIENCE_S)


def lose_the_keyboard(person, number, take_picture):
    """Where no desktop runs, a window that is taken off the display loses the keyboard."""
    person.xdotool("windowunmap", "--sync", number)
    time.sleep(0.5)
    person.xdotool("windowmap", "--sync", number)
    person.xdotool("windowfocus", "--sync", number)
    wait_until("the pause", is_shown(person, "operate.go_on"), PATIENCE_S)
    take_picture("keyboard-lost")
    person.click("operate.go_on")
    wait_until("the end of the pause", lambda: "operate.go_on" not in person.widgets(), PATIENCE_S)


class ClientMessage(ctypes.Structure):
    """XClientMessageEvent of Xlib, filled up to the size of XEvent."""
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int), ("display", ctypes.c_void_p),
                ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong), ("format", ctypes.c_int),
                ("data", ctypes.c_long * 5), ("pad", ctypes.c_long * 24)]


def send_close(display_name, number):
    """What a window manager sends when somebody presses the cross: WM_DELETE_WINDOW."""
    client_message = 33
    xlib = ctypes.CDLL("libX11.so.6")
    xlib.XOpenDisplay.restype = ctypes.c_void_p
    xlib.XInternAtom.restype = ctypes.c_ulong
    xlib.XInternAtom.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int]
    xlib.XSendEvent.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_long, ctypes.c_void_p]
    xlib.XCloseDisplay.argtypes = [ctypes.c_void_p]
    display = xlib.XOpenDisplay(display_name.encode())
    message = ClientMessage(type=client_message, window=number, format=32)
    message.message_type = xlib.XInternAtom(display, b"WM_PROTOCOLS", 0)
    message.data[0] = xlib.XInternAtom(display, b"WM_DELETE_WINDOW", 0)
    xlib.XSendEvent(display, number, 0, 0, ctypes.byref(message))
    xlib.XCloseDisplay(display)


def ask_to_close(person, window, number, take_picture):
    """As the desktop does for its cross: the window stays, and asks."""
    send_close(person.environment["DISPLAY"], int(number))
    wait_until("the question", is_shown(person, "operate.ask_leave.keep"), PATIENCE_S)
    take_picture("close-asked")
    if window.poll() is not None:
        sys.exit(f"the window ended with {window.returncode} while an attempt was recorded")


def check_kept(program, place, ticks_before):
    """Whoever opens the course next marks the attempt as interrupted; not more than 0.6 s of it are lost."""
    subprocess.run([program, "--as", "admin-1", "--data", str(place / "course"), "attempts"], check=True, text=True,
                   input=PASSWORD + "\n", stdout=subprocess.DEVNULL)
    states = rows_of(place, "SELECT state FROM attempt")
    if states != [("interrupted",)] or recorded_ticks(place) < ticks_before:
        sys.exit(f"kept: {states}, {recorded_ticks(place)} ticks after {ticks_before}")
    print(f"operating in hard times: {recorded_ticks(place)} ticks kept of an attempt that was cut off")


def operate(course):
    person, place, take_picture = course.person, course.place, course.take_picture
    come_in(person)
    begin(person, take_picture)
    number = window_of(person)
    start_the_saw(person, place)
    lose_the_keyboard(person, number, take_picture)
    start_the_saw(person, place)
    ask_to_close(person, course.window, number, take_picture)
    ticks = recorded_ticks(place)
    lose_display(course.server, course.window)
    return ticks


def operate_until_the_session_ends(course):
    """SIGTERM in mid-attempt: nobody is asked, the tool is safe, what was recorded is kept."""
    person, place = course.person, course.place
    come_in(person)
    begin(person, course.take_picture)
    start_the_saw(person, place)
    ticks = recorded_ticks(place)
    end_by_the_system(course.window, signal.SIGTERM)
    return ticks


def main():
    program = sys.argv[1]
    pictures = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    with opened_course(program, pictures=pictures) as course:
        check_kept(program, course.place, operate(course))
    with opened_course(program) as course:
        check_kept(program, course.place, operate_until_the_session_ends(course))
    print("operating in hard times: passed")


if __name__ == "__main__":
    main()
