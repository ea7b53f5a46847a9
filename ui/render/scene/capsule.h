/// A capsule of any length and radius as one mesh.
#pragma once

#include <vector>

#include "simulator/mesh/indexed_mesh.h"
#include "ui/render/scene/float_vector.h"

namespace hallux::ui {

/// Unit direction from the end of the axis that it belongs to; w: 0 the axis's beginning, 1 its
/// end.
struct CapsuleVertex {
  Float4 direction_and_end{0.0F};
};

struct CapsuleMesh {
  std::vector<CapsuleVertex> vertices;
  std::vector<simulator::Triangle> triangles;
};

/// Axis z; counter-clockwise from outside.
CapsuleMesh capsule_mesh();

}  // namespace hallux::ui
