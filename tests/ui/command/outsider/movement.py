"""How the hand moved: docs/metrics.md, "Smoothness", and the row `idle_s` of "How the work was done"."""

import cmath
import math

from outsider.export import BORING, CUTTING, IN_BORE, IN_CONTACT, IN_KERF, RUNNING
from outsider.geometry import percentile

TICK_S = 0.001
CUTOFF_HZ = 10.0
BEYOND_TICKS = 100
# Bits of the status with which a movement is not free.
NOT_FREE = IN_CONTACT | IN_KERF | IN_BORE


def low_passed(values):
    """Butterworth of second order (bilinear transform, the cut-off kept where it is), forward and backward."""
    beyond = min(BEYOND_TICKS, len(values) - 1)
    longer = [2 * values[0] - values[index] for index in range(beyond, 0, -1)]
    longer += values
    longer += [2 * values[-1] - values[-1 - index] for index in range(1, beyond + 1)]
    for _ in range(2):
        longer = filtered(longer)[::-1]
    return longer[beyond:beyond + len(values)]


def filtered(values):
    """One way, as if the first value had always been there."""
    warped = math.tan(math.pi * CUTOFF_HZ * TICK_S)
    scale = 1 + math.sqrt(2) * warped + warped * warped
    b = warped * warped / scale
    a1, a2 = 2 * (warped * warped - 1) / scale, (1 - math.sqrt(2) * warped + warped * warped) / scale
    x1 = x2 = y1 = y2 = values[0]
    passed = []
    for x in values:
        y = b * (x + 2 * x1 + x2) - a1 * y1 - a2 * y2
        x1, x2, y1, y2 = x, x1, y, y1
        passed.append(y)
    return passed


class Stretch:
    """Ticks that follow each other while the clock ran: speeds of the handle [mm/s] and bits of the status, one a tick."""

    def __init__(self, places, status):
        self.status = status
        axes = [low_passed(list(axis)) for axis in zip(*places)]
        last = len(status) - 1
        self.speeds = []
        for index in range(last + 1):
            before, after = max(index - 1, 0), min(index + 1, last)
            way_mm = math.sqrt(sum((axis[after] - axis[before]) ** 2 for axis in axes))
            self.speeds.append(way_mm / ((after - before) * TICK_S) if after > before else 0.0)

    def runs(self, holds):
        """Longest runs (first, last) of ticks for which `holds(speed, status)`."""
        found, first = [], None
        for index, (speed, status) in enumerate(zip(self.speeds, self.status)):
            if holds(speed, status):
                first = index if first is None else first
            elif first is not None:
                found.append((first, index - 1))
                first = None
        return found if first is None else [*found, (first, len(self.speeds) - 1)]


def stretches_of(export):
    """A line that covers several ticks moves evenly; a pause or a gap ends a stretch."""
    status_at = {sample.tick: sample.status for sample in export.samples}
    found, places, status, next_tick = [], [], [], 0
    for line in export.tape:
        last_tick = line.tick + line.covered - 1
        now = status_at.get(last_tick, 0)
        if places and (not now & RUNNING or line.tick != next_tick):
            found.append(Stretch(places, status))
            places, status = [], []
        next_tick = last_tick + 1
        if now & RUNNING:
            from_ = places[-1] if places else line.place_mm
            for tick in range(1, line.covered + 1):
                share = tick / line.covered
                places.append(tuple(a + share * (b - a) for a, b in zip(from_, line.place_mm)))
                status.append(now)
    if places:
        found.append(Stretch(places, status))
    return found


def spectral_arc_length(speeds):
    count = 1
    while count < 4 * len(speeds):
        count *= 2
    step_hz = 1 / (TICK_S * count)

    def size(frequency):
        turn, at, total = cmath.exp(-2j * math.pi * frequency / count), 1.0, 0.0
        for speed in speeds:
            total += speed * at
            at *= turn
        return abs(total)

    rest = sum(speeds)
    shares = [size(frequency) / rest for frequency in range(min(math.floor(10 / step_hz), count // 2) + 1)]
    last = max(index for index, share in enumerate(shares) if share >= 0.05)
    return -sum(math.hypot(1 / last, shares[index] - shares[index - 1]) for index in range(1, last + 1))


def log_dimensionless_jerk(speeds):
    integral = sum(((after - 2 * now + before) / TICK_S**2) ** 2 * TICK_S
                   for before, now, after in zip(speeds, speeds[1:], speeds[2:]))
    duration_s = (len(speeds) - 1) * TICK_S
    return -math.log(duration_s**3 / max(speeds)**2 * integral)


def movement_metrics(export):
    stretches = stretches_of(export)
    movements = [stretch.speeds[first:last + 1] for stretch in stretches
                 for first, last in stretch.runs(lambda speed, status: not status & NOT_FREE and speed >= 5.0)
                 if last - first + 1 >= 300]
    idle = [last - first + 1 for stretch in stretches
            for first, last in stretch.runs(lambda speed, status: speed < 2.0 and not status & (CUTTING | BORING))]
    is_told = len(movements) >= 3
    return {("sparc", ""): percentile(map(spectral_arc_length, movements), 0.5) if is_told else None,
            ("ldlj", ""): percentile(map(log_dimensionless_jerk, movements), 0.5) if is_told else None,
            ("idle_s", ""): sum(ticks for ticks in idle if ticks > 1500) * TICK_S}
