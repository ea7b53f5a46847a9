/// Reads a sweep: the motion of a blade in its plane, as a JSON file that nobody vouches for.
/// Inside this corner only.
#pragma once

#include <filesystem>
#include <string_view>

#include "simulator/bone/blade_sweep.h"
#include "simulator/mesh/mesh_error.h"

namespace hallux::ui {

/// A plane or sweep that the mesh cannot be cut with, said like what is wrong with a mesh: file,
/// place, mend.
class CutInputError : public simulator::MeshError {
 public:
  using MeshError::MeshError;
};

/// errors  CutInputError naming the path of the value; a key that is unknown, or twice in one
///         object, is refused
/// source  docs/cutting.md section 6
simulator::Sweep read_sweep(const std::filesystem::path& file);
/// The same from a text; `name` stands in the messages.
simulator::Sweep parse_sweep(std::string_view text, std::string_view name);

/// Holds a sweep's poses against the plane that it was given with.
/// errors  CutInputError where a pose leaves it by more than 0.01 mm or 0.1 degree
void expect_in_plane(const simulator::Sweep& sweep, const simulator::KerfPlane& asked,
                     std::string_view name);

}  // namespace hallux::ui
