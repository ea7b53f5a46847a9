/// What the thesis's chapter 7.2 did to its two meshes, as appends and removals on buffers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::benchmarks {

/// A mesh whose buffers are worked on.
struct BufferModel {
  std::string name;
  simulator::IndexedMesh mesh;
};

/// A foot of about 120,000 triangles and a sphere of about 1,000, as in thesis 7.1 and 7.2.
std::vector<BufferModel> buffer_models(bool is_quick);

/// What is appended at once: by a triangle that is split, or by a cap.
struct AppendStep {
  std::uint32_t vertices = 0, triangles = 0;
};

struct AppendWork {
  /// "cutting" or "subdividing".
  std::string name;
  std::vector<AppendStep> steps;
};

/// Twelve planes across x, each 1/13 of the model's width after the one before. A triangle that is
/// crossed adds two triangles and a pair of points (thesis 4.5.1); a ring's caps are two fans
/// around two middles (4.5.3).
AppendWork cutting_of(const BufferModel& model);
/// Each triangle is bisected: one point and one triangle more; of large models only the first
/// `steps_at_most`.
AppendWork subdividing_of(const BufferModel& model, std::size_t steps_at_most);

}  // namespace hallux::benchmarks
