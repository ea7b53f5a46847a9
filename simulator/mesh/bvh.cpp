#include "simulator/mesh/bvh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulator/mesh/bvh_walk.h"
#include "simulator/mesh/closest_point.h"

/// The queries. Each walks the tree with a stack of its own of fixed size; boxes are outside their
/// triangles, so no triangle is missed, and the same walk is done on every machine, so ties fall
/// the same way.
namespace hallux::simulator {

namespace {

/// Visits the leaves whose boxes are wanted. `wants(box)` and `visit(slot)` may not throw.
template <typename Wants, typename Visit>
void visit_leaves(const std::vector<TreeNode>& nodes, const std::vector<TreeSlot>& slots,
                  const Wants& wants, const Visit& visit) {
  if (nodes.empty()) return;
  std::array<std::uint32_t, tree_stack_size> stack{};
  std::size_t height = 1;
  while (height > 0) {
    const TreeNode& node = nodes[stack[--height]];
    for (std::size_t side = 0; side < 2; ++side) {
      if (!wants(node.box[side])) continue;
      const std::uint32_t first = node.child[side];
      if (node.count[side] == 0) {
        stack[height++] = first;
        continue;
      }
      for (std::uint32_t i = 0; i < node.count[side]; ++i) visit(slots[first + i]);
    }
  }
}

struct Candidate {
  double squared_mm2 = 0.0;
  ClosestPoint closest;
  const TreeSlot* slot = nullptr;
};

ClosestPoint closest_on(const TreeSlot& slot, const Vec3& point_mm) noexcept {
  return slot.is_sliver ? closest_on_edges(slot.corner_mm, point_mm)
                        : closest_on_triangle(slot.corner_mm, point_mm);
}

void try_slots(const TreeSlot* slot, std::uint32_t count, const Vec3& point_mm,
               Candidate& best) noexcept {
  for (const TreeSlot* const end = slot + count; slot != end; ++slot) {
    const ClosestPoint closest = closest_on(*slot, point_mm);
    const Vec3 apart = point_mm - closest.point_mm;
    const double squared_mm2 = glm::dot(apart, apart);
    if (squared_mm2 < best.squared_mm2) best = {squared_mm2, closest, slot};
  }
}

/// The nearest triangle below the squared distance that `best` comes with.
void find_nearest(const std::vector<TreeNode>& nodes, const std::vector<TreeSlot>& slots,
                  const Vec3& point_mm, Candidate& best) noexcept {
  walk_nearer(
      nodes, slots, point_mm, [&](double squared_mm2) { return squared_mm2 < best.squared_mm2; },
      [&](const TreeSlot* slot, std::uint32_t count, double) {
        try_slots(slot, count, point_mm, best);
      });
}

/// Whether the vertical line through the point meets the triangle, by the parity of its edges to
/// the right of the point. Each edge is judged from its lower end whichever triangle asks, so
/// neighbours always agree and no line slips through between two triangles.
bool is_in_shadow(const std::array<Vec3, 3>& corner_mm, const Vec3& point_mm) noexcept {
  bool is_inside = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = corner_mm[i];
    const Vec3& b = corner_mm[(i + 1) % 3];
    if ((a.y <= point_mm.y) == (b.y <= point_mm.y)) continue;
    const Vec3& lower = a.y < b.y ? a : b;
    const Vec3& upper = a.y < b.y ? b : a;
    const double turn =
        (upper.x - lower.x) * (point_mm.y - lower.y) - (upper.y - lower.y) * (point_mm.x - lower.x);
    if (turn > 0.0) is_inside = !is_inside;
  }
  return is_inside;
}

/// Whether the triangle, met by the vertical line through the point, is met above it.
bool is_above(const std::array<Vec3, 3>& corner_mm, const Vec3& point_mm) noexcept {
  const auto [low, high] = std::minmax({corner_mm[0].z, corner_mm[1].z, corner_mm[2].z});
  if (point_mm.z < low) return true;
  if (point_mm.z >= high) return false;
  const Vec3 normal = glm::cross(corner_mm[1] - corner_mm[0], corner_mm[2] - corner_mm[0]);
  return normal.z * glm::dot(normal, corner_mm[0] - point_mm) > 0.0;
}

/// Distance along the ray, or nothing. The three triple products are exact opposites of the
/// neighbour's, so no ray slips through an edge (as in Embree's Pluecker intersector).
std::optional<double> ray_distance(const std::array<Vec3, 3>& corner_mm, const Vec3& origin_mm,
                                   const Vec3& direction) noexcept {
  const Vec3 a = corner_mm[0] - origin_mm;
  const Vec3 b = corner_mm[1] - origin_mm;
  const Vec3 c = corner_mm[2] - origin_mm;
  const double u = glm::dot(direction, glm::cross(a, b));
  const double v = glm::dot(direction, glm::cross(b, c));
  const double w = glm::dot(direction, glm::cross(c, a));
  const bool is_met = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
  if (!is_met) return std::nullopt;
  const Vec3 normal = glm::cross(corner_mm[1] - corner_mm[0], corner_mm[2] - corner_mm[0]);
  const double toward = glm::dot(normal, direction);
  if (toward == 0.0) return std::nullopt;
  const double distance_mm = glm::dot(normal, a) / toward;
  if (!(distance_mm >= 0.0)) return std::nullopt;
  return distance_mm;
}

/// Whether the endless line comes into the box grown by the radius to all sides.
bool line_meets_box(const TreeBox& box, const Vec3& point_mm, const Vec3& direction,
                    double radius_mm) noexcept {
  double enter = -std::numeric_limits<double>::infinity();
  double leave = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto part = static_cast<glm::length_t>(axis);
    const double low = static_cast<double>(box.low[axis]) - radius_mm - point_mm[part];
    const double high = static_cast<double>(box.high[axis]) + radius_mm - point_mm[part];
    if (direction[part] == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    const double first = low / direction[part];
    const double second = high / direction[part];
    enter = std::max(enter, std::min(first, second));
    leave = std::min(leave, std::max(first, second));
  }
  return enter <= leave;
}

/// Whether the ray meets the box before `limit_mm`. Slabs of a direction component of 0 are decided
/// by the origin.
bool meets_box(const TreeBox& box, const Vec3& origin_mm, const Vec3& direction,
               double limit_mm) noexcept {
  // A margin for the rounding of the two divisions; boxes may be too large but never too small.
  constexpr double margin = 1.0 + 1.0e-14;
  double enter = 0.0;
  double leave = limit_mm;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto part = static_cast<glm::length_t>(axis);
    const double low = static_cast<double>(box.low[axis]) - origin_mm[part];
    const double high = static_cast<double>(box.high[axis]) - origin_mm[part];
    if (direction[part] == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    const double first = low / direction[part];
    const double second = high / direction[part];
    enter = std::max(enter, std::min(first, second));
    leave = std::min(leave, std::max(first, second) * margin);
  }
  return enter <= leave;
}

}  // namespace

