"""Reads arrows.txt and answers: which unit holds a file, and may this unit use that one."""

import pathlib
from dataclasses import dataclass, field


@dataclass
class ArrowTable:
    arrows: dict = field(default_factory=dict)     # unit -> list of units or room/*
    foreign: dict = field(default_factory=dict)    # header prefix -> list of units
    libraries: dict = field(default_factory=dict)  # library -> list of units
    doors: dict = field(default_factory=dict)      # header of a guarded room -> units and files that may include it

    def unit_of(self, path):
        """The longest unit that holds `path` (from the root, with /), or None."""
        held = [unit for unit in self.arrows if lies_in(path, unit)]
        return max(held, key=len, default=None)

    def units_of(self, folder):
        """The unit that holds `folder` and the units below it: a library may be made of several."""
        held = self.unit_of(folder)
        return [unit for unit in self.arrows if unit == held or lies_in(unit, folder)]

    def may_include(self, unit, other):
        if unit == other:
            return True
        return any(other == allowed or (allowed.endswith("/*") and lies_in(other, allowed[:-2]))
                   for allowed in self.arrows[unit])

    def guarded_rooms(self):
        return {header.split("/", 1)[0] for header in self.doors}

    def is_open(self, path, header):
        """Whether the file `path` may include `header` of a guarded room: its plain records are everybody's."""
        room = header.split("/", 1)[0]
        if room not in self.guarded_rooms() or lies_in(path, room) or lies_in(header, room + "/records"):
            return True
        return any(lies_in(path, unit) for unit in self.doors.get(header, ()))

    def targets(self, unit):
        return [other for other in self.arrows if other != unit and self.may_include(unit, other)]


def lies_in(path, folder):
    return path == folder or path.startswith(folder + "/")


def read_arrow_table(file):
    table = ArrowTable()
    section = None
    for number, line in enumerate(pathlib.Path(file).read_text().splitlines(), 1):
        text = line.split("#", 1)[0].strip()
        if not text:
            continue
        if text.startswith("["):
            section = getattr(table, text.strip("[]"), None)
            if section is None:
                raise SystemExit(f"{file}:{number}: no such section: {text}")
            continue
        # A library's own name may hold colons (glm::glm); the one that ends the name is followed by a space.
        name, _, allowed = (text + " ").partition(": ")
        if section is None or name in section:
            raise SystemExit(f"{file}:{number}: outside a section or named twice: {name}")
        section[name] = allowed.split()
    return table


def find_cycle(graph):
    """One cycle of {node: successors} as a list of nodes that begins and ends alike, or None."""
    done = set()

    def visit(node, trail):
        if node in trail:
            return trail[trail.index(node):] + [node]
        if node in done:
            return None
        for successor in sorted(graph.get(node, ())):
            cycle = visit(successor, trail + [node])
            if cycle:
                return cycle
        done.add(node)
        return None

    return next((cycle for node in sorted(graph) if (cycle := visit(node, []))), None)
