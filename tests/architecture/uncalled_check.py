#!/usr/bin/env python3
"""Refuses functions of the product that the program `hallux` does not contain: only tests call them, or nobody.

Each function has a section of its own and the program is linked with --gc-sections, so what no call leads to from main()
is left out. A function that is missing may still be there inlined, as the program's debug information says, or folded
into a constant, which only what is compiled with it can do: what is called there is taken as called.
Looked at are the functions that the rooms' archives define for others (nm's T), moves and destructors excepted: they
belong to their type. Functions of headers that nobody calls are in no archive, and anonymous ones that nobody calls
are a warning already.

uncalled.txt lists what may be uncalled, with its reason; an entry that is called, or is gone, is refused too.

usage: uncalled_check.py ROOT BUILD [--allowed FILE]
"""

import argparse
import pathlib
import re
import subprocess

from findings import finish

ROOMS = ("simulator", "scenarios", "database", "assessment", "ui")
PROGRAM = "ui/app/hallux"
OURS = re.compile(r"\bhallux::")
SPECIAL = re.compile(r"(?:^|::)(\w+)::(?:\1\(\S*\b\1&&\)|operator=\(\S*\b\1&&\)|~\1\(\))$")
CLONE = re.compile(r" \[clone [^]]*\]|\[abi:\w+\]")
DIE = re.compile(r"^ <[0-9a-f]+><([0-9a-f]+)>: Abbrev Number: \d+ \((\w+)\)")
VALUE = re.compile(r"^    <[0-9a-f]+>   DW_AT_(linkage_name|abstract_origin|specification|low_pc|entry_pc) *: (.*)$")


def lines_of(*command):
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                          errors="replace") as running:
        yield from running.stdout
    if running.returncode:
        raise SystemExit(f"{' '.join(map(str, command))} ended with {running.returncode}")


def plain(name):
    """A demangled name without what the compiler adds to it."""
    return CLONE.sub("", name).strip()


def defined_functions(archive):
    """(member, function) of each function of ours that an archive defines for others."""
    member = archive.name
    for line in lines_of("nm", "-C", "--defined-only", str(archive)):
        if line.rstrip().endswith(":"):
            member = line.rstrip()[:-1]
        match = re.match(r"^[0-9a-f]+ T (.*)$", line)
        if match and OURS.search(match.group(1)):
            yield member, plain(match.group(1))


def kept_functions(program):
    """Every function that has a place of its own in the program."""
    return {plain(line.split(" ", 2)[2]) for line in lines_of("nm", "-C", "--defined-only", str(program))}


def read_inlined(program):
    """(origins of what stands inlined in code that was kept, {entry: mangled name}, {entry: entry it completes})"""
    inlined, names, links = set(), {}, {}
    entry, tag, origin, is_kept = None, None, None, False
    for line in lines_of("readelf", "--debug-dump=info", str(program)):
        if line.startswith(" <"):
            if tag == "DW_TAG_inlined_subroutine" and origin and is_kept:
                inlined.add(origin)
            found = DIE.match(line)
            entry, tag = found.groups() if found else (None, None)
            origin, is_kept = None, False
            continue
        if tag not in ("DW_TAG_subprogram", "DW_TAG_inlined_subroutine"):
            continue
        found = VALUE.match(line)
        if not found:
            continue
        what, value = found.groups()
        if what == "linkage_name":
            names[entry] = value.rsplit(" ", 1)[-1].strip()
        elif what in ("abstract_origin", "specification"):
            origin = value.strip("<>\n ").removeprefix("0x")
            links[entry] = origin
        else:
            is_kept = is_kept or int(value, 16) != 0
    return inlined, names, links


