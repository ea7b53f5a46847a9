#include "assessment/rebuild/bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "simulator/base/units.h"
#include "simulator/bone/contact_points.h"
#include "simulator/mesh/bvh.h"

namespace hallux::assessment {

namespace {

using simulator::Bvh;
using simulator::CutSolid;

/// Nearer than this bodies touch.
constexpr double touching_mm = 0.2;
/// Further apart two faces do not face each other.
constexpr double facing_mm = 5.0;
/// A body lies ahead of a point of a face where its nearest point does, within 10 degrees.
constexpr double straight_ahead = 0.985;
/// A sawn face is sampled at least once in so much of it.
constexpr double sample_mm2 = 0.25;

double turn_deg(const Quat& rotation) {
  const double half_sine = length_of(Vec3(rotation.x, rotation.y, rotation.z));
  return degree_from_radian(2.0 * std::atan2(half_sine, std::abs(rotation.w)));
}

/// Of RebuiltBone::pieces, the fragment that it is of; -1: it was taken out.
std::int32_t fragment_of(std::size_t piece, const RebuiltBone& rebuilt) {
  for (std::size_t i = 0; i < rebuilt.fragments.size(); ++i) {
    const RebuiltFragment& fragment = rebuilt.fragments[i];
    const bool is_of =
        piece >= fragment.first_piece && piece < fragment.first_piece + fragment.piece_count;
    if (is_of) return rebuilt.is_piece_out[piece] ? -1 : static_cast<std::int32_t>(i);
  }
  return -1;
}

/// The planned fragment that a piece is: it holds the fragment's point, and is nearer to it in size
/// than to the whole bone, which holds the point until it is parted.
const scenarios::PlannedFragment* planned_as(const Body& body, const RebuiltBone& rebuilt,
                                             const scenarios::Plan& plan) {
  const auto& fragments = plan.fixation.fragments;
  const auto found = std::find_if(
      fragments.begin(), fragments.end(), [&](const scenarios::PlannedFragment& fragment) {
        return fragment.bone == body.bone &&
               body.volume_mm3 * body.volume_mm3 <
                   fragment.volume_mm3 * rebuilt.inputs_mm3[body.bone] &&
               body.tree->contains(fragment.holds_in_bone_mm);
      });
  return found == fragments.end() ? nullptr : &*found;
}

/// Of the bodies that are there, the greatest of each bone that is no planned fragment goes by the
/// bone's name.
void name_bodies(std::vector<Body>& bodies, const RebuiltBone& rebuilt, const scenarios::Plan& plan,
                 const simulator::Bones& bones) {
  std::vector<Body*> rests(bones.size(), nullptr);
  for (Body& body : bodies) {
    body.name = "body-" + std::to_string(body.piece + 1);
    Body*& rest = rests[body.bone];
    if (const auto* planned = planned_as(body, rebuilt, plan)) {
      body.name = planned->name;
    } else if (body.fragment >= 0 && (rest == nullptr || body.volume_mm3 > rest->volume_mm3)) {
      rest = &body;
    }
  }
  for (std::size_t bone = 0; bone < bones.size(); ++bone) {
    if (rests[bone] != nullptr) rests[bone]->name = bones[bone].name;
  }
}

struct SurfacePoint {
  Vec3 point_mm{0.0, 0.0, 0.0}, normal{0.0, 0.0, 0.0};
  double area_mm2 = 0.0;
};

/// Points of a triangle, spread evenly, each with its share of the area: the middles of the small
/// triangles of a lattice of so many rows.
void add_points(const std::array<Vec3, 3>& corners, int rows, std::vector<SurfacePoint>& points) {
  const Vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double doubled_mm2 = length_of(across);
  if (!(doubled_mm2 > 0.0)) return;
  const double share_mm2 = 0.5 * doubled_mm2 / (rows * rows);
  const auto add = [&](double u, double v) {
    points.push_back({corners[0] + (u / rows) * (corners[1] - corners[0]) +
                          (v / rows) * (corners[2] - corners[0]),
                      across / doubled_mm2, share_mm2});
  };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; i + j < rows; ++j) {
      add(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j + 1 < rows) add(i + 2.0 / 3.0, j + 2.0 / 3.0);
    }
  }
}

std::vector<SurfacePoint> sawn_points(const CutSolid& solid) {
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    if (solid.sources[i].kerf < 0) continue;
    const auto& triangle = solid.mesh.triangles[i];
    const std::array<Vec3, 3> corners{solid.mesh.points_mm[triangle[0]],
                                      solid.mesh.points_mm[triangle[1]],
                                      solid.mesh.points_mm[triangle[2]]};
    const double area_mm2 =
        0.5 * length_of(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    add_points(corners, 1 + static_cast<int>(std::sqrt(area_mm2 / sample_mm2)), points);
  }
  return points;
}

/// Visits the nearest point of each other body that is there within the distance: visit(signed_mm,
/// way), with the way to it in the frame of the first bone, as the point; negative inside.
template <typename Visit>
void visit_others(const std::vector<Body>& bodies, const Body& body, const Vec3& point_in_first_mm,
                  double within_mm, const Visit& visit) {
  for (const Body& other : bodies) {
    if (&other == &body || other.fragment < 0) continue;
    const RigidTransform& pose = other.first_from_piece;
    const Vec3 point_mm = transform_point(inverse(pose), point_in_first_mm);
    const auto near = other.tree->nearest(point_mm, within_mm);
    if (!near) continue;
    const double signed_mm = near->is_inside ? -near->distance_mm : near->distance_mm;
    visit(signed_mm, transform_direction(pose, near->point_mm - point_mm));
  }
}

