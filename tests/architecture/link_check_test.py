#!/usr/bin/env python3
"""The link check refuses each planted link and names the program or the list it stands in."""

import unittest

from planted import PlantedTree

LINKED = """build {output}: CXX_EXECUTABLE_LINKER__it_RelWithDebInfo some/object.o | lib.a
  LINK_LIBRARIES = simulator/base/libhallux_base.a  {libraries}
  TARGET_FILE = {output}
"""


class LinkCheck(PlantedTree):
    def setUp(self):
        super().setUp()
        self.build = self.root / "build"
        self.program("ui/app/hallux", "/usr/lib/x86_64-linux-gnu/libsodium.so")
        self.room("simulator/base", "hallux_base", "glm::glm PkgConfig::sodium")
        self.room("simulator/mesh", "hallux_mesh", "hallux_base OpenMeshCore")

    def program(self, output, libraries):
        self.plant("build/build.ninja", LINKED.format(output=output, libraries=libraries))

    def room(self, folder, name, uses):
        self.plant(f"{folder}/CMakeLists.txt", f"hallux_room({name}\n  SOURCES one.cpp\n  USES {uses})\n")

    def test_lets_the_links_of_the_table_pass(self):
        self.expect_clean("link_check.py", self.build)

    def test_refuses_an_oracle_in_what_is_installed(self):
        for library in ("/usr/lib/libCGAL.so", "-lgmp", "/usr/lib/libvtkCommonCore-9.1.so", "/usr/lib/libgtest.a"):
            self.program("ui/app/hallux", library)
            self.expect_violation("ui/app/hallux", "nothing installed may link", "link_check.py", self.build)

    def test_lets_a_test_link_its_oracle(self):
        self.program("tests/oracles/volume", "-lgmp /usr/lib/libvtkCommonCore-9.1.so")
        self.expect_clean("link_check.py", self.build)

    def test_refuses_a_room_that_links_against_the_flow(self):
        self.room("simulator/base", "hallux_base", "hallux_mesh")
        self.expect_violation("simulator/base/CMakeLists.txt", "may not link hallux_mesh", "link_check.py", self.build)

    def test_reads_the_arrows_of_a_library_that_holds_several_corners(self):
        self.room("simulator/cutting", "hallux_cutting", "hallux_base hallux_mesh")
        self.room("simulator/contact", "hallux_contact", "hallux_cutting")
        self.expect_clean("link_check.py", self.build)
        self.room("simulator/mesh", "hallux_mesh", "hallux_cutting")
        self.expect_violation("simulator/mesh/CMakeLists.txt", "may not link hallux_cutting", "link_check.py", self.build)

    def test_refuses_a_foreign_library_outside_its_home(self):
        self.room("simulator/mesh", "hallux_mesh", "hallux_base SQLiteCpp")
        self.expect_violation("simulator/mesh/CMakeLists.txt", "may not link SQLiteCpp", "link_check.py", self.build)

    def test_refuses_a_library_that_nobody_named(self):
        self.room("simulator/mesh", "hallux_mesh", "Boost::boost")
        self.expect_violation("simulator/mesh/CMakeLists.txt", "does not name", "link_check.py", self.build)

    def test_reads_links_added_to_a_room_later(self):
        self.plant("database/CMakeLists.txt", "hallux_room(hallux_database SOURCES a.cpp USES hallux_base)\n"
                   "target_link_libraries(hallux_database PRIVATE OpenMeshCore)\n")
        self.expect_violation("database/CMakeLists.txt", "may not link OpenMeshCore", "link_check.py", self.build)


if __name__ == "__main__":
    unittest.main()
