"""Kerfs and the finished faces that they left: docs/metrics.md, "What is measured", "Faces", "Silver" and "Akin"."""

import functools
import math

from outsider.export import CUTTING, HINGE_CLOSED, PLANE_FROZEN, STEP_DONE, STEP_REOPENED
from outsider.geometry import (Plane, add, angle_between, cross, dot, fitted_plane, length, percentile, scaled, sub)
from outsider.work import break_throughs

# Kinds of steps in which a planned face is sawn.
SAWN = ("cut", "trim")
# A wall is exact but for the rounding of the cut.
ON_WALL_MM = 1e-6
X = (1.0, 0.0, 0.0)


def cut_at_hand(export, kerf):
    """ "Which face": the cut whose step was at hand when a tenth of the kerf's sawing was over."""
    steps = {index: step["cut"] for index, step in enumerate(export.scenario["steps"]) if step["kind"] in SAWN}
    told = [event for event in export.events if event.kind in (STEP_DONE, STEP_REOPENED) and event.subject in steps]
    if all(event.kind != STEP_DONE for event in told):
        return None
    sawn = [sample.tick for sample in export.samples if sample.kerf == kerf and sample.status & CUTTING]
    frozen = export.events_of(PLANE_FROZEN)[kerf].tick
    tick = sawn[math.ceil(len(sawn) / 10) - 1] if sawn else frozen
    done, reopened = set(), None
    for event in told:
        if event.tick > tick:
            break
        if event.kind == STEP_REOPENED:
            done.discard(event.subject)
            reopened = event.subject
        else:
            done.add(event.subject)
            reopened = None if reopened == event.subject else reopened
    later = [event.subject for event in told
             if event.tick > tick and event.kind == STEP_DONE and event.subject not in done]
    at_hand = [reopened] if reopened is not None else later + [step for step in steps if step not in done]
    return steps[at_hand[0]] if at_hand else None


def misfit(export, kerf, cut):
    """A degree counts as a millimetre."""
    plane, pose = export.planned_plane(cut), export.kerfs[kerf]
    angle = angle_between(pose.axis(2), plane.normal)
    return math.degrees(min(angle, math.pi - angle)) + abs(plane.height_mm(pose.place))


def kerfs_of_cuts(export):
    """Without the rule for wedges of which all kerfs fall to one cut: it asks for how much of each was sawn, which an export
    does not tell."""
    names = [cut["name"] for cut in export.plan["cuts"]]
    found = {name: [] for name in names}
    for kerf in range(len(export.kerfs)):
        cut = cut_at_hand(export, kerf) or min(names, key=lambda name: misfit(export, kerf, name))
        found[cut].append(kerf)
    return found


class Face:
    """The wall of one kerf on the side that the plan keeps, on the largest piece that has it."""

    def __init__(self, export, cut, kerf):
        self.export, self.kerf, self.blade = export, kerf, export.blades_of_kerfs[kerf]
        self.bone_from_kerf = export.kerfs[kerf]
        self.side = -1.0 if dot(self.bone_from_kerf.axis(2), export.planned_plane(cut).normal) >= 0.0 else 1.0
        self.normal = scaled(self.bone_from_kerf.axis(2), -self.side)
        self.wall_mm = self.side * 0.5 * self.blade["kerf_mm"]
        sampled = ((number, *self.sampled(self.walls_on(piece))) for number, piece in enumerate(export.pieces))
        # What is too narrow for a sample, as where a hinge is divided, is no wall.
        self.piece, self.nodes, self.step_mm = next((found for found in sampled if found[1]), (None, {}, 0.25))
        self.samples = [self.bone_from_kerf.point((u * self.step_mm, v * self.step_mm, height))
                        for (u, v), height in sorted(self.nodes.items())]
        self.area_mm2 = len(self.samples) * self.step_mm**2
        self.plane = fitted_plane(self.samples, self.normal) if self.samples else None

    def walls_on(self, mesh):
        kerf_from_bone = self.bone_from_kerf.inverse()
        row, offset = kerf_from_bone.rows[2], kerf_from_bone.place[2] - self.wall_mm
        is_on = [abs(dot(row, point) + offset) <= ON_WALL_MM for point in mesh.points]
        return [tuple(kerf_from_bone.point(mesh.points[corner]) for corner in triangle)
                for triangle in mesh.triangles if is_on[triangle[0]] and is_on[triangle[1]] and is_on[triangle[2]]]

    @staticmethod
    def sampled(walls):
        """ "Samples": a 0.25 mm grid, halved down to 0.05 mm where it gives fewer than 200."""
        step_mm = 0.25
        nodes = heights_over(walls, step_mm)
        while nodes and len(nodes) < 200 and 0.5 * step_mm >= 0.05:
            step_mm *= 0.5
            nodes = heights_over(walls, step_mm)
        return {node: heights[0] for node, heights in nodes.items()}, step_mm

    @functools.cached_property
    def flatness_mm(self):
        """Row flatness_mm: taken from the blade, the ends and the middle of the tooth line."""
        teeth = [(0.0, share * self.blade["width_mm"], 0.0) for share in (-0.5, 0.0, 0.5)]
        points = []
        for sample in self.export.samples:
            if sample.kerf == self.kerf and sample.status & CUTTING:
                bone_from_tool = self.export.bone_from_tool(sample)
                points += [bone_from_tool.point(tooth) for tooth in teeth]
        plane = fitted_plane(points, X)
        distances = plane.heights_mm(points)
        return percentile(distances, 0.975) - percentile(distances, 0.025)

    def thicknesses_mm(self):
        """Row thickness_mm: from each sample along the normal to the bone's surface as it was, which lies over the same nodes
        of the grid, for the fitted plane is the kerf's wall to about 1e-9."""
        kerf_from_bone = self.bone_from_kerf.inverse()
        points = [kerf_from_bone.point(point) for point in self.export.bone.points]
        above = [tuple(points[corner] for corner in triangle) for triangle in self.export.bone.triangles
                 if any(self.side * points[corner][2] < self.side * self.wall_mm for corner in triangle)]
        over = heights_over(above, self.step_mm)
        return [min((way for height in over.get(node, ()) if (way := self.side * (wall - height)) > 0.0), default=0.0)
                for node, wall in self.nodes.items()]


