"""From metrics to points, and from points to a score: docs/metrics.md, "From a metric to points", "From points to a score",
"Unfinished cuts" and "What has no value". Points are whole thousandths throughout."""

import math
from fractions import Fraction

FULL = 100_000
LOST = {"the cut was not made", "it was not done"}
KEPT = {"there was nothing to measure it by", "what was kept of the attempt does not tell it"}


def nearest(value):
    return math.floor(value + 0.5)


def milli(points):
    """Of a weight or a cap as the scenario says it."""
    return nearest(points * 1000)


def share_of(value, zero, full):
    return min(1.0, max(0.0, (zero - value) / (zero - full)))


def points_for(knots, value, weight):
    if "band" in knots:
        zero_low, full_low, full_high, zero_high = knots["band"]
        if full_low <= value <= full_high:
            return weight
        zero, full = (zero_low, full_low) if value < full_low else (zero_high, full_high)
        return nearest(weight * share_of(value, zero, full))
    if knots["full"] == knots["zero"]:
        return weight if value <= knots["full"] else 0
    return nearest(weight * share_of(value, knots["zero"], knots["full"]))


def knots_for(item, device_class):
    """Those of the attempt's device class, where an item has some."""
    return next((each for each in item.get("devices", []) if each["device"] == device_class), item)


def measurement_for(measurements, asked):
    """The one that an item or a gate asks for; nothing where it is not measured yet."""
    keys = ("cut", "hinge", "zone", "fragment", "implant")
    return next((each for each in measurements if each["metric"] == asked["metric"] and
                 all((each[key] or "") == asked.get(key, "") for key in keys)), None)


def earned_by(item, measurement, device_class):
    weight = milli(item["weight"])
    why = measurement["not_measured_because"]
    if why in LOST:
        return 0
    if why is not None and why not in KEPT:
        raise ValueError(f"{item['id']}: no value for a reason that nothing tells of: {why}")
    full = weight if why in KEPT else points_for(knots_for(item, device_class), measurement["value"], weight)
    return nearest(measurement["done_fraction"] * full)


def is_triggered(gate, measurement):
    if measurement is None or measurement["value"] is None:
        return False
    return measurement["value"] < gate["at_least"] if "at_least" in gate else measurement["value"] > gate["limit"]


def shown_losses(losses, measured, score):
    """By largest remainders, ties to the earlier: they add up to 100 minus the score."""
    exact = [Fraction(loss * FULL, measured) for loss in losses]
    shown = [math.floor(each) for each in exact]
    order = sorted(range(len(losses)), key=lambda index: shown[index] - exact[index])
    for index in order[:FULL - score - sum(shown)]:
        shown[index] += 1
    return shown


class Score:
    """`lines` are (item, group, points lost) in the order of the ledger; the rest is by group."""

    def __init__(self, rubric, measurements, device_class):
        self.lines = []
        self.earned = {group["name"]: 0 for group in rubric["groups"]}
        self.measured = dict(self.earned)
        for item in rubric["items"]:
            measurement = measurement_for(measurements, item)
            if measurement is not None:
                self.add_item(item, earned_by(item, measurement, device_class))
        self.damp()
        self.whole = sum(self.measured.values())
        self.left = sum(self.earned.values())
        self.cap(rubric["gates"], measurements)
        self.score = (2 * FULL * self.left + self.whole) // (2 * self.whole)
        self.shown = shown_losses([lost for _, _, lost in self.lines], self.whole, self.score)

    def add_item(self, item, earned):
        weight = milli(item["weight"])
        self.measured[item["group"]] += weight
        self.earned[item["group"]] += earned
        self.lines.append((item["id"], item["group"], weight - earned))

    def damp(self):
        """Efficiency counts min(1, accuracy fraction / 0.6)."""
        if not self.measured["accuracy"] or not self.measured["efficiency"]:
            return
        factor = min(1, Fraction(self.earned["accuracy"], self.measured["accuracy"]) / Fraction(3, 5))
        kept = math.floor(self.earned["efficiency"] * factor + Fraction(1, 2))
        self.lines.append(("damping", "efficiency", self.earned["efficiency"] - kept))
        self.earned["efficiency"] = kept

    def cap(self, gates, measurements):
        """The lowest cap first; the others find nothing more to take."""
        self.triggered = {gate["name"]: is_triggered(gate, measurement_for(measurements, gate)) for gate in gates}
        for gate in sorted((gate for gate in gates if self.triggered[gate["name"]]), key=lambda gate: gate["cap"]):
            lost = max(0, self.left - self.whole * milli(gate["cap"]) // FULL)
            self.left -= lost
            self.lines.append((gate["name"], "gate", lost))
