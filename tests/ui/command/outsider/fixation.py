"""Fragments, and the wires and screws that hold them: docs/metrics.md, "Fragments and implants".

An export tells of what is there, and not of what was taken out: of what was to come out again nothing is computed where
something was taken.
"""

import functools
import math

from outsider.export import IMPLANT_TAKEN
from outsider.geometry import add, angle_between, cross, dot, length, pose_from_matrix, scaled, sub
from outsider.solids import (crossings_of_line, holds, is_on, outer_triangles, segment_to_triangle_mm,
                             volume_and_centroid)

# A crossing further from the bone's surface as it was is one of a sawn face.
ON_SKIN_MM = 1e-3
# Less of an axis in a body does not hold it.
ENGAGED_MM = 1.0
PARALLEL_DEG = 5.0
# A diameter is as planned but for rounding.
SAME_MM = 1e-6
OF_IMPLANTS = ("entry_mm", "direction_deg", "tip_to_joint_mm", "protrusion_mm", "length_error_mm", "cortices",
               "insertions", "right_tool")
# Row by row the worse one: more is worse, but for these.
HIGHER_IS_BETTER = ("tip_to_joint_mm", "cortices", "right_tool")


class Body:
    """An entry of fragments.json that is there."""

    def __init__(self, export, told):
        self.name, self.pose, self.mesh = told["name"], pose_from_matrix(told["pose"]), export.mesh_as_cut(told)

    @functools.cached_property
    def volume_and_centroid(self):
        return volume_and_centroid(self.mesh)

    @functools.cached_property
    def corners(self):
        return set(self.mesh.points)

    def has_triangle(self, corners):
        """Of the bone's surface as it was a triangle is where its centroid is: it is whole, or the cuts left that."""
        kept = sum(corner in self.corners for corner in corners)
        middle = scaled(add(add(corners[0], corners[1]), corners[2]), 1 / 3)
        return kept == 3 or kept > 0 and is_on(self.mesh, self.mesh.triangles, middle, ON_SKIN_MM)


class Site:
    """What lies there at the end, and the bone as it was."""

    def __init__(self, export):
        self.export = export

    @functools.cached_property
    def bodies(self):
        return [Body(self.export, told) for told in self.export.fragments if not told["taken_out"]]

    @functools.cached_property
    def outer(self):
        return outer_triangles(self.export.bone)

    @functools.cached_property
    def canal(self):
        outer = set(self.outer)
        return [triangle for triangle in self.export.bone.triangles if triangle not in outer]

    @functools.cached_property
    def placed(self):
        return [Placed(self, told) for told in self.export.implants]

    def body_of(self, fragment):
        """The body that holds its point, and is nearer to it in size than to the bone; nothing where none is."""
        whole_mm3 = volume_and_centroid(self.export.bone)[0]
        return next((body for body in self.bodies
                     if body.volume_and_centroid[0] ** 2 < fragment["volume_mm3"] * whole_mm3 and
                     holds(body.mesh, fragment["holds_in_bone_mm"])), None)

    @functools.cached_property
    def joint_triangles(self):
        """Corners, as plan.schema.json says which triangles these are."""
        found = []
        for surface in self.export.plan["joint_surfaces"]:
            least = math.cos(math.radians(surface["within_deg"]))
            for triangle in self.outer:
                a, b, c = (self.export.bone.points[corner] for corner in triangle)
                normal = cross(sub(b, a), sub(c, a))
                middle = scaled(add(add(a, b), c), 1 / 3)
                if (length(sub(middle, surface["centre_in_bone_mm"])) <= surface["radius_mm"] and
                        dot(normal, surface["facing_in_bone"]) >= least * length(normal)):
                    found.append((a, b, c))
        return found


