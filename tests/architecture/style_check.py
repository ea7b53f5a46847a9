#!/usr/bin/env python3
"""Refuses what clang-format and clang-tidy do not see: names of files, macros, places of one machine.

usage: style_check.py ROOT
"""

import argparse
import pathlib
import re

from findings import finish

FOLDERS = ("simulator", "scenarios", "database", "assessment", "ui", "tests", "docs", "cmake", ".ci")
FILES = ("run", "test", "README.md", "CMakeLists.txt", "CMakePresets.json")
CODE = (".h", ".cpp")
TEXT = CODE + (".py", ".sh", ".txt", ".md", ".cmake", ".json", ".sql", "")
FILE_NAME = re.compile(r"^[a-z0-9_]+(\.[a-z0-9_]+)*$")
MACHINE_PATH = re.compile(r"(?<![\w.$}])/(home|root|work|Users|mnt)/\w")
UNFINISHED = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")
MACRO = re.compile(r"^\s*#\s*define\s+(\w+)")


def files_of(root):
    for folder in FOLDERS:
        yield from sorted(file for file in (root / folder).rglob("*")
                          if file.is_file() and "__pycache__" not in file.parts)
    yield from (root / name for name in FILES if (root / name).is_file())


def check_code(path, text, findings):
    lines = text.splitlines()
    for number, line in enumerate(lines, 1):
        macro = MACRO.match(line)
        if macro and macro.group(1) != "CHECK":
            findings.append((f"{path}:{number}", f"a macro of our own: {macro.group(1)}"))
    if path.endswith(".h"):
        check_header(path, lines, findings)


def check_header(path, lines, findings):
    if not lines or not lines[0].startswith("///"):
        findings.append((f"{path}:1", "a header opens with its purpose in one sentence (///)"))
    if "#pragma once" not in lines:
        findings.append((path, "a header has `#pragma once`"))
    for number, line in enumerate(lines, 1):
        if line.startswith("using namespace"):
            findings.append((f"{path}:{number}", "a header opens no namespace for those who include it"))


def check_text(path, text, findings):
    for number, line in enumerate(text.splitlines(), 1):
        if MACHINE_PATH.search(line):
            findings.append((f"{path}:{number}", "a path of one machine"))
        if UNFINISHED.search(line):
            findings.append((f"{path}:{number}", "unfinished work is said in an issue, not in the tree"))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    root = parser.parse_args().root.resolve()
    findings, count = [], 0
    for file in files_of(root):
        path = file.relative_to(root).as_posix()
        count += 1
        if file.suffix in CODE + (".py", ".sql") and not FILE_NAME.match(file.name):
            findings.append((path, "a file's name is snake_case"))
        if file.suffix not in TEXT or lies_in_planted(path):
            continue
        text = file.read_text(errors="replace")
        check_text(path, text, findings)
        if file.suffix in CODE:
            check_code(path, text, findings)
    finish("style check", findings, f"{count} files")


def lies_in_planted(path):
    """The tests of these checks, and this one, must spell what is refused."""
    return path.startswith("tests/architecture/")


if __name__ == "__main__":
    main()
