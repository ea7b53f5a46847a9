#!/usr/bin/env python3
"""The arrow check refuses each planted violation and names its place."""

import unittest

from planted import PlantedTree


class ArrowCheck(PlantedTree):
    def test_lets_an_arrow_of_the_table_pass(self):
        self.plant("simulator/base/vector.h", "#include <vector>\n#include <glm/vec3.hpp>\n")
        self.plant("simulator/mesh/bvh.h", '#include "simulator/base/vector.h"\n#include <cmath>\n')
        self.plant("tests/simulator/mesh/bvh_test.cpp", "#include <gtest/gtest.h>\n")
        self.expect_clean("arrow_check.py")

    def test_refuses_an_arrow_against_the_flow(self):
        self.plant("simulator/loop/loop.h", "")
        self.plant("simulator/base/vector.h", '\n#include "simulator/loop/loop.h"\n')
        self.expect_violation("simulator/base/vector.h:2", "simulator/base may not include simulator/loop",
                              "arrow_check.py")

    def test_refuses_a_room_that_includes_the_screens(self):
        self.plant("ui/jobs/cut_mesh.h", "")
        self.plant("database/people/people.cpp", '#include "ui/jobs/cut_mesh.h"\n')
        self.expect_violation("database/people/people.cpp:1", "database/people may not include ui/jobs", "arrow_check.py")

    def test_refuses_a_path_that_does_not_begin_at_the_root(self):
        self.plant("simulator/mesh/bvh.h", "")
        self.plant("simulator/mesh/bvh.cpp", '#include "bvh.h"\n')
        self.expect_violation("simulator/mesh/bvh.cpp:1", "not a file from the repository root", "arrow_check.py")

    def test_refuses_a_file_outside_every_unit(self):
        self.plant("simulator/surprise/new.h", "")
        self.expect_violation("simulator/surprise/new.h", "belongs to no unit", "arrow_check.py")

    def test_refuses_each_foreign_header_outside_its_home(self):
        for header in ("sqlite3.h", "SQLiteCpp/Database.h", "zstd.h", "sodium.h", "hidapi/hidapi.h",
                       "libusb-1.0/libusb.h", "nlohmann/json.hpp", "CLI/CLI.hpp", "epoxy/gl.h", "GL/gl.h",
                       "imgui.h", "imgui_internal.h", "OpenMesh/Core/IO/MeshIO.hh", "glm/vec3.hpp",
                       "CGAL/Surface_mesh.h", "thread", "mutex", "chrono", "random", "unordered_map"):
            self.plant("simulator/contact/feed.cpp", f"#include <{header}>\n")
            self.expect_violation("simulator/contact/feed.cpp:1", f"<{header}>", "arrow_check.py")

    def test_refuses_a_foreign_header_that_nobody_named(self):
        self.plant("ui/app/main.cpp", "#include <boost/any.hpp>\n")
        self.expect_violation("ui/app/main.cpp:1", "does not name", "arrow_check.py")

    def test_lets_doors_be_used_by_whom_they_are_for(self):
        self.plant("database/desks/session.h", "Session sign_in(Database& database);\n")
        self.plant("database/records/note.h", "")
        self.plant("ui/jobs/come_in.cpp", '#include "database/desks/session.h"\n#include "database/records/note.h"\n'
                   "void come(Database& database) { database::sign_in(database); desk.load_note(database); }\n")
        self.expect_clean("arrow_check.py")

    def test_refuses_a_header_behind_a_desk(self):
        self.plant("database/course/notes.h", "")
        self.plant("ui/jobs/read.cpp", '#include "database/course/notes.h"\n')
        self.expect_violation("ui/jobs/read.cpp:1", "behind a desk", "arrow_check.py")

    def test_refuses_a_function_behind_a_desk_that_another_header_brings_along(self):
        self.plant("database/course/notes.h", "std::vector<Note> list_notes(Database& database,\n    AttemptId id);\n")
        for call in ("database::list_notes(opened, id)", "list_notes(database, id)", "list_notes(*database_, id)"):
            self.plant("ui/jobs/read.cpp", f"auto read() {{ return {call}; }}\n")
            self.expect_violation("ui/jobs/read.cpp:1", "list_notes() of database/course/notes.h", "arrow_check.py")

    def test_refuses_a_door_that_is_for_another_file(self):
        self.plant("database/maintenance/verify.h", "void verify(Database& database);\n")
        self.plant("ui/jobs/read.cpp", '#include "database/maintenance/verify.h"\n')
        self.expect_violation("ui/jobs/read.cpp:1", "behind a desk", "arrow_check.py")

    def test_refuses_a_cycle_in_the_table(self):
        self.plant("tests/architecture/arrows.txt", "[arrows]\nsimulator/a: simulator/b\nsimulator/b: simulator/a\n")
        self.expect_violation("arrows.txt", "simulator/a -> simulator/b -> simulator/a", "arrow_check.py")

    def test_refuses_a_cycle_of_includes(self):
        self.plant("simulator/base/units.h", '#include "simulator/mesh/bvh.h"\n')
        self.plant("simulator/mesh/bvh.h", '#include "simulator/base/units.h"\n')
        self.expect_violation("includes", "simulator/base -> simulator/mesh -> simulator/base", "arrow_check.py")


if __name__ == "__main__":
    unittest.main()
