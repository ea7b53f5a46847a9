/// The blade is a row of teeth and a grid of balls on its faces. Asking the bone is dear, so each
/// ball remembers what it asked last: a clearance falls by no more than the way since, and most
/// balls are answered by that alone. Walls of open kerfs are the teeth's matter; only beside
/// missing pieces, or near a wall, is the exact search called, at most so many times a tick.
#include "simulator/contact/blade_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "simulator/contact/tool_motion.h"

namespace hallux::simulator {

namespace {

/// Behind the teeth the faces begin: a touch of 0.3 mm must not bring them into the bone.
constexpr double first_row_mm = 1.0;
/// Radius of a tooth's ball. It has one so that a tooth on the surface still knows which way is
/// out.
constexpr double tooth_radius_mm = 0.1;
/// Nearer than this the way to the surface is no direction.
constexpr double direction_mm = 1.0e-5;
/// How deep a point may be in bone and still be led out.
constexpr double way_out_mm = 1.0;
/// However far a surface is.
constexpr double any_mm = std::numeric_limits<double>::infinity();
/// Behind a surface, to ask whether bone stands there.
constexpr double behind_mm = 1.0e-3;
/// Dear answers (walls, rims, missing pieces) in one search; points beyond that are taken to be
/// free.
constexpr int dear_limit = 12;

struct Ball {
  Vec3 in_tool_mm{0.0, 0.0, 0.0};
  double radius_mm = 0.0;
};

Ball ball(std::size_t point, const Blade& blade) noexcept {
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

/// One search over the blade's points; counts what is dear.
class ContactSearch {
 public:
  explicit ContactSearch(const RemainingTissue& bone) noexcept : bone_(bone) {}

  /// The surface within the distance, or around a point less than a millimetre inside; the memory
  /// learns what was asked.
  std::optional<NearSurface> near_surface(const Vec3& point_mm, double within_mm,
                                          SurfaceMemory& memory) noexcept {
    const double moved_mm = memory.moved_mm(point_mm);
    if (memory.is_known && memory.clearance_mm - moved_mm > within_mm) return std::nullopt;
    if (bone_.surface().outside_box_mm(point_mm) > within_mm) return std::nullopt;
    // In its own slot a blade is between two walls, which its teeth feel.
    if (bone_.removed_pieces.empty() && bone_.kerfs.is_open(point_mm)) return std::nullopt;
    if (memory.is_known && memory.clearance_mm + moved_mm < -way_out_mm)
      return near_inside(point_mm, within_mm, std::nullopt);
    const std::optional<NearestPoint> found =
        nearest_by_memory(bone_.surface(), point_mm, any_mm, memory);
    if (!found) return std::nullopt;
    const double side = found->is_inside ? -1.0 : 1.0;
    memory = {point_mm, side * found->distance_mm, true};
    if (found->distance_mm < direction_mm) return near_standing(point_mm, within_mm);
    const NearSurface skin{(side / found->distance_mm) * (point_mm - found->point_mm),
                           side * found->distance_mm};
    if (found->is_inside) return near_inside(point_mm, within_mm, skin);
    if (skin.height_mm > within_mm) return std::nullopt;
    if (!is_gone(found->point_mm - behind_mm * skin.normal)) return skin;
    if (bone_.removed_pieces.empty()) return std::nullopt;
    return near_standing(point_mm, within_mm);
  }

 private:
  bool is_gone(const Vec3& point_mm) const noexcept {
    return bone_.kerfs.is_open(point_mm) || bone_.remaining().is_taken_out(point_mm);
  }

  /// Whether a wall of some kerf is within the distance, be it open there or not.
  bool is_near_kerf(const Vec3& point_mm, double within_mm) const noexcept {
    for (const std::int32_t kerf : bone_.kerfs) {
      const double height_mm = transform_point(bone_.kerfs.kerf_from_bone(kerf), point_mm).z;
      if (std::abs(height_mm) < 0.5 * bone_.kerfs.plane(kerf).thickness_mm + within_mm) return true;
    }
    return false;
  }

  /// A point within the original outer surface. Beside a piece that is missing a single wall may
  /// hold a face.
  std::optional<NearSurface> near_inside(const Vec3& point_mm, double within_mm,
                                         const std::optional<NearSurface>& skin) noexcept {
    if (is_gone(point_mm)) {
      if (!is_near_kerf(point_mm, within_mm)) return std::nullopt;
      return near_standing(point_mm, within_mm);
    }
    const double skin_mm = skin ? std::abs(skin->height_mm) : way_out_mm;
    if (is_near_kerf(point_mm, std::min(skin_mm, way_out_mm)))
      return near_standing(point_mm, way_out_mm);
    return skin_mm < way_out_mm ? skin : std::nullopt;
  }

  /// The exact and dear answer, where kerfs or missing pieces have a say.
  std::optional<NearSurface> near_standing(const Vec3& point_mm, double within_mm) noexcept {
    if (++dear_count_ > dear_limit) return std::nullopt;
    const RemainingBone remaining = bone_.remaining();
    const std::optional<RemainingPoint> found = remaining.nearest(point_mm, within_mm);
    if (!found) return std::nullopt;
    const double side = remaining.contains(point_mm) ? -1.0 : 1.0;
    if (found->distance_mm < direction_mm)
      return NearSurface{found->normal, side * found->distance_mm};
    return NearSurface{(side / found->distance_mm) * (point_mm - found->point_in_bone_mm),
                       side * found->distance_mm};
  }

  const RemainingTissue& bone_;
  int dear_count_ = 0;
};

/// The contacts with one fragment; `slot`: its place among those that are touched.
void add_contacts(const RigidTransform& bone_from_tool, const WoundFragment& standing,
                  std::size_t slot, double margin_mm, BladeMemory& memory,
                  BladeContacts& contacts) noexcept {
  const RigidTransform fragment_from_tool = standing.fragment_from(bone_from_tool);
  ContactSearch search(standing.tissue);
  SurfaceMemory last;
  for (std::size_t point = 0; point < contact_point_count; ++point) {
    const Ball part = ball(point, standing.tissue.kerfs.blade());
    Vec3 arm_mm = transform_direction(fragment_from_tool, part.in_tool_mm);
    const Vec3 centre_mm = fragment_from_tool.translation_mm + arm_mm;
    const double within_mm = part.radius_mm + margin_mm;
    // What the point before it has just learnt may be enough.
    if (last.is_known && last.clearance_mm - length_of(centre_mm - last.asked_mm) > within_mm)
      continue;
    SurfaceMemory& own = memory[point];
    const std::optional<NearSurface> near = search.near_surface(centre_mm, within_mm, own);
    last = own;
    if (!near || near->height_mm > within_mm) continue;
    Vec3 normal = near->normal;
    if (standing.is_moved) {
      normal = transform_direction(standing.wound_from_fragment, normal);
      arm_mm = transform_direction(standing.wound_from_fragment, arm_mm);
    }
    contacts.list[contacts.count++] = {
        slot * contact_point_count + point, arm_mm - part.radius_mm * normal, normal,
        near->height_mm - part.radius_mm, point < contact_tooth_count};
  }
}

}  // namespace

BladeContacts find_contacts(const RigidTransform& bone_from_tool, const Wound& bone,
                            double margin_mm, OfFragments<BladeMemory>& memory) noexcept {
  BladeContacts contacts;
  std::size_t slot = 0;
  bone.visit_near(bone_from_tool.translation_mm, reach_of_blade_mm(bone.blade()) + margin_mm,
                  [&](std::int32_t number, const WoundFragment& standing) {
                    if (slot == touched_fragments) return;
                    add_contacts(bone_from_tool, standing, slot++, margin_mm,
                                 memory[static_cast<std::size_t>(number)], contacts);
                  });
  return contacts;
}

}  // namespace hallux::simulator
