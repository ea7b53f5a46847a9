#!/usr/bin/env python3
"""What happens to the mouse that leads a saw: another program holds the pointer, the mouse is unplugged, a second one is used.

usage: operate_pointer_check.py HALLUX [PICTURE_FOLDER]
"""

import contextlib
import ctypes
import pathlib
import sys
import time

from hard_times_check import window_of
from operate_check import PATIENCE_S, begin, come_in
from window_check import opened_course, wait_until

NOT_CAUGHT = "The mouse is not caught"
RIGHT_BUTTON = "3"
STAYS_S = 3.0


@contextlib.contextmanager
def another_program(display_name):
    """(Xlib, its connection) of a second client of the display."""
    xlib = ctypes.CDLL("libX11.so.6")
    xlib.XOpenDisplay.restype = ctypes.c_void_p
    xlib.XDefaultRootWindow.restype = ctypes.c_ulong
    for function in (xlib.XDefaultRootWindow, xlib.XCloseDisplay):
        function.argtypes = [ctypes.c_void_p]
    xlib.XSync.argtypes = [ctypes.c_void_p, ctypes.c_int]
    display = xlib.XOpenDisplay(display_name.encode())
    try:
        yield xlib, display
    finally:
        xlib.XCloseDisplay(display)


@contextlib.contextmanager
def pointer_held(display_name):
    """Another program has the pointer, as an open menu or a magnifier does."""
    grab_mode_async, grab_success = 1, 0
    with another_program(display_name) as (xlib, display):
        number = ctypes.c_ulong
        xlib.XGrabPointer.argtypes = [ctypes.c_void_p, number, ctypes.c_int, ctypes.c_uint, ctypes.c_int, ctypes.c_int, number,
                                      number, number]
        answer = xlib.XGrabPointer(display, xlib.XDefaultRootWindow(display), 0, 0, grab_mode_async, grab_mode_async, 0, 0, 0)
        if answer != grab_success:
            sys.exit(f"the other program did not get the pointer either: {answer}")
        yield


class DeviceInfo(ctypes.Structure):
    """XIDeviceInfo of Xlib's input extension."""
    _fields_ = [("number", ctypes.c_int), ("name", ctypes.c_char_p), ("use", ctypes.c_int), ("attachment", ctypes.c_int),
                ("enabled", ctypes.c_int), ("num_classes", ctypes.c_int), ("classes", ctypes.c_void_p)]


def plug_mouse(display_name, is_plugged):
    """Takes the display's own mouse away, as a cable that is drawn, or brings it back. xdotool moves another, which stays."""
    all_devices, slave_pointer, integer, replace = 0, 3, 19, 0
    with another_program(display_name) as (xlib, display):
        extension = ctypes.CDLL("libXi.so.6")
        extension.XIQueryDevice.restype = ctypes.POINTER(DeviceInfo)
        extension.XIQueryDevice.argtypes = [ctypes.c_void_p, ctypes.c_int, ctypes.POINTER(ctypes.c_int)]
        xlib.XInternAtom.restype = ctypes.c_ulong
        xlib.XInternAtom.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int]
        extension.XIChangeProperty.argtypes = [ctypes.c_void_p, ctypes.c_int, ctypes.c_ulong, ctypes.c_ulong, ctypes.c_int,
                                               ctypes.c_int, ctypes.c_char_p, ctypes.c_int]
        count = ctypes.c_int()
        devices = extension.XIQueryDevice(display, all_devices, ctypes.byref(count))
        mice = [devices[i].number for i in range(count.value)
                if b"XTEST" not in devices[i].name and (devices[i].use == slave_pointer or b"mouse" in devices[i].name)]
        if len(mice) != 1:
            sys.exit(f"not one mouse: {[(devices[i].name, devices[i].use) for i in range(count.value)]}")
        enabled = xlib.XInternAtom(display, b"Device Enabled", 0)
        extension.XIChangeProperty(display, mice[0], enabled, integer, 8, replace, bytes([is_plugged]), 1)
        xlib.XSync(display, 0)
        now = extension.XIQueryDevice(display, all_devices, ctypes.byref(count))
        if bool(next(now[i].enabled for i in range(count.value) if now[i].number == mice[0])) != is_plugged:
            sys.exit("the mouse cannot be unplugged")


def foot_and_captured(person):
    """What the foot says, and what has the pointer, of one frame."""
    shown = person.map()
    return next((each["text"] for each in shown["read_outs"] if each["id"] == "operate.foot"), ""), shown["captured"]


def is_caught(person):
    foot, captured = foot_and_captured(person)
    return foot and NOT_CAUGHT not in foot and captured == "operate.view"


def is_not_caught(person):
    foot, captured = foot_and_captured(person)
    return NOT_CAUGHT in foot and not captured


def wait_caught(person):
    wait_until("the pointer is caught", lambda: is_caught(person), PATIENCE_S)


def wait_not_caught(person):
    """It stays so while the window asks again now and then."""
    wait_until("the foot says that it is not caught", lambda: is_not_caught(person), PATIENCE_S)
    end = time.monotonic() + STAYS_S
    while time.monotonic() < end:
        if not is_not_caught(person):
            sys.exit(f"the window claims a pointer that another program holds: {foot_and_captured(person)}")
        time.sleep(0.05)


def wait_free(person):
    wait_until("the pointer is free", lambda: not person.map()["captured"], PATIENCE_S)


def pause_by_escape(person):
    person.press("Escape")
    wait_until("the pause", lambda: "operate.go_on" in person.widgets(), PATIENCE_S)
    wait_free(person)


def go_on(person):
    person.click("operate.go_on")
    wait_until("the end of the pause", lambda: "operate.go_on" not in person.widgets(), PATIENCE_S)


def begin_while_held(course, display):
    """The window says that it has no mouse, works as before, and has it once the other lets go."""
    person = course.person
    held = contextlib.ExitStack()
    with held:
        begin(person, course.take_picture, while_ready=lambda: held.enter_context(pointer_held(display)))
        wait_not_caught(person)
        course.take_picture("not-caught")
        pause_by_escape(person)
        person.press("p")
        wait_not_caught(person)
    wait_caught(person)


def unplug(course, display):
    """Keys free it while the mouse is gone, and so does the right button of a second one."""
    person = course.person
    plug_mouse(display, False)
    pause_by_escape(person)
    go_on(person)
    wait_caught(person)
    person.xdotool("mousemove_relative", "5", "0", "click", RIGHT_BUTTON)
    wait_free(person)
    person.xdotool("click", RIGHT_BUTTON)
    wait_caught(person)
    plug_mouse(display, True)
    pause_by_escape(person)


def main():
    pictures = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    with opened_course(sys.argv[1], pictures=pictures) as course:
        display = course.person.environment["DISPLAY"]
        come_in(course.person)
        begin_while_held(course, display)
        unplug(course, display)
        if course.window.poll() is not None or not window_of(course.person):
            sys.exit(f"the window ended: {course.window.stderr.read()}")
    print("the pointer of an operation: passed")


if __name__ == "__main__":
    main()
