#!/usr/bin/env python3
"""A device at a real window under Xvfb, by keyboard or mouse: found, tried in the hand, chosen, operated with; pulled out it is
waited for, and a practice goes on with the mouse. The window runs on a bus with modelled devices (tests/support/served_bus).

usage: devices_check.py HALLUX SERVED_BUS mouse|keyboard [PICTURE_FOLDER]
"""

import json
import pathlib
import subprocess
import sys
import time

from journeys_check import HANDS, PATIENCE_S, make_course, sign_in
from window_check import opened_course, rows_of, wait_until

# Between what a person does and the sample that shows it; between a plug and the device that is opened again.
SOON_S = 1.0
OPENED_AGAIN_S = 3.0


class Bus:
    """What happens to the devices once it is asked for, one after the other."""
    events = (("pull", "falcon"), ("plug", "falcon"), ("pull", "falcon"), ("plug", "falcon"))

    def __init__(self, program):
        self.program = program
        self.done = 0

    def words(self, place):
        self.place = place
        later = [word for number, event in enumerate(self.events) for word in ("--once", str(self.mark(number)), *event)]
        return ["umockdev-wrapper", self.program, "falcon:loaded", "space_mouse", *later, "--report",
                str(place / "seen.json"), "--"]

    def mark(self, number):
        return self.place / f"event-{number}"

    def go_on(self):
        self.mark(self.done).touch()
        self.done += 1


def read_outs(person):
    return {each["id"]: each["text"] for each in person.map().get("read_outs", [])}


def try_in_the_hand(hand, person, take_picture):
    """The Falcon needs its firmware named first; loaded already, it is only homed."""
    hand.press("nav.devices")
    hand.press("devices.row.falcon")
    hand.press("devices.feel")
    wait_until("the Falcon, homed and seen", lambda: "devices.felt" in read_outs(person), PATIENCE_S)
    seen = read_outs(person)["devices.felt"]
    wait_until("a grip that moves", lambda: read_outs(person).get("devices.felt", seen) != seen, PATIENCE_S)
    hand.press("devices.wall")
    take_picture("devices")
    hand.press("devices.let_go")
    hand.press("devices.choose")
    wait_until("the choice", lambda: not person.widgets()["devices.choose"]["enabled"])
    hand.press("devices.row.space_mouse")
    hand.press("devices.second")


def begin_practice(hand, take_picture):
    hand.press("nav.operations")
    hand.press("operations.card.silver")
    hand.wait_for("brief.law")
    take_picture("briefing_with_arm")
    hand.press("brief.begin")
    hand.press("operate.begin")
    hand.wait_for("operate.panel.tool")


def is_running(person):
    return "operate.go_on" not in person.widgets() and "operate.lost.mouse" not in person.widgets()


def operate(hand, person, bus, place, take_picture):
    begin_practice(hand, take_picture)
    time.sleep(SOON_S)
    person.press("space")
    time.sleep(SOON_S)
    take_picture("operating_with_device")
    angle = read_outs(person)["operate.plan.angle"]
    wait_until("the other hand turns the saw", lambda: read_outs(person).get("operate.plan.angle", angle) != angle)
    bus.go_on()
    wait_until("the device is away", lambda: "operate.lost.mouse" in person.widgets(), PATIENCE_S)
    take_picture("device_away")
    bus.go_on()
    wait_until("it goes on by itself", lambda: is_running(person), PATIENCE_S)
    time.sleep(SOON_S)
    bus.go_on()
    hand.press("operate.lost.mouse")
    wait_until("it goes on with the mouse", lambda: is_running(person), PATIENCE_S)
    # Its motors have what they were told last: whoever plugs it in again must not be pushed.
    bus.go_on()
    time.sleep(OPENED_AGAIN_S)
    person.press("End")
    hand.press("operate.ask_finish.act")
    hand.wait_for("result.replay")
    wait_until("the score", lambda: rows_of(place, "SELECT count(*) FROM score")[0][0] >= 1, PATIENCE_S)


def check_record(place):
    (device_class, quality, is_valid), = rows_of(
        place, "SELECT device_class, quality_json, is_valid FROM attempt WHERE device_class <> 'scripted' AND hand = ''"
               " ORDER BY attempt_id DESC LIMIT 1")
    quality = json.loads(quality)
    found = (device_class, quality["device"]["kind"], quality["second_device"], quality["device_changed"], is_valid)
    wanted = ("arm3", "falcon", "space_mouse", True, 0)
    if found != wanted or "device_changed" not in quality["not_valid_because"]:
        sys.exit(f"wanted {wanted}, found {found} in {quality}")
    if quality["pauses"] < 2 or quality["device"]["packets"] < 500:
        sys.exit(f"two losses are two pauses, and the device spoke between them: {quality}")


def end(bus, place):
    """Of the window, whose bus says what it saw: no motor is driven any more, though it came back while the mouse led."""
    subprocess.run(["pkill", "-TERM", "-P", str(bus.pid)], check=True)
    bus.wait(timeout=60)
    falcon = json.loads((place / "seen.json").read_text())[0]
    if falcon["motors"] != [0, 0, 0]:
        sys.exit(f"a force was left: {falcon}")


def main():
    program, served_bus, by = sys.argv[1:4]
    pictures = pathlib.Path(sys.argv[4]) if len(sys.argv) > 4 else None
    passwords, bus = [], Bus(served_bus)

    def prepare(folder):
        passwords.append(make_course(program, folder))
        firmware = folder / "falcon.bin"
        words = 3900
        firmware.write_bytes(bytes([0xAA, 0x08]) + bytes(20) + words.to_bytes(2, "little") + bytes(4)
                             + bytes(i * 31 % 256 for i in range(2 * words)) + bytes(2))
        (folder / "devices.json").write_text(json.dumps({"devices": {"falcon": {"firmware": str(firmware)}}}))

    with opened_course(program, pictures=pictures, prepare=prepare, within=bus.words) as course:
        hand = HANDS[by](course.person, course.place)
        sign_in(hand, "trainee-1", passwords[0])
        try_in_the_hand(hand, course.person, course.take_picture)
        operate(hand, course.person, bus, course.place, course.take_picture)
        check_record(course.place)
        end(course.window, course.place)
    print(f"devices check: passed by {by}")


if __name__ == "__main__":
    main()
