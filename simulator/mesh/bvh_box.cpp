#include <algorithm>
#include <cmath>

#include "simulator/mesh/bvh_walk.h"
#include "simulator/mesh/closest_point.h"

/// Queries with a box, and those that end at the first answer.
namespace hallux::simulator {

namespace {

/// The tree's boxes, seen from the box of a query.
class BoxView {
 public:
  explicit BoxView(const OrientedBox& box) noexcept
      : box_from_bone_(inverse(box.bone_from_box)), half_mm_(box.half_mm) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      Vec3 unit(0.0);
      unit[axis] = 1.0;
      size_[axis] = glm::abs(transform_direction(box_from_bone_, unit));
    }
  }

  double squared_mm2(const TreeBox& box) const noexcept {
    const Vec3 low(box.low[0], box.low[1], box.low[2]);
    const Vec3 high(box.high[0], box.high[1], box.high[2]);
    const Vec3 middle = glm::abs(transform_point(box_from_bone_, 0.5 * (low + high)));
    const Vec3 half = 0.5 * (high - low);
    const Vec3 reach = half_mm_ + half.x * size_[0] + half.y * size_[1] + half.z * size_[2];
    // Less what the sums may have lost to rounding: a lower bound may be too low but never too high.
    const Vec3 gap = glm::max(middle - reach - 1.0e-12 * (middle + reach), Vec3(0.0));
    return glm::dot(gap, gap);
  }

  BoxGap gap_of(const TreeSlot& slot) const noexcept {
    std::array<Vec3, 3> corner_mm;
    for (std::size_t k = 0; k < 3; ++k) {
      corner_mm[k] = transform_point(box_from_bone_, slot.corner_mm[k]);
    }
    return box_gap(corner_mm, half_mm_);
  }

 private:
  RigidTransform box_from_bone_;
  Vec3 half_mm_;
  std::array<Vec3, 3>
      size_;  ///< what a unit along each axis of the bone reaches along the box's axes
};

}  // namespace

std::optional<BoxContact> Bvh::nearest_to_box(const OrientedBox& box,
                                              double within_mm) const noexcept {
  const BoxView view(box);
  std::optional<BoxContact> best;
  double limit_mm2 = within_mm * within_mm;
  walk_nearer(
      tree_->nodes, tree_->slots, limit_mm2,
      [&](const TreeBox& tree_box) { return view.squared_mm2(tree_box); },
      [&](const TreeSlot& slot) {
        const BoxGap gap = view.gap_of(slot);
        if (!(gap.squared_mm2 < limit_mm2)) return;
        limit_mm2 = gap.squared_mm2 > 0.0 ? gap.squared_mm2 : -1.0;
        best = BoxContact{std::sqrt(gap.squared_mm2), slot.triangle, gap.on_triangle_mm,
                          gap.on_box_mm};
      });
  if (!best) return best;
  best->on_surface_mm = transform_point(box.bone_from_box, best->on_surface_mm);
  best->on_box_mm = transform_point(box.bone_from_box, best->on_box_mm);
  return best;
}

bool Bvh::touches_box(const OrientedBox& box, double margin_mm) const noexcept {
  const BoxView view(box);
  double limit_mm2 = margin_mm * margin_mm;
  const double margin_mm2 = limit_mm2;
  walk_nearer(
      tree_->nodes, tree_->slots, limit_mm2,
      [&](const TreeBox& tree_box) { return view.squared_mm2(tree_box); },
      [&](const TreeSlot& slot) {
        if (limit_mm2 >= 0.0 && view.gap_of(slot).squared_mm2 <= margin_mm2) limit_mm2 = -1.0;
      });
  return limit_mm2 < 0.0;
}

bool Bvh::touches_ball(const Vec3& point_mm, double radius_mm) const noexcept {
  double limit_mm2 = radius_mm * radius_mm;
  const double radius_mm2 = limit_mm2;
  walk_nearer(
      tree_->nodes, tree_->slots, limit_mm2,
      [&](const TreeBox& box) { return squared_distance(box, point_mm); },
      [&](const TreeSlot& slot) {
        const ClosestPoint closest = slot.is_sliver ? closest_on_edges(slot.corner_mm, point_mm)
                                                    : closest_on_triangle(slot.corner_mm, point_mm);
        const Vec3 apart = point_mm - closest.point_mm;
        if (glm::dot(apart, apart) <= radius_mm2) limit_mm2 = -1.0;
      });
  return limit_mm2 < 0.0;
}

void Bvh::visit_near(const Vec3& point_mm, double within_mm, NearVisit visit,
                     void* context) const noexcept {
  double limit_mm2 = within_mm * within_mm;
  walk_nearer(
      tree_->nodes, tree_->slots, limit_mm2,
      [&](const TreeBox& box) { return squared_distance(box, point_mm); },
      [&](const TreeSlot& slot) {
        const ClosestPoint closest = slot.is_sliver ? closest_on_edges(slot.corner_mm, point_mm)
                                                    : closest_on_triangle(slot.corner_mm, point_mm);
        const NearTriangle found{slot.triangle, slot.corner_mm, closest.point_mm};
        const double lowered_mm = visit(context, found);
        limit_mm2 = lowered_mm < 0.0 ? -1.0 : std::min(limit_mm2, lowered_mm * lowered_mm);
      });
}

}  // namespace hallux::simulator
