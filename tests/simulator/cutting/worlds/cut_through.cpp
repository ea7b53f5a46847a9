#include "tests/simulator/cutting/worlds/cut_through.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "simulator/cutting/solid/slab_volume.h"

namespace hallux::tests {

using namespace simulator;

KerfPlane plane_through(const Vec3& point_mm, const Vec3& normal, double thickness_mm,
                        const Vec3& x_hint) {
  const Vec3 z = normal / std::sqrt(glm::dot(normal, normal));
  const Vec3 y = glm::cross(z, x_hint);
  const Vec3 x = glm::cross(y, z);
  const double length = std::sqrt(glm::dot(x, x));
  return {{rotation_from_axes(x / length, y), point_mm}, thickness_mm};
}

KerfPlane axis_plane(std::size_t axis, double offset_mm, double thickness_mm) {
  const std::array<Quat, 3> rotations{Quat(0.5, 0.5, 0.5, 0.5), Quat(0.5, -0.5, -0.5, -0.5),
                                      Quat(1.0, 0.0, 0.0, 0.0)};
  Vec3 origin_mm(0.0);
  origin_mm[static_cast<glm::length_t>(axis)] = offset_mm;
  return {{rotations.at(axis), origin_mm}, thickness_mm};
}

CutOutcome cut_through(const CutSolid& solid, const KerfPlane& plane, std::int32_t kerf) {
  const Bvh bvh(solid.mesh);
  CutOutcome outcome;
  outcome.section = slice_section(solid, bvh, plane);
  const std::vector<std::uint8_t> all(outcome.section.regions.size(), 1);
  outcome.solid = remove_slab(solid, bvh, outcome.section, kerf, all);
  outcome.removed_mm3 = slab_volume_mm3(solid, outcome.section, all);
  return outcome;
}

void expect_closed(const CutSolid& solid) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  std::vector<bool> is_used(solid.mesh.points_mm.size(), false);
  for (const Triangle& corners : solid.mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++uses[{corners[i], corners[(i + 1) % 3]}];
      is_used.at(corners[i]) = true;
    }
  }
  std::size_t repeated = 0, open = 0;
  for (const auto& [edge, count] : uses) {
    if (count != 1 || edge.first == edge.second) ++repeated;
    if (!uses.contains({edge.second, edge.first})) ++open;
  }
  EXPECT_EQ(repeated, 0U);
  EXPECT_EQ(open, 0U);
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    EXPECT_TRUE(is_used[i]);
    const Vec3& point_mm = solid.mesh.points_mm[i];
    EXPECT_TRUE(std::isfinite(point_mm.x) && std::isfinite(point_mm.y) &&
                std::isfinite(point_mm.z));
  }
  EXPECT_EQ(solid.sources.size(), solid.mesh.triangles.size());
}

void expect_balance(const CutSolid& before, const CutOutcome& outcome) {
  double pieces_mm3 = 0.0;
  for (const CutSolid& piece : split_pieces(outcome.solid)) {
    pieces_mm3 += signed_volume_mm3(piece.mesh);
  }
  const double before_mm3 = signed_volume_mm3(before.mesh);
  EXPECT_NEAR(pieces_mm3 + outcome.removed_mm3, before_mm3, 1e-9 * before_mm3);
}

}  // namespace hallux::tests
