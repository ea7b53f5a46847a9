#!/usr/bin/env python3
"""`hallux cut`: the kernel on any closed mesh. It opens no database."""

import struct
import unittest

from hallux_command import BAD_INPUT, DONE, STORAGE, WRONG_USAGE, CommandTest
from small_meshes import block_ply

ANSWER_KEYS = {"input_mm3", "removed_mm3", "debris_mm3", "debris_pieces", "missing_mm3", "pieces", "cuts", "frame_ms",
               "refused_frames", "triangles_max", "hinge"}
CUT_KEYS = {"contact_ms", "frames", "frame_ms", "refused_frames", "nudges", "reopens", "removed_mm3"}
BLOCK_MM3 = 30.0 * 14.0 * 12.0


def read_piece(file):
    """(points, triangles) of a binary little-endian PLY with double coordinates."""
    header, body = file.read_bytes().split(b"end_header\n", 1)
    lines = header.decode("ascii").splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"], lines
    counts = {words[1]: int(words[2]) for words in map(str.split, lines) if words[0] == "element"}
    points = list(struct.iter_unpack("<3d", body[:24 * counts["vertex"]]))
    triangles = list(struct.iter_unpack("<B3I", body[24 * counts["vertex"]:]))
    assert len(triangles) == counts["face"] and all(row[0] == 3 for row in triangles)
    return points, [row[1:] for row in triangles]


def volume_mm3(points, triangles):
    total = 0.0
    for a, b, c in ([points[index] for index in triangle] for triangle in triangles):
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                  + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6.0
    return total


