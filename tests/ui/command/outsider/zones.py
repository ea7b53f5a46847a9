"""Contacts with danger zones: docs/metrics.md, "How the work was done", row `danger_contacts_count`, and "Danger zones"."""

import math

from outsider.export import DRIVE_ON, RUNNING, SAW_ON, TICKS_PER_LINE
from outsider.geometry import distance_of_crossing_lines, distance_to_segment, length, sub

AWAY_MM, AWAY_TICKS = 0.5, 200


class Blade:
    """The rectangle behind the tooth line, in the tool's frame."""

    def __init__(self, blade):
        self.depth_mm, self.half_mm = blade["depth_mm"], 0.5 * blade["width_mm"]
        self.around_mm = 0.5 * blade["kerf_mm"]
        self.corners = [(0.0, -self.half_mm, 0.0), (0.0, self.half_mm, 0.0),
                        (-self.depth_mm, self.half_mm, 0.0), (-self.depth_mm, -self.half_mm, 0.0)]
        self.edges = list(zip(self.corners, self.corners[1:] + self.corners[:1]))

    def distance_of_point(self, point):
        beyond = point[0] if point[0] > 0.0 else min(0.0, point[0] + self.depth_mm)
        return math.sqrt(beyond**2 + max(0.0, abs(point[1]) - self.half_mm) ** 2 + point[2] ** 2)

    def is_crossed_by(self, from_, to):
        if (from_[2] > 0.0) == (to[2] > 0.0):
            return False
        share = from_[2] / (from_[2] - to[2])
        x, y = (from_[axis] + share * (to[axis] - from_[axis]) for axis in (0, 1))
        return -self.depth_mm <= x <= 0.0 and abs(y) <= self.half_mm

    def distance_of_line(self, from_, to):
        """The nearest pair holds an end of the line, a corner, or lies within an edge and the line, unless they cross."""
        if self.is_crossed_by(from_, to):
            return 0.0
        return min(self.distance_of_point(from_), self.distance_of_point(to),
                   *(distance_to_segment(corner, from_, to) for corner in self.corners),
                   *(distance_of_crossing_lines(from_, to, *edge) for edge in self.edges))


class Shaft:
    """The line from the tip back to chuck or head, in the tool's frame."""

    def __init__(self, tool):
        self.around_mm = tool["radius_mm"]
        self.corners = [(0.0, 0.0, 0.0), (-tool["shaft_mm"], 0.0, 0.0)]

    def distance_of_line(self, from_, to):
        """The nearest pair holds an end of either line, or lies within both."""
        return min(*(distance_to_segment(end, from_, to) for end in self.corners),
                   *(distance_to_segment(end, *self.corners) for end in (from_, to)),
                   distance_of_crossing_lines(from_, to, *self.corners))


class Watch:
    """One zone, sample by sample."""

    def __init__(self, zone):
        self.zone, self.tool = zone, None
        self.line = tuple(zone["from_in_bone_mm"]), tuple(zone["to_in_bone_mm"])
        self.contacts, self.ticks_within, self.least_mm = 0, 0, math.inf
        self.is_touched, self.away_ticks = False, 0
        # No further than it is.
        self.known_mm = 0.0

    def hold(self, tool):
        if tool is not self.tool:
            self.tool, self.known_mm = tool, 0.0

    def distance_mm(self, bone_from_tool, moved_mm):
        """Exact up to the margin of a contact. A rigid tool has moved no further than the corner that moved most, so further
        away a bound will do."""
        self.known_mm -= moved_mm
        if self.known_mm <= AWAY_MM:
            tool_from_bone = bone_from_tool.inverse()
            self.known_mm = (self.tool.distance_of_line(*map(tool_from_bone.point, self.line)) -
                             self.zone["radius_mm"] - self.tool.around_mm)
        return self.known_mm

    def follow(self, distance_mm, ticks):
        """`distance_mm` is infinite where the tool stands still."""
        self.least_mm = min(self.least_mm, distance_mm)
        if distance_mm <= 0.0:
            self.ticks_within += ticks
            self.contacts += not self.is_touched
            self.is_touched = True
        if distance_mm <= AWAY_MM:
            self.away_ticks = 0
            return
        self.away_ticks += ticks
        if self.away_ticks >= AWAY_TICKS:
            self.is_touched = False


def zone_metrics(export):
    """The saw is on where a saw is in the hand, and the drive where something else is."""
    tools = dict(enumerate(map(Blade, export.blades)))
    tools |= {tool["place"]: Shaft(tool) for tool in export.plan.get("boring_tools", [])}
    watches = [Watch(zone) for zone in export.plan["danger_zones"]]
    last_tick, corners = -1, []
    for sample, place in zip(export.samples, export.tools):
        ticks = min(max(sample.tick - last_tick, 0), TICKS_PER_LINE)
        last_tick = sample.tick
        runs = sample.status & RUNNING and sample.status & (SAW_ON | DRIVE_ON)
        if runs:
            bone_from_tool, before = export.bone_from_tool(sample), corners
            corners = [bone_from_tool.point(corner) for corner in tools[place].corners]
            moved_mm = max((length(sub(a, b)) for a, b in zip(corners, before)), default=0.0)
        for watch in watches:
            if runs:
                watch.hold(tools[place])
            watch.follow(watch.distance_mm(bone_from_tool, moved_mm) if runs else math.inf, ticks)
    found = {}
    for watch in watches:
        name = watch.zone["name"]
        found["danger_contacts_count", name] = watch.contacts
        found["danger_s", name] = watch.ticks_within / 1000
        found["danger_depth_mm", name] = max(0.0, -watch.least_mm)
    for metric, over_all in (("danger_contacts_count", sum), ("danger_s", sum), ("danger_depth_mm", max)):
        found[metric, ""] = over_all(found[metric, watch.zone["name"]] for watch in watches)
    return found
