#!/usr/bin/env python3
"""Groups of sources (cmake/group_sources.py): files whose private names would meet are never compiled as one."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parents[2] / "cmake" / "group_sources.py"

ALONE = "namespace hallux {\nnamespace {\nint length_mm(int a) { return a; }\n}\nint first() { return length_mm(1); }\n}\n"
ITS_OWN = "namespace hallux {\nnamespace {\nstruct length_mm {};\n}\n}\n"
USES_IT = "namespace hallux {\nint second(int length_mm) { return length_mm; }\n}\n"
MEMBER = "namespace hallux {\nint third(const Blade& blade) { return blade.length_mm + other::length_mm; }\n}\n"
SAID_ONLY = "// length_mm in a remark\nnamespace hallux {\nconst char* fourth() { return \"length_mm\"; }\n}\n"


class Groups(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="hallux-groups-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "cmake").mkdir()
        self.script = shutil.copy(SCRIPT, self.folder / "cmake")

    def chosen(self, asked, before, lines=1500):
        """What the script makes of (target, source) rows: by target and source the group."""
        files = self.folder / "asked.txt", self.folder / "chosen.txt"
        for file, rows in zip(files, (asked, before)):
            file.write_text("".join("\t".join(map(str, row)) + "\n" for row in rows))
        subprocess.run([sys.executable, self.script, str(lines), *files], cwd=self.folder, check=True)
        rows = [line.split("\t") for line in files[1].read_text().splitlines()]
        return {(target, source): int(number) for target, source, number in rows}

    def groups_of(self, *texts, lines=1500, before=()):
        """The number of each text's group."""
        for number, text in enumerate(texts):
            (self.folder / f"{number}.cpp").write_text(text)
        names = [f"{number}.cpp" for number in range(len(texts))]
        rows = self.chosen([("room", name) for name in names], [("room", *row) for row in before], lines)
        return [rows["room", name] for name in names]

    def assert_apart(self, *texts):
        self.assertEqual(len(set(self.groups_of(*texts))), len(texts))

    def assert_together(self, *texts):
        self.assertEqual(len(set(self.groups_of(*texts))), 1)

    def test_who_shares_no_private_name_is_compiled_together(self):
        self.assert_together(ALONE, MEMBER, SAID_ONLY)

    def test_a_private_name_that_another_declares_or_uses_keeps_them_apart(self):
        self.assert_apart(ALONE, ITS_OWN)
        self.assert_apart(ALONE, USES_IT)

    def test_the_bases_of_a_type_are_not_declared_by_it(self):
        derived = "namespace {\nclass %s final : public testing::Test, protected SomeCourse {\n};\n}\n"
        self.assert_together(derived % "One", derived % "Other", "int f(SomeCourse& course) { return 1; }\n")
        self.assert_apart(derived % "One", derived % "One")
        template = "namespace {\ntemplate <typename T>\nstruct %s : Base<T> {\n};\n}\n"
        self.assert_together(template % "One", template % "Other")
        self.assert_apart(template % "One", template % "One")

    def test_every_kind_of_private_name_is_known(self):
        use = "int f(int spot) { return spot; }\n"
        for declaration in ("constexpr double edge = 1.0, spot = 2.0;", "static int spot();", "enum class spot : int { A };",
                            "std::vector<Row<int>> spot(const Ui& ui) { return {}; }", "template <typename T>\nT spot(T t);",
                            "[[noreturn]] void spot();", "class spot final : Base {};", "using spot = int;",
                            "int other() {\n  return 1;\n}\nint spot = 3;"):
            with self.subTest(declaration=declaration):
                self.assert_apart("namespace {\n" + declaration + "\n}\n", use)

    def test_a_private_name_that_a_header_of_another_declares_keeps_them_apart(self):
        (self.folder / "room").mkdir()
        (self.folder / "room/values.h").write_text("namespace hallux {\nclass length_mm {};\n}\n")
        (self.folder / "room/rows.h").write_text('#include "room/values.h"\n')
        reads_it = '#include "room/rows.h"\nnamespace hallux {\nint fifth();\n}\n'
        self.assert_apart(ALONE, reads_it)
        self.assert_together('#include "room/values.h"\n' + ALONE, reads_it)
        self.assert_together(ALONE, '#include "room/generated.h"\nint sixth();\n')

    def test_the_same_using_may_be_said_again_and_another_may_not(self):
        use = "using database::Action;\nAction f();\n"
        self.assert_together(use, use.replace("f", "g"))
        self.assert_apart(use, "using ui::Action;\nAction h();\n")
        self.assert_apart("using namespace ui;\n", "using namespace simulator;\n")

    def test_macros_stay_alone(self):
        self.assert_apart("#define None 0\n", "int f();\n")
        self.assert_apart("#include <X11/Xlib.h>\n", "int f();\n")

    def test_a_group_has_its_limit(self):
        text = "int f();\n" * 60
        self.assertEqual(self.groups_of(text, text, text, lines=130), [0, 0, 1])

    def test_who_can_stays_where_it_was(self):
        self.assertEqual(self.groups_of("int f();\n", "int g();\n", before=(("0.cpp", 4), ("1.cpp", 7))), [4, 7])
        [first, second] = self.groups_of(ALONE, USES_IT, before=(("0.cpp", 4), ("1.cpp", 4)))
        self.assertEqual(first, 4)
        self.assertNotEqual(second, 4)

    def test_each_target_has_groups_of_its_own(self):
        self.groups_of("int f();\n", "int g();\n")
        asked = [("room", "0.cpp"), ("other", "0.cpp"), ("other", "1.cpp")]
        self.assertEqual(self.chosen(asked, [("other", "0.cpp", 3)]),
                         {("room", "0.cpp"): 0, ("other", "0.cpp"): 3, ("other", "1.cpp"): 3})


if __name__ == "__main__":
    unittest.main()
