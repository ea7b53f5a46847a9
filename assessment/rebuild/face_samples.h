/// Points on a finished face, spread evenly so that each stands for the same area.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <vector>

#include "assessment/rebuild/rebuild.h"
#include "scenarios/site/planned_window.h"

namespace hallux::assessment {

/// Samples lie on a grid in the kerf's plane, made finer until there are enough or the grid is as
/// fine as the field's.
inline constexpr double sample_step_mm = 0.25;
inline constexpr std::size_t samples_wanted = 200;

struct FaceSamples {
  std::vector<Vec3> points_in_bone_mm;
  /// Of the face, as far as samples tell.
  double area_mm2 = 0.0;
  /// Of the grid that they lie on.
  double step_mm = sample_step_mm;
  /// Of all samples, those that lack one of their eight neighbours: the face's border.
  double border_share = 0.0;
};

/// Samples of one wall of a kerf on a piece; empty where the piece has nothing of that wall.
/// step_mm  of the grid before it is made finer
FaceSamples sample_wall(const simulator::CutSolid& piece, const simulator::FaceSource& wall,
                        const simulator::KerfPlane& plane, double step_mm = sample_step_mm);

/// Samples of what the blade opened inside the bone, at the height of the wall on `side`.
FaceSamples sample_opened(const RebuiltKerf& kerf, const simulator::KerfField& field,
                          std::int32_t side);

/// What the blade opened inside the bone, on both walls, on a grid of this step.
std::vector<Vec3> points_opened(const RebuiltKerf& kerf, const simulator::KerfField& field,
                                double step_mm);

/// The first kerf of that bone whose slab is open at this point of its frame, but for one; -1 where
/// none is.
std::int32_t kerf_open_at(const RebuiltBone& rebuilt, std::size_t bone, const Vec3& point_mm,
                          std::int32_t but_for = -1);

/// How much of the window, of the regions that the blade touched, kerf `index` opened [0, 1]. Bone
/// that this blade would reach only through another kerf counts as done: there the waste is free
/// already.
double opened_share(const RebuiltBone& rebuilt, std::int32_t index,
                    const scenarios::PlannedWindow& window);
/// The same of the window of a planned face, whichever way the blade came.
double opened_share(const RebuiltBone& rebuilt, std::int32_t index,
                    const scenarios::FaceWindow& window);

}  // namespace hallux::assessment
