/// The nearest point of what stands is looked for among candidates: walls straight across, skin by
/// the tree, lines where two walls meet, fronts along the rim. A candidate counts where bone stands
/// a micrometre behind it. Skin that a slab covers is clipped to what lies outside the slab; a rim
/// behind which a ball of air is known is not asked again. Every candidate lowers the distance that
/// the next ones must beat.
#include "simulator/cutting/remaining/remaining_search.h"

#include <algorithm>
#include <cmath>

#include "simulator/mesh/closest_point.h"

namespace hallux::simulator {

namespace {

/// A step into the bone behind a surface: above the outline's slack (0.2 um) and a nudged plane
/// (0.03 um), below anything that is felt.
constexpr double behind_mm = 1.0e-3;
/// Points nearer than this to a plane or a surface lie on it: rounding.
constexpr double on_mm = 1.0e-6;
/// Inside a kerf by more than this: not on its wall.
constexpr double in_slab_mm = 1.0e-9;

Vec2 closest_on_segment(const RimSegment& segment, const Vec2& place_mm) noexcept {
  const Vec2 way = segment.end_mm - segment.start_mm;
  const double length2 = glm::dot(way, way);
  if (!(length2 > 0.0)) return segment.start_mm;
  return segment.start_mm +
         std::clamp(glm::dot(place_mm - segment.start_mm, way) / length2, 0.0, 1.0) * way;
}

}  // namespace

RemainingSearch::RemainingSearch(const RemainingBone& bone, const Vec3& point_mm,
                                 double within_mm) noexcept
    : bone_(bone), kerfs_(bone.kerfs.numbers()), point_mm_(point_mm), within_mm_(within_mm) {
  for (const std::int32_t kerf : kerfs_) {
    const KerfPlane& plane = bone.kerfs.plane(kerf);
    Slab& slab = slabs_[static_cast<std::size_t>(kerf)];
    slab.axis_x = axis_x(plane.bone_from_kerf);
    slab.axis_y = axis_y(plane.bone_from_kerf);
    slab.axis_z = axis_z(plane.bone_from_kerf);
    slab.origin_mm = plane.bone_from_kerf.translation_mm;
    slab.half_mm = 0.5 * plane.thickness_mm;
    slab.local_mm = slab.to_local(point_mm);
  }
}

/// Outside the original bone, nearest to skin that stands, there is nothing nearer. Inside, skin
/// may be far and takes long to find: it comes last, and is looked for only as far as the best so
/// far.
std::optional<RemainingPoint> RemainingSearch::run() noexcept {
  if (!bone_.original.contains(point_mm_)) {
    const std::optional<NearestPoint> skin = bone_.original.nearest(point_mm_, within_mm_);
    if (!skin) return std::nullopt;
    barren_[0] = {point_mm_, skin->distance_mm};
    const bool is_nearest = skin_stands(skin->point_mm);
    if (is_nearest) within_mm_ = std::min(within_mm_, skin->distance_mm + on_mm);
    try_skin();
    if (is_nearest) return best_;
  }
  for (const std::int32_t kerf : kerfs_) try_walls(kerf);
  for (const std::int32_t kerf : kerfs_) {
    for (const std::int32_t other : kerfs_) {
      if (other > kerf) try_lines(kerf, other);
    }
  }
  for (const std::int32_t kerf : kerfs_) try_rim(kerf);
  if (barren_[0].radius_mm == 0.0) try_skin();
  return best_;
}

bool RemainingSearch::is_open(std::int32_t kerf, const Vec3& point_mm,
                              double margin_mm) const noexcept {
  const Vec3 local = slab(kerf).to_local(point_mm);
  return std::abs(local.z) < slab(kerf).half_mm - margin_mm &&
         field(kerf).is_open(Vec2(local.x, local.y));
}

bool RemainingSearch::is_open_elsewhere(std::int32_t but_kerf,
                                        const Vec3& point_mm) const noexcept {
  for (const std::int32_t kerf : kerfs_) {
    if (kerf != but_kerf && is_open(kerf, point_mm, in_slab_mm)) return true;
  }
  return false;
}

/// Whether bone stands at a point just behind a wall or front of `but_kerf`.
bool RemainingSearch::stands(const Vec3& point_behind_mm, std::int32_t but_kerf) const noexcept {
  return !is_open_elsewhere(but_kerf, point_behind_mm) &&
         bone_.original.contains(point_behind_mm) && !bone_.is_taken_out(point_behind_mm);
}

bool RemainingSearch::skin_stands(const Vec3& on_skin_mm) const noexcept {
  if (is_open_elsewhere(-1, on_skin_mm)) return false;
  return std::none_of(bone_.taken_out.begin(), bone_.taken_out.end(), [&](const Bvh* body) {
    return body->signed_distance_mm(on_skin_mm, 2.0 * on_mm) <= on_mm;
  });
}

void RemainingSearch::offer(RemainingPoint found) noexcept {
  found.distance_mm = length_of(found.point_in_bone_mm - point_mm_);
  if (!(found.distance_mm < within_mm_)) return;
  within_mm_ = found.distance_mm;
  best_ = found;
}

void RemainingSearch::try_walls(std::int32_t kerf) noexcept {
  const Slab& at = slab(kerf);
  for (const std::int32_t side : {1, -1}) {
    const double level_mm = side * at.half_mm;
    if (!(std::abs(at.local_mm.z - level_mm) < within_mm_)) continue;
    if (!field(kerf).is_open(Vec2(at.local_mm.x, at.local_mm.y))) return;
    const Vec3 across(at.local_mm.x, at.local_mm.y, level_mm);
    if (!stands(at.to_bone(across + Vec3(0.0, 0.0, side * behind_mm)), kerf)) continue;
    const double out = -side;
    offer({0.0, at.to_bone(across), out * at.axis_z, BoneSide::Wall, kerf});
  }
}

void RemainingSearch::try_skin() noexcept {
  // Skin exactly as near as a wall is no nearer, but without any kerf the first triangle must
  // count.
  bone_.original.visit_near(point_mm_, within_mm_, [this](const NearTriangle& found) {
    try_triangle(found);
    return within_mm_;
  });
}

void RemainingSearch::offer_skin(const Vec3& on_skin_mm, const NearTriangle& of) noexcept {
  RemainingPoint found;
  found.point_in_bone_mm = on_skin_mm;
  const Vec3 normal =
      glm::cross(of.corner_mm[1] - of.corner_mm[0], of.corner_mm[2] - of.corner_mm[0]);
  const double length = length_of(normal);
  if (length > 0.0) found.normal = normal / length;
  offer(found);
}

void RemainingSearch::try_triangle(const NearTriangle& found) noexcept {
  if (!(squared_length(found.closest_mm - point_mm_) < within_mm_ * within_mm_)) return;
  if (skin_stands(found.closest_mm)) {
    offer_skin(found.closest_mm, found);
    return;
  }
  Polygon whole;
  for (const Vec3& corner : found.corner_mm) whole.corner_mm[whole.count++] = corner;
  try_polygon(whole, kerfs_.begin(), found);
}

/// Divides the polygon by the planes of one kerf after the other. Where the nearest point of a part
/// in a slab is open, the rest of that part is nearest on the rim.
void RemainingSearch::try_polygon(const Polygon& polygon, KerfNumbers::Iterator kerf,
                                  const NearTriangle& of) noexcept {
  if (polygon.count < 3) return;
  if (kerf != KerfNumbers::end()) {
    const Slab& at = slab(*kerf);
    ++kerf;
    double low = at.height_mm(polygon.corner_mm[0]), high = low;
    for (std::size_t i = 1; i < polygon.count; ++i) {
      low = std::min(low, at.height_mm(polygon.corner_mm[i]));
      high = std::max(high, at.height_mm(polygon.corner_mm[i]));
    }
    if (low >= at.half_mm || high <= -at.half_mm) return try_polygon(polygon, kerf, of);
    try_polygon(clipped(polygon, at, 1.0, at.half_mm), kerf, of);
    try_polygon(clipped(polygon, at, -1.0, at.half_mm), kerf, of);
    const Polygon under = clipped(polygon, at, -1.0, -at.half_mm);
    try_polygon(clipped(under, at, 1.0, -at.half_mm), kerf, of);
    return;
  }
  Vec3 nearest_mm(0.0);
  double least_mm2 = within_mm_ * within_mm_;
  bool is_near = false;
  for (std::size_t i = 2; i < polygon.count; ++i) {
    const Vec3 closest =
        closest_on_triangle({polygon.corner_mm[0], polygon.corner_mm[i - 1], polygon.corner_mm[i]},
                            point_mm_)
            .point_mm;
    if (!(squared_length(closest - point_mm_) < least_mm2)) continue;
    least_mm2 = squared_length(closest - point_mm_);
    nearest_mm = closest;
    is_near = true;
  }
  if (is_near && skin_stands(nearest_mm)) offer_skin(nearest_mm, of);
}

/// The part where side * height >= level.
RemainingSearch::Polygon RemainingSearch::clipped(const Polygon& polygon, const Slab& slab,
                                                  double side, double level_mm) noexcept {
  Polygon part;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec3& from = polygon.corner_mm[i];
    const Vec3& to = polygon.corner_mm[(i + 1) % polygon.count];
    const double from_mm = side * slab.height_mm(from) - level_mm;
    const double to_mm = side * slab.height_mm(to) - level_mm;
    if (from_mm >= 0.0) part.corner_mm[part.count++] = from;
    if ((from_mm >= 0.0) == (to_mm >= 0.0)) continue;
    part.corner_mm[part.count++] = from + (from_mm / (from_mm - to_mm)) * (to - from);
  }
  return part;
}

