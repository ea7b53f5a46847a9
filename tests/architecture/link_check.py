#!/usr/bin/env python3
"""Refuses wrong links: an oracle in a program that is installed, a room that links what its table line forbids.

Programs are read from the link lines that Ninja runs; a static library has none, so the `USES` of its
hallux_room() line are read instead.

usage: link_check.py ROOT BUILD
"""

import argparse
import pathlib
import re

from arrow_table import read_arrow_table
from findings import finish

# What only tests, oracles and benchmarks may link: GPL or large, or of use to tests alone.
NEVER_INSTALLED = re.compile(r"^(-l|lib)(CGAL|vtk|gmp|mpfr|gtest|gmock|rapidcheck|benchmark)", re.IGNORECASE)
LINK_RULE = re.compile(r"^build (.+?): CXX_(?:EXECUTABLE|SHARED_LIBRARY|MODULE_LIBRARY)_LINKER\S* ")
ROOM = re.compile(r"hallux_room\(\s*(\w+)([^)]*)\)", re.DOTALL)
LINK = re.compile(r"target_link_libraries\(\s*(\w+)([^)]*)\)", re.DOTALL)


def read_link_lines(ninja_file):
    """(output, linked words) of each program and shared library."""
    output = None
    for line in ninja_file.read_text().splitlines():
        match = LINK_RULE.match(line)
        if match:
            output = match.group(1)
        elif line and not line.startswith(" "):
            output = None
        elif output and re.match(r"\s+(LINK_LIBRARIES|LINK_FLAGS) = ", line):
            yield output, line.split(" = ", 1)[1]


def check_programs(build, findings):
    count = 0
    for output, words in read_link_lines(build / "build.ninja"):
        if output.startswith("tests/"):
            continue
        count += 1
        for word in words.split():
            if NEVER_INSTALLED.search(pathlib.PurePath(word).name):
                findings.append((output, f"links {word}, which nothing installed may link"))
    return count


def read_rooms(root):
    """(library, folder, libraries it uses) of each hallux_room and each link added to one."""
    for room in ("simulator", "scenarios", "database", "assessment", "ui"):
        for file in sorted((root / room).rglob("CMakeLists.txt")):
            text = re.sub(r"#.*", "", file.read_text())
            folder = file.parent.relative_to(root).as_posix()
            for name, body in ROOM.findall(text):
                yield name, folder, re.split(r"\bUSES\b", body + " USES ")[1].split()
            for name, body in LINK.findall(text):
                yield name, folder, [word for word in body.split()
                                     if word not in ("PUBLIC", "PRIVATE", "INTERFACE")]


def why_refused(table, folders, folder, library):
    if library == "hallux_rules":
        return None
    if library in folders:
        is_allowed = any(table.may_include(unit, other) for unit in table.units_of(folder)
                         for other in table.units_of(folders[library]))
        return None if is_allowed else f"{folder} may not link {library} of {folders[library]}"
    if library not in table.libraries:
        return f"links {library}, which the arrow table does not name"
    held = [allowed for allowed in table.libraries[library]
            if folder == allowed or (folder + "/").startswith(allowed + "/")
            or allowed.startswith(folder + "/")]
    return None if held else f"may not link {library}"


def check_rooms(root, table, findings):
    rooms = list(read_rooms(root))
    folders = {name: folder for name, folder, _ in rooms}
    for name, folder, uses in rooms:
        if not table.units_of(folder):
            findings.append((f"{folder}/CMakeLists.txt", f"{name} belongs to no unit of the arrow table"))
            continue
        for library in uses:
            wrong = why_refused(table, folders, folder, library)
            if wrong:
                findings.append((f"{folder}/CMakeLists.txt", f"{name}: {wrong}"))
    return len(folders)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--table", type=pathlib.Path)
    arguments = parser.parse_args()
    table = read_arrow_table(arguments.table or arguments.root / "tests/architecture/arrows.txt")
    findings = []
    rooms = check_rooms(arguments.root, table, findings)
    programs = check_programs(arguments.build, findings)
    finish("link check", findings, f"{rooms} libraries and {programs} programs")


if __name__ == "__main__":
    main()
