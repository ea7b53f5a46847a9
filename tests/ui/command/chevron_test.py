#!/usr/bin/env python3
"""A chevron from end to end, as a script sees it: carried out by the hand without errors, replayed, told, exported; and what
was exported lies as it may lie, by code that shares nothing with the program's.
"""

import json
import math
import unittest

from hallux_command import DONE, SHIPPED, CommandTest
from outsider.export import Export, read_ply
from outsider.geometry import cross, dot, length, sub


def volume_mm3(mesh):
    six = sum(dot(mesh.points[a], cross(mesh.points[b], mesh.points[c])) for a, b, c in mesh.triangles)
    return six / 6


class Solid:
    """A closed mesh in columns along x, each with the triangles above its square of y and z."""

    def __init__(self, mesh, cell_mm=0.5):
        self.mesh, self.cell_mm, self.columns = mesh, cell_mm, {}
        for triangle in mesh.triangles:
            corners = [mesh.points[corner] for corner in triangle]
            for column in self.columns_of([corner[1] for corner in corners], [corner[2] for corner in corners]):
                self.columns.setdefault(column, []).append(corners)

    def columns_of(self, ys, zs):
        low = [math.floor(min(values) / self.cell_mm) for values in (ys, zs)]
        high = [math.floor(max(values) / self.cell_mm) for values in (ys, zs)]
        return [(y, z) for y in range(low[0], high[0] + 1) for z in range(low[1], high[1] + 1)]

    def holds(self, point):
        """By the parity of the surfaces ahead along x."""
        column = math.floor(point[1] / self.cell_mm), math.floor(point[2] / self.cell_mm)
        ahead = 0
        for a, b, c in self.columns.get(column, ()):
            if max(a[0], b[0], c[0]) < point[0]:
                continue
            twice = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])
            if twice == 0.0:
                continue
            of_b = ((point[1] - a[1]) * (c[2] - a[2]) - (point[2] - a[2]) * (c[1] - a[1])) / twice
            of_c = ((b[1] - a[1]) * (point[2] - a[2]) - (b[2] - a[2]) * (point[1] - a[1])) / twice
            if min(of_b, of_c, 1.0 - of_b - of_c) >= 0.0:
                ahead += (1.0 - of_b - of_c) * a[0] + of_b * b[0] + of_c * c[0] > point[0]
        return ahead % 2 == 1

    def depth_mm(self, point, most_mm=3.0):
        """How far a point inside lies from the surface: the nearest of points spread over the triangles that are near."""
        nearest = most_mm
        for a, b, c in self.near(point, most_mm):
            nearest = min(nearest, distance_mm(point, a, b, c))
        return nearest

    def near(self, point, reach_mm):
        ys, zs = [(point[axis] - reach_mm, point[axis] + reach_mm) for axis in (1, 2)]
        return [corners for column in self.columns_of(ys, zs) for corners in self.columns.get(column, ())]


def distance_mm(point, a, b, c):
    """To a triangle: over its inside to its plane, else to the nearest of its edges."""
    normal = cross(sub(b, a), sub(c, a))
    size = length(normal)
    edges = [(a, b), (b, c), (c, a)]
    if size > 0.0 and all(dot(cross(sub(end, start), sub(point, start)), normal) >= 0.0 for start, end in edges):
        return abs(dot(sub(point, a), normal)) / size

    def to_edge(start, end):
        way, along = sub(point, start), sub(end, start)
        share = min(1.0, max(0.0, dot(way, along) / max(dot(along, along), 1e-300)))
        return length(tuple(w - share * d for w, d in zip(way, along)))

    return min(to_edge(start, end) for start, end in edges)


class Chevron(CommandTest):
    def operated(self):
        scenario = json.loads((SHIPPED / "chevron.json").read_text())
        scenario["patient"]["bones"][0]["edge_mm"] = 0.9
        file = self.folder / "chevron.json"
        file.write_text(json.dumps(scenario))
        return self.ask("attempt", file, "--hand", "perfect")

    def test_is_carried_out_told_and_replayed(self):
        told = self.operated()
        self.assertTrue(all(step["done"] for step in told["steps"]), told["steps"])
        head = next(body for body in told["fragments"] if body["name"] == "head")
        self.assertLess(abs(head["moved_mm"] - 5.1), 0.1)
        self.assertLess(head["error_mm"], 1.2)
        self.assertLess(head["error_deg"], 0.5)
        self.assertTrue(head["held"])
        self.assertLess(max(body["overlap_max_mm"] for body in told["fragments"]), 0.05)
        screw, = told["implants"]
        self.assertEqual([screw["kind"], screw["diameter_mm"], screw["insertions"]], ["screw", 2.7, 1])
        self.assertEqual(sorted(screw["engages"]), ["first_metatarsal", "head"])
        self.assertGreater(screw["tip_to_joint_mm"], 2.0)
        balance = told["balance"]
        self.assertLess(abs(balance["error_mm3"]), 1e-6 * balance["input_mm3"])
        self.assertTrue(self.ask("replay", told["attempt"])["identical"])
        self.expect_an_export_that_lies_apart(told)

    def expect_an_export_that_lies_apart(self, told):
        folder = self.folder / "exported"
        done = self.hallux("export", told["attempt"], "-o", folder)
        self.assertEqual(done.code, DONE, done)
        export = Export(folder / told["attempt"])
        self.assertEqual(json.loads((export.folder / "implants.json").read_text()), told["implants"])
        files = [file for body in export.fragments for file in body["files"]]
        pieces_mm3 = sum(volume_mm3(read_ply(export.folder / file)) for file in files)
        balance = told["balance"]
        left_mm3 = pieces_mm3 + balance["removed_mm3"] + balance["debris_mm3"]
        self.assertLess(abs(left_mm3 - volume_mm3(export.bone)), 1e-6 * left_mm3)
        solids = [Solid(mesh) for mesh in export.bodies_as_they_lie()]
        self.assertGreater(len(solids), 1)
        for body in solids:
            for other in solids:
                if body is not other:
                    self.expect_outside(body.mesh, other)

    def expect_outside(self, mesh, other):
        """Of the corners and the middles of triangles."""
        middles = [tuple(sum(mesh.points[corner][axis] for corner in triangle) / 3 for axis in range(3))
                   for triangle in mesh.triangles]
        for point in mesh.points + middles:
            if other.holds(point):
                self.assertLess(other.depth_mm(point), 0.05, point)


if __name__ == "__main__":
    unittest.main()
