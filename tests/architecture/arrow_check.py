#!/usr/bin/env python3
"""Refuses an #include that the arrow table does not allow, and cycles between units.

usage: arrow_check.py ROOT [--table FILE]
"""

import argparse
import pathlib
import re

from arrow_table import find_cycle, lies_in, read_arrow_table
from findings import finish

ROOMS = ("simulator", "scenarios", "database", "assessment", "ui", "tests")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def source_files(root):
    for room in ROOMS:
        for file in sorted((root / room).rglob("*")):
            if file.suffix in (".h", ".cpp"):
                yield file


def check_own(table, root, unit, header):
    """Why `unit` may not include the quoted `header`, or None."""
    if not (root / header).is_file():
        return f'"{header}" is not a file from the repository root'
    other = table.unit_of(header)
    if other is None:
        return f'"{header}" belongs to no unit of the arrow table'
    if not table.may_include(unit, other):
        return f'{unit} may not include {other} ("{header}")'
    return None


def is_named_by(header, prefix):
    """`glm/` names all below it, `imgui` also imgui_internal.h, `random` only itself."""
    is_standard = "." not in header and "/" not in header
    return header == prefix or (not is_standard and header.startswith(prefix))


def check_foreign(table, path, header):
    """Why the file `path` may not include the foreign `header`, or None."""
    named = [prefix for prefix in table.foreign if is_named_by(header, prefix)]
    if not named:
        if "." in header or "/" in header:
            return f"<{header}> is a foreign header that the arrow table does not name"
        return None
    if any(lies_in(path, unit) for unit in table.foreign[max(named, key=len)]):
        return None
    return f"<{header}> may not be included here"


DECLARED = re.compile(r"^(?!#|//|using|namespace|struct|class|enum|friend|extern|inline constexpr|constexpr)"
                      r"[\w:<>,&* ]+?[ &*](\w+)\(", re.MULTILINE)


def guarded_functions(table, root):
    """Of each header of a guarded room the free functions that it declares: they stand at the line's beginning."""
    functions = {}
    for room in table.guarded_rooms():
        for header in sorted((root / room).rglob("*.h")):
            path = header.relative_to(root).as_posix()
            if lies_in(path, room + "/records"):
                continue
            for name in DECLARED.findall(header.read_text(errors="replace")):
                functions.setdefault(name, set()).add(path)
    return functions


def check_doors(table, functions, path, line):
    """Why this line of `path` goes past the doors of a guarded room, or None: a header in reach may bring others along."""
    for match in re.finditer(r"(?<![\w.>:])(?:database::(\w+)\(|(\w+)\(\*?\w*database_?[,)])", line):
        name = match.group(1) or match.group(2)
        headers = functions.get(name, ())
        if headers and not any(table.is_open(path, header) for header in headers):
            return f"{name}() of {min(headers)} is behind a desk; ask the desk, or name this file in [doors]"
    return None


def check_file(table, root, file, arrows, findings, functions):
    path = file.relative_to(root).as_posix()
    is_test = lies_in(path, "tests")
    unit = "tests" if is_test else table.unit_of(path)
    if unit is None:
        findings.append((path, "belongs to no unit of the arrow table"))
        return
    for number, line in enumerate(file.read_text(errors="replace").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            past = None if is_test or not functions else check_doors(table, functions, path, line)
            if past:
                findings.append((f"{path}:{number}", past))
            continue
        header = match.group(2)
        if match.group(1) == "<":
            wrong = None if is_test else check_foreign(table, path, header)
        elif is_test:
            wrong = None if (root / header).is_file() else f'"{header}" is not a file from the root'
        else:
            wrong = check_own(table, root, unit, header)
            if not wrong and not table.is_open(path, header):
                wrong = f"{header} is behind a desk; ask the desk, or name this file in [doors]"
            arrows.setdefault(unit, set()).add(table.unit_of(header) or header)
        if wrong:
            findings.append((f"{path}:{number}", wrong))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--table", type=pathlib.Path)
    arguments = parser.parse_args()
    root = arguments.root.resolve()
    table_file = arguments.table or root / "tests/architecture/arrows.txt"
    table = read_arrow_table(table_file)
    findings, arrows, count = [], {}, 0
    functions = guarded_functions(table, root)
    for file in source_files(root):
        check_file(table, root, file, arrows, findings, functions)
        count += 1
    allowed = {unit: table.targets(unit) for unit in table.arrows}
    used = {unit: others - {unit} for unit, others in arrows.items()}
    for place, graph in ((table_file.name, allowed), ("includes", used)):
        cycle = find_cycle(graph)
        if cycle:
            findings.append((place, "a cycle: " + " -> ".join(cycle)))
    finish("arrow check", findings, f"{count} files")


if __name__ == "__main__":
    main()