class Met:
    """One body as an axis meets it; ways are from its head."""

    def __init__(self, site, body, head, tip):
        piece_from_bone = body.pose.inverse()
        length_mm = length(sub(tip, head))
        crossings = crossings_of_line(body.mesh, piece_from_bone.point(head), piece_from_bone.point(tip))
        ways = [min(max(crossing.way_mm, 0.0), length_mm) for crossing in crossings]
        inside = [(begin, end) for begin, end in zip(ways[::2], ways[1::2]) if end > begin]
        on_axis = [crossing for crossing in crossings if 0.0 <= crossing.way_mm <= length_mm]
        self.body = body
        self.engaged_mm = sum(end - begin for begin, end in inside)
        self.entry_mm = inside[0][0] if inside else None
        self.last_mm = inside[-1][1] if inside else None
        self.cortices = sum(is_on(site.export.bone, site.outer, each.point, ON_SKIN_MM) for each in on_axis)
        self.comes_out = bool(on_axis) and not on_axis[-1].goes_in and not is_on(
            site.export.bone, site.canal, on_axis[-1].point, ON_SKIN_MM)


class Placed:
    """An entry of implants.json: its axis is told there, and what the axis meets follows from the bodies."""

    def __init__(self, site, told):
        self.site, self.told, self.tip = site, told, tuple(told["tip_in_bone_mm"])
        way = sub(self.tip, told["entry_in_bone_mm"])
        self.direction = scaled(way, 1 / length(way))
        head = sub(self.tip, scaled(self.direction, told["length_mm"]))
        met = [each for each in (Met(site, body, head, self.tip) for body in site.bodies) if each.entry_mm is not None]
        self.entry = add(head, scaled(self.direction, min((each.entry_mm for each in met), default=0.0)))
        self.engages = {each.body.name for each in met if each.engaged_mm >= ENGAGED_MM}
        self.cortices = sum(each.cortices for each in met)
        last = max(met, key=lambda each: each.last_mm, default=None)
        self.protrusion_mm = told["length_mm"] - last.last_mm if last and last.comes_out else 0.0

    def tip_to_joint_mm(self):
        """Joint surfaces go along with the bodies that they are on."""
        least = None
        for body in self.site.bodies:
            piece_from_bone = body.pose.inverse()
            axis = piece_from_bone.point(self.entry), piece_from_bone.point(self.tip)
            away = sorted((segment_to_triangle_mm(*axis, *corners), corners) for corners in self.site.joint_triangles)
            nearest = next((mm for mm, corners in away if body.has_triangle(corners)), None)
            if nearest is not None and (least is None or nearest < least):
                least = nearest
        return least


def fragment_metrics(site, fragment):
    """The first table."""
    body = site.body_of(fragment)
    if body is None:
        absent = dict.fromkeys(("shift_mm", "shift_error_mm", "turn_error_deg", "elevation_mm", "fixed"))
        return {**absent, "shifted": 0}
    planned, centroid = pose_from_matrix(fragment["pose"]), body.volume_and_centroid[1]
    off = sub(body.pose.point(centroid), planned.point(centroid))
    gone, way = sub(body.pose.point(centroid), centroid), sub(planned.point(centroid), centroid)
    return {"shift_mm": length(gone),
            "shift_error_mm": length(off),
            "turn_error_deg": turn_deg(planned.inverse().after(body.pose)),
            "elevation_mm": dot(off, fragment["dorsal_in_bone"]),
            "shifted": 1 if 2 * dot(gone, way) >= dot(way, way) else 0,
            "fixed": 1 if is_fixed(site, body.name) else 0}


def turn_deg(pose):
    """A rotation turns by the arc tangent of its skew part over its trace."""
    (_, xy, xz), (yx, _, yz), (zx, zy, _) = pose.rows
    twice_sine = length((zy - yz, xz - zx, yx - xy))
    return math.degrees(math.atan2(twice_sine, sum(pose.rows[axis][axis] for axis in range(3)) - 1))