Bvh::~Bvh() = default;
Bvh::Bvh(Bvh&&) noexcept = default;
Bvh& Bvh::operator=(Bvh&&) noexcept = default;

Bvh::Bvh(const IndexedMesh& mesh, const BvhBuild& build) {
  auto tree = std::make_unique<Tree>();
  build_nodes(mesh, build, tree->nodes, tree->slots);
  tree->normals = SurfaceNormals{mesh};
  for (TreeSlot& slot : tree->slots) slot.is_sliver = tree->normals.is_sliver(slot.triangle);
  tree_ = std::move(tree);
}

std::optional<NearestPoint> Bvh::nearest(const Vec3& point_mm, double within_mm) const noexcept {
  Candidate best;
  best.squared_mm2 = within_mm * within_mm;
  find_nearest(tree_->nodes, tree_->slots, point_mm, best);
  if (best.slot == nullptr) return std::nullopt;

  NearestPoint nearest;
  nearest.distance_mm = std::sqrt(best.squared_mm2);
  nearest.triangle = best.slot->triangle;
  nearest.point_mm = best.closest.point_mm;
  const Vec3 normal = tree_->normals.at(best.slot->triangle, best.closest);
  // No normal beside slivers: there the crossings are counted.
  nearest.is_inside = normal == Vec3{0.0, 0.0, 0.0}
                          ? contains(point_mm)
                          : glm::dot(point_mm - nearest.point_mm, normal) < 0.0;
  return nearest;
}

double Bvh::outside_box_mm(const Vec3& point_mm) const noexcept {
  if (tree_->nodes.empty()) return std::numeric_limits<double>::infinity();
  const std::array<TreeBox, 2>& boxes = tree_->nodes.front().box;
  return std::sqrt(
      std::min(squared_distance(boxes[0], point_mm), squared_distance(boxes[1], point_mm)));
}

double Bvh::signed_distance_mm(const Vec3& point_mm, double within_mm) const noexcept {
  const std::optional<NearestPoint> found = nearest(point_mm, within_mm);
  if (found) return found->is_inside ? -found->distance_mm : found->distance_mm;
  return contains(point_mm) ? -within_mm : within_mm;
}

