"""What a check found, and how it says so."""

import sys


def finish(check, findings, looked_at):
    """Prints each finding (`place: what`) and ends the program: 0 where there are none, 1 otherwise."""
    for place, text in findings:
        print(f"{place}: {text}")
    print(f"{check}: {len(findings)} violations in {looked_at}")
    sys.exit(1 if findings else 0)
