#include <algorithm>
#include <cmath>

#include "simulator/cutting/remaining/remaining_search.h"

/// The fronts: upright faces over the rim of a region, and where they end at skin or at another kerf.
namespace hallux::simulator {

namespace {

constexpr double behind_mm = 1.0e-3;
constexpr double in_slab_mm = 1.0e-9;

Vec2 closest_on_segment(const RimSegment& segment, const Vec2& place_mm) noexcept {
  const Vec2 way = segment.end_mm - segment.start_mm;
  const double length2 = glm::dot(way, way);
  if (!(length2 > 0.0)) return segment.start_mm;
  return segment.start_mm +
         std::clamp(glm::dot(place_mm - segment.start_mm, way) / length2, 0.0, 1.0) * way;
}

}  // namespace

void RemainingSearch::try_rim(std::int32_t kerf) noexcept {
  const Slab& at = slab(kerf);
  const double above_mm = std::max(0.0, std::abs(at.local_mm.z) - at.half_mm);
  const auto reach_mm = [&] {
    return std::sqrt(std::max(0.0, within_mm_ * within_mm_ - above_mm * above_mm));
  };
  visit_rim(field(kerf), Vec2(at.local_mm.x, at.local_mm.y), reach_mm(),
            [&](const RimSegment& segment) {
              try_segment(kerf, segment);
              return reach_mm();
            });
}

/// The ball's whole inside is in the air, so an upright face that it holds is no front.
bool RemainingSearch::is_barren(const Slab& at, const RimSegment& segment) const noexcept {
  for (const Barren& ball : barren_) {
    const Vec3 centre = at.to_local(ball.centre_mm);
    const double up_mm = std::abs(centre.z) + at.half_mm;
    double furthest_mm2 = 0.0;
    for (const Vec2& end : {segment.start_mm, segment.end_mm}) {
      const Vec2 arm = end - Vec2(centre.x, centre.y);
      furthest_mm2 = std::max(furthest_mm2, glm::dot(arm, arm) + up_mm * up_mm);
    }
    const double safe_mm = ball.radius_mm - 2.0 * behind_mm;
    if (safe_mm > 0.0 && furthest_mm2 < safe_mm * safe_mm) return true;
  }
  return false;
}

void RemainingSearch::try_segment(std::int32_t kerf, const RimSegment& segment) noexcept {
  const Slab& at = slab(kerf);
  const Vec2 place(at.local_mm.x, at.local_mm.y);
  const Vec2 rim_mm = closest_on_segment(segment, place);
  const double height_mm = std::clamp(at.local_mm.z, -at.half_mm, at.half_mm);
  const Vec2 arm = rim_mm - place;
  const double up_mm = height_mm - at.local_mm.z;
  if (!(glm::dot(arm, arm) + up_mm * up_mm < within_mm_ * within_mm_)) return;
  if (is_barren(at, segment)) return;
  const Vec2 way = segment.end_mm - segment.start_mm;
  const double length = std::sqrt(glm::dot(way, way));
  if (!(length > 0.0)) return;
  const Vec3 along(way.x / length, way.y / length, 0.0);
  const FrontPoint front{Vec3(rim_mm.x, rim_mm.y, height_mm), Vec3(along.y, -along.x, 0.0)};
  const Vec3 behind = at.to_bone(front.local_mm + behind_mm * front.outward);
  if (stands(behind, kerf)) {
    offer_front(kerf, front);
    return;
  }
  if (!bone_.original.contains(behind)) {
    barren_[1] = {behind, bone_.original.signed_distance_mm(behind)};
    if (is_barren(at, segment)) return;
  }
  const double to_start_mm =
      std::sqrt(glm::dot(rim_mm - segment.start_mm, rim_mm - segment.start_mm));
  try_along(kerf, front, Vec3(0.0, 0.0, 1.0), at.half_mm - height_mm);
  try_along(kerf, front, Vec3(0.0, 0.0, -1.0), at.half_mm + height_mm);
  try_along(kerf, front, along, length - to_start_mm);
  try_along(kerf, front, -along, to_start_mm);
}

void RemainingSearch::offer_front(std::int32_t kerf, const FrontPoint& front) noexcept {
  const Slab& at = slab(kerf);
  const Vec3 into_kerf = -front.outward.x * at.axis_x - front.outward.y * at.axis_y;
  offer({0.0, at.to_bone(front.local_mm), into_kerf, BoneSide::Front, kerf});
}

/// From a point of an upright face where no bone stands, along the face: where bone begins to, at the original surface or
/// where another kerf's slab ends.
void RemainingSearch::try_along(std::int32_t kerf, const FrontPoint& from, const Vec3& direction,
                                double room_mm) noexcept {
  const Slab& at = slab(kerf);
  const Vec3 start = at.to_bone(from.local_mm + behind_mm * from.outward);
  const Vec3 way = at.to_bone(from.local_mm + behind_mm * from.outward + direction) - start;
  const auto try_at = [&](double along_mm) {
    if (!(along_mm >= 0.0 && along_mm <= room_mm)) return;
    if (!stands(start + (along_mm + behind_mm) * way, kerf)) return;
    offer_front(kerf, {from.local_mm + along_mm * direction, from.outward});
  };
  const std::optional<RayHit> hit = bone_.original.first_hit(start, way);
  if (hit) try_at(hit->distance_mm);
  for (std::int32_t other = 0; other < bone_.kerfs.count(); ++other) {
    if (other == kerf || !is_open(other, start, in_slab_mm)) continue;
    const double rise = glm::dot(slab(other).axis_z, way);
    const double level_mm = slab(other).height_mm(start);
    if (rise != 0.0) try_at(((rise > 0.0 ? 1.0 : -1.0) * slab(other).half_mm - level_mm) / rise);
  }
}

}  // namespace hallux::simulator
