"""A person who has read no guide and operates by what the screen says. It knows no operation: it looks at the map of the
window, does what the hint says, and looks again."""

import dataclasses
import random
import re
import time

from hint import read_hint

LOOK_S = 0.25
# After an input nothing that the hint names came nearer for so long: a wrong turn.
WRONG_TURN_S = 5.0
AT_ONCE = 8
# A press that moves less is a click; as far as a hand goes at once.
CLICK_PIXELS, PIXELS_AT_MOST = 8, 150
# To look from elsewhere. What is meant to go less, in millimetres or degrees, teaches nothing: hints round.
LOOK_PIXELS, LEARNT_FROM = 40, 2.0
# Who is sent to and fro so often goes half as far.
SWINGS_AT_MOST = 3
# A button is held on for so long: a frame that hears it let go hears of a drag no more, and takes a notch for a plain one.
HELD_ON_S = 0.2
# A display gives fast movements of a mouse more pixels than slow ones.
SHORT_PIXELS, SLOW_STEP_PIXELS, FAST_STEP_PIXELS, STEP_S = 30, 2, 10, "0.02"
# Until an input is seen, and until it has come to rest.
SEEN_S, REST_S, STILL_S = 4.0, 1.5, 0.5
# Of a question: as many keys until its button has the focus, as many clicks until it is heard.
TABS_AT_MOST, CLICKS_AT_MOST = 8, 5
# The button of a pause, the way out of the tray, and how a tool of it is named.
PAUSED = "operate.go_on"
TRAY_KEPT, TRAY_TOOL = "operate.tray.keep", re.compile(r"operate\.tray\.\d+$")
# Steps of the ring from any tool of the tray to any other.
ARROWS_AT_MOST = 40
# How often a hand slips.
SLIPS_SHARE = 0.04

KEYS = {"Left": "Left", "Right": "Right", "Up": "Up", "Down": "Down", "Page up": "Prior", "Page down": "Next",
        "Space": "space", "Enter": "Return", "Backspace": "BackSpace", "Ctrl": "ctrl", "Shift": "shift", "Alt": "alt"}


def chord_of(words):
    """"Shift+Ctrl+Page up" as xdotool says it; the key B writes a small b."""
    return "+".join(KEYS.get(part, part.lower()) for part in words.split("+"))


def arrow_from(here, there):
    """First to the row, then along it."""
    down = there["y"] - here["y"]
    if abs(down) > here["h"] / 2:
        return "Down" if down > 0 else "Up"
    return "Right" if there["x"] > here["x"] else "Left"


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

    def says_lifted(self):
        return "A right click sets it down" in self.text("operate.foot")

    def is_asked(self):
        return any(name.endswith(".keep") for name in self.widgets)

    def is_tray_open(self):
        return TRAY_KEPT in self.widgets

    def tool_of_tray(self, words):
        """The name of the tool that the hint asks for; None where it asks for none that lies there."""
        tools = {each["label"]: name for name, each in self.widgets.items() if TRAY_TOOL.match(name)}
        return next((name for label, name in tools.items() if f": {label}." in words), None)

    def look_until(self, is_so):
        """What was done is soon seen, or was not heard."""
        end = time.monotonic() + SEEN_S
        while time.monotonic() < end and not (self.look() and is_so()):
            time.sleep(0.05)


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
    """Presses what the hint says, a few times at once."""

    def __init__(self, person):
        self.person = person

    def do(self, hint, _screen):
        self.person.press_slowly(*[chord_of(hint.keys)] * max(1, min(hint.times, AT_ONCE)))

    def choose(self, name, screen):
        """A control that keys lead to; True where it was heard."""
        for _ in range(TABS_AT_MOST):
            is_there = self.person.focus() == name
            self.person.press_slowly("Return" if is_there else "Tab")
            # What was pressed is waited for; a machine that does much else answers late.
            screen.look_until(lambda: name not in screen.widgets or (not is_there and self.person.focus() == name))
            if name not in screen.widgets:
                return True
        return False

    def take(self, name, screen):
        """A tool of the tray, to which arrows lead; the ring begins at the tool in the hand."""
        for _ in range(ARROWS_AT_MOST):
            at = self.person.focus()
            if at == name:
                self.person.press_slowly("Return")
                return screen.look_until(lambda: not screen.is_tray_open())
            if at not in screen.widgets or not TRAY_TOOL.match(at):
                key = "Tab"
            else:
                key = arrow_from(screen.widgets[at], screen.widgets[name])
            self.person.press_slowly(key)
            screen.look_until(lambda at=at: self.person.focus() != at)
        return None

    def slip(self, chance):
        self.person.press_slowly(chance.choice(["Left", "Right", "Up", "Down", "Next", "ctrl+Left", "ctrl+Up"]))