/// Where walls of two kerfs meet: the point of their line that is nearest.
void RemainingSearch::try_lines(std::int32_t first, std::int32_t second) noexcept {
  const Slab& a = slab(first);
  const Slab& b = slab(second);
  const Vec3 along = glm::cross(a.axis_z, b.axis_z);
  const double sine2 = squared_length(along);
  if (sine2 < 1.0e-12) return;
  const double cosine = glm::dot(a.axis_z, b.axis_z);
  for (const std::int32_t side_a : {1, -1}) {
    for (const std::int32_t side_b : {1, -1}) {
      const double up_a = side_a * a.half_mm - a.local_mm.z;
      const double up_b = side_b * b.half_mm - b.local_mm.z;
      const Vec3 way =
          ((up_a - cosine * up_b) / sine2) * a.axis_z + ((up_b - cosine * up_a) / sine2) * b.axis_z;
      if (!(squared_length(way) < within_mm_ * within_mm_)) continue;
      const Vec3 meeting = point_mm_ + way;
      const Vec3 in_a = a.to_local(meeting), in_b = b.to_local(meeting);
      if (!field(first).is_open(Vec2(in_a.x, in_a.y))) continue;
      if (!field(second).is_open(Vec2(in_b.x, in_b.y))) continue;
      const double turn = side_a * side_b * cosine;
      // Behind both walls, as far from one as from the other.
      const Vec3 into = (behind_mm / (1.0 + turn)) * (static_cast<double>(side_a) * a.axis_z +
                                                      static_cast<double>(side_b) * b.axis_z);
      const Vec3 behind = meeting + into;
      if (is_open(first, behind, in_slab_mm) || !stands(behind, first)) continue;
      offer({0.0, meeting, static_cast<double>(-side_a) * a.axis_z, BoneSide::Wall, first});
    }
  }
}

