"""Entries into the bone: docs/metrics.md, "How the work was done", row `restarts_count`."""

import math

from outsider.export import SAW_ON
from outsider.geometry import add, dot, scaled, sub

AWAY_MM = 3.0


def entries_of(export):
    """The kerf of each entry."""
    entries, last_kerf, left, furthest_mm = [], -1, None, 0.0
    for sample in export.samples:
        place = tuple(micrometres / 1000 for micrometres in sample.quanta[:3])
        if sample.kerf < 0:
            furthest_mm = max(furthest_mm, math.dist(place, left)) if left else 0.0
            continue
        if sample.kerf != last_kerf or furthest_mm > AWAY_MM:
            entries.append(sample.kerf)
        last_kerf, left, furthest_mm = sample.kerf, place, 0.0
    return entries


def needed_entries(export, kerf):
    """The passes that the section needs which the blade touched. It is that of the whole bone: what an earlier kerf took out of
    it changes its width along the teeth by less than a pass has to spare."""
    kerf_from_bone = export.kerfs[kerf].inverse()
    blade = export.blades_of_kerfs[kerf]
    width_mm, depth_mm = blade["width_mm"], blade["depth_mm"]
    # In 20 ms the blade moves by a small part of its size.
    poses = [kerf_from_bone.after(export.bone_from_tool(sample)) for sample in export.samples[::20]
             if sample.kerf == kerf and sample.status & SAW_ON]
    frames = [(pose.place, pose.axis(0), pose.axis(1)) for pose in poses]

    def is_under(frame, point):
        place, x, y = frame
        way = sub(point, place)
        return -depth_mm <= dot(way, x) <= 0.0 and abs(dot(way, y)) <= 0.5 * width_mm

    touched = [region for region in section_of(export.bone, kerf_from_bone, 0.5 * blade["kerf_mm"])
               if any(is_under(frame, point) for frame in frames for point in region)]
    across = [point[1] for region in touched for point in region]
    if not across:
        return 1
    return max(1, 1 + math.ceil((max(across) - min(across) + 2.0 - width_mm) / (width_mm - 1.0)))


def section_of(mesh, kerf_from_bone, half_mm):
    """The bone's skin within the kerf's slab: the corners of each connected part, in the kerf's frame."""
    points = [kerf_from_bone.point(point) for point in mesh.points]
    parent, corners = {}, {}

    def root(edge):
        while parent[edge] != edge:
            parent[edge] = parent[parent[edge]]
            edge = parent[edge]
        return edge

    for triangle in mesh.triangles:
        edges = [(min(a, b), max(a, b)) for a, b in zip(triangle, triangle[1:] + triangle[:1])]
        for edge in edges:
            if edge not in corners:
                corners[edge] = corners_within(points[edge[0]], points[edge[1]], half_mm)
        within = [edge for edge in edges if corners[edge]]
        for edge in within:
            parent.setdefault(edge, edge)
            parent[root(edge)] = root(within[0])
    regions = {}
    for edge in parent:
        regions.setdefault(root(edge), []).extend(corners[edge])
    return list(regions.values())


def corners_within(a, b, half_mm):
    """The ends of an edge that lie in the slab, and where it enters and leaves it."""
    found = [end for end in (a, b) if abs(end[2]) <= half_mm]
    for height in (-half_mm, half_mm):
        if (a[2] > height) != (b[2] > height):
            found.append(add(a, scaled(sub(b, a), (height - a[2]) / (b[2] - a[2]))))
    return found


def restarts_count(export, faces_of_cut):
    """The entries into each cut's kerfs beyond those that the section of the face that counts needs."""
    entries = entries_of(export)
    return sum(max(0, sum(entry in [face.kerf for face in faces] for entry in entries) - needed_entries(export, faces[0].kerf))
               for faces in faces_of_cut.values() if faces)