def is_fixed(site, name):
    """A screw, or two wires that are not parallel, through it and through another body."""
    through = [placed for placed in site.placed if name in placed.engages and len(placed.engages) > 1]
    wires = [placed.direction for placed in through if placed.told["kind"] == "wire"]
    least_sine = math.sin(math.radians(PARALLEL_DEG))
    is_crossed = any(length(cross(one, other)) > least_sine for one in wires for other in wires)
    return is_crossed or any(placed.told["kind"] == "screw" for placed in through)


def assigned(site, implants):
    """By the name of the planned one: what lies there stands for that of its kind whose two ends are nearest."""
    def ends_off_mm(placed, planned):
        ends = (placed.entry, planned["entry_in_bone_mm"]), (placed.tip, planned["tip_in_bone_mm"])
        return sum(length(sub(lies, wanted)) for lies, wanted in ends)

    pairs = [(ends_off_mm(placed, planned), placed, planned["name"]) for planned in implants
             for placed in site.placed if planned["kind"] == placed.told["kind"]]
    found = {}
    for _, placed, name in sorted(pairs, key=lambda pair: pair[0]):
        if name not in found and placed not in found.values():
            found[name] = placed
    return found


def is_unknown(export, name):
    """It was to come out, and something was taken."""
    is_temporary = any(planned["name"] == name and planned["temporary"] for planned in export.plan.get("implants", []))
    return is_temporary and bool(export.events_of(IMPLANT_TAKEN))


def implant_metrics(placed, planned):
    """The second table."""
    direction = tuple(planned["direction"])
    off = sub(placed.entry, planned["entry_in_bone_mm"])
    way = sub(placed.tip, placed.entry)
    (shortest, longest), (thinnest, thickest) = planned["lengths_mm"], planned["diameters_mm"]
    return {"entry_mm": length(sub(off, scaled(direction, dot(off, direction)))),
            "direction_deg": math.degrees(angle_between(way, direction)),
            "tip_to_joint_mm": placed.tip_to_joint_mm(),
            "protrusion_mm": placed.protrusion_mm,
            "length_error_mm": max(0.0, shortest - length(way), length(way) - longest),
            "cortices": placed.cortices,
            "insertions": placed.told["insertions"],
            "right_tool": 1 if thinnest - SAME_MM < placed.told["diameter_mm"] < thickest + SAME_MM else 0}


def worst_of(rows):
    """Of each metric, among implants of which all are there."""
    found = {}
    for metric in rows[0]:
        values = [row[metric] for row in rows if row[metric] is not None]
        found[metric] = (min if metric in HIGHER_IS_BETTER else max)(values, default=None)
    return found


def group_metrics(steps, by_name):
    """Of alternative steps that which was carried out: all of it before some, more before less, the first of equals."""
    def is_set(step):
        return [by_name[name] is not None for name in step["implants"]]

    done = max(steps, key=lambda step: (all(is_set(step)), sum(is_set(step))))
    return worst_of([by_name[name] for name in done["implants"]]) if all(is_set(done)) else None


def metrics_of_implants(site, implants):
    """Of each by its name, and of each group of alternative steps by its; None where it was not set."""
    placed = assigned(site, implants)
    by_name = {each["name"]: implant_metrics(placed[each["name"]], each) if each["name"] in placed else None
               for each in implants}
    groups = {}
    for step in site.export.scenario["steps"]:
        if implants and step.get("implants") and step.get("one_of"):
            groups.setdefault(step["one_of"], []).append(step)
    return by_name | {group: group_metrics(steps, by_name) for group, steps in groups.items()}


def fixation_metrics(export):
    """None in exports of older programs, which knew no fragments."""
    found, site = {}, Site(export)
    for fragment in export.plan.get("fragments", []):
        found |= {(metric, fragment["name"]): value for metric, value in fragment_metrics(site, fragment).items()}
    for name, metrics in metrics_of_implants(site, export.plan.get("implants", [])).items():
        if not is_unknown(export, name):
            found |= {(metric, name): value for metric, value in (metrics or dict.fromkeys(OF_IMPLANTS)).items()}
    return found
