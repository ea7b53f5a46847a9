// Named points and directions on a block whose geometry is known by hand.
#include "scenarios/geometry/ground.h"

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
using simulator::Bone;

constexpr double rounding = 1.0e-13;

json point(const char* name, json keys) {
  keys["name"] = name;
  keys["origin"] = "author: a test.";
  return keys;
}

/// A block whose bone stands in the foot, turned by 90 degrees about z: its x axis points dorsally.
Bone standing_block() {
  Bone bone = block();
  bone.world_from_bone = {rotation_from_axes({0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}), {5.0, 6.0, 7.0}};
  return bone;
}

class OnBlock {
 public:
  explicit OnBlock(const json& whole, Bone bone = block())
      : scenario_(parse_scenario(whole.dump(), "f.json")),
        bone_(std::move(bone)),
        ground_(scenario_, bone_) {}

  Vec3 point(const std::string& name) const { return ground_.point(name, 0, "test"); }
  Vec3 direction(const std::string& name) const { return ground_.direction(name, 0, "test"); }

 private:
  Scenario scenario_;
  Bone bone_;
  Ground ground_;
};

void expect_near(const Vec3& a, const Vec3& b, double tolerance = rounding) {
  EXPECT_LT(length_of(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

TEST(Ground, PlacesPointsByLandmarksMovesSharesAndRays) {
  json whole = block_json();
  whole["points"] = {
      point("up", {{"at", "middle"},
                   {"move", {{{"along", "dorsal"}, {"mm", 3}}, {{"along", "medial"}, {"mm", 2}}}}}),
      point("quarter", {{"between", {"base", "up"}}, {"share", 0.25}}),
      point("top", {{"on_surface", {{"from", "up"}, {"along", "dorsal"}}}}),
      point("corner", {{"on_surface", {{"from", "middle"}, {"along", "aslant"}}}})};
  whole["directions"] = {point("aslant", {{"turn", "dorsal"}, {"about", "distal"}, {"deg", 30}})};
  const OnBlock ground(whole);
  expect_near(ground.point("up"), {30.0, 3.0, -2.0});
  expect_near(ground.point("quarter"), {7.5, 0.75, -0.5});
  expect_near(ground.point("top"), {30.0, 10.0, -2.0});
  expect_near(ground.point("corner"), {30.0, 10.0, 10.0 * std::tan(radian_from_degree(30.0))},
              1.0e-12);
  expect_near(ground.point("end"), {60.0, 0.0, 0.0});
}

TEST(Ground, MakesDirectionsOfPointsAndOfOthers) {
  json whole = block_json();
  whole["points"] = {point("up", {{"at", "end"}, {"move", {{{"along", "dorsal"}, {"mm", 60}}}}})};
  whole["directions"] = {point("rising", {{"from", "base"}, {"to", "up"}}),
                         point("falling", {{"turn", "rising"}, {"about", "lateral"}, {"deg", -90}}),
                         point("across", {{"square_to_both", {"rising", "falling"}}}),
                         point("level", {{"lay", "rising"}, {"square_to", "dorsal"}})};
  const OnBlock ground(whole);
  const double half = std::sqrt(0.5);
  expect_near(ground.direction("rising"), {half, half, 0.0});
  expect_near(ground.direction("falling"), {half, -half, 0.0});
  expect_near(ground.direction("across"), {0.0, 0.0, -1.0});
  expect_near(ground.direction("level"), {1.0, 0.0, 0.0});
  expect_near(ground.direction("medial"), {0.0, 0.0, -1.0});
}

TEST(Ground, KnowsTheSoleByTheBonesPlaceInTheFoot) {
  const OnBlock ground(block_json(), standing_block());
  expect_near(ground.direction("distal"), {1.0, 0.0, 0.0});
  expect_near(ground.direction("foot_dorsal"), {1.0, 0.0, 0.0});
  expect_near(ground.direction("foot_distal"), {0.0, -1.0, 0.0});
  expect_near(ground.direction("foot_plantar"), {-1.0, 0.0, 0.0});
  expect_near(ground.direction("foot_lateral"), {0.0, 0.0, 1.0});
}

RC_GTEST_PROP(Ground, ATurnKeepsLengthAndTheAngleToItsAxis, ()) {
  const int deg = *rc::gen::inRange(-180, 181);
  json whole = block_json();
  whole["directions"] = {point("tilted", {{"turn", "distal"}, {"about", "dorsal"}, {"deg", 20}}),
                         point("turned", {{"turn", "tilted"}, {"about", "distal"}, {"deg", deg}})};
  const Vec3 turned = OnBlock(whole).direction("turned");
  RC_ASSERT(std::abs(length_of(turned) - 1.0) < rounding);
  RC_ASSERT(std::abs(turned.x - std::cos(radian_from_degree(20.0))) < rounding);
  const double across = -std::sin(radian_from_degree(20.0));
  RC_ASSERT(std::abs(turned.z - across * std::cos(radian_from_degree(deg))) < rounding);
  RC_ASSERT(std::abs(turned.y + across * std::sin(radian_from_degree(deg))) < rounding);
}

std::string refusal(json points, json directions) {
  json whole = block_json();
  if (!points.empty()) whole["points"] = std::move(points);
  if (!directions.empty()) whole["directions"] = std::move(directions);
  const std::string read = scenarios_test::refusal_of(whole);
  return read.empty() ? scenarios_test::plan_refusal_of(whole, block()) : read;
}

TEST(Ground, RefusesWhatItCannotPlaceWithPathAndMend) {
  EXPECT_EQ(refusal({point("a", {{"at", "nowhere"}})}, {}),
            "block: points[0] \"a\": the bone \"block\" has no landmark \"nowhere\"; use one of: "
            "base, middle, end, a");
  EXPECT_EQ(refusal({point("middle", {{"at", "base"}})}, {}),
            "block: points[0] \"middle\": the bone \"block\" has a landmark of that name; choose "
            "another name");
  EXPECT_EQ(refusal({point("a", {{"at", "end"}})}, {point("d", {{"from", "end"}, {"to", "a"}})}),
            "block: directions[0] \"d\": the points \"end\" and \"a\" coincide; name points that "
            "lie apart");
  EXPECT_EQ(refusal({}, {point("d", {{"square_to_both", {"distal", "proximal"}}})}),
            "block: directions[0] \"d\": the directions \"distal\" and \"proximal\" are parallel; "
            "name directions that part");
  EXPECT_EQ(refusal({}, {point("d", {{"lay", "distal"}, {"square_to", "proximal"}})}),
            "block: directions[0] \"d\": the directions \"distal\" and \"proximal\" are parallel; "
            "name directions that part");
  EXPECT_EQ(refusal({point("far", {{"at", "end"}, {"move", {{{"along", "distal"}, {"mm", 5}}}}}),
                     point("b", {{"on_surface", {{"from", "far"}, {"along", "distal"}}}})},
                    {}),
            "block: points[1] \"b\": the way from \"far\" along \"distal\" misses the bone "
            "\"block\"; mend on_surface.from or on_surface.along");
}

TEST(Ground, RefusesNamesThatStandLaterOrNowhere) {
  EXPECT_EQ(refusal({point("a", {{"at", "b"}}), point("b", {{"at", "middle"}})}, {}),
            "f.json: points[0].at: is \"b\", which stands later or is made from this one; name "
            "what stands before it, and let none refer back");
  EXPECT_EQ(
      refusal({point("a", {{"at", "base"}, {"move", {{{"along", "d"}, {"mm", 1}}}}})},
              {point("d", {{"from", "base"}, {"to", "a"}})}),
      "f.json: points[0].move[0].along: is \"d\", which stands later or is made from this one; "
      "name what stands before it, and let none refer back");
  EXPECT_EQ(
      refusal({}, {point("d", {{"turn", "e"}, {"about", "dorsal"}, {"deg", 3}})}),
      "f.json: directions[0].turn: is \"e\", which is no direction; use one of: distal, proximal, "
      "dorsal, plantar, medial, lateral, foot_distal, foot_proximal, foot_dorsal, foot_plantar, "
      "foot_medial, foot_lateral, d");
}

TEST(Ground, CarriesNamesFromOneBoneToAnother) {
  json whole = block_json();
  whole["patient"]["bones"].push_back({{"bone", "first_proximal_phalanx"},
                                       {"length_mm", 33},
                                       {"edge_mm", 1},
                                       {"origin", "author: a test."}});
  whole["points"] = {point("far_end", {{"at", "end"}, {"bone", "first_proximal_phalanx"}})};
  whole["directions"] = {point(
      "its_distal",
      {{"bone", "first_proximal_phalanx"}, {"turn", "distal"}, {"about", "lateral"}, {"deg", 0}})};
  const Scenario scenario = parse_scenario(whole.dump(), "f.json");
  const std::vector<Bone> bones{block(), standing_block()};
  const Ground ground(scenario, bones);
  expect_near(ground.point("far_end", 1, "test"), {60.0, 0.0, 0.0});
  expect_near(ground.point("far_end", 0, "test"), {5.0, 66.0, 7.0}, 1.0e-12);
  expect_near(ground.direction("its_distal", 0, "test"), {0.0, 1.0, 0.0});
  EXPECT_EQ(ground.bone_index("first_proximal_phalanx"), 1U);
  try {
    plan_on(scenario, bones[0]);
    ADD_FAILURE() << "one bone is not both";
  } catch (const ScenarioError& error) {
    EXPECT_STREQ(error.what(),
                 "block: patient: has 2 bones, and the plan was asked for 1; plan it on all of "
                 "them");
  }
}

TEST(Ground, LaysCutsAndZonesOnTheBoneThatTheyName) {
  json whole = block_json();
  whole["patient"]["bones"].push_back({{"bone", "first_proximal_phalanx"},
                                       {"length_mm", 33},
                                       {"edge_mm", 1},
                                       {"origin", "author: a test."}});
  whole["cuts"][0]["bone"] = "first_proximal_phalanx";
  whole["danger_zones"] = {{{"name", "nerve"},
                            {"title", "Nerve"},
                            {"severity", "minor"},
                            {"from_in_bone_mm", {0, 12, 0}},
                            {"to_in_bone_mm", {0, 14, 0}},
                            {"from_landmark", "end"},
                            {"to_landmark", "end"},
                            {"radius_mm", 1},
                            {"checked", false},
                            {"bone", "first_proximal_phalanx"},
                            {"origin", "author: a test."}}};
  const std::vector<Bone> bones{block(), standing_block()};
  const Plan plan = plan_on(parse_scenario(whole.dump(), "f.json"), bones);
  EXPECT_EQ(plan.cuts.at(0).bone, 1U);
  expect_near(plan.cuts[0].face.normal, {1.0, 0.0, 0.0});
  EXPECT_EQ(plan.danger_zones.at(0).bone, 1U);
  expect_near(plan.danger_zones[0].capsule.from_in_bone_mm, {60.0, 12.0, 0.0});
}

}  // namespace
}  // namespace hallux::scenarios
