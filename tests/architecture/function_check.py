#!/usr/bin/env python3
"""Refuses forbidden functions in the built archives, by the symbols of their objects.

A symbol shows what the compiler really left in the program, through whatever header it came. Three rules:
  exact   the bit-exact rooms know no libm transcendental, no random source, no clock and no unordered container
  bounded contact and step take no memory, touch no file or stream, start and lock nothing
  folded  a call with a constant argument leaves no symbol, so the spelling is refused as well

usage: function_check.py ROOT BUILD
"""

import argparse
import pathlib
import re
import subprocess
from dataclasses import dataclass

from findings import finish

EXACT_ROOMS = ("simulator/base", "simulator/tool", "simulator/record", "simulator/mesh", "simulator/cutting", "simulator/bone",
               "simulator/contact", "simulator/jobs", "simulator/history", "simulator/step", "scenarios/foot")
BOUNDED_ROOMS = ("simulator/contact", "simulator/step")

TRANSCENDENTAL = (r"sin|cos|tan|sincos|asin|acos|atan|atan2|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|"
                  r"hypot|sinh|cosh|tanh|asinh|acosh|atanh|fma|erf|erfc|tgamma|lgamma")


@dataclass(frozen=True)
class Rule:
    name: str
    rooms: tuple
    symbol: re.Pattern


def rule(name, rooms, pattern):
    return Rule(name, rooms, re.compile(pattern))


RULES = (
    rule("a libm transcendental", EXACT_ROOMS,
         rf"^(std::)?(__)?({TRANSCENDENTAL})[fl]?(_finite)?(\(|$)|^_ZGV"),
    rule("a random source", EXACT_ROOMS,
         r"^(rand|srand|rand_r|random|srandom|[delmnj]rand48|getrandom|getentropy|randombytes\w*)(\(|$)|"
         r"std::random_device|std::\w+_distribution<|std::(mersenne_twister|linear_congruential)_engine|"
         r"std::generate_canonical"),
    rule("an unordered container", EXACT_ROOMS,
         r"std::(__detail::)?_(Hashtable|Prime_rehash_policy|Hash_node)|std::unordered_|std::_Hash_bytes"),
    rule("a clock", EXACT_ROOMS,
         r"^(clock_gettime|clock_nanosleep|nanosleep|gettimeofday|time|clock|usleep|sleep)(\(|$)|"
         r"std::chrono::.*::now\("),
    rule("memory taken", BOUNDED_ROOMS,
         r"^operator new|^(malloc|calloc|realloc|aligned_alloc|posix_memalign|strdup|__cxa_allocate_exception)(\(|$)"),
    rule("a thread or lock", BOUNDED_ROOMS,
         r"^pthread_|std::j?thread|std::condition_variable|std::mutex|^(syscall|sched_\w+|futex)(\(|$)"),
    rule("a file or stream", BOUNDED_ROOMS,
         r"^(f?open(at|64)?|fread|fwrite|fclose|read|write|close|mmap|puts|putchar|fputs|perror)(\(|$)|"
         r"^(__)?(v?f?d?s?n?printf)(_chk)?(\(|$)|std::basic_[io]?f?stream|std::basic_filebuf|"
         r"std::ios_base|std::(cout|cerr|clog)"),
)

SPELLED = re.compile(rf"\b(?:std|glm)::(?:{TRANSCENDENTAL})[fl]?\s*\(")


def read_symbols(archive):
    """(object, symbol) of each undefined or weak symbol of an archive or object, demangled."""
    printed = subprocess.run(["nm", "-C", str(archive)], capture_output=True, text=True, check=True)
    member = archive.name
    for line in printed.stdout.splitlines():
        if line.endswith(":") and not line.startswith(" "):
            member = line[:-1]
        match = re.match(r"^\s*[0-9a-f]*\s+([UWVwvu])\s+(.*)$", line)
        if match:
            yield member, match.group(2).split("@", 1)[0]


def built_objects(build, room):
    """The archives of one room: what CMake built in its folder, not in the folders below."""
    return sorted((build / room).glob("*.a")) + sorted((build / room).glob("*.o"))


def check_symbols(build, room, findings):
    for archive in built_objects(build, room):
        for member, symbol in read_symbols(archive):
            for each in RULES:
                if room in each.rooms and each.symbol.search(symbol):
                    findings.append((f"{room}/{member}", f"{each.name}: {symbol}"))


def check_spelling(root, room, findings):
    for file in sorted((root / room).rglob("*")):
        if file.suffix not in (".h", ".cpp"):
            continue
        for number, line in enumerate(file.read_text().splitlines(), 1):
            found = SPELLED.search(line.split("//", 1)[0])
            if found:
                place = f"{file.relative_to(root).as_posix()}:{number}"
                findings.append((place, f"a libm transcendental, spelled: {found.group(0)}"))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    arguments = parser.parse_args()
    findings = []
    rooms = [room for room in EXACT_ROOMS if (arguments.root / room / "CMakeLists.txt").is_file()]
    for room in rooms:
        if not built_objects(arguments.build, room):
            findings.append((room, "was not built: nothing to read the symbols of"))
        check_symbols(arguments.build, room, findings)
        check_spelling(arguments.root, room, findings)
    finish("function check", sorted(set(findings)), f"{len(rooms)} rooms")


if __name__ == "__main__":
    main()