def heights_over(triangles, step_mm):
    """The heights of all triangles over each node of a grid, in the order of the triangles."""
    nodes = {}
    for a, b, c in triangles:
        twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if twice == 0.0:
            continue
        low = [math.ceil(min(a[axis], b[axis], c[axis]) / step_mm) for axis in (0, 1)]
        high = [math.floor(max(a[axis], b[axis], c[axis]) / step_mm) for axis in (0, 1)]
        for u in range(low[0], high[0] + 1):
            for v in range(low[1], high[1] + 1):
                x, y = u * step_mm - a[0], v * step_mm - a[1]
                of_b = (x * (c[1] - a[1]) - y * (c[0] - a[0])) / twice
                of_c = ((b[0] - a[0]) * y - (b[1] - a[1]) * x) / twice
                if min(of_b, of_c, 1 - of_b - of_c) >= -1e-9:
                    nodes.setdefault((u, v), []).append((1 - of_b - of_c) * a[2] + of_b * b[2] + of_c * c[2])
    return nodes


def faces_of_cuts(export, kerfs_of_cut):
    """By cut, the face that counts first: on the largest piece, then of the greatest area. Of cuts that were finished."""
    return {cut: sorted((Face(export, cut, kerf) for kerf in kerfs), key=lambda face: (
        math.inf if face.piece is None else face.piece, -face.area_mm2)) for cut, kerfs in kerfs_of_cut.items()}


def counting(faces):
    """The face of a cut that counts, in a list of its own; none where no wall stands on a piece."""
    return [face for face in faces[:1] if face.plane]


def distal(plane):
    return plane if plane.normal[0] >= 0.0 else plane.turned()


def transverse_deg(plane):
    return math.degrees(math.atan2(plane.normal[2], plane.normal[0]))


def sagittal_deg(plane):
    return math.degrees(math.atan2(plane.normal[1], plane.normal[0]))


def is_ledge(face, other):
    """Row ledges_count."""
    heights = [abs(face.plane.height_mm(sample)) for sample in other.samples]
    return bool(heights) and sum(heights) / len(heights) > 0.5


def partner_of(export, cut):
    """Row included_angle_deg: the first other cut that is planned to contain the same direction within 0.1 degrees."""
    for other in export.plan["cuts"]:
        if other["name"] != cut["name"] and length(cross(other["contains"], cut["contains"])) <= 1.75e-3:
            return other["name"]
    return None


def included_deg(one, other, planned_deg=0.0):
    sharp = math.degrees(math.acos(min(1.0, abs(dot(one, other)))))
    return min(sharp, 180.0 - sharp, key=lambda angle: abs(angle - planned_deg))


