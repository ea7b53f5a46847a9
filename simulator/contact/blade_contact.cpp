#include "simulator/contact/blade_contact.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "simulator/contact/tool_motion.h"

namespace hallux::simulator {

namespace {

/// Behind the teeth the faces begin: a touch of 0.3 mm must not bring them into the bone.
constexpr double first_row_mm = 1.0;
/// Radius of a tooth's ball. It has one so that a tooth on the surface still knows which way is out.
constexpr double tooth_radius_mm = 0.1;
/// Nearer than this the way to the surface is no direction.
constexpr double direction_mm = 1.0e-5;
/// How deep a point may be in bone and still be led out.
constexpr double way_out_mm = 1.0;
/// Behind a surface, to ask whether bone stands there.
constexpr double behind_mm = 1.0e-3;

struct Ball {
  Vec3 in_tool_mm{0.0, 0.0, 0.0};
  double radius_mm = 0.0;
};

Ball ball(std::size_t point, const BladeSize& blade) noexcept {
  if (point < contact_tooth_count) {
    const double share_mm = blade.width_mm / static_cast<double>(tooth_count);
    const double along_mm =
        (2.0 * static_cast<double>(point) + 0.5) * share_mm - 0.5 * blade.width_mm;
    return {{-tooth_radius_mm, along_mm, 0.0}, tooth_radius_mm};
  }
  const std::size_t place = point - contact_tooth_count;
  const double radius_mm = 0.5 * blade.kerf_mm;
  const auto share = [](std::size_t index, std::size_t count) {
    return static_cast<double>(index) / static_cast<double>(count - 1);
  };
  const double first_mm = std::min(first_row_mm, 0.5 * blade.depth_mm);
  const double back_mm =
      first_mm + share(place / contact_columns, contact_rows) * (blade.depth_mm - first_mm);
  const double along_mm =
      (share(place % contact_columns, contact_columns) - 0.5) * (blade.width_mm - 2.0 * radius_mm);
  return {{-back_mm, along_mm, 0.0}, radius_mm};
}

struct NearSurface {
  Vec3 normal{0.0, 0.0, 0.0};
  double height_mm = 0.0;  ///< outside of it; negative inside
};

double length_mm(const Vec3& way) noexcept { return std::sqrt(glm::dot(way, way)); }

/// The exact and dear answer, where kerfs or missing pieces have a say.
std::optional<NearSurface> near_standing(const Vec3& point_mm, double within_mm,
                                         const StandingBone& bone) noexcept {
  const RemainingBone remaining = bone.remaining();
  const std::optional<RemainingPoint> found = remaining.nearest(point_mm, within_mm);
  if (!found) return std::nullopt;
  const double side = remaining.contains(point_mm) ? -1.0 : 1.0;
  if (found->distance_mm < direction_mm)
    return NearSurface{found->normal, side * found->distance_mm};
  return NearSurface{(side / found->distance_mm) * (point_mm - found->point_in_bone_mm),
                     side * found->distance_mm};
}

/// Whether a wall of some kerf is within the distance, be it open there or not.
bool is_near_kerf(const Vec3& point_mm, double within_mm, const KerfSet& kerfs) noexcept {
  for (std::int32_t kerf = 0; kerf < kerfs.count(); ++kerf) {
    const double height_mm = transform_point(kerfs.kerf_from_bone(kerf), point_mm).z;
    if (std::abs(height_mm) < 0.5 * kerfs.plane(kerf).thickness_mm + within_mm) return true;
  }
  return false;
}

bool is_gone(const Vec3& point_mm, const StandingBone& bone) noexcept {
  return bone.kerfs.is_open(point_mm) || bone.remaining().is_taken_out(point_mm);
}

/// A point within the original outer surface. In an open kerf the blade is between two walls that its teeth feel; only
/// where a piece is missing beside it a single wall may hold a face.
std::optional<NearSurface> near_inside(const Vec3& point_mm, double within_mm,
                                       const std::optional<NearSurface>& skin,
                                       const StandingBone& bone) noexcept {
  if (is_gone(point_mm, bone)) {
    if (bone.removed_pieces.empty() || !is_near_kerf(point_mm, within_mm, bone.kerfs))
      return std::nullopt;
    return near_standing(point_mm, within_mm, bone);
  }
  const double skin_mm = skin ? std::abs(skin->height_mm) : way_out_mm;
  if (is_near_kerf(point_mm, std::min(skin_mm, way_out_mm), bone.kerfs))
    return near_standing(point_mm, way_out_mm, bone);
  return skin_mm < way_out_mm ? skin : std::nullopt;
}

/// The original surface where it is near, or within reach from outside; the memory learns what was asked.
std::optional<NearSurface> near_surface(const Vec3& point_mm, double within_mm,
                                        const StandingBone& bone, SurfaceMemory& memory) noexcept {
  const double moved_mm = length_mm(point_mm - memory.asked_mm);
  if (memory.is_known && memory.clearance_mm - moved_mm > within_mm) return std::nullopt;
  if (memory.is_known && memory.clearance_mm + moved_mm < -way_out_mm)
    return near_inside(point_mm, within_mm, std::nullopt, bone);
  const std::optional<NearestPoint> found = bone.original.surface().nearest(point_mm);
  if (!found) return std::nullopt;
  const double side = found->is_inside ? -1.0 : 1.0;
  memory = {point_mm, side * found->distance_mm, true};
  if (found->distance_mm < direction_mm) return near_standing(point_mm, within_mm, bone);
  const NearSurface skin{(side / found->distance_mm) * (point_mm - found->point_mm),
                         side * found->distance_mm};
  if (found->is_inside) return near_inside(point_mm, within_mm, skin, bone);
  if (skin.height_mm > within_mm) return std::nullopt;
  if (!is_gone(found->point_mm - behind_mm * skin.normal, bone)) return skin;
  if (bone.removed_pieces.empty()) return std::nullopt;
  return near_standing(point_mm, within_mm, bone);
}

}  // namespace

BladeContacts find_contacts(const RigidTransform& bone_from_tool, const StandingBone& bone,
                            double reach_mm, BladeMemory& memory) noexcept {
  BladeContacts contacts;
  SurfaceMemory last;
  for (std::size_t point = 0; point < contact_point_count; ++point) {
    const Ball part = ball(point, bone.kerfs.blade());
    const Vec3 arm_mm = transform_direction(bone_from_tool, part.in_tool_mm);
    const Vec3 centre_mm = bone_from_tool.translation_mm + arm_mm;
    const double within_mm = part.radius_mm + reach_mm;
    // What the point before it has just learnt may be enough.
    if (last.is_known && last.clearance_mm - length_mm(centre_mm - last.asked_mm) > within_mm)
      continue;
    SurfaceMemory& own = memory[point];
    const std::optional<NearSurface> near = near_surface(centre_mm, within_mm, bone, own);
    last = own;
    if (!near || near->height_mm > within_mm) continue;
    contacts.list[contacts.count++] = {point, arm_mm - part.radius_mm * near->normal, near->normal,
                                       near->height_mm - part.radius_mm};
  }
  return contacts;
}

}  // namespace hallux::simulator