// The fronts: upright faces over the rim of a region, and where they end at skin or at another
// kerf.

void RemainingSearch::try_rim(std::int32_t kerf) noexcept {
  const Slab& at = slab(kerf);
  const double above_mm = std::max(0.0, std::abs(at.local_mm.z) - at.half_mm);
  const auto rim_distance_mm = [&] {
    return std::sqrt(std::max(0.0, within_mm_ * within_mm_ - above_mm * above_mm));
  };
  visit_rim(field(kerf), Vec2(at.local_mm.x, at.local_mm.y), rim_distance_mm(),
            [&](const RimSegment& segment) {
              try_segment(kerf, segment);
              return rim_distance_mm();
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
  const double length = length_of(way);
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
  const double to_start_mm = length_of(rim_mm - segment.start_mm);
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

/// From a point of an upright face where no bone stands, along the face: where bone begins to, at
/// the original surface or where another kerf's slab ends.
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
  for (const std::int32_t other : kerfs_) {
    if (other == kerf || !is_open(other, start, in_slab_mm)) continue;
    const double rise = glm::dot(slab(other).axis_z, way);
    const double level_mm = slab(other).height_mm(start);
    if (rise != 0.0) try_at(((rise > 0.0 ? 1.0 : -1.0) * slab(other).half_mm - level_mm) / rise);
  }
}

}  // namespace hallux::simulator
