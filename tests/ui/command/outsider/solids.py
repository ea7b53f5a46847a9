"""Closed meshes: volume, centroid, what a line meets of them, and how near a segment comes to their triangles."""

from outsider.geometry import (add, cross, distance_of_crossing_lines, distance_to_segment, distance_to_triangle, dot,
                               length, scaled, sub)


def volume_and_centroid(mesh):
    """By the tetrahedra from one corner."""
    origin = mesh.points[0]
    six, sums = 0.0, (0.0, 0.0, 0.0)
    for triangle in mesh.triangles:
        a, b, c = (sub(mesh.points[corner], origin) for corner in triangle)
        part = dot(a, cross(b, c))
        six += part
        sums = add(sums, scaled(add(add(a, b), c), part))
    return six / 6, add(origin, scaled(sums, 1 / (4 * six)))


class Crossing:
    """`way_mm` is from the line's first point; `goes_in` where the line comes into the solid."""

    def __init__(self, way_mm, goes_in, point):
        self.way_mm, self.goes_in, self.point = way_mm, goes_in, point


def square_to(direction):
    """Two unit directions square to it and to each other."""
    least = min(range(3), key=lambda axis: abs(direction[axis]))
    one = cross(direction, tuple(float(axis == least) for axis in range(3)))
    one = scaled(one, 1 / length(one))
    return one, cross(direction, one)


def crossings_of_line(mesh, from_, to):
    """In the order in which the endless line meets them."""
    along = scaled(sub(to, from_), 1 / length(sub(to, from_)))
    u, v = square_to(along)
    xs = [dot(u, point) - dot(u, from_) for point in mesh.points]
    found = []
    for triangle in mesh.triangles:
        x = [xs[corner] for corner in triangle]
        if min(x) > 0.0 or max(x) < 0.0:
            continue
        corners = [mesh.points[corner] for corner in triangle]
        y = [dot(v, corner) - dot(v, from_) for corner in corners]
        of_corner = [x[second] * y[third] - x[third] * y[second] for second, third in ((1, 2), (2, 0), (0, 1))]
        twice = sum(of_corner)
        if twice == 0.0 or min(share / twice for share in of_corner) < 0.0:
            continue
        way_mm = sum(share / twice * dot(along, sub(corner, from_)) for share, corner in zip(of_corner, corners))
        found.append(Crossing(way_mm, twice < 0.0, add(from_, scaled(along, way_mm))))
    return sorted(found, key=lambda crossing: crossing.way_mm)


def holds(mesh, point):
    """By the parity of the surfaces ahead."""
    ahead = crossings_of_line(mesh, point, add(point, (0.6, 0.48, 0.64)))
    return sum(crossing.way_mm > 0.0 for crossing in ahead) % 2 == 1


def is_on(mesh, triangles, point, within_mm):
    """Whether one of the triangles is so near."""
    for triangle in triangles:
        corners = [mesh.points[corner] for corner in triangle]
        if all(min(corner[axis] for corner in corners) - within_mm <= point[axis] <=
               max(corner[axis] for corner in corners) + within_mm for axis in range(3)):
            if distance_to_triangle(point, *corners) <= within_mm:
                return True
    return False


def outer_triangles(mesh):
    """Of a bone those of its outer skin: of the part that reaches furthest distal; the rest is the marrow's canal."""
    parent = list(range(len(mesh.points)))

    def root(corner):
        while parent[corner] != corner:
            parent[corner] = parent[parent[corner]]
            corner = parent[corner]
        return corner

    for a, b, c in mesh.triangles:
        parent[root(b)] = root(a)
        parent[root(c)] = root(a)
    outer = root(max(range(len(mesh.points)), key=lambda corner: mesh.points[corner][0]))
    return [triangle for triangle in mesh.triangles if root(triangle[0]) == outer]


def goes_through(from_, to, a, b, c):
    way, one, other = sub(to, from_), sub(b, a), sub(c, a)
    normal = cross(one, other)
    across = -dot(way, normal)
    if across == 0.0:
        return False
    start = sub(from_, a)
    turned = cross(start, way)
    on_one, on_other = dot(other, turned) / across, -dot(one, turned) / across
    return 0.0 <= dot(start, normal) / across <= 1.0 and min(on_one, on_other, 1.0 - on_one - on_other) >= 0.0


def segment_to_triangle_mm(from_, to, a, b, c):
    """0 where it goes through; else the nearest pair holds an end of the segment or a corner, or lies within edges."""
    if goes_through(from_, to, a, b, c):
        return 0.0
    ends = [distance_to_triangle(end, a, b, c) for end in (from_, to)]
    corners = [distance_to_segment(corner, from_, to) for corner in (a, b, c)]
    edges = [distance_of_crossing_lines(from_, to, *edge) for edge in ((a, b), (b, c), (c, a))]
    return min(ends + corners + edges)
