"""A hint on the screen, read as a person reads it: what is so, where it is to come, and what the hand is told to do.

    "Tilt along is +4.9°, Tilt across −1.2°: bring them to 0.0° and 0.0°. Keys: Ctrl+Down, 3 times. Mouse: drag down ... by 3.0°."
     |________________ values ______________|               |__ goals __|        |___ the hand ___|
"""

import dataclasses
import re

NUMBER = r"[+−-]?\d+(?:\.\d+)?"


def number_of(text):
    return float(text.replace("−", "-").replace("+", ""))


def numbers_in(text):
    return [number_of(each) for each in re.findall(NUMBER, text)]


@dataclasses.dataclass(frozen=True)
class Hint:
    # Its words without numbers: two hints that ask for the same thing are alike.
    kind: str
    # How far from what it asks for; None where it names no value.
    distance: float | None
    # The greatest part of that.
    greatest: float | None
    # Words for the hand, and how often a key is to be pressed.
    keys: str
    times: int
    mouse: str
    # How far it goes: notches of the wheel, millimetres of a move, degrees of a drag; None where that is not said.
    amount: float | None


def parts_left(sentence):
    """What is left by the sentence's own words: to its goals, to its band, or of its way."""
    if goals := re.search(r"^(.*): bring (?:it|them) to (.*)$", sentence):
        values, wanted = numbers_in(goals[1]), numbers_in(goals[2])
        return [abs(value - goal) for value, goal in zip(values, wanted)]
    if band := re.search(rf"is ({NUMBER}) N: keep it between ({NUMBER}) and ({NUMBER})(.*)", sentence):
        value, least, most = (number_of(band[group]) for group in (1, 2, 3))
        left = re.search(rf"({NUMBER}) mm are left", band[4])
        return [max(least - value, value - most, 0.0), 10.0 * number_of(left[1]) if left else 0.0]
    if way := re.search(rf"({NUMBER}) mm", sentence):
        return [number_of(way[1])]
    return []


def read_hint(text):
    """None for no hint."""
    if not text:
        return None
    match = re.fullmatch(r"(.*?)(?: Keys: (.*?)(?:, (\d+) times)?\. Mouse: (.*)\.)?", text)
    sentence, keys, times, mouse = match.groups()
    left = parts_left(sentence)
    # Of a push it is the force that the hand sets right.
    greatest = left[0] if "keep it between" in sentence else max(left, default=None)
    words, amount = re.fullmatch(r"(.*?)(?:,? (?:by )?(\d+(?:\.\d+)?)(?: notch(?:es)?| mm|°))?", mouse or "").groups()
    return Hint(re.sub(NUMBER, "#", sentence), sum(left) if left else None, greatest, keys or "", int(times or 1), words,
                float(amount) if amount else None)