def axis_metrics(export, cut, planned, face, faces_of_cut):
    leaves = math.asin(min(1.0, abs(dot(face.plane.normal, cut["contains"]))))
    found = {"common_axis_deg": math.degrees(leaves), "included_angle_deg": None}
    partner = partner_of(export, cut)
    other = counting(faces_of_cut[partner]) if partner else []
    if other:
        planned_deg = included_deg(planned.normal, export.planned_plane(partner).normal)
        found["included_angle_deg"] = included_deg(face.plane.normal, other[0].plane.normal, planned_deg)
    return found


def overhang_mm(export, cut, planned):
    """Row overhang_mm: the corners of what is left between depth point and exit, and where edges cross those ends."""
    depth, exit_ = cut["depth_in_bone_mm"], cut["exit_in_bone_mm"]
    along = scaled(sub(exit_, depth), 1 / length(sub(exit_, depth)))
    ends = dot(along, depth), dot(along, exit_)
    most = 0.0
    for mesh in export.bodies_as_they_lie():
        beyond = [planned.height_mm(point) for point in mesh.points]
        at = [dot(along, point) for point in mesh.points]
        for triangle in mesh.triangles:
            for one, other in zip(triangle, triangle[1:] + triangle[:1]):
                if beyond[one] <= most and beyond[other] <= most:
                    continue
                if ends[0] <= at[one] <= ends[1]:
                    most = max(most, beyond[one])
                for end in ends:
                    if (at[one] < end) != (at[other] < end):
                        share = (end - at[one]) / (at[other] - at[one])
                        most = max(most, beyond[one] + share * (beyond[other] - beyond[one]))
    return most


def lies_along_bone(cut):
    """Older programs knew faces of format 1 alone, and did not say it."""
    return cut.get("along_bone", cut["kind"] == "along_axis")


def is_sawn_as_planned(export, cut, kerfs):
    """Row right_tool: where a blade is planned, each kerf was sawn with it."""
    if cut.get("blade") is None:
        return True
    place = [blade["name"] for blade in export.blades].index(cut["blade"])
    return all(tool == place for sample, tool in zip(export.samples, export.tools)
               if sample.kerf in kerfs and sample.status & CUTTING)


def exit_mm(cut, face, planned, towards):
    """Row exit_mm: a cut across the bone without a hinge has none."""
    if not lies_along_bone(cut) and cut["hinge"] is None:
        return None
    exit_ = cut["exit_in_bone_mm"]
    return face.plane.way_mm(exit_, towards) - planned.way_mm(exit_, towards)


def cut_metrics(export, name, faces, faces_of_cut):
    """The tables of "Faces" and "Silver"."""
    cut, planned, face = export.cut(name), export.planned_plane(name), faces[0]
    is_along = lies_along_bone(cut)
    towards = planned.normal if is_along else X
    entry, kerfs = cut["entry_in_bone_mm"], [each.kerf for each in faces]
    distances = [planned.height_mm(sample) for sample in face.samples]
    found = {"angle_deg": math.degrees(angle_between(face.plane.normal, planned.normal)),
             "location_mm": max(map(abs, distances)),
             "mean_mm": sum(map(abs, distances)) / len(distances),
             "rms_mm": math.sqrt(sum(distance**2 for distance in distances) / len(distances)),
             "entry_mm": face.plane.way_mm(entry, towards) - planned.way_mm(entry, towards),
             "exit_mm": exit_mm(cut, face, planned, towards),
             "flatness_mm": face.flatness_mm,
             "ledges_count": sum(is_ledge(face, other) for other in faces[1:])}
    found["plunge_mm"], found["breakthrough_newton"], found["breakthrough_mm_s"] = break_throughs(export, kerfs)
    found |= axis_metrics(export, cut, planned, face, faces_of_cut)
    found["right_tool"] = 1 if is_sawn_as_planned(export, cut, kerfs) else 0
    if is_along:
        found |= resection_metrics(cut, planned, faces)
        found["overhang_mm"] = overhang_mm(export, cut, planned)
    else:
        made, plan = distal(face.plane), distal(planned)
        found["transverse_tilt_deg"] = transverse_deg(made) - transverse_deg(plan)
        found["sagittal_tilt_deg"] = sagittal_deg(made) - sagittal_deg(plan)
    return {(metric, name): value for metric, value in found.items()}


