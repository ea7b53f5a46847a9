#!/usr/bin/env python3
"""The door check refuses each planted header whose opening does not tell its reach."""

import unittest

from planted import PlantedTree

CORNER = "/// What this is for. Inside this corner only.\n#pragma once\n"
ROOM = "/// What this is for.\n/// Inside this room only.\n#pragma once\n"
DOOR = "/// What this is for.\n#pragma once\n"
HEADER = "simulator/mesh/bvh.h"
INCLUDED = f'#include "{HEADER}"\n'


class DoorCheck(PlantedTree):
    def refuses(self, what):
        self.expect_violation(HEADER, what, "door_check.py")

    def test_lets_each_reach_pass(self):
        self.plant("simulator/mesh/tree.h", CORNER)
        self.plant("simulator/mesh/tree.cpp", '#include "simulator/mesh/tree.h"\n')
        self.plant("simulator/mesh/walk.h", ROOM)
        self.plant("simulator/cutting/field/walk.cpp", '#include "simulator/mesh/walk.h"\n')
        self.plant(HEADER, DOOR)
        self.plant("scenarios/plan.cpp", INCLUDED)
        self.expect_clean("door_check.py")

    def test_lets_tests_include_every_header(self):
        self.plant(HEADER, CORNER)
        self.plant("tests/simulator/mesh/bvh_test.cpp", INCLUDED)
        self.expect_clean("door_check.py")

    def test_asks_nothing_where_the_table_lets_nobody_in(self):
        self.plant("ui/app/verb.h", DOOR)
        self.plant("ui/widgets/controls/button.h", DOOR)
        self.plant("ui/screens/parts/people.cpp", '#include "ui/widgets/controls/button.h"\n')
        self.expect_clean("door_check.py")

    def test_refuses_a_header_of_a_corner_that_another_corner_includes(self):
        self.plant(HEADER, CORNER)
        self.plant("simulator/cutting/field/cut.cpp", INCLUDED)
        self.refuses("is included by simulator/cutting/field/cut.cpp")

    def test_refuses_a_header_of_a_room_that_another_room_includes(self):
        self.plant(HEADER, ROOM)
        self.plant("scenarios/plan.cpp", INCLUDED)
        self.refuses("is included by scenarios/plan.cpp")

    def test_refuses_a_door_that_nobody_outside_uses(self):
        self.plant(HEADER, DOOR)
        self.plant("simulator/mesh/bvh.cpp", INCLUDED)
        self.refuses('ends with "Inside this corner only."')
        self.plant("simulator/cutting/field/cut.cpp", INCLUDED)
        self.refuses('ends with "Inside this room only."')

    def test_refuses_a_room_where_a_corner_is_enough(self):
        self.plant(HEADER, ROOM)
        self.refuses('ends with "Inside this corner only."')

    def test_refuses_other_words_and_other_places(self):
        self.plant(HEADER, "/// What this is for; inside this corner only.\n#pragma once\n")
        self.refuses('ends with "Inside this corner only."')
        self.plant(HEADER, CORNER + "/// Inside this corner only.\nint f();\n")
        self.refuses("elsewhere or in other words")
        self.plant(HEADER, "/// What this is for.\n///\n/// Inside this corner only.\n#pragma once\n")
        self.refuses('ends with "Inside this corner only."')


if __name__ == "__main__":
    unittest.main()
