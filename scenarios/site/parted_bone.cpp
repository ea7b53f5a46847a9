#include "scenarios/site/parted_bone.h"

#include <algorithm>

namespace hallux::scenarios {

namespace {

constexpr double grid_mm = 0.5;

struct Box {
  Vec3 low_mm{0.0, 0.0, 0.0}, high_mm{0.0, 0.0, 0.0};
};

Box box_of(const simulator::IndexedMesh& mesh) {
  Box box{mesh.points_mm.front(), mesh.points_mm.front()};
  for (const Vec3& point : mesh.points_mm) {
    box.low_mm = glm::min(box.low_mm, point);
    box.high_mm = glm::max(box.high_mm, point);
  }
  return box;
}

/// Points of a grid in the box.
template <typename Visit>
void visit_grid(const Box& box, Visit&& visit) {
  for (double x = box.low_mm.x; x <= box.high_mm.x; x += grid_mm) {
    for (double y = box.low_mm.y; y <= box.high_mm.y; y += grid_mm) {
      for (double z = box.low_mm.z; z <= box.high_mm.z; z += grid_mm) visit(Vec3(x, y, z));
    }
  }
}

bool is_in_any(std::span<const simulator::Bvh* const> bodies, const Vec3& place_mm) noexcept {
  return std::any_of(bodies.begin(), bodies.end(),
                     [&](const simulator::Bvh* body) { return body->contains(place_mm); });
}

}  // namespace

std::vector<std::string> cuts_around(const OperationStep& step, const Plan& plan) {
  const PlannedHinge* hinge = find_hinge(plan, step.hinge);
  if (hinge == nullptr) return {step.cut};
  return {hinge->first_cut, hinge->second_cut};
}

SawnFace sawn_face(const HeldCut& held, const PlannedCut& cut, double kerf_mm) {
  const Vec3 normal = axis_z(held.bone_from_kerf);
  const Vec3 to_waste = glm::dot(normal, cut.face.normal) < 0.0 ? -normal : normal;
  const double middle_mm = glm::dot(to_waste, held.bone_from_kerf.translation_mm);
  return {{to_waste, middle_mm - 0.5 * kerf_mm},
          inverse(held.bone_from_kerf),
          held.low_mm,
          held.high_mm};
}

bool lies_beyond(std::span<const SawnFace> faces, const Vec3& point_in_bone_mm) noexcept {
  return std::all_of(faces.begin(), faces.end(), [&](const SawnFace& face) {
    if (glm::dot(face.plane.normal, point_in_bone_mm) <= face.plane.offset_mm) return false;
    const Vec3 foot_mm = transform_point(face.kerf_from_bone, point_in_bone_mm);
    return foot_mm.x >= face.low_mm.x && foot_mm.x <= face.high_mm.x &&
           foot_mm.y >= face.low_mm.y && foot_mm.y <= face.high_mm.y;
  });
}

std::vector<Vec3> parted_places_mm(std::span<const SawnFace> faces,
                                   const simulator::SolidWithTree& whole,
                                   const simulator::KerfSet& all,
                                   const simulator::KerfNumbers& kerfs) {
  std::vector<Vec3> places_mm;
  if (faces.empty()) return places_mm;
  visit_grid(box_of(whole.solid.mesh), [&](const Vec3& place_mm) {
    if (!lies_beyond(faces, place_mm) || !whole.bvh.contains(place_mm)) return;
    if (!all.is_open(kerfs, place_mm)) places_mm.push_back(place_mm);
  });
  return places_mm;
}

bool are_mostly_in(std::span<const simulator::Bvh* const> bodies,
                   std::span<const Vec3> places_mm) noexcept {
  const auto within = std::count_if(places_mm.begin(), places_mm.end(), [&](const Vec3& place_mm) {
    return is_in_any(bodies, place_mm);
  });
  return 2 * static_cast<std::size_t>(within) > places_mm.size();
}

}  // namespace hallux::scenarios
