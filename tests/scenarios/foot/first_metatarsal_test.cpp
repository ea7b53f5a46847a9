#include "scenarios/foot/first_metatarsal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scenarios/foot/topology.h"
#include "simulator/base/progress.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;

/// Bones of 1 mm edges without canal, each made once for the whole program.
class FirstMetatarsal : public testing::Test {
 protected:
  static const Bone& bone(double eminence_mm, double length_mm = 0.0) {
    const auto key = std::make_pair(eminence_mm, length_mm);
    const auto found = bones.find(key);
    if (found != bones.end()) return found->second;
    return bones
        .emplace(key,
                 make_first_metatarsal(first_metatarsal_table(), coarse(eminence_mm, length_mm)))
        .first->second;
  }
  static BoneRequest coarse(double eminence_mm, double length_mm = 0.0) {
    return {
        .length_mm = length_mm, .eminence_mm = eminence_mm, .edge_mm = 1.0, .with_canal = false};
  }
  static Vec3 landmark(const Bone& of, const char* name) {
    const auto point = simulator::find_landmark(of, name);
    EXPECT_TRUE(point.has_value()) << name;
    return point.value_or(Vec3{0.0});
  }

  inline static std::map<std::pair<double, double>, Bone> bones;
};

double distance(const Vec3& a, const Vec3& b) { return std::sqrt(glm::dot(a - b, a - b)); }

TEST_F(FirstMetatarsal, IsTwoClosedSpheresOfTheSameBytesEachTime) {
  const BoneRequest request{.eminence_mm = 4.0, .edge_mm = 1.0};
  const Bone b = make_first_metatarsal(first_metatarsal_table(), request);
  EXPECT_NO_THROW(check_sphere(b.outer, "outer surface"));
  EXPECT_NO_THROW(check_sphere(b.canal, "canal"));
  EXPECT_GT(simulator::signed_volume_mm3(b.outer), 0.0);
  EXPECT_LT(simulator::signed_volume_mm3(b.canal), 0.0);
  const Bone again = make_first_metatarsal(first_metatarsal_table(), request);
  EXPECT_EQ(digest_of(simulator::encode_bone(b)), digest_of(simulator::encode_bone(again)));
}

TEST_F(FirstMetatarsal, GrowsTheEminenceAskedForBesideItsSulcus) {
  for (const double eminence_mm : {2.0, 4.0, 6.0}) {
    const Bone& b = bone(eminence_mm);
    EXPECT_NEAR(landmark(b, "eminence_apex").z, -10.6 - eminence_mm, 0.1);
    // The sulcus lies between the head and the eminence, towards the joint.
    const Vec3 sulcus = landmark(b, "med_sulcus");
    EXPECT_LT(landmark(b, "eminence_apex").z, sulcus.z - 3.0);
    EXPECT_LT(sulcus.z, landmark(b, "head_centre").z - 5.0);
    EXPECT_GT(sulcus.x, landmark(b, "head_centre").x);
  }
}

TEST_F(FirstMetatarsal, FillsItsLengthAndCarriesItsLandmarksAlong) {
  const Bone& own = bone(4.0);
  const Bone& longer = bone(4.0, 70.0);
  ASSERT_EQ(own.landmarks.size(), longer.landmarks.size());
  for (const simulator::Landmark& l : own.landmarks) {
    const Vec3 there = landmark(longer, l.name.c_str());
    // An extreme point of a flat place may be the neighbouring mesh point: an edge of 1 mm, and 4/3
    // where it is long.
    EXPECT_NEAR(there.x, l.point_in_bone_mm.x * 70.0 / 63.2, 4.0 / 3.0) << l.name;
    EXPECT_NEAR(there.z, l.point_in_bone_mm.z, 4.0 / 3.0) << l.name;
  }
  EXPECT_EQ(longer.cortex->length_mm, 70.0);
  const auto is_left = [](const Vec3& a, const Vec3& b) { return a.x < b.x; };
  const auto [low, high] =
      std::minmax_element(longer.outer.points_mm.begin(), longer.outer.points_mm.end(), is_left);
  EXPECT_NEAR(low->x, 0.0, 0.2);
  EXPECT_NEAR(high->x, 70.0, 0.2);
}

TEST_F(FirstMetatarsal, KeepsItsHeadCentreWhereAnEminenceGrows) {
  EXPECT_LT(distance(landmark(bone(0.0), "head_centre"), landmark(bone(6.0), "head_centre")), 0.3);
  EXPECT_LT(distance(landmark(bone(0.0), "head_centre"), {53.2, 0.5, -0.4}), 1.0);
}

/// A face along the shaft, tilted 5 degrees, 1 mm medial to the sulcus.
TEST_F(FirstMetatarsal, LetsACutBesideTheSulcusLeaveTheBoneJustBeforeTheShaft) {
  const Bone& b = bone(4.0);
  const Vec3 along = landmark(b, "shaft_distal") - landmark(b, "shaft_proximal");
  const Vec3 axis = along / std::sqrt(glm::dot(along, along));
  const Vec3 across = glm::cross(axis, {0.0, 1.0, 0.0});
  const Vec3 medial = -across / std::sqrt(glm::dot(across, across));
  const double tilt_rad = radian_from_degree(5.0);
  const Vec3 normal = std::cos(tilt_rad) * medial + std::sin(tilt_rad) * glm::cross(axis, medial);
  const double offset_mm = glm::dot(normal, landmark(b, "med_sulcus")) + 1.0;
  const double room_mm = offset_mm - glm::dot(normal, landmark(b, "shaft_medial"));
  EXPECT_GT(room_mm, 0.3);
  EXPECT_LT(room_mm, 0.8);
}

TEST_F(FirstMetatarsal, StandsInTheFootWithItsHeadBeforeItsBase) {
  const Bone& b = bone(4.0);
  EXPECT_EQ(transform_point(b.world_from_bone, Vec3{0.0}), Vec3(130.0, 37.0, -20.0));
  EXPECT_LT(distance(transform_point(b.world_from_bone, landmark(b, "head_centre")),
                     {179.0, 19.0, -27.0}),
            2.0);
  EXPECT_GT(transform_direction(b.world_from_bone, {0.0, 1.0, 0.0}).y, 0.9);
}

TEST_F(FirstMetatarsal, StopsWhenToldTo) {
  for (const double stop_at : {0.0, 0.2}) {
    const auto until = [stop_at](double fraction) { return fraction < stop_at; };
    EXPECT_THROW(make_first_metatarsal(first_metatarsal_table(), coarse(4.0), until), Cancelled)
        << stop_at;
  }
}

TEST_F(FirstMetatarsal, ReportsProgressThatRises) {
  double last = -1.0;
  make_first_metatarsal(first_metatarsal_table(), {.edge_mm = 1.5}, [&](double fraction) {
    EXPECT_GT(fraction, last);
    last = fraction;
    return true;
  });
  EXPECT_EQ(last, 1.0);
}

TEST_F(FirstMetatarsal, RefusesRequestsOutOfRange) {
  const BoneTable table = first_metatarsal_table();
  EXPECT_THROW(make_first_metatarsal(table, {.length_mm = 20.0}), ScenarioError);
  EXPECT_THROW(make_first_metatarsal(table, {.eminence_mm = 40.0}), ScenarioError);
  EXPECT_THROW(make_first_metatarsal(table, {.edge_mm = 0.01}), ScenarioError);
  EXPECT_THROW(make_first_metatarsal(table, {.edge_mm = std::nan("")}), ScenarioError);
}

}  // namespace
}  // namespace hallux::scenarios