class Cut(CommandTest):
    def setUp(self):
        super().setUp()
        self.bone = self.write("bone.ply", block_ply(30, 14, 12))
        self.out = self.folder / "out"

    def tearDown(self):
        self.assertFalse(self.data.exists(), "cutting a mesh opens no database")
        super().tearDown()

    def cut(self, *groups):
        return self.ask("cut", self.bone, *groups, "-o", self.out)

    def sweep(self, tip_mm):
        """A blade that comes from -y in the plane x = 1 and stops with its teeth at y = `tip_mm`."""
        poses = [{"tip": [1, y, 0], "direction": [0, 1, 0]} for y in (-20, tip_mm)]
        return self.write("sweep.json", {"blade": {"width_mm": 13, "depth_mm": 30}, "poses": poses})

    def test_the_answer_has_the_keys_of_the_contract(self):
        answer = self.cut("--plane", "1,0,0,2", "--kerf", "0.5")
        self.assertLessEqual(ANSWER_KEYS, answer.keys())
        for piece in answer["pieces"]:
            self.assertLessEqual({"file", "triangles", "volume_mm3", "closed"}, piece.keys())
        for cut in answer["cuts"]:
            self.assertLessEqual(CUT_KEYS, cut.keys())
            self.assertGreaterEqual(cut["contact_ms"], 0.0)
        self.assertEqual(answer["frame_ms"], {"median": None, "p99": None, "max": None})

    def test_groups_act_in_turn_and_the_volumes_add_up(self):
        answer = self.cut("--plane", "1,0,0,2", "--kerf", "0.5", "--plane", "-2,0,0,6", "--kerf", "1")
        self.assertAlmostEqual(answer["input_mm3"], BLOCK_MM3, delta=1e-9)
        self.assertAlmostEqual(answer["removed_mm3"], 1.5 * 168.0, delta=1e-9)
        self.assertEqual([round(cut["removed_mm3"], 6) for cut in answer["cuts"]], [84.0, 168.0])
        kept_mm3 = sum(piece["volume_mm3"] for piece in answer["pieces"]) + answer["debris_mm3"]
        self.assertAlmostEqual(kept_mm3 + answer["removed_mm3"], BLOCK_MM3, delta=1e-6)

    def test_pieces_are_closed_binary_files_the_largest_first(self):
        answer = self.cut("--plane", "1,0,0,2", "--kerf", "0.5")
        pieces = answer["pieces"]
        self.assertEqual([piece["file"] for piece in pieces], ["piece-1.ply", "piece-2.ply"])
        self.assertEqual(sorted(file.name for file in self.out.iterdir()), ["piece-1.ply", "piece-2.ply"])
        self.assertGreater(pieces[0]["volume_mm3"], pieces[1]["volume_mm3"])
        for piece in pieces:
            points, triangles = read_piece(self.out / piece["file"])
            edges = {(a, b) for t in triangles for a, b in zip(t, t[1:] + t[:1])}
            self.assertEqual(len(edges), 3 * len(triangles))
            self.assertEqual(edges, {(b, a) for a, b in edges})
            self.assertIs(piece["closed"], True)
            self.assertEqual(piece["triangles"], len(triangles))
            self.assertAlmostEqual(piece["volume_mm3"], volume_mm3(points, triangles), delta=1e-6)

    def test_a_plane_that_misses_leaves_one_piece_and_removes_nothing(self):
        answer = self.cut("--plane", "0,0,1,80", "--kerf", "0.5")
        self.assertEqual(len(answer["pieces"]), 1)
        self.assertEqual(answer["removed_mm3"], 0.0)
        self.assertAlmostEqual(answer["pieces"][0]["volume_mm3"], BLOCK_MM3, delta=1e-9)

    def test_a_sweep_all_the_way_through_frees_a_piece(self):
        answer = self.cut("--plane", "1,0,0,1", "--kerf", "0.5", "--sweep", self.sweep(7.5))
        self.assertEqual(len(answer["pieces"]), 2)
        self.assertAlmostEqual(answer["removed_mm3"], 84.0, delta=1e-9)

    def test_a_sweep_that_stops_inside_the_bone_leaves_a_kerf(self):
        answer = self.cut("--plane", "1,0,0,1", "--kerf", "0.5", "--sweep", self.sweep(2.0))
        self.assertEqual(len(answer["pieces"]), 1)
        self.assertAlmostEqual(answer["removed_mm3"], 0.5 * 12.0 * 9.0, delta=2e-3)
        self.assertGreater(answer["frame_ms"]["median"], 0.0)
        self.assertEqual(answer["refused_frames"], 0)

    def test_two_groups_without_a_wedge_have_no_hinge_and_nothing_is_written(self):
        self.expect_refusal(BAD_INPUT, ["--close 1,2"], "cut", self.bone, "--plane", "1,0,0,1", "--kerf", "0.5",
                            "--plane", "1,0,0,5", "--kerf", "0.5", "--close", "1,2", "-o", self.out)
        self.assertFalse(self.out.exists())

    def test_progress_goes_to_stderr_and_quiet_silences_it(self):
        arguments = ["cut", self.bone, "--plane", "1,0,0,2", "--kerf", "0.5", "-o", self.out]
        self.assertIn("Cutting", self.hallux(*arguments, "--json").err)
        self.assertEqual(self.hallux(*arguments, "--json", "--quiet").err, "")

    def test_a_kerf_before_its_plane_is_wrong_usage(self):
        answer = self.hallux("cut", self.bone, "--kerf", "0.5", "--plane", "1,0,0,2", "-o", self.out)
        self.assertEqual(answer.code, WRONG_USAGE, answer)

    def test_a_file_where_the_folder_should_be_is_bad_input(self):
        self.write("out", "a file where the folder should be")
        self.expect_refusal(BAD_INPUT, ["out"], "cut", self.bone, "--plane", "1,0,0,2", "--kerf", "0.5", "-o", self.out)

    def test_a_folder_without_room_is_a_storage_error_and_keeps_what_was_there(self):
        self.cut("--plane", "1,0,0,2", "--kerf", "0.5")
        before = {file.name: file.read_bytes() for file in self.out.iterdir()}
        answer = self.run_with_room(100, "cut", self.bone, "--plane", "0,1,0,2", "--kerf", "0.5", "-o", self.out, "--quiet")
        self.assertEqual((answer.code, answer.out, len(answer.err.splitlines())), (STORAGE, "", 1), answer)
        self.assertIn("out", answer.err)
        self.assertEqual({file.name: file.read_bytes() for file in self.out.iterdir()}, before)

    def test_the_same_cut_writes_the_same_bytes(self):
        arguments = ["--plane", "0.3,0.9,0.1,1", "--kerf", "0.5"]
        self.cut(*arguments)
        first = {file.name: file.read_bytes() for file in self.out.iterdir()}
        self.cut(*arguments)
        self.assertEqual({file.name: file.read_bytes() for file in self.out.iterdir()}, first)


if __name__ == "__main__":
    unittest.main()
