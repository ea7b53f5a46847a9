#include "scenarios/foot/first_proximal_phalanx.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scenarios/foot/first_metatarsal.h"
#include "scenarios/foot/topology.h"
#include "simulator/base/units.h"
#include "simulator/mesh/bvh.h"
#include "tests/scenarios/foot/measured_phalanx.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;

/// Bones of 1 mm edges without canal, each made once for the whole program.
class FirstProximalPhalanx : public testing::Test {
 protected:
  static const Bone& bone(double length_mm = 0.0) {
    const auto found = bones.find(length_mm);
    if (found != bones.end()) return found->second;
    const BoneRequest request{.length_mm = length_mm, .edge_mm = 1.0, .with_canal = false};
    return bones.emplace(length_mm, made(request)).first->second;
  }
  static Bone made(const BoneRequest& request) {
    return make_first_proximal_phalanx(first_proximal_phalanx_table(), request);
  }
  static Vec3 landmark(const Bone& of, const char* name) {
    const auto point = simulator::find_landmark(of, name);
    EXPECT_TRUE(point.has_value()) << name;
    return point.value_or(Vec3{0.0});
  }

  inline static std::map<double, Bone> bones;
};

std::string complaint_about(const BoneTable& table, const BoneRequest& request) {
  try {
    make_first_proximal_phalanx(table, request);
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST_F(FirstProximalPhalanx, IsTwoClosedSpheresOfTheSameBytesEachTime) {
  const Bone b = made({.edge_mm = 1.0});
  EXPECT_NO_THROW(check_sphere(b.outer, "outer surface"));
  EXPECT_NO_THROW(check_sphere(b.canal, "canal"));
  EXPECT_LT(simulator::signed_volume_mm3(b.canal), 0.0);
  EXPECT_EQ(digest_of(simulator::encode_bone(b)),
            digest_of(simulator::encode_bone(made({.edge_mm = 1.0}))));
}

TEST_F(FirstProximalPhalanx, IsTwoClosedSpheresAtItsLeastAndGreatestLength) {
  for (const double length_mm : {24.75, 42.9}) {
    const Bone b = made({.length_mm = length_mm, .edge_mm = 1.5});
    EXPECT_NO_THROW(check_sphere(b.outer, "outer surface")) << length_mm;
    EXPECT_NO_THROW(check_sphere(b.canal, "canal")) << length_mm;
    EXPECT_LT(simulator::signed_volume_mm3(b.canal), -500.0) << length_mm;
  }
}

TEST_F(FirstProximalPhalanx, HasTheVolumeOfItsSections) {
  // The area of a superellipse lies between that of its rhombus and that of its box, and harmonics
  // keep it within a tenth: here n 2.1 to 3.6, so 0.79 to 0.94 of the box 4 a b. Integrated over
  // the stations, constant past the ends.
  const BoneTable table = first_proximal_phalanx_table();
  const auto box = [](const Station& s) { return 4.0 * s.half_width_mm * s.half_height_mm; };
  double boxes_mm3 =
      table.length_mm * (table.stations.front().position * box(table.stations.front()) +
                         (1.0 - table.stations.back().position) * box(table.stations.back()));
  for (std::size_t i = 0; i + 1 < table.stations.size(); ++i) {
    const Station& from = table.stations[i];
    const Station& to = table.stations[i + 1];
    boxes_mm3 += 0.5 * (to.position - from.position) * table.length_mm * (box(from) + box(to));
  }
  // The hollow of the facet and the rounded rims take some 3 mm of the base and 1 mm of the head
  // away.
  const double ends_mm3 = 4.0 * box(table.stations.front());
  const double volume_mm3 = simulator::signed_volume_mm3(bone().outer);
  EXPECT_LT(volume_mm3, 0.94 * boxes_mm3);
  EXPECT_GT(volume_mm3, 0.75 * (boxes_mm3 - ends_mm3));
}

TEST_F(FirstProximalPhalanx, HasItsLandmarksOnItsSurfaceAndItsShaftInside) {
  const Bone& b = bone();
  const simulator::Bvh surface(b.outer);
  for (const simulator::Landmark& l : b.landmarks) {
    const double distance_mm = surface.signed_distance_mm(l.point_in_bone_mm);
    if (l.name.starts_with("shaft_")) {
      EXPECT_LT(distance_mm, -3.0) << l.name;
    } else {
      // Points of the mesh lie on it; those of the field as far off as the arc of a 1 mm edge is
      // high.
      EXPECT_NEAR(distance_mm, 0.0, 0.1) << l.name;
    }
  }
  EXPECT_EQ(b.landmarks.size(), 14U);
}

TEST_F(FirstProximalPhalanx, NamesItsSidesAsTheyLie) {
  const Bone& b = bone();
  for (const char* place : {"base", "waist", "ip"}) {
    const Vec3 medial = landmark(b, (std::string(place) + "_med").c_str());
    const Vec3 lateral = landmark(b, (std::string(place) + "_lat").c_str());
    EXPECT_LT(medial.z + 10.0, lateral.z) << place;
  }
  EXPECT_GT(landmark(b, "base_dors").y, landmark(b, "base_centre").y + 5.0);
  EXPECT_LT(landmark(b, "base_plant").y, landmark(b, "base_centre").y - 5.0);
  EXPECT_GT(landmark(b, "waist_dors").y, landmark(b, "waist_plant").y + 8.0);
  EXPECT_LT(landmark(b, "base_centre").x, landmark(b, "shaft_proximal").x);
  EXPECT_LT(landmark(b, "shaft_distal").x, landmark(b, "ip_centre").x);
}

TEST_F(FirstProximalPhalanx, HasItsJointLineSquareToItsLengthOverAHollowFacet) {
  for (const double length_mm : {0.0, 27.0}) {
    const Bone& b = bone(length_mm);
    const Vec3 line = landmark(b, "base_lat") - landmark(b, "base_med");
    // The rim rests on mesh points that lie some hundredths of a millimetre beside its crest, 14 mm
    // apart.
    EXPECT_NEAR(degree_from_radian(std::atan2(line.x, line.z)), 0.0, 0.5) << length_mm;
    EXPECT_GT(landmark(b, "base_centre").x, landmark(b, "base_med").x + 2.0) << length_mm;
  }
}

TEST_F(FirstProximalPhalanx, KeepsTheObliquityOfAFacetThatATableTilts) {
  const Bone b = make_first_proximal_phalanx(scenarios_test::measured_phalanx_table(),
                                             {.edge_mm = 1.0, .with_canal = false});
  const Vec3 line = landmark(b, "base_lat") - landmark(b, "base_med");
  EXPECT_NEAR(degree_from_radian(std::atan2(line.x, line.z)), 13.3, 0.5);
}

TEST_F(FirstProximalPhalanx, PointsFromItsBaseToItsHeadAlongX) {
  const Bone& b = bone();
  const Vec3 along = landmark(b, "ip_centre") - landmark(b, "base_centre");
  EXPECT_LT(std::atan2(std::abs(along.y), along.x), radian_from_degree(3.0));
  EXPECT_LT(std::atan2(std::abs(along.z), along.x), radian_from_degree(1.0));
}

TEST_F(FirstProximalPhalanx, CarriesItsLandmarksAlongWithItsLength) {
  const Bone& own = bone();
  const Bone& shorter = bone(27.0);
  ASSERT_EQ(own.landmarks.size(), shorter.landmarks.size());
  for (const simulator::Landmark& l : own.landmarks) {
    const Vec3 there = landmark(shorter, l.name.c_str());
    // An extreme point of a flat place may be the neighbouring mesh point: an edge of 1 mm, and 4/3
    // where it is long.
    EXPECT_NEAR(there.x, l.point_in_bone_mm.x * 27.0 / 33.0, 4.0 / 3.0) << l.name;
  }
  EXPECT_EQ(shorter.cortex->length_mm, 27.0);
  EXPECT_EQ(shorter.cortex->mid_mm, 1.5);
  const auto is_left = [](const Vec3& a, const Vec3& b) { return a.x < b.x; };
  const auto [low, high] =
      std::minmax_element(shorter.outer.points_mm.begin(), shorter.outer.points_mm.end(), is_left);
  // The rims of both ends are rounded and keep off the planes that bound them.
  EXPECT_GE(low->x, 0.0);
  EXPECT_LT(low->x, 0.7);
  EXPECT_LE(high->x, 27.0);
  EXPECT_GT(high->x, 26.5);
}

TEST_F(FirstProximalPhalanx, StandsInTheFootBeforeTheHeadOfTheFirstMetatarsal) {
  const Bone metatarsal =
      make_first_metatarsal(first_metatarsal_table(), {.edge_mm = 1.0, .with_canal = false});
  const simulator::Bvh surface(metatarsal.outer);
  const RigidTransform metatarsal_from_phalanx =
      inverse(metatarsal.world_from_bone) * bone().world_from_bone;
  double nearest_mm = 100.0;
  for (const Vec3& p : bone().outer.points_mm) {
    nearest_mm = std::min(nearest_mm,
                          surface.signed_distance_mm(transform_point(metatarsal_from_phalanx, p)));
  }
  // The joint's cartilage has its room, and no bone lies in the other.
  EXPECT_GT(nearest_mm, 0.8);
  EXPECT_LT(nearest_mm, 2.0);
}

TEST_F(FirstProximalPhalanx, SaysWhatMadeIt) {
  EXPECT_EQ(bone().name, "first_proximal_phalanx");
  EXPECT_EQ(bone().generator,
            "first_proximal_phalanx PP1 generator 3 length_mm 33 edge_mm 1 without canal");
  EXPECT_NE(bone().credit.find("BodyParts3D"), std::string::npos);
}

TEST_F(FirstProximalPhalanx, RefusesRequestsOutOfRangeByName) {
  const BoneTable table = first_proximal_phalanx_table();
  EXPECT_EQ(
      complaint_about(table, {.length_mm = 63.2}),
      "length_mm 63.2 is out of range; ask for 24.75 to 42.9, or 0 for the table's own length");
  EXPECT_EQ(complaint_about(table, {.eminence_mm = 4.0}),
            "eminence_mm 4 is asked of the bone \"first_proximal_phalanx\", on which none grows; "
            "ask for 0");
  EXPECT_NE(complaint_about(table, {.edge_mm = 0.01}).find("edge_mm 0.01 is out of range"),
            std::string::npos);
  EXPECT_NE(complaint_about(table, {.length_mm = std::nan("")}).find("length_mm nan"),
            std::string::npos);
  EXPECT_EQ(complaint_about(first_metatarsal_table(), {}),
            "a table of the bone \"first_metatarsal\" was given to make a first_proximal_phalanx; "
            "give that bone's own table");
}

}  // namespace
}  // namespace hallux::scenarios
