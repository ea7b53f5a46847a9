"""Resident memory of a window, as the system counts it."""

import pathlib
import re

WINDOW_KIB_AT_MOST = 450_000_000 // 1024


def status_kib(pid, what):
    """VmRSS: now; VmHWM: the most since it began, or since forget_peak."""
    return int(re.search(rf"{what}:\s+(\d+) kB", pathlib.Path(f"/proc/{pid}/status").read_text())[1])


def resident_kib(pid):
    return status_kib(pid, "VmRSS")


def peak_kib(pid):
    return status_kib(pid, "VmHWM")


def forget_peak(pid):
    pathlib.Path(f"/proc/{pid}/clear_refs").write_text("5")
