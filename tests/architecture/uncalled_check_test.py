#!/usr/bin/env python3
"""The uncalled check lists each planted function that the program does not contain, and no other."""

import os
import subprocess
import unittest

from planted import PlantedTree

MAIN = "namespace hallux { int used(int); }\nint main(int count, char**) { return hallux::used(count); }\n"
USED = "int used(int x) { return x * 3; }\n"


class UncalledCheck(PlantedTree):
    def setUp(self):
        super().setUp()
        self.plant("planted.h", "")

    def build(self, text, main=MAIN):
        """A room of one source, and the program that is linked with it as the project would."""
        build = self.root / "build"
        source = self.plant("simulator/mesh/planted.cpp", f'#include "planted.h"\nnamespace hallux {{\n{text}}}\n')
        program = self.plant("main.cpp", main)
        for folder in ("simulator/mesh", "ui/app"):
            (build / folder).mkdir(parents=True, exist_ok=True)
        compiler = [os.environ.get("CXX", "c++"), "-std=c++20", "-O2", "-g1", "-ffunction-sections", "-fdata-sections",
                    f"-I{self.root}"]
        built, archive = build / "planted.cpp.o", build / "simulator/mesh/libplanted.a"
        subprocess.run([*compiler, "-c", str(source), "-o", str(built)], check=True)
        archive.unlink(missing_ok=True)
        subprocess.run(["ar", "rcs", str(archive), str(built)], check=True)
        subprocess.run([*compiler, str(program), str(archive), "-Wl,--gc-sections", "-o", str(build / "ui/app/hallux")],
                       check=True)
        return build

    def refuses(self, text, what):
        self.expect_violation("simulator/mesh/planted.cpp", f"only tests call {what}", "uncalled_check.py",
                              self.build(text))

    def passes(self, text, main=MAIN):
        self.expect_clean("uncalled_check.py", self.build(text, main))

    def test_lets_what_is_called_pass(self):
        self.passes(USED)
        self.passes("int twice(int x);\nint used(int x) { return twice(x); }\n"
                    "__attribute__((noinline)) int twice(int x) { return 2 * x; }\n")

    def test_lets_what_was_inlined_or_folded_pass(self):
        self.passes("int twice(int x) { return 2 * x + (x >> 3); }\nint used(int x) { return twice(x) * x; }\n")
        self.passes("int six() { return 6; }\nint used(int x) { return six() * x; }\n")

    def test_lets_virtual_functions_of_a_used_type_pass(self):
        self.passes("struct A { virtual ~A() = default; virtual int f(int) = 0; };\n"
                    "struct B final : A { int f(int) override; ~B() override; };\n"
                    "int B::f(int x) { return x; }\nB::~B() = default;\n"
                    "A* make() { return new B; }\nint used(int x) { return make()->f(x); }\n")

    def test_refuses_a_function_that_nobody_calls(self):
        self.refuses(USED + "int lost(int x) { return x * 5; }\n", "hallux::lost(int)")

    def test_refuses_a_member_that_nobody_calls(self):
        self.plant("planted.h", "namespace hallux { struct A { int lost() const; int x; }; }\n")
        self.refuses(USED + "int A::lost() const { return x; }\n", "hallux::A::lost() const")

    def test_refuses_what_only_an_uncalled_function_calls(self):
        text = USED + "int lost(int);\nint caller(int x) { return x + 1; }\n"
        build = self.build(text)
        other = self.plant("simulator/mesh/other.cpp", "namespace hallux { int caller(int);\n"
                           "int lost(int x) { return caller(x); } }\n")
        built = build / "other.cpp.o"
        subprocess.run([os.environ.get("CXX", "c++"), "-O2", "-c", str(other), "-o", str(built)], check=True)
        subprocess.run(["ar", "rcs", str(build / "simulator/mesh/libplanted.a"), str(built)], check=True)
        self.expect_violation("simulator/mesh/planted.cpp", "hallux::caller(int)", "uncalled_check.py", build)
        self.expect_violation("simulator/mesh/other.cpp", "hallux::lost(int)", "uncalled_check.py", build)

    def test_lets_moves_and_destructors_pass(self):
        self.passes(USED + "struct A { A(A&&) noexcept; A& operator=(A&&) noexcept; ~A(); int x; };\n"
                    "A::A(A&&) noexcept = default;\nA& A::operator=(A&&) noexcept = default;\nA::~A() { x = 0; }\n")

    def test_reads_the_list_and_refuses_what_it_holds_in_vain(self):
        self.plant("planted.h", "namespace hallux { struct A { int lost() const; int x; }; }\n")
        text = USED + "int unused(int x) { return x; }\nint A::lost() const { return x; }\n"
        self.plant("tests/architecture/uncalled.txt", "# why\nhallux::unused: a test asks it\nhallux::A::: as well\n")
        self.passes(text)
        self.plant("tests/architecture/uncalled.txt", "hallux::unused: a\nhallux::A::lost: b\nhallux::used: c\n")
        self.expect_violation("uncalled.txt", "hallux::used is called, or is gone", "uncalled_check.py",
                              self.build(text))
        self.plant("tests/architecture/uncalled.txt", "hallux::unused\n")
        code, said = self.run_check("uncalled_check.py", self.build(text))
        self.assertNotEqual(code, 0)
        self.assertIn("its reason", said)


if __name__ == "__main__":
    unittest.main()
