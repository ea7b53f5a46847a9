// Order: loft, bumps and grooves in the table's order, the grown eminence and the sulcus beside it,
// relief. Everything works in the table's millimetres; at() stretches x around it. Source:
// docs/foot.md.
#include "scenarios/foot/bone_field.h"

#include <algorithm>
#include <string_view>

#include "scenarios/foot/relief.h"
#include "simulator/base/check.h"

namespace hallux::scenarios {
namespace {

/// A bump acts near the surface only; further out it would make islands in free air.
constexpr double bump_full_mm = 2.0;
constexpr double bump_none_mm = 4.0;
/// exp(-20) of a bump's height is below a nanometre.
constexpr double bump_reach = 40.0;
constexpr int newton_steps = 12;
constexpr double newton_close_mm = 1e-9;
/// The table's own bump, which a grown eminence replaces.
constexpr std::string_view eminence_bump = "eminence";

Dual length_of(const Vec3& offset) {
  const double length = std::sqrt(glm::dot(offset, offset) + 1e-18);
  return {length, offset / length};
}

Dual bump(const Dual& distance, const Feature& feature, const Vec3& point_mm) {
  const double near = 1.0 - smooth_step(bump_full_mm, bump_none_mm, std::abs(distance.value));
  const Vec3 q = (point_mm - feature.centre_mm) / feature.extent_mm;
  const double squared = glm::dot(q, q);
  if (near <= 0.0 || squared > bump_reach) return distance;
  const Dual exponent{-0.5 * squared, -q / feature.extent_mm};
  return distance - exp(exponent) * (feature.height_mm * near);
}

/// Distance to the segment from `from` to `to`.
Dual segment_distance(const Vec3& from, const Vec3& to, const Vec3& point_mm) {
  const Vec3 along = to - from;
  const double t = glm::dot(point_mm - from, along) / glm::dot(along, along);
  return length_of(point_mm - (from + along * std::clamp(t, 0.0, 1.0)));
}

Dual carve(const Dual& distance, const Dual& tool, double blend_mm) {
  return smooth_max(distance, -tool, blend_mm);
}

/// Exact on the ellipsoid, a fair distance near it.
Dual ellipsoid_distance(const Vec3& centre_mm, const Vec3& radii_mm, const Vec3& point_mm) {
  const Vec3 offset = point_mm - centre_mm;
  const Dual size = length_of(offset / radii_mm);
  const Vec3 slope = size.slope / radii_mm;
  const double steepness = std::sqrt(glm::dot(slope, slope));
  return {(size.value - 1.0) / steepness, slope / steepness};
}

/// 1 on the head's cartilage, 0 beyond its edge, for a point near the head.
double cartilage_share(const HeadCartilage& c, const Vec3& point_mm) {
  const Vec3 offset = point_mm - c.centre_mm;
  if (offset.x < -c.radius_mm) return 0.0;
  const double across = elementary::atan2(offset.z, std::max(offset.x, 0.0));
  const double up = elementary::atan2(offset.y, offset.x);
  const double across_limit = offset.z < 0.0 ? c.medial_rad : c.lateral_rad;
  const double up_limit = offset.y < 0.0 ? c.plantar_rad : c.dorsal_rad;
  // Past a right angle the transverse angle is taken in the tilted plane through the joint's axis.
  const double in_plane = std::sqrt(offset.x * offset.x + offset.y * offset.y);
  const double turned = elementary::atan2(std::abs(offset.z), in_plane);
  const double used = std::min(std::abs(across), turned);
  constexpr double edge_rad = 0.05;
  return (1.0 - smooth_step(across_limit - edge_rad, across_limit + edge_rad, used)) *
         (1.0 - smooth_step(up_limit - edge_rad, up_limit + edge_rad, std::abs(up)));
}

}  // namespace

BoneField::BoneField(const BoneTable& table, double length_mm, double eminence_mm)
    : table_(table),
      loft_(table),
      stretch_(length_mm / table.length_mm),
      eminence_mm_(eminence_mm) {
  CHECK(eminence_mm <= 0.0 || table.eminence.has_value());
  double reach_y_mm = 0.0;
  double reach_z_mm = 0.0;
  for (const Station& s : table.stations) {
    const double radius = std::max(s.half_width_mm, s.half_height_mm) * 1.3;
    reach_y_mm = std::max(reach_y_mm, std::abs(s.centre_y_mm) + radius);
    reach_z_mm = std::max(reach_z_mm, std::abs(s.centre_z_mm) + radius);
  }
  constexpr double room_mm = 3.0;
  low_mm_ = {-room_mm, -reach_y_mm - room_mm, -reach_z_mm - eminence_mm - room_mm};
  high_mm_ = {length_mm + room_mm, reach_y_mm + room_mm, reach_z_mm + room_mm};
  if (eminence_mm > 0.0) lay_sulcus();
}

void BoneField::lay_sulcus() {
  const EminenceShape& shape = *table_.eminence;
  for (Vec3 point : shape.sulcus_mm) {
    Vec3 outward{0.0, 0.0, 0.0};
    for (int step = 0; step < newton_steps; ++step) {
      const Dual distance = body(point, loft_.parts_at(point));
      const Vec3 slope{distance.slope.x, distance.slope.y, 0.0};
      const double squared = glm::dot(slope, slope);
      point -= slope * (distance.value / squared);
      outward = slope / std::sqrt(squared);
    }
    sulcus_bottom_mm_.push_back(point - outward * shape.sulcus_depth_mm);
    sulcus_line_mm_.push_back(point + outward * (shape.sulcus_radius_mm - shape.sulcus_depth_mm));
  }
}

Vec3 BoneField::stretched(const Vec3& point_in_table_mm) const noexcept {
  return {point_in_table_mm.x * stretch_, point_in_table_mm.y, point_in_table_mm.z};
}

Dual BoneField::with_eminence(const Dual& distance, const Vec3& point_mm) const noexcept {
  const EminenceShape& shape = *table_.eminence;
  const Vec3 centre = shape.centre_mm - Vec3{0.0, 0.0, eminence_mm_};
  Dual grown =
      smooth_min(distance, ellipsoid_distance(centre, shape.radii_mm, point_mm), shape.blend_mm);
  Dual groove{1e3};
  for (std::size_t i = 0; i + 1 < sulcus_line_mm_.size(); ++i) {
    const Dual part = segment_distance(sulcus_line_mm_[i], sulcus_line_mm_[i + 1], point_mm);
    if (part.value < groove.value) groove = part;
  }
  return carve(grown, groove - shape.sulcus_radius_mm, shape.sulcus_blend_mm);
}

double BoneField::roughness(const Vec3& point_mm, const LoftDistances& parts) const noexcept {
  const double t = point_mm.x / table_.length_mm;
  const double metaphysis = 1.0 - smooth_step(0.2, 0.35, t) + smooth_step(0.65, 0.8, t);
  const double facet = smooth_step(0.0, 1.5, parts.base.value - parts.side.value);
  double share = (0.45 + 0.55 * metaphysis) * (1.0 - facet) *
                 (1.0 - cartilage_share(table_.cartilage, point_mm));
  if (eminence_mm_ > 0.0) {
    // The apex is where the eminence is measured: smooth, so that its height is what was asked for.
    const EminenceShape& shape = *table_.eminence;
    const Vec3 apex = shape.centre_mm - Vec3{0.0, 0.0, shape.radii_mm.z + eminence_mm_};
    share *= smooth_step(2.5, 5.0, length_of(point_mm - apex).value);
  }
  return table_.relief_mm * share;
}

Dual BoneField::body(const Vec3& point_mm, const LoftDistances& parts) const noexcept {
  Dual distance = loft_.joined(parts);
  for (const Feature& feature : table_.features) {
    if (feature.kind == FeatureKind::Groove) {
      const Dual line = segment_distance(feature.centre_mm, feature.end_mm, point_mm);
      distance = carve(distance, line - feature.radius_mm, feature.blend_mm);
    } else if (eminence_mm_ <= 0.0 || feature.name != eminence_bump) {
      distance = bump(distance, feature, point_mm);
    }
  }
  return distance;
}

Dual BoneField::featured(const Vec3& point_mm) const noexcept {
  const LoftDistances parts = loft_.parts_at(point_mm);
  Dual distance = body(point_mm, parts);
  if (eminence_mm_ > 0.0) distance = with_eminence(distance, point_mm);
  if (std::abs(distance.value) > bump_none_mm) return distance;
  const double rough_mm = roughness(point_mm, parts);
  return rough_mm > 0.0 ? distance - relief_at(point_mm) * rough_mm : distance;
}

Dual BoneField::at(const Vec3& point_in_bone_mm) const noexcept {
  const Vec3 point_mm{point_in_bone_mm.x / stretch_, point_in_bone_mm.y, point_in_bone_mm.z};
  Dual distance = featured(point_mm);
  distance.slope.x /= stretch_;
  return distance;
}

bool BoneField::is_head_cartilage(const Vec3& point_in_bone_mm) const noexcept {
  const Vec3 point_mm{point_in_bone_mm.x / stretch_, point_in_bone_mm.y, point_in_bone_mm.z};
  return cartilage_share(table_.cartilage, point_mm) > 0.5;
}

Vec3 BoneField::onto_surface(const Vec3& point_in_bone_mm) const noexcept {
  Vec3 point = point_in_bone_mm;
  for (int step = 0; step < newton_steps; ++step) {
    const Dual distance = at(point);
    if (std::abs(distance.value) < newton_close_mm) break;
    point -= distance.slope * (distance.value / glm::dot(distance.slope, distance.slope));
  }
  return point;
}

}  // namespace hallux::scenarios
