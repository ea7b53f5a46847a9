/// The finished face that each planned cut left on the bone that is kept. Inside this room only.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "assessment/metrics/face_plane.h"
#include "assessment/rebuild/rebuild.h"
#include "assessment/rebuild/step_of_kerf.h"
#include "scenarios/plan.h"

namespace hallux::assessment {

/// One face of one kerf, on the side that the plan keeps.
struct CutFace {
  std::int32_t kerf = -1;
  /// Fitted to the samples; normal to the waste, like the plan's.
  FacePlane plane;
  std::vector<Vec3> samples_in_bone_mm;
  double area_mm2 = 0.0;
  /// Of the grid that the samples lie on, and how many of them are the face's border (see
  /// FaceSamples).
  double step_mm = 0.0, border_share = 0.0;
  bool is_finished = false;
  /// Of what was to be sawn, 1 where it is finished (see done_fraction_of).
  double done_fraction = 0.0;
  /// That has the face: 0 is the largest. A face on no piece is sampled where the blade opened
  /// bone.
  std::size_t piece = 0;
  /// It stands on that piece.
  bool is_wall = false;
};

/// The faces of all kerfs that belong to the planned cut `cut` (see cuts_of_kerfs), the one that
/// counts first: finished before unfinished, on a larger piece before a smaller one (a shaving may
/// carry the face of an earlier kerf), then the greater area.
std::vector<CutFace> faces_of_cut(const RebuiltBone& rebuilt, const scenarios::Plan& plan,
                                  std::size_t cut, const StepEvidence& evidence);

/// The face that kerf `kerf` left on the side that the planned cut keeps.
CutFace face_of_kerf(const RebuiltBone& rebuilt, std::int32_t kerf, const scenarios::Plan& plan,
                     std::size_t cut);

/// Whether the blade was at the foot of this point on the face's plane.
bool is_opened_at(const CutFace& face, const RebuiltBone& rebuilt, const Vec3& point_in_bone_mm);

}  // namespace hallux::assessment
