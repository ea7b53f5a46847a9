#!/usr/bin/env python3
"""Wherever a verb takes the name of an output: what is kept, and what belongs to others, is never replaced."""

import os
import re
import subprocess
import unittest

from hallux_command import BAD_INPUT, DONE, PROGRAM, REFUSED, RecordedTest
from small_meshes import block_ply

PASSWORD = "saw bone hinge wire"
# Options that name an output.
FILES = {("report", "--output")}
FOLDERS = {("cut", "--output"), ("export", "--output"), ("export-person", "--output"), ("backup", "--to")}
# Options with a text that names none: files that are read, names, numbers.
READ = {("attempt", "--hand"), ("cut", "--plane"), ("cut", "--kerf"), ("cut", "--sweep"), ("cut", "--close"),
        ("verify", "--anchor"), ("export", "--person"), ("export", "--cohort"), ("restore", "--erasures"), ("origins", "--accept"),
        ("origins", "--unaccept"), ("retention", "--practice-days"), ("retention", "--assessment-days"),
        ("retention", "--account-days"), ("retention", "--cache-days"), ("user add", "--name"), ("user erase", "--reason")}
OPTION = re.compile(r"^ +(?:-\w,)?(--[\w-]+) TEXT(?!:)", re.MULTILINE)


def help_of(*verb):
    return subprocess.run([PROGRAM, *verb, "--help"], capture_output=True, text=True, check=True).stdout


class Outputs(RecordedTest):
    def setUp(self):
        super().setUp()
        self.mesh = self.write("bone.ply", block_ply(30, 14, 12))
        self.elsewhere = self.folder / "elsewhere"
        self.elsewhere.mkdir()

    def ask_for(self, verb, output):
        """The verb with an output at that place, all else being right."""
        lines = {
            "report": ["report", self.attempt, "-o", output],
            "cut": ["cut", self.mesh, "--plane", "1,0,0,0", "--kerf", "0.5", "-o", output],
            "export": ["export", self.attempt, "-o", output],
            "backup": ["backup", "--to", output],
        }
        if verb == "export-person":
            return self.hallux("export-person", "anna", "-o", output, "--as", "anna", stdin=f"{PASSWORD}\n")
        return self.hallux(*lines[verb])

    def add_anna(self):
        self.ask("user", "add", "anna", "--administrator", stdin=f"{PASSWORD}\n")

    def expect_refused(self, verb, output):
        """Nothing is altered, but for who signed in."""
        kept = self.names if verb == "export-person" else self.stored
        before = kept()
        answer = self.ask_for(verb, output)
        self.assertEqual(answer.code, BAD_INPUT, (verb, output, answer))
        self.assertIn("hallux: ", answer.err)
        self.assertEqual(kept(), before, (verb, output))

    def names(self):
        return sorted(self.stored())

    def test_every_option_that_names_an_output_is_in_this_test(self):
        verbs = re.findall(r"^  ([a-z][a-z-]*) ", help_of().split("Subcommands:")[1], re.MULTILINE)
        self.assertGreater(len(verbs), 12)
        verbs += [f"user {verb}" for verb in ("add", "passwd", "disable", "erase", "recover")]
        found = {(verb, option) for verb in verbs for option in OPTION.findall(help_of(*verb.split()))}
        self.assertEqual(found, FILES | FOLDERS | READ)

    def test_nothing_is_written_into_the_data_directory(self):
        """By any name: the file itself, a new one, a folder, through links of both kinds."""
        door, page, twin = (self.elsewhere / name for name in ("door", "page.html", "twin.html"))
        door.symlink_to(self.data)
        page.symlink_to(self.database())
        os.link(self.database(), twin)
        places = [self.database(), self.data, self.data / "new", door, door / "new", page, twin]
        for verb in ("report", "cut", "export", "backup"):
            for place in places:
                self.expect_refused(verb, place)
        self.add_anna()
        for place in places:
            self.expect_refused("export-person", place)
        os.remove(twin)
        self.assertIs(self.ask("verify")["whole"], True)

    def test_what_somebody_else_made_stays(self):
        thesis = self.write("thesis.html", "<html>my thesis")
        self.expect_refused("report", thesis)
        self.assertEqual(thesis.read_text(), "<html>my thesis")
        foreign = self.elsewhere / "piece-1.ply"
        foreign.write_text("ply\nformat ascii 1.0\n")
        self.expect_refused("cut", self.elsewhere)
        self.assertEqual([file.name for file in self.elsewhere.iterdir()], ["piece-1.ply"])
        foreign.rename(self.elsewhere / "piece-7.ply")
        self.assertEqual(self.ask_for("cut", self.elsewhere).code, DONE)
        self.assertIn("ascii", (self.elsewhere / "piece-7.ply").read_text())
        for verb in ("export", ):
            answer = self.ask_for(verb, self.elsewhere)
            self.assertEqual(answer.code, REFUSED, answer)

    def test_what_this_program_made_is_replaced(self):
        page = self.folder / "page.html"
        page.touch()
        for _ in range(2):
            self.assertEqual(self.ask_for("report", page).code, DONE)
            self.assertEqual(page.stat().st_mode & 0o777, 0o600)
            self.assertEqual(self.ask_for("cut", self.elsewhere).code, DONE)
            self.assertEqual(self.ask_for("backup", self.folder / "kept").code, DONE)

    def test_the_window_keeps_to_it_too(self):
        for place in (self.database(), self.data / "map.json", self.write("thesis.json", "{}")):
            before = self.stored()
            answer = self.hallux("--ui-map", place)
            self.assertEqual(answer.code, BAD_INPUT, answer)
            self.assertEqual(self.stored(), before)

    def test_the_usual_folder_of_backups_may_be_named(self):
        self.assertEqual(self.ask_for("backup", self.data / "backups").code, DONE)
        self.expect_refused("backup", self.data / "backups" / "mine")

    def test_a_link_in_the_folder_of_backups_is_not_followed(self):
        kept = self.folder / "kept"
        kept.mkdir()
        (kept / "recordings").symlink_to(self.elsewhere)
        self.expect_refused("backup", kept)
        self.assertEqual(list(self.elsewhere.iterdir()), [])

    def test_a_place_has_a_name(self):
        for line in (["report", self.attempt, "-o", ""], ["cut", self.mesh, "--plane", "1,0,0,0", "--kerf", "1", "-o", ""],
                     ["export", self.attempt, "-o", ""], ["backup", "--to", ""], ["--ui-map", ""]):
            answer = self.hallux(*line)
            self.assertEqual(answer.code, 2, answer)
            self.assertIn("must name a place", answer.err)


if __name__ == "__main__":
    unittest.main()
