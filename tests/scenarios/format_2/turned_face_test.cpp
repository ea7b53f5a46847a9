// The one kind of plane of format 2 on a block, against closed forms.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "simulator/base/units.h"
#include "tests/scenarios/format_2/fixtures.h"

namespace hallux::scenarios {
namespace {

using nlohmann::json;
using scenarios_test::block;
using scenarios_test::block_json;

constexpr double rounding = 1.0e-13;

void expect_near(const Vec3& a, const Vec3& b, double tolerance = rounding) {
  EXPECT_LT(length_of(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

PlannedCut planned(const json& whole) {
  return plan_on(parse_scenario(whole.dump(), "f.json"), block()).cuts.at(0);
}

json turned(double angle_deg, double roll_deg) {
  json whole = block_json();
  whole["cuts"][0]["face"]["angle_deg"] = angle_deg;
  whole["cuts"][0]["face"]["roll_deg"] = roll_deg;
  return whole;
}

std::string refusal(const json& whole) {
  const std::string read = scenarios_test::refusal_of(whole);
  return read.empty() ? scenarios_test::plan_refusal_of(whole, block()) : read;
}

TEST(TurnedFace, AtNoAngleContainsItsTwoDirections) {
  const PlannedCut cut = planned(block_json());
  expect_near(cut.face.normal, {1.0, 0.0, 0.0});
  EXPECT_NEAR(cut.face.offset_mm, 30.0, rounding);
  expect_near(cut.axis, {0.0, 1.0, 0.0});
  EXPECT_NEAR(cut.entry_point_in_bone_mm.z, -10.0, rounding);
  EXPECT_NEAR(cut.exit_point_in_bone_mm.z, 10.0, rounding);
  EXPECT_EQ(cut.depth_point_in_bone_mm, cut.entry_point_in_bone_mm);
  EXPECT_FALSE(cut.keeps_both);
  EXPECT_FALSE(cut.is_along_bone);
  EXPECT_TRUE(cut.has_exit);
  EXPECT_FALSE(cut.blade.has_value());
}

/// About dorsal by a, then about the turned lateral direction by r.
RC_GTEST_PROP(TurnedFace, IsTheClosedFormOfItsTwoAngles, ()) {
  const double a = *rc::gen::inRange(-400, 401) / 10.0, r = *rc::gen::inRange(-400, 401) / 10.0;
  json whole = turned(a, r);
  whole["cuts"][0]["keep"] = "proximal";
  const PlannedCut cut = planned(whole);
  const double ca = std::cos(radian_from_degree(a)), sa = std::sin(radian_from_degree(a));
  const double cr = std::cos(radian_from_degree(r)), sr = std::sin(radian_from_degree(r));
  // c = y; g = ca z + sa x; c x g = ca x - sa z; n = cr (c x g) + sr c.
  const Vec3 normal(cr * ca, sr, -cr * sa);
  RC_ASSERT(length_of(cut.face.normal - normal) < rounding);
  RC_ASSERT(std::abs(cut.face.offset_mm - 30.0 * normal.x) < 1.0e-12);
  const Vec3 second(sa, 0.0, ca);
  RC_ASSERT(std::abs(glm::dot(cut.face.normal, second)) < rounding);
}

TEST(TurnedFace, TurnsUpToARightAngle) {
  json level = turned(90.0, 0.0);
  level["cuts"][0]["keep"] = "lateral";
  expect_near(planned(level).face.normal, {0.0, 0.0, -1.0});
  json rolled = turned(0.0, 90.0);
  rolled["cuts"][0]["keep"] = "plantar";
  expect_near(planned(rolled).face.normal, {0.0, 1.0, 0.0});
}

TEST(TurnedFace, MayKeepBothSidesAndMeasureOne) {
  json both = block_json();
  both["cuts"][0]["keep"] = "both";
  both["cuts"][0]["measured"] = "distal";
  const PlannedCut cut = planned(both);
  EXPECT_TRUE(cut.keeps_both);
  expect_near(cut.face.normal, {-1.0, 0.0, 0.0});
}

TEST(TurnedFace, ComesFromAnyDirection) {
  json aslant = block_json();
  aslant["directions"] = {{{"name", "from_corner"},
                           {"turn", "medial"},
                           {"about", "distal"},
                           {"deg", 45},
                           {"origin", "author: a test."}}};
  aslant["cuts"][0]["approach"] = "from_corner";
  const PlannedCut cut = planned(aslant);
  expect_near(cut.approach_in_bone, Vec3(0.0, std::sqrt(0.5), -std::sqrt(0.5)));
  expect_near(cut.entry_point_in_bone_mm, {30.0, 10.0, -10.0});
  expect_near(cut.exit_point_in_bone_mm, {30.0, -10.0, 10.0});
}

TEST(TurnedFace, EndsAtItsWindow) {
  json half = block_json();
  half["cuts"][0]["window"] = {{"beyond", "middle"}, {"along", "lateral"}};
  EXPECT_NEAR(planned(half).entry_point_in_bone_mm.z, 0.0, rounding);
  EXPECT_NEAR(planned(half).exit_point_in_bone_mm.z, 10.0, rounding);
  half["cuts"][0]["window"]["across"] = "plantar";
  half["cuts"][0]["window"]["across_mm"] = {2, 4};
  half["cuts"][0]["approach"] = "dorsal";
  const PlannedCut cut = planned(half);
  EXPECT_NEAR(cut.entry_point_in_bone_mm.y, -2.0, rounding);
  EXPECT_NEAR(cut.exit_point_in_bone_mm.y, -4.0, rounding);
  ASSERT_TRUE(cut.window.has_value());
  expect_near(cut.window->across, {0.0, -1.0, 0.0});
  EXPECT_TRUE(lies_within(*cut.window, {30.0, -3.0, 1.0}));
  EXPECT_FALSE(lies_within(*cut.window, {30.0, -3.0, -1.0}));
  EXPECT_FALSE(lies_within(*cut.window, {30.0, -5.0, 1.0}));
}

TEST(TurnedFace, AlongTheBoneHasItsDepthAndItsExit) {
  json along = block_json();
  json& cut = along["cuts"][0];
  along["points"] = {{{"name", "side"},
                      {"at", "middle"},
                      {"move", {{{"along", "medial"}, {"mm", 7}}}},
                      {"origin", "author: a test."}}};
  cut["face"] = {{"through", "side"}, {"contains", "distal"}, {"from", "dorsal"}, {"angle_deg", 0}};
  cut["keep"] = "lateral";
  cut["approach"] = "dorsal";
  cut["depth_at"] = "end";
  cut["flush_at"] = "base";
  const PlannedCut made = planned(along);
  EXPECT_TRUE(made.is_along_bone);
  expect_near(made.face.normal, {0.0, 0.0, -1.0});
  EXPECT_NEAR(made.face.offset_mm, 7.0, rounding);
  EXPECT_NEAR(made.depth_mm, 7.0, rounding);
  expect_near(made.axis, {1.0, 0.0, 0.0});
  expect_near(made.depth_point_in_bone_mm, {60.0, 0.0, 0.0});
}

TEST(TurnedFace, RefusesWhatSaysNoPlane) {
  json whole = block_json();
  whole["cuts"][0]["face"]["from"] = "plantar";
  EXPECT_EQ(refusal(whole),
            "block: cuts[0] \"cut\".face.from: \"plantar\" runs along \"dorsal\"; name a direction "
            "that parts from face.contains");
  whole = block_json();
  whole["cuts"][0]["keep"] = "lateral";
  EXPECT_EQ(refusal(whole),
            "block: cuts[0] \"cut\": the side \"lateral\" lies in the face; name a direction that "
            "leaves it");
  whole = block_json();
  whole["cuts"][0]["face"]["through"] = "centre";
  EXPECT_EQ(refusal(whole),
            "block: cuts[0] \"cut\": the bone \"block\" has no landmark \"centre\"; use one of: "
            "base, middle, end");
  whole = block_json();
  whole["points"] = {{{"name", "beyond"},
                      {"at", "end"},
                      {"move", {{{"along", "distal"}, {"mm", 1}}}},
                      {"origin", "author: a test."}}};
  whole["cuts"][0]["face"]["through"] = "beyond";
  EXPECT_EQ(refusal(whole),
            "block: cuts[0] \"cut\": its plane misses the bone \"block\"; mend face.through, its "
            "angles or the window");
}

TEST(TurnedFace, RefusesAWindowThatHasNoPlaceInIt) {
  json whole = block_json();
  whole["cuts"][0]["window"] = {{"beyond", "middle"}, {"along", "distal"}};
  EXPECT_EQ(refusal(whole),
            "block: cuts[0] \"cut\".window.along: \"distal\" is square to the face; name a "
            "direction that lies nearer to it");
  whole["cuts"][0]["window"] = {
      {"beyond", "middle"}, {"along", "lateral"}, {"across", "medial"}, {"across_mm", {-1, 1}}};
  EXPECT_EQ(refusal(whole),
            "block: cuts[0] \"cut\".window.across: \"medial\" does not run across the window; name "
            "a direction square to \"lateral\" in the face");
  whole["cuts"][0]["window"] = {
      {"beyond", "middle"}, {"along", "lateral"}, {"across", "dorsal"}, {"across_mm", {11, 12}}};
  EXPECT_EQ(refusal(whole),
            "block: cuts[0] \"cut\": its plane misses the bone \"block\"; mend face.through, its "
            "angles or the window");
}

}  // namespace
}  // namespace hallux::scenarios