bool Bvh::contains(const Vec3& point_mm) const noexcept {
  bool is_inside = false;
  visit_leaves(
      tree_->nodes, tree_->slots,
      [&](const TreeBox& box) {
        return static_cast<double>(box.low[0]) <= point_mm.x &&
               static_cast<double>(box.high[0]) >= point_mm.x &&
               static_cast<double>(box.low[1]) <= point_mm.y &&
               static_cast<double>(box.high[1]) >= point_mm.y &&
               static_cast<double>(box.high[2]) >= point_mm.z;
      },
      [&](const TreeSlot& slot) {
        if (is_in_shadow(slot.corner_mm, point_mm) && is_above(slot.corner_mm, point_mm)) {
          is_inside = !is_inside;
        }
      });
  return is_inside;
}

std::optional<RayHit> Bvh::first_hit(const Vec3& origin_mm, const Vec3& direction) const noexcept {
  std::optional<RayHit> best;
  double limit_mm = std::numeric_limits<double>::infinity();
  visit_leaves(
      tree_->nodes, tree_->slots,
      [&](const TreeBox& box) { return meets_box(box, origin_mm, direction, limit_mm); },
      [&](const TreeSlot& slot) {
        const std::optional<double> found = ray_distance(slot.corner_mm, origin_mm, direction);
        if (!found || !(*found < limit_mm)) return;
        limit_mm = *found;
        best = RayHit{*found, slot.triangle};
      });
  return best;
}

void Bvh::triangles_in_slab(const Vec3& normal, double offset_mm, double half_mm,
                            std::vector<std::uint32_t>& triangles) const {
  // A height is a sum of three products, and rounding keeps the order of products and sums: to the
  // last bit no corner in a box lies below the box's own lowest height or above its highest one.
  const auto height_mm = [&](const Vec3& point_mm) {
    return glm::dot(normal, point_mm) - offset_mm;
  };
  const auto reaches = [&](double lowest_mm, double highest_mm) {
    return lowest_mm <= half_mm && highest_mm >= -half_mm;
  };
  triangles.clear();
  visit_leaves(
      tree_->nodes, tree_->slots,
      [&](const TreeBox& box) {
        Vec3 lowest_mm{box.low[0], box.low[1], box.low[2]};
        Vec3 highest_mm{box.high[0], box.high[1], box.high[2]};
        for (glm::length_t axis = 0; axis < 3; ++axis) {
          if (normal[axis] < 0.0) std::swap(lowest_mm[axis], highest_mm[axis]);
        }
        return reaches(height_mm(lowest_mm), height_mm(highest_mm));
      },
      [&](const TreeSlot& slot) {
        const auto [lowest_mm, highest_mm] =
            std::minmax({height_mm(slot.corner_mm[0]), height_mm(slot.corner_mm[1]),
                         height_mm(slot.corner_mm[2])});
        if (reaches(lowest_mm, highest_mm)) triangles.push_back(slot.triangle);
      });
  std::sort(triangles.begin(), triangles.end());
}

void Bvh::visit_near(const Vec3& point_mm, double within_mm, NearVisit visit,
                     void* context) const noexcept {
  double limit_mm2 = within_mm * within_mm;
  walk_nearer(
      tree_->nodes, tree_->slots, point_mm,
      [&](double squared_mm2) { return squared_mm2 <= limit_mm2; },
      [&](const TreeSlot* slot, std::uint32_t count, double box_mm2) {
        for (const TreeSlot* const end = slot + count; slot != end && box_mm2 <= limit_mm2;
             ++slot) {
          const NearTriangle found{slot->triangle, slot->corner_mm,
                                   closest_on(*slot, point_mm).point_mm};
          const double lowered_mm = visit(context, found);
          limit_mm2 = lowered_mm < 0.0 ? -1.0 : std::min(limit_mm2, lowered_mm * lowered_mm);
        }
      });
}

void Bvh::visit_line(const Vec3& point_mm, const Vec3& direction, double radius_mm, LineVisit visit,
                     void* context) const {
  // More than the rounding of the walk, so that a line through an edge finds both its triangles.
  constexpr double rounding_mm = 1.0e-6;
  visit_leaves(
      tree_->nodes, tree_->slots,
      [&](const TreeBox& box) {
        return line_meets_box(box, point_mm, direction, radius_mm + rounding_mm);
      },
      [&](const TreeSlot& slot) { visit(context, slot.triangle, slot.corner_mm); });
}

}  // namespace hallux::simulator
