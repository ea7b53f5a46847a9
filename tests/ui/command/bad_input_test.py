#!/usr/bin/env python3
"""Meshes and sweeps that nobody should trust: one sentence with the file and the mend, exit 3, nothing written."""

import struct
import unittest

from hallux_command import BAD_INPUT, CommandTest
from small_meshes import block, block_ply, ply_text

TEN_MILLION = 10_000_000


def binary_header(vertices, faces):
    return (f"ply\nformat binary_little_endian 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\n"
            f"property float z\nelement face {faces}\nproperty list uchar int vertex_indices\nend_header\n").encode()


class BadMesh(CommandTest):
    def setUp(self):
        super().setUp()
        self.points, self.triangles = block(30, 14, 12)

    def refuse(self, name, content, *says):
        """`hallux cut` refuses the file in one sentence, and leaves no folder and no data directory."""
        file = self.folder / name
        file.write_bytes(content.encode() if isinstance(content, str) else content)
        self.refuse_file(file, *says)

    def refuse_file(self, file, *says):
        out = self.folder / "out"
        self.expect_refusal(BAD_INPUT, [file.name, *says], "cut", file, "--plane", "1,0,0,0", "--kerf", "0.5", "-o", out)
        self.assertFalse(out.exists())
        self.assertFalse(self.data.exists())

    def test_an_open_mesh(self):
        self.refuse("open.ply", ply_text(self.points, self.triangles[1:]), "3 edges", "closed")

    def test_a_mesh_with_three_triangles_at_an_edge(self):
        points = self.points + [(0.0, 0.0, 40.0)]
        fin = [(0, 1, 8), (1, 0, 8)]
        self.refuse("fin.ply", ply_text(points, self.triangles + fin), "edge")

    def test_a_triangle_that_looks_the_other_way(self):
        a, b, c = self.triangles[0]
        self.refuse("turned.ply", ply_text(self.points, [(a, c, b), *self.triangles[1:]]), "edge")

    def test_a_mesh_that_is_inside_out(self):
        self.refuse("inside_out.ply", ply_text(self.points, [t[::-1] for t in self.triangles]))

    def test_a_coordinate_that_is_not_a_number(self):
        for word in ("nan", "inf", "1e999"):
            with self.subTest(word=word):
                self.refuse("nan.ply", block_ply(30, 14, 12).replace("15.0", word, 1))
        facet = struct.pack("<12fH", *([0.0] * 3), float("nan"), *([1.0] * 8), 0)
        self.refuse("nan.stl", b"\0" * 80 + struct.pack("<I", 1) + facet)

    def test_zero_triangles(self):
        self.refuse("none.ply", ply_text(self.points, []), "no triangles")
        self.refuse("none.stl", b"\0" * 80 + struct.pack("<I", 0))
        self.refuse("none.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no triangles")
        self.refuse("nothing.stl", "", "empty")

    def test_counts_larger_than_the_file(self):
        self.refuse("few.stl", b"\0" * 80 + struct.pack("<I", 4_000_000) + b"\0" * 500)
        self.refuse("few.ply", binary_header(3, 4_000_000) + b"\0" * 500)
        self.refuse("cut_short.ply", block_ply(30, 14, 12)[:-30])

    def test_a_hostile_header_of_200_bytes(self):
        header = binary_header(4294967295, 4294967295)
        self.refuse("hostile.ply", header + b"\xff" * (200 - len(header)))
        self.refuse("endless.ply", b"ply\nformat ascii 1.0\n" + b"comment " + b"a" * 171)
        lists = b"ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty list uint double x\nend_header\n"
        self.refuse("long_list.ply", (lists + b"\xff" * 200)[:200])

    def test_a_text_named_stl(self):
        self.refuse("letter.stl", "Dear colleague,\nplease find the bone attached.\n")
        self.refuse("short.stl", "solid")

    def test_ten_million_triangles(self):
        file = self.folder / "huge.ply"
        header = binary_header(4, TEN_MILLION)
        with file.open("wb") as stream:
            stream.write(header)
            stream.truncate(len(header) + 4 * 12 + TEN_MILLION * 13)
        self.refuse_file(file, "10000000", "reduce the mesh")

    def test_an_unknown_kind_a_folder_and_a_file_that_is_not_there(self):
        self.refuse("bone.step", "ISO-10303-21;", ".stl")
        folder = self.folder / "bones.stl"
        folder.mkdir()
        self.refuse_file(folder, "folder")
        self.refuse_file(self.folder / "nowhere.ply", "no such file")


class BadMotion(CommandTest):
    """A hand that is a file goes through the same door."""

    def refuse(self, content, *says):
        file = self.write("hand.json", content)
        self.expect_refusal(BAD_INPUT, ["hand.json", *says], "attempt", "silver", "--hand", file)
        self.assertFalse(self.data.exists())

    def test_a_motion_that_cannot_be_used(self):
        key = {"time_s": 0, "tip_mm": [0, 0, 90], "direction": [1, 0, 0], "normal": [0, 0, 1]}
        self.refuse("", "not JSON")
        self.refuse("[" * 100_000)
        self.refuse({"keys": []}, "keys")
        self.refuse({"keys": [key], "speed": 3}, "speed")
        self.refuse({"keys": [key, key]}, "keys[1]", "time_s")
        self.refuse({"keys": [{**key, "time_s": -1}]}, "keys[0]")
        self.refuse({"keys": [{**key, "tip_mm": [0, 0]}]}, "keys[0]", "tip_mm")
        self.refuse({"keys": [{**key, "normal": [1, 0, 0]}]}, "keys[0]", "parallel")

    def test_a_hand_that_is_nowhere(self):
        self.expect_refusal(BAD_INPUT, ["surgeon", "expert", "novice", "perfect"], "attempt", "silver", "--hand", "surgeon")
        self.assertFalse(self.data.exists())


if __name__ == "__main__":
    unittest.main()
