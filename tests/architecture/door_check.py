#!/usr/bin/env python3
"""Refuses a header that is used beyond what its opening says, or that nobody uses so far.

A header's opening paragraph ends with its reach:
  "Inside this corner only."  files of its own unit of the arrow table may include it
  "Inside this room only."    files of its own top-level folder
  neither                     a door: whoever the arrow table lets in
A door that only its own corner or room includes must say so, except where nobody else could: the arrow table lets no
other unit in. Tests may include every header.

usage: door_check.py ROOT [--table FILE]
"""

import argparse
import pathlib
import re
from dataclasses import dataclass

from arrow_check import INCLUDE, source_files
from arrow_table import lies_in, read_arrow_table
from findings import finish

REACHES = ("corner", "room", "door")  # from the narrowest to the widest
SENTENCE = {"corner": "Inside this corner only.", "room": "Inside this room only."}
SPOKEN = re.compile(r"[Ii]nside this (corner|room) only([.;,]?)")


@dataclass
class Header:
    path: str
    said: str
    found: str  # the narrowest reach that holds all who include it
    widest: tuple  # who includes it from farthest away: (file, reach)


def opening_of(text):
    """The words of the first paragraph of `///` lines."""
    words = []
    for line in text.splitlines():
        if not line.startswith("///") or not line[3:].strip():
            break
        words.append(line[3:].strip())
    return " ".join(words)


def said_reach(text):
    opening = opening_of(text)
    return next((reach for reach, sentence in SENTENCE.items() if opening.endswith(sentence)), "door")


def room_of(path):
    return path.split("/", 1)[0]


def reach_of(table, path, includer):
    if table.unit_of(path) == table.unit_of(includer):
        return "corner"
    return "room" if room_of(path) == room_of(includer) else "door"


def possible_reach(table, path):
    """The widest reach that the arrow table gives the header's unit."""
    unit = table.unit_of(path)
    reaches = ["corner"] + [reach_of(table, path, other) for other in table.arrows
                            if other != unit and table.may_include(other, unit)]
    return max(reaches, key=REACHES.index)


def read_headers(root, table):
    """Every header of the product that lies in a unit of the table, with what it says and who includes it."""
    texts = {file.relative_to(root).as_posix(): file.read_text(errors="replace") for file in source_files(root)}
    product = {path: text for path, text in texts.items()
               if not lies_in(path, "tests") and table.unit_of(path)}
    includers = {}
    for path, text in product.items():
        for line in text.splitlines():
            match = INCLUDE.match(line)
            if match and match.group(1) == '"':
                includers.setdefault(match.group(2), []).append(path)
    for path, text in product.items():
        if path.endswith(".h"):
            users = [(user, reach_of(table, path, user)) for user in includers.get(path, ())]
            widest = max(users, key=lambda user: REACHES.index(user[1]), default=(None, "corner"))
            yield Header(path, said_reach(text), widest[1], widest), text


def wanted_reach(table, header):
    """What the header's opening is to say: nothing ("door") where the table closes the way already."""
    possible = possible_reach(table, header.path)
    return "door" if header.found == possible else header.found


def why_refused(table, header, text):
    if REACHES.index(header.found) > REACHES.index(header.said):
        return f'says "{SENTENCE[header.said]}" and is included by {header.widest[0]}'
    wanted = wanted_reach(table, header)
    if wanted != header.said:
        return (f'nobody beyond includes it: its opening ends with "{SENTENCE[wanted]}"' if wanted != "door"
                else f'says "{SENTENCE[header.said]}", which the arrow table says already')
    spoken = SPOKEN.findall(text)
    if len(spoken) != (header.said != "door"):
        return "speaks of its reach elsewhere or in other words than at the end of its opening"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--table", type=pathlib.Path)
    arguments = parser.parse_args()
    root = arguments.root.resolve()
    table = read_arrow_table(arguments.table or root / "tests/architecture/arrows.txt")
    findings, count = [], dict.fromkeys(REACHES, 0)
    for header, text in read_headers(root, table):
        count[wanted_reach(table, header)] += 1
        wrong = why_refused(table, header, text)
        if wrong:
            findings.append((header.path, wrong))
    finish("door check", findings, f"{count['door']} doors, {count['room']} headers of a room and "
                                   f"{count['corner']} of a corner")


if __name__ == "__main__":
    main()
