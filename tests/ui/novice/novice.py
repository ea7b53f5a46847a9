"""A person who has read no guide and operates by what the screen says. It knows no operation: it looks at the map of the
window, does what the hint says, and looks again."""

import random
import re
import time

from hint import read_hint

LOOK_S = 0.25
# After an input nothing that the hint names came nearer for so long: a wrong turn.
WRONG_TURN_S = 5.0
AT_ONCE = 8
# Until an input is seen, and until it has come to rest.
SEEN_S, REST_S = 1.5, 0.8

KEYS = {"Left": "Left", "Right": "Right", "Up": "Up", "Down": "Down", "Page up": "Prior", "Page down": "Next",
        "Space": "space", "Enter": "Return", "Backspace": "BackSpace", "Ctrl": "ctrl", "Shift": "shift", "Alt": "alt"}


def chord_of(words):
    """"Shift+Ctrl+Page up" as xdotool says it."""
    return "+".join(KEYS[part] for part in words.split("+"))


class Screen:
    """What can be read."""

    def __init__(self, person):
        self.person = person
        self.look()

    def look(self):
        seen = self.person.map()
        self.widgets = {each["id"]: each for each in seen["widgets"]}
        self.read_outs = {each["id"]: each["text"] for each in seen.get("read_outs", [])}
        return self

    def text(self, name):
        return self.read_outs.get(name, "")


class WrongTurns:
    """Counts inputs that led nowhere."""

    def __init__(self):
        self.count, self.kind, self.best, self.since = 0, None, None, None

    def acted(self, now):
        if self.since is None:
            self.since = now

    def seen(self, hint, now):
        distance = hint.distance if hint else None
        if hint is None or hint.kind != self.kind:
            self.kind, self.best, self.since = hint and hint.kind, distance, None
        elif distance is not None and (self.best is None or distance < self.best - 1e-6):
            self.best, self.since = distance, None
        elif self.since is not None and now - self.since > WRONG_TURN_S:
            self.count += 1
            self.best, self.since = distance, None


class KeyboardHand:
    def __init__(self, person):
        self.person = person

    def do(self, hint):
        count = 1 if hint.times == 1 else max(1, min(hint.times, AT_ONCE))
        self.person.press_slowly(*[chord_of(hint.keys)] * count)


class Novice:
    def __init__(self, person, hand, slips=None, say=print):
        self.person, self.hand, self.say = person, hand, say
        self.screen = Screen(person)
        self.slips = slips or (lambda: None)
        self.wrong_turns = WrongTurns()

    def clock_s(self):
        match = re.match(r"(\d+):(\d+)", self.screen.text("operate.time"))
        return 60 * int(match[1]) + int(match[2]) if match else 0

    def answer_question(self):
        """A question that nobody meant to raise is answered by its safe side, which has the focus."""
        if not any(name.endswith(".keep") for name in self.screen.widgets):
            return False
        self.person.press("Escape")
        time.sleep(LOOK_S)
        return True

    def watch(self, text):
        """Until what was done is seen and has come to rest; nobody does the next thing before."""
        end = time.monotonic() + SEEN_S
        while time.monotonic() < end and self.screen.look().text("operate.hint") == text:
            time.sleep(0.05)
        end, still_since = time.monotonic() + REST_S, time.monotonic()
        while time.monotonic() < min(end, still_since + LOOK_S):
            text = self.screen.text("operate.hint")
            time.sleep(0.05)
            if self.screen.look().text("operate.hint") != text:
                still_since = time.monotonic()

    def operate(self, is_over, limit_s):
        """Does what is hinted until is_over(screen)."""
        end = time.monotonic() + limit_s
        last = ""
        while time.monotonic() < end:
            self.screen.look()
            if is_over(self.screen):
                return
            text = self.screen.text("operate.hint")
            hint = read_hint(text)
            if text != last:
                self.say(f"{self.clock_s():4d} s  {text}")
                last = text
            self.wrong_turns.seen(hint, time.monotonic())
            if self.answer_question():
                continue
            if hint and hint.keys:
                self.slips()
                self.hand.do(hint)
                self.wrong_turns.acted(time.monotonic())
                self.watch(text)
            else:
                time.sleep(LOOK_S)
        raise SystemExit(f"not over after {limit_s} s: {self.screen.read_outs}")
