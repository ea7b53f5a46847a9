#!/usr/bin/env python3
"""The function check refuses each planted call by the symbol the compiler left, and names its object."""

import os
import subprocess
import unittest

from planted import PlantedTree


class FunctionCheck(PlantedTree):
    def compile(self, room, text):
        """Builds one object of `room` as the project would; returns the place that a violation names."""
        self.plant(f"{room}/CMakeLists.txt", "")
        source = self.plant("planted.cpp", text)
        folder = self.root / "build" / room
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run([os.environ.get("CXX", "c++"), "-std=c++20", "-O2", "-c", str(source),
                        "-o", str(folder / "planted.o")], check=True)
        return f"{room}/planted.o"

    def expect_refused(self, room, text, what):
        place = self.compile(room, text)
        self.expect_violation(place, what, "function_check.py", self.root / "build")

    def test_lets_sqrt_and_rounding_pass(self):
        self.compile("simulator/mesh", "#include <cmath>\n"
                     "double f(double x) { return std::sqrt(x) + std::floor(x) + std::abs(x); }\n"
                     "namespace hallux::elementary { double sin(double x); }\n"
                     "double g(double x) { return hallux::elementary::sin(x); }\n")
        self.expect_clean("function_check.py", self.root / "build")

    def test_refuses_each_transcendental(self):
        calls = ("sin", "cos", "tan", "asin", "acos", "atan", "exp", "exp2", "expm1", "log", "log2", "log10",
                 "log1p", "cbrt", "sinh", "cosh", "tanh")
        text = "".join(f"double f_{call}(double x) {{ return std::{call}(x); }}\n"
                       f"float g_{call}(float x) {{ return std::{call}(x); }}\n" for call in calls)
        text += "".join(f"double f_{call}(double x, double y) {{ return std::{call}(x, y); }}\n"
                        for call in ("atan2", "pow", "hypot"))
        text += "double f_fma(double x) { return std::fma(x, x, x); }\n"
        place = self.compile("simulator/base", "#include <cmath>\n" + text)
        _, said = self.run_check("function_check.py", self.root / "build")
        found = {line.rpartition(" ")[2] for line in said.splitlines() if line.startswith(place)}
        wanted = set(calls) | {call + "f" for call in calls} | {"atan2", "pow", "hypot", "fma"}
        self.assertEqual(wanted - found, set())

    def test_refuses_sine_and_cosine_joined_by_the_compiler(self):
        self.expect_refused("simulator/record", "#include <cmath>\n"
                            "double f(double x) { return std::sin(x) / std::cos(x); }\n", "sincos")

    def test_refuses_a_transcendental_folded_to_a_constant(self):
        self.compile("simulator/step", "")
        self.plant("simulator/step/step.cpp", "\ndouble f() { return std::sin(1.0); }\n")
        self.expect_violation("simulator/step/step.cpp:2", "std::sin(", "function_check.py", self.root / "build")

    def test_refuses_random_sources(self):
        self.expect_refused("simulator/jobs", "#include <cstdlib>\nint f() { return std::rand(); }\n", "rand")
        self.expect_refused("simulator/mesh", "#include <random>\n"
                            "unsigned f() { std::random_device device; return device(); }\n", "std::random_device")
        self.expect_refused("scenarios/foot", "#include <random>\ndouble f(std::mt19937& g) {\n"
                            "std::normal_distribution<double> normal; return normal(g) + normal(g); }\n",
                            "a random source")

    def test_refuses_unordered_containers(self):
        self.expect_refused("simulator/cutting", "#include <unordered_map>\n"
                            "void f(std::unordered_map<int, int>& map) { map[3] = 4; }\n", "an unordered container")

    def test_refuses_clocks(self):
        self.expect_refused("simulator/contact", "#include <chrono>\n"
                            "long f() { return std::chrono::steady_clock::now().time_since_epoch().count(); }\n",
                            "a clock")
        self.expect_refused("simulator/step", "#include <ctime>\n"
                            "void f(timespec& now) { clock_gettime(CLOCK_MONOTONIC, &now); }\n", "clock_gettime")

    def test_refuses_memory_taken_in_the_step(self):
        self.expect_refused("simulator/step", "int* f() { return new int[8]; }\n", "operator new")
        self.expect_refused("simulator/contact", "#include <cstdlib>\nvoid* f() { return std::malloc(8); }\n", "malloc")
        self.expect_refused("simulator/step", "#include <vector>\n"
                            "void f(std::vector<int>& values) { values.push_back(1); }\n", "operator new")

    def test_lets_other_rooms_take_memory(self):
        self.compile("simulator/mesh", "int* f() { return new int[8]; }\n")
        self.expect_clean("function_check.py", self.root / "build")

    def test_refuses_threads_and_files_in_the_step(self):
        self.expect_refused("simulator/step", "#include <thread>\nvoid f() { std::jthread work([] {}); }\n", "a thread")
        self.expect_refused("simulator/contact", "#include <mutex>\n"
                            "void f(std::mutex& mutex) { mutex.lock(); }\n", "pthread_mutex_lock")
        self.expect_refused("simulator/step", "#include <cstdio>\nvoid f() { std::fopen(\"x\", \"r\"); }\n", "fopen")
        self.expect_refused("simulator/step", "#include <fstream>\nvoid f() { std::ofstream file(\"x\"); }\n",
                            "a file or stream")
        self.expect_refused("simulator/contact", "#include <cstdio>\nvoid f(int x) { std::printf(\"%d\", x); }\n",
                            "printf")

    def test_refuses_a_room_that_was_not_built(self):
        self.plant("simulator/mesh/CMakeLists.txt", "")
        self.expect_violation("simulator/mesh", "was not built", "function_check.py", self.root / "build")


if __name__ == "__main__":
    unittest.main()
