/// An operation on a bone-like shaft, driven by hand until much was done to it, and the strokes at
/// the end that are measured.
///
///     x:   -31        -15                       15        31
///           |  piece 2 |   bone, as it was       |  piece 1 |      the ends are sawn off and moved
///             k  w  k    w  k k k k k 0 k k k k w  k  w  k         k kerf, w wire, 0 the stroke
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulator/mesh/bone.h"
#include "tests/simulator/step/simulation_run.h"

namespace hallux::benchmarks {

/// Lines of the tape in which one thing was done, and nothing else.
struct MeasuredWork {
  std::string what;
  std::size_t begin = 0, end = 0;
};

struct DrivenRecording {
  simulator::Recording recording;
  std::vector<MeasuredWork> works;
};

// What is measured, in words.
inline const std::string sawing = "sawn", laying = "laid on", leading = "gripped, led",
                         pressing = "gripped, pressed", boring = "bored",
                         boring_late = "bored, after 12 more";

/// A cortical shaft of 62 x 16 x 14 mm.
simulator::Bone shaft(std::size_t triangles);
/// A saw, and a wire driver at place 1.
simulator::Tray shaft_tray();

/// Two kerfs in one body: the second is sawn, then the blade is laid on and a wire bored.
DrivenRecording with_two_kerfs(const simulator::Bone& bone);
/// 16 kerfs, three bodies of which two were moved, four wires: the last kerf is sawn, the blade
/// laid on, a piece gripped, led and pressed against the bone, wires bored.
/// errors  std::runtime_error where less came of it
DrivenRecording with_sixteen_kerfs(const simulator::Bone& bone);

}  // namespace hallux::benchmarks
