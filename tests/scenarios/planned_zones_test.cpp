#include "scenarios/planned_zones.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/plan.h"
#include "tests/support/worlds.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;

Bone block() {
  Bone bone;
  bone.name = "block";
  bone.outer = tests::solid_block({60.0, 20.0, 20.0});
  bone.landmarks = {{"base_centre", Vec3(-30.0, 0.0, 0.0)}, {"head_centre", Vec3(30.0, 1.0, 2.0)}};
  return bone;
}

/// One zone along the whole of the block's top.
Scenario with_zone(const DangerZone& zone) {
  Scenario scenario;
  scenario.name = "one_zone";
  scenario.danger_zones = {zone};
  return scenario;
}

std::vector<PlannedZone> zones_on_block(const Scenario& scenario) {
  const Bone bone = block();
  return plan_zones(scenario, Ground(scenario, std::span(&bone, 1)));
}

DangerZone tendon() {
  DangerZone zone;
  zone.name = "tendon";
  zone.from_in_bone_mm = Vec3(0.0, 12.0, 0.0);
  zone.to_in_bone_mm = Vec3(-5.0, 13.0, 1.0);
  zone.radius_mm = 2.0;
  return zone;
}

std::string refusal_of(const DangerZone& zone) {
  try {
    zones_on_block(with_zone(zone));
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

TEST(PlannedZones, WithoutLandmarksLieWhereTheFileSays) {
  const auto zones = zones_on_block(with_zone(tendon()));
  ASSERT_EQ(zones.size(), 1U);
  EXPECT_EQ(zones[0].name, "tendon");
  EXPECT_EQ(zones[0].capsule.from_in_bone_mm, Vec3(0.0, 12.0, 0.0));
  EXPECT_EQ(zones[0].capsule.to_in_bone_mm, Vec3(-5.0, 13.0, 1.0));
  EXPECT_EQ(zones[0].capsule.radius_mm, 2.0);
}

TEST(PlannedZones, CountEachEndFromItsLandmark) {
  DangerZone zone = tendon();
  zone.from_landmark = "base_centre";
  zone.to_landmark = "head_centre";
  const auto zones = zones_on_block(with_zone(zone));
  ASSERT_EQ(zones.size(), 1U);
  EXPECT_EQ(zones[0].capsule.from_in_bone_mm, Vec3(-30.0, 12.0, 0.0));
  EXPECT_EQ(zones[0].capsule.to_in_bone_mm, Vec3(25.0, 14.0, 3.0));
}

TEST(PlannedZones, OfALandmarkThatTheBoneLacksAreRefusedWithThoseItHas) {
  DangerZone zone = tendon();
  zone.to_landmark = "apex";
  EXPECT_EQ(
      refusal_of(zone),
      "one_zone: danger_zones[0] \"tendon\": the bone \"block\" has no landmark \"apex\"; use "
      "one of: base_centre, head_centre");
}

TEST(PlannedZones, FarFromTheBoneAreRefused) {
  DangerZone zone = tendon();
  zone.from_in_bone_mm.z = zone.to_in_bone_mm.z = 90.0;
  EXPECT_NE(refusal_of(zone).find("danger_zones[0] \"tendon\": it lies more than 60 mm"),
            std::string::npos);
  zone.from_in_bone_mm.z = 60.0;
  EXPECT_EQ(refusal_of(zone), "");
}

}  // namespace
}  // namespace hallux::scenarios