def inlined_functions(program):
    """Every function whose code stands in another's, where that was kept."""
    inlined, names, links = read_inlined(program)
    mangled = set()
    for entry in inlined:
        while entry and entry not in names:
            entry = links.get(entry)
        if entry:
            mangled.add(names[entry])
    text = "\n".join(sorted(mangled))
    done = subprocess.run(["c++filt"], input=text, capture_output=True, text=True, check=True)
    return {plain(name) for name in done.stdout.splitlines()}


def sources_of(root, build, room, member):
    """The source that an object was made of; of a group (cmake/group_sources.py) all that were compiled as one."""
    source = member.removesuffix(".o")
    groups = list((build / room).rglob(f"Unity/{source}"))
    if not groups:
        return list((root / room).rglob(source))
    return [pathlib.Path(path) for group in groups for path in re.findall(r'#include "(.*)"', group.read_text())]


def is_called_at_home(sources, function):
    """Whether the source that defines the function also calls it: its name and `(` stand there more than once."""
    *_, owner, name = without_arguments(function).split("::")
    called = re.compile(rf"\b{re.escape(name)}\(")
    texts = [re.sub(r"//.*", "", source.read_text(errors="replace")) for source in sources]
    homes = [text for text in texts if f"{owner}::{name}(" in text] or texts
    return any(len(called.findall(text)) > 1 for text in homes)


def without_arguments(function):
    """`hallux::a::f` of `hallux::a::f(int (*)(int)) const`."""
    operator = re.search(r"\boperator\W+?(?=\()", function)
    if operator:
        return function[:operator.end()]
    depth = 0
    for index, letter in enumerate(function):
        if letter == "(" and depth == 0 and not function[:index].endswith("::"):
            return function[:index]
        depth += (letter in "<(") - (letter in ">)")
    return function


def read_allowed(file):
    """{name: reason}; a name that ends in `::` allows all of that class or namespace."""
    allowed = {}
    for number, line in enumerate(file.read_text().splitlines() if file.is_file() else [], 1):
        text = line.split("#", 1)[0].strip()
        if text:
            name, _, reason = text.partition(": ")
            if not reason.strip():
                raise SystemExit(f"{file}:{number}: an entry has a name, a colon and its reason: {text}")
            allowed[name] = reason.strip()
    return allowed


def is_allowed(name, allowed, used):
    entry = next((each for each in allowed if name == each or (each.endswith("::") and name.startswith(each))), None)
    used.add(entry)
    return entry is not None


def archives_of(build, room):
    """The archives that Ninja makes of the room; without its plan, those that lie there. An old one may lie there for ever."""
    plan = build / "build.ninja"
    if not plan.is_file():
        return sorted((build / room).rglob("*.a"))
    made = re.findall(rf"^build ({re.escape(room)}/\S+\.a):", plan.read_text(errors="replace"), re.MULTILINE)
    return [build / archive for archive in sorted(made)]


def product_functions(build):
    for room in ROOMS:
        for archive in archives_of(build, room):
            for member, function in defined_functions(archive):
                yield archive.parent.relative_to(build).as_posix(), member, function


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--allowed", type=pathlib.Path)
    arguments = parser.parse_args()
    allowed_file = arguments.allowed or arguments.root / "tests/architecture/uncalled.txt"
    program = arguments.build / PROGRAM
    if not program.is_file():
        raise SystemExit(f"{program} was not built")
    called = kept_functions(program) | inlined_functions(program)
    allowed, used, findings, count = read_allowed(allowed_file), set(), set(), 0
    for room, member, function in product_functions(arguments.build):
        count += 1
        if function in called or SPECIAL.search(function) or \
                is_called_at_home(sources_of(arguments.root, arguments.build, room, member), function) or \
                is_allowed(without_arguments(function), allowed, used):
            continue
        findings.add((f"{room}/{member.removesuffix('.o')}", f"only tests call {function}"))
    findings |= {(allowed_file.name, f"{name} is called, or is gone") for name in allowed if name not in used}
    finish("uncalled check", sorted(findings), f"{count} functions")


if __name__ == "__main__":
    main()
