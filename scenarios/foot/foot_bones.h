/// The bones of the foot that a scenario may ask for: one row each, read by everybody who makes,
/// checks or draws a bone by its name. Inside this room only.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

struct BoneTable;
struct LandmarkSources;

struct BoneRequest {
  /// Base facet to head along x; 0 keeps the table's own length.
  double length_mm = 0.0;
  /// Medial prominence beyond the table's datum; 0 keeps the table's own bump.
  double eminence_mm = 0.0;
  /// Edge length of the outer surface after remeshing.
  double edge_mm = 0.3;
  bool with_canal = true;
};

/// One row. A further bone is its table in tables/, a function for its landmarks where no bone of
/// its kind has one yet, and a row in foot_bones.cpp.
struct FootBone {
  /// As in the table's line `bone`, and in words.
  std::string_view name, title;
  BoneTable (*table)();
  std::vector<simulator::Landmark> (*find_landmarks)(const LandmarkSources&);
  /// The name of the row that is drawn beside it.
  std::string_view neighbour;
  /// What a scenario may ask for, with room for the smallest and the largest foot.
  double length_low_mm = 0.0, length_high_mm = 0.0;
  /// As the table has it: a scenario must say how large it is.
  bool has_eminence = false;
};

/// Lives as long as the program.
std::span<const FootBone> foot_bones() noexcept;

/// Null where no row has that name.
const FootBone* find_foot_bone(std::string_view name,
                               std::span<const FootBone> bones = foot_bones()) noexcept;

/// "first_metatarsal, first_proximal_phalanx", in the order of the rows.
std::string names_of(std::span<const FootBone> bones);

/// The bone of a row from its own table; promises and errors as make_bone.
simulator::Bone make_foot_bone(const FootBone& bone, const BoneRequest& request,
                               const Progress& progress = {});

}  // namespace hallux::scenarios
