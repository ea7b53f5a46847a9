#!/usr/bin/env python3
"""Each row of the tables of what is protected and what is lost names a test that is there.

usage: evidence_check.py ROOT

Looks at docs/security.md and docs/reliability.md: the last column of each table is `test`, and each of its rows names files below
tests/ in backquotes, with or without their ending, or a folder of them.
"""

import argparse
import pathlib
import re

from findings import finish

PAGES = ("docs/security.md", "docs/reliability.md")
NAMED = re.compile(r"`([\w./]+)`")


def names_of(root):
    """What a row may name: each test's file with and without its ending, and each folder from the root on."""
    tests = root / "tests"
    names = set()
    for path in tests.rglob("*"):
        if path.is_dir():
            names.add(str(path.relative_to(root)))
        elif path.suffix in (".cpp", ".py"):
            names.update((path.name, path.stem))
    return names


def cells_of(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def check_page(page, text, names, findings):
    """Returns how many rows it has looked at."""
    header, rows = None, 0
    for number, line in enumerate(text.splitlines(), 1):
        if not line.startswith("|"):
            header = None
        elif header is None:
            header = cells_of(line)
            if header[-1] != "test":
                findings.append((f"{page}:{number}", "the last column of this table is not `test`"))
        elif set(line) - set("|-: "):
            rows += 1
            check_row(f"{page}:{number}", cells_of(line)[-1], names, findings)
    return rows


def check_row(place, cell, names, findings):
    named = NAMED.findall(cell)
    if not named:
        findings.append((place, "this row names no test"))
    for name in named:
        if name not in names:
            findings.append((place, f"there is no test {name}"))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    root = parser.parse_args().root
    names, findings, rows = names_of(root), [], 0
    for page in PAGES:
        if (root / page).is_file():
            rows += check_page(page, (root / page).read_text(), names, findings)
    finish("evidence check", findings, f"{rows} rows")


if __name__ == "__main__":
    main()