def resection_metrics(cut, planned, faces):
    """ "Silver": the first face is judged, the worst of all finished ones did the harm."""
    def off_mm(face, point):
        return face.plane.way_mm(point, planned.normal) - planned.way_mm(point, planned.normal)

    depth, exit_ = cut["depth_in_bone_mm"], cut["exit_in_bone_mm"]
    stand = [face for face in faces if face.plane]
    return {"depth_mm": abs(off_mm(faces[0], depth)),
            "step_mm": abs(off_mm(faces[0], exit_)),
            "past_landmark_mm": max(max(0.0, -face.plane.way_mm(depth, planned.normal)) for face in stand),
            "notch_mm": max(max(0.0, -off_mm(face, exit_)) for face in stand)}


def wedge_metrics(export, hinge, first, second):
    """The table of "Akin"."""
    faces = distal(first.plane), distal(second.plane)
    plans = [distal(export.planned_plane(hinge[key])) for key in ("first_cut", "second_cut")]
    entry = export.cut(hinge["first_cut"])["entry_in_bone_mm"]

    def wedge_deg(planes):
        return transverse_deg(planes[1]) - transverse_deg(planes[0])

    def lean_deg(planes):
        return sagittal_deg(planes[1]) - sagittal_deg(planes[0])

    def base_mm(planes):
        return planes[1].way_mm(entry, X) - planes[0].way_mm(entry, X)

    point = hinge["point_in_bone_mm"]
    meets = cross(faces[0].normal, faces[1].normal)
    axis = scaled(meets, 1 / length(meets))
    angle = angle_between(axis, hinge["axis"])
    found = {"wedge_error_deg": abs(wedge_deg(faces) - wedge_deg(plans)),
             "wedge_sagittal_deg": abs(lean_deg(faces) - lean_deg(plans)),
             "wedge_reversed": 1 if wedge_deg(faces) * wedge_deg(plans) < 0.0 else 0,
             "base_mm": math.copysign(1.0, base_mm(plans)) * base_mm(faces),
             "apex_offset_mm": length(cross(axis, sub(point, point_of_line(*faces)))),
             "apex_angle_deg": math.degrees(min(angle, math.pi - angle)),
             "flatness_mm": max(face.flatness_mm for face in (first, second))}
    return {(metric, hinge["name"]): value for metric, value in found.items()}


def point_of_line(one, other):
    """The point nearest to the origin of the line in which two planes meet."""
    axis = cross(one.normal, other.normal)
    return scaled(add(scaled(cross(other.normal, axis), one.offset_mm), scaled(cross(axis, one.normal), other.offset_mm)),
                  1 / dot(axis, axis))


def closing_metrics(export, hinge, first, second):
    """The table of what closing the wedge is measured by. `first` and `second` hold one face, or none."""
    names = ("correction_deg", "shortening_mm", "gap_mm", "contact_share")
    closed = export.events_of(HINGE_CLOSED)
    if not closed or not first or not second:
        return {(name, hinge["name"]): None for name in names}
    bone_from_moved = closed[-1].pose()
    planned = [transverse_deg(distal(export.planned_plane(hinge[key]))) for key in ("first_cut", "second_cut")]
    turned_deg = transverse_deg(Plane(bone_from_moved.axis(0), 0.0))
    end_mm = max(point[0] for point in export.bone.points)
    face = second[0].plane
    normal = bone_from_moved.direction(face.normal)
    turned = Plane(normal, dot(normal, bone_from_moved.point(scaled(face.normal, face.offset_mm))))
    apart = [turned.height_mm(sample) for sample in first[0].samples]
    values = (turned_deg if planned[0] >= planned[1] else -turned_deg,
              end_mm - length(bone_from_moved.point((end_mm, 0.0, 0.0))),
              max(0.0, *apart), sum(way <= 0.2 for way in apart) / len(apart))
    return {(name, hinge["name"]): value for name, value in zip(names, values)}


def piece_metrics(export, faces_of_cut):
    """ "Faces", rows thickness_mm and thickness_max_mm, of what a step removes."""
    hinges = {hinge["name"]: hinge for hinge in export.plan["hinges"]}
    found = {}
    for step in export.scenario["steps"]:
        if step["kind"] != "remove":
            continue
        cuts = [hinges[step["hinge"]][key] for key in ("first_cut", "second_cut")] if "hinge" in step else [step["cut"]]
        about = step.get("hinge") or step["cut"]
        faces = [face for cut in cuts for face in counting(faces_of_cut[cut])]
        if len(faces) < len(cuts):
            continue
        if len(faces) == 2:
            ways = [max(0.0, faces[1].plane.way_mm(sample, faces[0].plane.normal)) for sample in faces[0].samples]
        else:
            ways = faces[0].thicknesses_mm()
        found["thickness_mm", about] = sum(ways) / len(ways)
        found["thickness_max_mm", about] = max(ways)
    return found
