/// Reads a sweep: the motion of a blade in its plane, as a JSON file that nobody vouches for.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "simulator/cutting/kerf.h"
#include "simulator/mesh/mesh_error.h"

namespace hallux::ui {

/// A plane or sweep that the mesh cannot be cut with, said like what is wrong with a mesh: file, place, mend.
class CutInputError : public simulator::MeshError {
 public:
  using MeshError::MeshError;
};

struct SweepPose {
  Vec3 tip_in_mesh_mm{0.0, 0.0, 0.0};  ///< middle of the tooth line
  Vec3 direction{1.0, 0.0, 0.0};       ///< unit length
};

struct Sweep {
  double width_mm = 0.0, depth_mm = 0.0;
  std::vector<SweepPose> poses;  ///< at least one
};

/// source  docs/cutting.md section 6
/// errors  CutInputError
Sweep read_sweep(const std::filesystem::path& file);
/// The same from a text; `name` stands in the messages.
Sweep parse_sweep(std::string_view text, std::string_view name);

/// Opens what the blade covers on its way.
/// needs   the field lies in the plane
/// errors  CutInputError where a pose leaves the plane by more than 0.01 mm or 0.1 degree
void stamp_sweep(simulator::KerfField& field, const simulator::KerfPlane& plane, const Sweep& sweep,
                 std::string_view name);

}  // namespace hallux::ui
