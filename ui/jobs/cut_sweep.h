/// Reads a sweep: the motion of a blade in its plane, as a JSON file that nobody vouches for.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "simulator/cutting/field/kerf.h"
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

/// errors  CutInputError naming the path of the value; a key that is unknown, or twice in one object, is refused
/// source  docs/cutting.md section 6
Sweep read_sweep(const std::filesystem::path& file);
/// The same from a text; `name` stands in the messages.
Sweep parse_sweep(std::string_view text, std::string_view name);

/// A sweep as a kerf's field takes it.
struct BladePath {
  simulator::Blade blade;
  std::vector<simulator::PlanarPose> poses;
};

/// The sweep in a kerf's plane. Its poses are held against `asked`, the plane that it was given with; `kerf` is the one
/// that opens: the same, or one so near that it is used again.
/// errors  CutInputError where a pose leaves `asked` by more than 0.01 mm or 0.1 degree
BladePath path_in_plane(const Sweep& sweep, const simulator::KerfPlane& asked,
                        const simulator::KerfPlane& kerf, std::string_view name);

/// Opens what the blade covers on its way from pose to pose; a turn is followed in steps.
void stamp_motion(simulator::KerfField& field, const simulator::Blade& blade,
                  const simulator::PlanarPose& from, const simulator::PlanarPose& to);

}  // namespace hallux::ui
