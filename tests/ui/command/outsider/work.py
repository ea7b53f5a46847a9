"""Forces, times and break-throughs: docs/metrics.md, "How the work was done" and "Faces"."""

import math

from outsider.export import BREAK_THROUGH, CUTTING, FINISHED, IN_CONTACT, IRRIGATED, RUNNING, SAW_ON, STARTED
from outsider.geometry import distance_to_triangle, dot, length, percentile, sub

WINDOW_TICKS = 20
NEAR_MM = 50.0


def force_metrics(export):
    """Rows force_peak_newton, force_p95_newton, side_load_newton. A sample stands for each tick that it covers."""
    sizes, aside, windows = [], [], []
    for first, last in export.stretches(lambda sample: sample.status & CUTTING):
        stretch = []
        for index in range(first, last + 1):
            sample, ticks = export.samples[index], export.ticks_covered(index)
            force = sample.force_newton()
            stretch += [length(force)] * ticks
            aside += [dot(force, sample.world_from_tool().axis(2))] * ticks
        sizes += stretch
        windows += [math.fsum(stretch[at:at + WINDOW_TICKS]) / WINDOW_TICKS
                    for at in range(len(stretch) - WINDOW_TICKS + 1)]
    return {("force_peak_newton", ""): max(windows, default=None),
            ("force_p95_newton", ""): percentile(sizes, 0.95) if sizes else None,
            ("side_load_newton", ""): math.sqrt(math.fsum(each**2 for each in aside) / len(aside)) if aside else None}


class NearBone:
    """Whether a place is within 50 mm of the bone. A distance changes by no more than the way, so few are searched."""

    def __init__(self, mesh):
        self.mesh, self.asked, self.asked_mm = mesh, None, 0.0
        self.edge_mm = max(math.dist(mesh.points[a], mesh.points[b])
                           for triangle in mesh.triangles for a, b in zip(triangle, triangle[1:] + triangle[:1]))

    def holds(self, place):
        if self.asked is None or abs(self.asked_mm - NEAR_MM) <= math.dist(place, self.asked):
            self.asked, self.asked_mm = place, self.distance_mm(place)
        return self.asked_mm < NEAR_MM

    def distance_mm(self, place):
        """From the surface; the nearest corner is no further from its nearest point than an edge is long."""
        points = self.mesh.points
        ways = [math.dist(place, point) for point in points]
        limit_mm = min(ways) + self.edge_mm
        return min(distance_to_triangle(place, *(points[corner] for corner in triangle))
                   for triangle in self.mesh.triangles if min(ways[corner] for corner in triangle) <= limit_mm)


def saw_metrics(export):
    """Rows air_cutting_s, started_in_bone, irrigated_share."""
    samples = export.samples
    near = NearBone(export.bone)
    air = export.stretches(lambda sample: sample.status & SAW_ON and not sample.status & IN_CONTACT and
                           near.holds(export.tip_in_bone_mm(sample)))
    air_ticks = [samples[last].tick - samples[first].tick + export.ticks_covered(first) for first, last in air]
    starts = [now for before, now in zip(samples, samples[1:])
              if now.status & SAW_ON and not before.status & SAW_ON and before.status & IN_CONTACT]
    sawn = {index: export.ticks_covered(index) for index, sample in enumerate(samples) if sample.status & CUTTING}
    wet = sum(ticks for index, ticks in sawn.items() if samples[index].status & IRRIGATED)
    return {("air_cutting_s", ""): sum(ticks for ticks in air_ticks if ticks > 2000) / 1000,
            ("started_in_bone", ""): 1 if starts else 0,
            ("irrigated_share", ""): wet / sum(sawn.values()) if sawn else None}


def time_metrics(export):
    """Rows time_s, planning_s: the time in which the clock ran, from one tick to another."""
    def running_s(until):
        return sum(export.ticks_covered(index) for index, sample in enumerate(export.samples)
                   if started < sample.tick <= until and sample.status & RUNNING) / 1000

    started = export.events_of(STARTED)[0].tick
    finished = [event.tick for event in export.events_of(FINISHED)]
    sawn = [sample.tick for sample in export.samples if sample.status & CUTTING]
    return {("time_s", ""): running_s(finished[0]) if finished else None,
            ("planning_s", ""): running_s(sawn[0]) if sawn else None}


def break_throughs(export, kerfs):
    """Rows plunge_mm, breakthrough_newton, breakthrough_mm_s of "Faces": the worst of a cut's kerfs."""
    plunges, pushes, speeds = [0.0], [], []
    for event in export.events_of(BREAK_THROUGH):
        if event.subject not in kerfs:
            continue
        teeth = [(0.0, side * 0.5 * export.blades_of_kerfs[event.subject]["width_mm"], 0.0) for side in (-1, 1)]
        before = [sample for sample in export.samples if event.tick - 20 <= sample.tick < event.tick]
        after = [sample for sample in export.samples if event.tick <= sample.tick <= event.tick + 200]
        then = export.bone_from_tool(after[0])
        plunges += [dot(then.axis(0), sub(export.bone_from_tool(sample).point(tooth), then.place))
                    for sample in after for tooth in teeth]
        pushes.append(sum(length(sample.force_newton()) for sample in before) / len(before))
        last = [sample for sample in after if sample.tick <= event.tick + 50][-1]
        way_mm = dot(then.axis(0), sub(export.tip_in_bone_mm(last), then.place))
        speeds.append(max(0.0, way_mm / ((last.tick - after[0].tick) / 1000)))
    return max(plunges), max(pushes, default=None), max(speeds, default=None)
