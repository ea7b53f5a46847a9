// Along a ray the surface of the bone as it was is crossed in and out; between, what kerfs have
// opened and what lies in a piece that is out does not count. That is asked in short steps, since a
// kerf is half a millimetre.
#include "simulator/sight/blade_ahead.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

/// Half a millimetre apart on a usual blade: what an earlier pass has left is as narrow.
constexpr int teeth_asked = 25;
/// The outer teeth are asked this far inside the blade's sides, which slide along those of a slot.
constexpr double side_mm = 0.1;
constexpr double step_mm = 0.1;
/// A hit is passed by this before the next is looked for.
constexpr double past_mm = 1.0e-4;

/// Where a ray first meets standing bone, and where it leaves it last.
struct Standing {
  std::optional<double> first_mm, last_mm;
};

bool stands(const Vec3& point_mm, const StandingBone& bone) {
  if (bone.kerfs.is_open(point_mm)) return false;
  return std::none_of(bone.taken_out.begin(), bone.taken_out.end(),
                      [&](const Bvh* body) { return body->contains(point_mm); });
}

/// Adds what stands of a stretch of the ray inside the bone as it was.
void add_stretch(Standing& found, const Vec3& from_mm, const Vec3& feed, double begin_mm,
                 double end_mm, const StandingBone& bone) {
  for (double at_mm = begin_mm; at_mm < end_mm; at_mm += step_mm) {
    const double middle_mm = std::min(at_mm + 0.5 * step_mm, end_mm);
    if (!stands(from_mm + middle_mm * feed, bone)) continue;
    if (!found.first_mm) found.first_mm = at_mm;
    found.last_mm = std::min(at_mm + step_mm, end_mm);
  }
}

Standing standing_along(const Vec3& from_mm, const Vec3& feed, const StandingBone& bone) {
  Standing found;
  bool is_inside = bone.whole.contains(from_mm);
  double at_mm = 0.0;
  while (at_mm < looked_ahead_mm) {
    const std::optional<RayHit> hit = bone.whole.first_hit(from_mm + at_mm * feed, feed);
    const double next_mm = hit ? at_mm + hit->distance_mm : looked_ahead_mm;
    if (is_inside) add_stretch(found, from_mm, feed, at_mm, next_mm, bone);
    if (!hit) break;
    at_mm = next_mm + past_mm;
    is_inside = !is_inside;
  }
  return found;
}

}  // namespace

bool is_standing(const Vec3& point_mm, const StandingBone& bone) noexcept {
  return bone.whole.contains(point_mm) && stands(point_mm, bone);
}

BladeAhead look_ahead(const RigidTransform& bone_from_tool, const Blade& blade,
                      const StandingBone& bone) {
  const Vec3 feed = axis_x(bone_from_tool), along = axis_y(bone_from_tool);
  BladeAhead ahead;
  double nearest_mm = looked_ahead_mm;
  for (int tooth = 0; tooth < teeth_asked; ++tooth) {
    const double share = static_cast<double>(tooth) / (teeth_asked - 1) - 0.5;
    const Vec3 tooth_mm =
        bone_from_tool.translation_mm + share * (blade.width_mm - 2.0 * side_mm) * along;
    const Standing found = standing_along(tooth_mm, feed, bone);
    if (found.first_mm)
      ahead.to_bone_mm = std::min(ahead.to_bone_mm.value_or(looked_ahead_mm), *found.first_mm);
    if (found.last_mm)
      ahead.to_far_side_mm = std::max(ahead.to_far_side_mm.value_or(0.0), *found.last_mm);
    nearest_mm = std::min(nearest_mm, bone.whole.signed_distance_mm(tooth_mm, nearest_mm));
  }
  ahead.beside_mm = std::max(0.0, nearest_mm);
  return ahead;
}

BladeAhead ahead_of_both(const BladeAhead& one, const BladeAhead& other) noexcept {
  BladeAhead both = one;
  if (other.to_bone_mm)
    both.to_bone_mm = std::min(one.to_bone_mm.value_or(looked_ahead_mm), *other.to_bone_mm);
  if (other.to_far_side_mm)
    both.to_far_side_mm = std::max(one.to_far_side_mm.value_or(0.0), *other.to_far_side_mm);
  both.beside_mm = std::min(one.beside_mm, other.beside_mm);
  return both;
}

}  // namespace hallux::simulator
