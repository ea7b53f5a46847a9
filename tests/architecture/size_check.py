#!/usr/bin/env python3
"""Measures the tree: files per folder, lines per source and function, columns, comments.

Four numbers have limits. The share of comments is printed and no target to fill: a line that says nothing is worse
than none. A comment line is one that holds nothing else; doors are told by door_check.py.

usage: size_check.py ROOT
"""

import argparse
import pathlib
import re
from collections import Counter

from arrow_check import ROOMS, source_files
from arrow_table import lies_in
from door_check import said_reach
from findings import finish

MAX_FILES = 45
MAX_SOURCE_LINES = 500
MAX_FUNCTION_LINES = 70
MAX_COLUMNS = 100
COMMENT = re.compile(r"^\s*//")
# Opens something whose braces are no function's: what is inside is looked at on its own.
CONTAINER = re.compile(r"\b(namespace|class|struct|union|enum|extern)\b[^;()]*$|=\s*$|\bextern \"C\"\s*$")


def without_comments_and_text(source):
    """The source with comments, strings and characters blanked out; every newline stays."""
    pattern = re.compile(r'R"(\w*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])\'(?:\\.|[^\'\\\n])+\'',
                         re.DOTALL)
    blank = pattern.sub(lambda found: re.sub(r"[^\n]", " ", found.group(0)), source)
    return re.sub(r"^[ \t]*#[^\n]*", "", blank, flags=re.MULTILINE)


def function_lengths(source):
    """(first line, lines) of each outermost pair of braces that is not a namespace, a type or a table."""
    text = without_comments_and_text(source)
    line, head, stack, before = 1, "", [], ""
    for letter in text:
        if letter == "\n":
            line += 1
        if letter == "{":
            inside_function = any(is_function for is_function, _ in stack)
            # The second brace of `= {{` opens the same table as the first.
            is_table = before == "{" and bool(stack) and not stack[-1][0]
            stack.append((not inside_function and not is_table and not CONTAINER.search(head.strip()), line))
            head = ""
        elif letter == "}" and stack:
            is_function, first = stack.pop()
            if is_function:
                yield first, line - first + 1
            head = ""
        elif letter == ";":
            head = ""
        else:
            head += letter
        if not letter.isspace():
            before = letter


def files_per_folder(root):
    """Of each folder of the rooms the files that lie in it; what tests are fed with is not counted."""
    count = Counter()
    for room in ROOMS:
        for file in (root / room).rglob("*"):
            folder = file.parent.relative_to(root).as_posix()
            if file.is_file() and "__pycache__" not in file.parts and not lies_in(folder, "tests/fuzz/corpus"):
                count[folder] += 1
    return count


def check_source(path, text, findings):
    lines = text.splitlines()
    if len(lines) > MAX_SOURCE_LINES:
        findings.append((path, f"{len(lines)} lines; a source stops at {MAX_SOURCE_LINES}"))
    for first, length in function_lengths(text):
        if length > MAX_FUNCTION_LINES:
            findings.append((f"{path}:{first}", f"a function of {length} lines; it stops at {MAX_FUNCTION_LINES}"))
    for number, line in enumerate(lines, 1):
        if len(line) > MAX_COLUMNS:
            findings.append((f"{path}:{number}", f"{len(line)} columns; a line stops at {MAX_COLUMNS}"))


def kind_of(path, text):
    if lies_in(path, "tests"):
        return "tests"
    if path.endswith(".cpp"):
        return "sources"
    return "doors" if said_reach(text) == "door" else "parts"


def comment_shares(texts):
    """[(room, kind, files, lines that are not blank, share of comments in percent)]"""
    lines, comments, files = Counter(), Counter(), Counter()
    for path, text in texts.items():
        kind = kind_of(path, text)
        for key in {(path.split("/", 1)[0], kind), ("all", kind)}:
            filled = [line for line in text.splitlines() if line.strip()]
            files[key] += 1
            lines[key] += len(filled)
            comments[key] += sum(1 for line in filled if COMMENT.match(line))
    return [(*key, files[key], lines[key], 100.0 * comments[key] / max(1, lines[key])) for key in sorted(files)]


def print_table(folders, shares):
    print("files  folder")
    for folder, count in sorted(folders.items(), key=lambda item: (-item[1], item[0])):
        print(f"{count:5}  {folder}")
    print("\nfiles    lines  comment  of")
    for room, kind, files, lines, share in shares:
        print(f"{files:5}  {lines:7}  {share:5.1f} %  {kind} of {room}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    root = parser.parse_args().root.resolve()
    findings = []
    folders = files_per_folder(root)
    for folder, count in sorted(folders.items()):
        if count > MAX_FILES:
            findings.append((folder, f"{count} files; a folder holds at most {MAX_FILES}"))
    texts = {file.relative_to(root).as_posix(): file.read_text(errors="replace") for file in source_files(root)}
    for path, text in texts.items():
        check_source(path, text, findings)
    print_table(folders, comment_shares(texts))
    finish("size check", findings, f"{len(texts)} sources in {len(folders)} folders")


if __name__ == "__main__":
    main()