void measure_contact(const std::vector<Body>& bodies, const Body& body, const CutSolid& solid,
                     BodyPlacement& placement) {
  double sawn_mm2 = 0.0, touching_mm2 = 0.0, unsure_mm2 = 0.0;
  for (const SurfacePoint& sample : sawn_points(solid)) {
    const Vec3 point_mm = transform_point(body.first_from_piece, sample.point_mm);
    const Vec3 normal = transform_direction(body.first_from_piece, sample.normal);
    bool is_touching = false, is_sure = true;
    double gap_mm = std::numeric_limits<double>::infinity();
    visit_others(bodies, body, point_mm, facing_mm, [&](double signed_mm, const Vec3& way) {
      is_touching = is_touching || signed_mm <= touching_mm;
      is_sure = is_sure && std::abs(signed_mm - touching_mm) > sample_reach_mm;
      const double ahead_mm = glm::dot(way, normal);
      if (signed_mm > 0.0 && ahead_mm >= straight_ahead * signed_mm)
        gap_mm = std::min(gap_mm, ahead_mm);
    });
    sawn_mm2 += sample.area_mm2;
    if (!is_sure) unsure_mm2 += sample.area_mm2;
    if (is_touching) touching_mm2 += sample.area_mm2;
    if (gap_mm <= facing_mm)
      placement.gap_max_mm = std::max(placement.gap_max_mm.value_or(0.0), gap_mm);
  }
  if (!(sawn_mm2 > 0.0)) return;
  placement.contact_share = touching_mm2 / sawn_mm2;
  placement.contact_bound = unsure_mm2 / sawn_mm2;
}

double overlap_mm(const std::vector<Body>& bodies, const Body& body, const CutSolid& solid) {
  double most_mm = 0.0;
  const auto ask = [&](const Vec3& point_in_piece_mm) {
    const Vec3 point_mm = transform_point(body.first_from_piece, point_in_piece_mm);
    visit_others(bodies, body, point_mm, facing_mm,
                 [&](double signed_mm, const Vec3&) { most_mm = std::max(most_mm, -signed_mm); });
  };
  for (const Vec3& point : solid.mesh.points_mm) ask(point);
  for (const SurfacePoint& sample : sawn_points(solid)) ask(sample.point_mm);
  return most_mm;
}

void measure_error(const Body& body, const scenarios::Plan& plan, BodyPlacement& placement) {
  const scenarios::PlannedFragment* const planned = find_fragment(plan.fixation, body.name);
  if (planned == nullptr) return;
  const RigidTransform& wanted = planned->bone_from_rest;
  placement.error_mm = length_of(transform_point(body.bone_from_piece, body.centroid_in_bone_mm) -
                                 transform_point(wanted, body.centroid_in_bone_mm));
  placement.error_deg = turn_deg(glm::conjugate(wanted.rotation) * body.bone_from_piece.rotation);
}

}  // namespace

ClosedHinges hinges_of(const scenarios::Plan& plan) {
  return {planned_bridges(plan), !plan.fixation.fragments.empty()};
}

std::vector<Body> bodies_of(const RebuiltBone& rebuilt, const scenarios::Plan& plan,
                            const simulator::Bones& bones) {
  std::vector<Body> bodies;
  for (std::size_t piece = 0; piece < rebuilt.pieces.size(); ++piece) {
    Body body;
    body.piece = piece;
    body.bone = rebuilt.piece_bones[piece];
    body.fragment = fragment_of(piece, rebuilt);
    if (body.fragment >= 0)
      body.bone_from_piece = rebuilt.fields.fragments()[body.fragment].bone_from_fragment;
    body.first_from_piece =
        body.bone == 0 ? body.bone_from_piece : first_from(bones, body.bone) * body.bone_from_piece;
    body.centroid_in_bone_mm = simulator::centroid_of(rebuilt.pieces[piece].mesh);
    body.volume_mm3 = rebuilt.piece_volumes_mm3[piece];
    body.tree = std::make_unique<const Bvh>(rebuilt.pieces[piece].mesh);
    bodies.push_back(std::move(body));
  }
  name_bodies(bodies, rebuilt, plan, bones);
  return bodies;
}

std::vector<BodyPlacement> placements_of(const std::vector<Body>& bodies,
                                         const RebuiltBone& rebuilt, const scenarios::Plan& plan) {
  std::vector<BodyPlacement> placements;
  for (const Body& body : bodies) {
    BodyPlacement placement;
    placement.moved_mm = length_of(transform_point(body.bone_from_piece, body.centroid_in_bone_mm) -
                                   body.centroid_in_bone_mm);
    placement.turned_deg = turn_deg(body.bone_from_piece.rotation);
    if (body.fragment >= 0) {
      const CutSolid& solid = rebuilt.pieces[body.piece];
      measure_error(body, plan, placement);
      measure_contact(bodies, body, solid, placement);
      placement.overlap_max_mm = overlap_mm(bodies, body, solid);
    }
    placements.push_back(placement);
  }
  return placements;
}

}  // namespace hallux::assessment
