"""Vectors, poses, planes and distances, with Python's standard library only.

A vector is a tuple of three numbers. A pose's name says from which frame to which it leads: `bone_from_tool.point(p)` says the
tool's point p in the bone's frame.
"""

import math


def add(a, b):
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def sub(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def scaled(a, factor):
    return a[0] * factor, a[1] * factor, a[2] * factor


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def length(a):
    return math.sqrt(dot(a, a))


class Pose:
    """A rotation, row by row, and a place [mm]."""

    def __init__(self, rows, place):
        self.rows, self.place = rows, place

    def direction(self, a):
        return dot(self.rows[0], a), dot(self.rows[1], a), dot(self.rows[2], a)

    def point(self, a):
        return add(self.direction(a), self.place)

    def axis(self, index):
        return self.rows[0][index], self.rows[1][index], self.rows[2][index]

    def after(self, other):
        """a_from_b.after(b_from_c) is a_from_c."""
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = other.rows
        rows = tuple((x * ax + y * bx + z * cx, x * ay + y * by + z * cy, x * az + y * bz + z * cz)
                     for x, y, z in self.rows)
        return Pose(rows, self.point(other.place))

    def inverse(self):
        back = Pose(tuple(zip(*self.rows)), (0.0, 0.0, 0.0))
        back.place = scaled(back.direction(self.place), -1.0)
        return back


def pose_from_quanta(quanta):
    """Of x, y, z in micrometres and a quaternion in millionths, which is brought to length 1 first."""
    w, x, y, z = quanta[3:]
    size = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / size, x / size, y / size, z / size
    rows = ((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))
    return Pose(rows, tuple(micrometres / 1000 for micrometres in quanta[:3]))


def pose_from_matrix(matrix):
    return Pose(tuple(tuple(row[:3]) for row in matrix[:3]), tuple(row[3] for row in matrix[:3]))


class Plane:
    """Points p with normal . p = offset; `normal` has length 1."""

    def __init__(self, normal, offset_mm):
        self.normal, self.offset_mm = normal, offset_mm

    def height_mm(self, point):
        return dot(self.normal, point) - self.offset_mm

    def heights_mm(self, points):
        x, y, z = self.normal
        return [x * point[0] + y * point[1] + z * point[2] - self.offset_mm for point in points]

    def way_mm(self, point, direction):
        """How far one goes from the point along a direction to meet the plane."""
        return -self.height_mm(point) / dot(self.normal, direction)

    def turned(self):
        return Plane(scaled(self.normal, -1.0), -self.offset_mm)


def angle_between(a, b):
    return math.atan2(length(cross(a, b)), dot(a, b))


def percentile(values, share):
    """Linear between order statistics."""
    ordered = sorted(values)
    rank = share * (len(ordered) - 1)
    below = math.floor(rank)
    above = min(below + 1, len(ordered) - 1)
    return ordered[below] + (rank - below) * (ordered[above] - ordered[below])


def least_eigenvector(matrix):
    """Of a symmetric 3 x 3 matrix, by Jacobi's rotations."""
    a = [list(row) for row in matrix]
    vectors = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    for p, q in [(0, 1), (0, 2), (1, 2)] * 12:
        if a[p][q] == 0.0:
            continue
        turn = 0.5 * math.atan2(2 * a[p][q], a[q][q] - a[p][p])
        c, s = math.cos(turn), math.sin(turn)
        for row in a:
            row[p], row[q] = c * row[p] - s * row[q], s * row[p] + c * row[q]
        a[p], a[q] = ([c * x - s * y for x, y in zip(a[p], a[q])], [s * x + c * y for x, y in zip(a[p], a[q])])
        for row in vectors:
            row[p], row[q] = c * row[p] - s * row[q], s * row[p] + c * row[q]
    least = min(range(3), key=lambda index: a[index][index])
    return tuple(row[least] for row in vectors)


def moments_about(origin, points):
    """Count, sums of the ways from the origin, and of their squares and products."""
    x0, y0, z0 = origin
    sx = sy = sz = xx = yy = zz = xy = xz = yz = 0.0
    for x, y, z in points:
        x, y, z = x - x0, y - y0, z - z0
        sx += x
        sy += y
        sz += z
        xx += x * x
        yy += y * y
        zz += z * z
        xy += x * y
        xz += x * z
        yz += y * z
    return len(points), sx, sy, sz, xx, yy, zz, xy, xz, yz


def least_squares_plane(origin, moments):
    """The origin lies among the points, so that little is lost between their squares and those of the centre."""
    count, sx, sy, sz, xx, yy, zz, xy, xz, yz = moments
    x, y, z = sx / count, sy / count, sz / count
    xx, yy, zz = xx - sx * x, yy - sy * y, zz - sz * z
    xy, xz, yz = xy - sx * y, xz - sx * z, yz - sy * z
    normal = least_eigenvector(((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)))
    return Plane(normal, dot(normal, add(origin, (x, y, z))))


def fitted_plane(points, side):
    """docs/metrics.md, "What is measured", Fitted plane. Of those that are left out the moments are taken from all."""
    origin = scaled(tuple(math.fsum(axis) for axis in zip(*points)), 1 / len(points))
    of_all = moments_about(origin, points)
    used, plane = range(len(points)), least_squares_plane(origin, of_all)
    for _ in range(20):
        heights_mm = plane.heights_mm(points)
        sigma_mm = math.sqrt(math.fsum(heights_mm[index] ** 2 for index in used) / len(used))
        if sigma_mm < 1e-9:
            break
        limit_mm = 2.5 * sigma_mm
        kept = [index for index, height_mm in enumerate(heights_mm) if -limit_mm <= height_mm <= limit_mm]
        if len(kept) == len(used):
            break
        beyond = [point for point, height_mm in zip(points, heights_mm) if abs(height_mm) > limit_mm]
        used, left_out = kept, moments_about(origin, beyond)
        plane = least_squares_plane(origin, [whole - part for whole, part in zip(of_all, left_out)])
    return plane if dot(plane.normal, side) >= 0.0 else plane.turned()


def distance_to_segment(point, from_, to):
    along = sub(to, from_)
    share = dot(sub(point, from_), along) / dot(along, along)
    return length(sub(point, add(from_, scaled(along, min(1.0, max(0.0, share))))))


def distance_of_crossing_lines(a, b, c, d):
    """Between the lines a b and c d, where both feet lie within the segments; else infinite."""
    along, other, between = sub(b, a), sub(d, c), sub(c, a)
    aa, bb, ab = dot(along, along), dot(other, other), dot(along, other)
    size = aa * bb - ab * ab
    if size <= 0.0:
        return math.inf
    ar, br = dot(along, between), dot(other, between)
    share, share_of_other = (ar * bb - ab * br) / size, (ar * ab - br * aa) / size
    if not (0.0 <= share <= 1.0 and 0.0 <= share_of_other <= 1.0):
        return math.inf
    return length(sub(add(between, scaled(other, share_of_other)), scaled(along, share)))


def distance_to_triangle(point, a, b, c):
    """To the foot on its plane where that lies within, else to its nearest edge."""
    normal = cross(sub(b, a), sub(c, a))
    size = dot(normal, normal)
    inside = size > 0.0 and all(
        dot(cross(sub(to, from_), sub(point, from_)), normal) >= 0.0 for from_, to in ((a, b), (b, c), (c, a)))
    if inside:
        return abs(dot(sub(point, a), normal)) / math.sqrt(size)
    return min(distance_to_segment(point, from_, to) for from_, to in ((a, b), (b, c), (c, a)))
