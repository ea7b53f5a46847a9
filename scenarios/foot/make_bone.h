/// One bone from its table: what the bones of the parametric foot have in common.
/// Inside this corner only.
#pragma once

#include <string_view>
#include <vector>

#include "scenarios/foot/bone_table.h"
#include "scenarios/foot/foot_bones.h"
#include "scenarios/foot/landmarks.h"
#include "simulator/base/progress.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

/// What tells one bone from another beside its table.
struct BoneKind {
  /// As in the table's line `bone`.
  std::string_view name;
  std::vector<simulator::Landmark> (*find_landmarks)(const LandmarkSources&);
};

/// Builds the bone: field, marching tetrahedra, isotropic remesh with projection, canal, landmarks,
/// placement.
/// ensures outer and canal are closed, genus 0, one component each; the same request gives the same
///         bytes
/// errors  ScenarioError where the table is another bone's, the request is out of range, or the
///         surface came out with another topology (says which); Cancelled where progress said so
/// source  docs/foot.md
simulator::Bone make_bone(const BoneTable& table, const BoneRequest& request, const BoneKind& kind,
                          const Progress& progress);

}  // namespace hallux::scenarios