@dataclasses.dataclass(frozen=True)
class Pull:
    """A move or a drag of the mouse by so many pixels, and what it was meant for."""

    # "move", "drag" or "slow drag": of each a pixel goes equally far to all sides.
    kind: str
    # Of the hint that asked for it.
    hint: str
    way: tuple
    # Millimetres or degrees that were left.
    amount: float
    pixels: int

    def is_back_from(self, before):
        """The way back, for the same reason."""
        return (self.kind, self.hint) == (before.kind, before.hint) and self.way == (-before.way[0], -before.way[1])

    def gone(self, then):
        """How far it went, by what is asked for then; None where that tells nothing of it."""
        across = self.way[0] * then.way[0] + self.way[1] * then.way[1]
        if (self.kind, self.hint) != (then.kind, then.hint) or across == 0 or self.amount < LEARNT_FROM:
            return None
        return self.amount - across * then.amount


class MouseHand:
    """Moves, drags and turns the wheel as far as the hint says, of notches a few at once; how far a pixel goes it learns by
    looking."""

    # Where it begins to learn: pixels of a millimetre, or of a degree.
    PIXELS = {"move": 6.0, "drag": 4.0, "slow drag": 20.0}
    WAYS = {"left": (-1, 0), "right": (1, 0), "up": (0, -1), "down": (0, 1)}
    AWAY, TOWARDS = "4", "5"
    BUTTONS = {"tray": "operate.tray.open", "forceps": "operate.forceps", "drive home": "operate.drive_home", "of the water": "operate.irrigation",
               "last button": "operate.leave_or_take"}

    def __init__(self, person):
        self.person = person
        self.gain, self.last, self.swings = dict(self.PIXELS), None, 0

    def do(self, hint, screen):
        words = hint.mouse
        if "lift the hand" in words:
            return self.press_button(words, screen)
        if screen.says_lifted():
            return self.set_down(screen)
        if words.startswith("click"):
            return self.person.xdotool("click", "1")
        held = [key for name, key in (("Shift", "shift"), ("Alt", "alt")) if f"hold {name}" in words]
        for key in held:
            self.person.xdotool("keydown", key)
        if "wheel" in words:
            self.turn_wheel(words, min(AT_ONCE, int(hint.amount)))
        else:
            way = next(self.WAYS[each] for each in re.findall(r"\w+", words) if each in self.WAYS)
            button = ("2" if "middle" in words else "1") if "drag" in words else None
            self.move(way, self.pixels(hint, way), button)
        for key in held:
            self.person.xdotool("keyup", key)

    def pixels(self, hint, way):
        """As far as the hint says, as pixels went the last time."""
        if hint.amount is None:
            return LOOK_PIXELS
        kind = "move" if "drag" not in hint.mouse else "slow drag" if "hold Shift" in hint.mouse else "drag"
        asked = Pull(kind, hint.kind, way, hint.amount, 0)
        gone = self.last.gone(asked) if self.last else None
        if gone is not None and gone > 0.0:
            before = self.gain[kind]
            self.gain[kind] = min(2.0 * before, max(0.4 * before, self.last.pixels / gone))
        # What hardly moves is a click.
        least = 1 if kind == "move" else CLICK_PIXELS
        pixels = max(least, min(PIXELS_AT_MOST, round(hint.amount * self.gain[kind])))
        self.swings = self.swings + 1 if self.last and asked.is_back_from(self.last) else 0
        if self.swings > SWINGS_AT_MOST:
            pixels = max(least, pixels // 2)
        self.last = dataclasses.replace(asked, pixels=pixels)
        return pixels

    def move(self, way, pixels, dragged_by):
        if dragged_by:
            self.person.xdotool("mousedown", dragged_by)
        # Not out and back: GLFW loses what a caught pointer does on its way back.
        self.glide(way, pixels)
        if dragged_by:
            time.sleep(HELD_ON_S)
            self.person.xdotool("mouseup", dragged_by)

    def glide(self, way, pixels):
        """As a hand does, not at a bound: a short way so slowly that the display makes no longer one of it."""
        most = SLOW_STEP_PIXELS if abs(pixels) <= SHORT_PIXELS else FAST_STEP_PIXELS
        words = []
        while pixels:
            step = max(-most, min(most, pixels))
            words += ["mousemove_relative", "--", str(way[0] * step), str(way[1] * step), "sleep", STEP_S]
            pixels -= step
        if words:
            self.person.xdotool(*words)

    def turn_wheel(self, words, notches):
        is_held = "left button" in words
        if is_held:
            self.person.xdotool("mousedown", "1")
        self.person.xdotool("click", "--repeat", str(notches), "--delay", "25", self.AWAY if "away" in words else self.TOWARDS)
        time.sleep(HELD_ON_S)
        if is_held:
            self.person.xdotool("mouseup", "1")

    def take(self, name, screen):
        """A tool of the tray; the hand is on it again, unless the line at the foot says otherwise."""
        self.person.click(name)
        screen.look_until(lambda: not screen.is_tray_open())
        if screen.says_lifted():
            self.set_down(screen)

    def press_button(self, words, screen):
        """A button of the tool or of the step, or the number of a step that can be taken up again; then the hand is put on the
        tool again, but for the tray."""
        number = re.search(r"number (\d+)", words)
        name = next((each for part, each in self.BUTTONS.items() if part in words),
                    f"operate.step.{number[1]}" if number else "operate.step")
        if not screen.says_lifted():
            self.person.xdotool("click", "3")
            screen.look_until(screen.says_lifted)
        told = screen.text("operate.hint")
        self.person.click(name)
        screen.look_until(lambda: screen.text("operate.hint") != told)
        if not screen.is_asked():
            self.set_down(screen)

    def choose(self, name, screen):
        """The display may still put the pointer back that had led the saw: whoever sees it stay presses again."""
        for _ in range(CLICKS_AT_MOST):
            self.person.click(name)
            screen.look_until(lambda: name not in screen.widgets)
            if name not in screen.widgets:
                return True
        return False

    def set_down(self, screen):
        """A right click over the picture, as the line at the foot says. Where all is done there is none any more."""
        view = screen.widgets.get("operate.view")
        if not view:
            return
        self.person.xdotool("mousemove", str(view["x"] + view["w"] // 2), str(view["y"] + view["h"] // 2))
        time.sleep(LOOK_S)
        self.person.xdotool("click", "3")
        screen.look_until(lambda: not screen.says_lifted())

    def slip(self, chance):
        self.move(chance.choice(list(self.WAYS.values())), chance.randint(5, 20), None)


class Novice:
    """With a seed it slips now and then: a movement that nobody asked for. `retell` changes what it reads."""

    def __init__(self, person, hand, seed=None, retell=lambda text: text, say=print):
        self.person, self.hand, self.retell, self.say = person, hand, retell, say
        self.screen = Screen(person)
        self.chance = random.Random(seed) if seed is not None else None
        self.last_clock_s = 0
        # The tray lies over the hints: what it was opened for is remembered.
        self.last_words = ""
        self.wrong_turns = WrongTurns()

    def hint_words(self):
        return self.retell(self.screen.text("operate.hint"))

    def slip_now_and_then(self):
        if self.chance and self.chance.random() < SLIPS_SHARE:
            self.hand.slip(self.chance)

    def clock_s(self):
        match = re.match(r"(\d+):(\d+)", self.screen.text("operate.time"))
        if match:
            self.last_clock_s = 60 * int(match[1]) + int(match[2])
        return self.last_clock_s

    def answer_question(self):
        """The tray gives what was asked for; a question that nobody meant to raise is answered by its safe side, which has
        the focus."""
        if not self.screen.is_asked():
            return False
        tool = self.screen.tool_of_tray(self.last_words)
        if self.screen.is_tray_open() and tool:
            self.hand.take(tool, self.screen)
            return True
        self.person.press("Escape")
        time.sleep(LOOK_S)
        return True

    def go_on(self):
        """A pause that nobody meant to make: a saw that stands still on a busy machine is stopped."""
        return PAUSED in self.screen.widgets and self.hand.choose(PAUSED, self.screen)

    def watch(self, text):
        """Until what was done is seen and has come to rest; nobody does the next thing before."""
        self.screen.look_until(lambda: self.screen.text("operate.hint") != text)
        end, still_since = time.monotonic() + REST_S, time.monotonic()
        while time.monotonic() < min(end, still_since + STILL_S):
            text = self.screen.text("operate.hint")
            time.sleep(0.05)
            if self.screen.look().text("operate.hint") != text:
                still_since = time.monotonic()

    def operate(self, is_over, limit_s, patience_s):
        """Does what is hinted until is_over(screen). True where that was within `limit_s` of the attempt's clock; it waits no
        longer than `patience_s`."""
        end = time.monotonic() + patience_s
        last = ""
        while time.monotonic() < end and self.clock_s() < limit_s:
            self.screen.look()
            if is_over(self.screen):
                return True
            words = self.hint_words()
            hint = read_hint(words)
            self.last_words = words or self.last_words
            if words != last:
                self.say(f"{self.clock_s():4d} s  {words}")
                last = words
            self.wrong_turns.seen(hint, self.clock_s())
            if self.answer_question() or self.go_on():
                continue
            if hint and hint.keys:
                self.slip_now_and_then()
                told = self.screen.text("operate.hint")
                self.hand.do(hint, self.screen)
                self.wrong_turns.acted(self.clock_s())
                self.watch(told)
            else:
                time.sleep(LOOK_S)
        return False
