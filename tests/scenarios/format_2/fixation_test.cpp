// Pieces, shifts and implants on a block whose volumes are known by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "scenarios/fixation/bone_pieces.h"
#include "simulator/base/units.h"
#include "tests/scenarios/format_2/fixtures.h"

namespace hallux::scenarios {
namespace {

using nlohmann::json;
using scenarios_test::block;
using scenarios_test::block_json;

constexpr double rounding = 1.0e-12;
/// Of cells of a millimetre along a face of 20 x 20 mm, and as many along each other side.
constexpr double cells_mm3 = 2000.0;

PartingFace across_at(double x_mm) { return {{{1.0, 0.0, 0.0}, x_mm}, {}}; }

/// A face that begins at a point and goes on along a direction.
PartingFace half_face(const Vec3& normal, const Vec3& from_mm, const Vec3& along) {
  return {{normal, glm::dot(normal, from_mm)},
          FaceWindow{from_mm, along, glm::cross(normal, along)}};
}

double whole_mm3(const BonePieces& pieces) {
  return std::accumulate(pieces.volumes_mm3().begin(), pieces.volumes_mm3().end(), 0.0);
}

TEST(BonePieces, OfAWholeBoneAreOne) {
  const BonePieces pieces(block().outer, {});
  ASSERT_EQ(pieces.volumes_mm3().size(), 1U);
  EXPECT_NEAR(whole_mm3(pieces), 24000.0, cells_mm3);
  EXPECT_TRUE(pieces.at({30.0, 0.0, 0.0}).has_value());
  EXPECT_FALSE(pieces.at({30.0, 12.0, 0.0}).has_value());
  EXPECT_FALSE(pieces.at({300.0, 0.0, 0.0}).has_value());
  EXPECT_TRUE(pieces.near({30.0, 10.5, 0.0}).has_value()) << "on the surface, to a cell";
  EXPECT_FALSE(pieces.near({30.0, 16.0, 0.0}).has_value());
}

TEST(BonePieces, BetweenParallelFacesAreThree) {
  const std::vector<PartingFace> faces{across_at(20.0), across_at(30.0)};
  const BonePieces pieces(block().outer, faces);
  ASSERT_EQ(pieces.volumes_mm3().size(), 3U);
  EXPECT_NEAR(pieces.volumes_mm3()[*pieces.at({10.0, 0.0, 0.0})], 8000.0, cells_mm3);
  EXPECT_NEAR(pieces.volumes_mm3()[*pieces.at({25.0, 0.0, 0.0})], 4000.0, cells_mm3);
  EXPECT_NEAR(pieces.volumes_mm3()[*pieces.at({50.0, 0.0, 0.0})], 12000.0, cells_mm3);
}

/// Two half faces from an apex line along z: no side of either plane alone is a piece.
TEST(BonePieces, OfAVAreTheTongueAndTheRest) {
  const Vec3 apex(40.0, 0.0, 0.0);
  const double half = std::sqrt(0.5);
  const std::vector<PartingFace> faces{half_face({half, half, 0.0}, apex, {-half, half, 0.0}),
                                       half_face({half, -half, 0.0}, apex, {-half, -half, 0.0})};
  const BonePieces pieces(block().outer, faces);
  ASSERT_EQ(pieces.volumes_mm3().size(), 2U);
  EXPECT_EQ(pieces.at({44.0, 0.0, 0.0}), pieces.at({37.0, 8.0, 0.0})) << "past the dorsal arm";
  EXPECT_EQ(pieces.at({37.0, -8.0, 0.0}), pieces.at({37.0, 8.0, 0.0}));
  EXPECT_NE(pieces.at({34.0, 0.0, 0.0}), pieces.at({44.0, 0.0, 0.0}));
  // 30 mm of the block and the tongue's triangle of 10 mm.
  EXPECT_NEAR(pieces.volumes_mm3()[*pieces.at({10.0, 0.0, 0.0})], 30.0 * 400.0 + 2000.0, cells_mm3);
}

/// A long face along the bone and a short one at each of its ends.
TEST(BonePieces, OfAZAreTwo) {
  PartingFace along{{{0.0, 1.0, 0.0}, 0.0},
                    FaceWindow{{15.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
  const std::vector<PartingFace> open{
      along, half_face({1.0, 0.0, 0.0}, {15.0, 0.0, 0.0}, {0.0, -1.0, 0.0})};
  EXPECT_EQ(BonePieces(block().outer, open).volumes_mm3().size(), 2U)
      << "the long face runs out of the end";
  // With its far end at 45 mm: the window's own limits are counted across it.
  along.window = FaceWindow{{15.0, 0.0, -20.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 0.0, 30.0};
  const PartingFace near = half_face({1.0, 0.0, 0.0}, {15.0, 0.0, 0.0}, {0.0, -1.0, 0.0});
  const PartingFace far = half_face({1.0, 0.0, 0.0}, {45.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
  EXPECT_EQ(BonePieces(block().outer, std::vector{along, near}).volumes_mm3().size(), 1U)
      << "without the third face it hangs together";
  const BonePieces pieces(block().outer, std::vector{along, near, far});
  ASSERT_EQ(pieces.volumes_mm3().size(), 2U);
  EXPECT_EQ(pieces.at({5.0, -5.0, 0.0}), pieces.at({40.0, 5.0, 0.0}));
  EXPECT_EQ(pieces.at({55.0, 5.0, 0.0}), pieces.at({20.0, -5.0, 0.0}));
  EXPECT_NEAR(pieces.volumes_mm3()[0], 12000.0, cells_mm3);
}

json named(const char* name, json keys) {
  keys["name"] = name;
  keys["title"] = name;
  keys["origin"] = "author: a test.";
  return keys;
}

/// The block is parted at 30 mm, its end slides 4 mm laterally and turns, and a wire holds it.
json fixed_block() {
  json block = block_json();
  const auto place = [](const char* name, double x_mm, double y_mm) -> json {
    return {{"name", name},
            {"at", "middle"},
            {"move", {{{"along", "distal"}, {"mm", x_mm}}, {{"along", "dorsal"}, {"mm", y_mm}}}},
            {"origin", "author: a test."}};
  };
  block["points"] = {place("entry", -20.0, 5.0), place("beside", 10.0, 0.0)};
  block["fragments"] = {named("tip", {{"holds", "end"}})};
  block["shifts"] = {
      named("over", {{"fragment", "tip"}, {"moves", {{{"slide", "lateral"}, {"mm", 4}}}}})};
  block["wires"] = {named("wire", {{"entry", "entry"},
                                   {"direction", "distal"},
                                   {"diameter_mm", {1.2, 1.4}},
                                   {"depth_mm", {30, 34}},
                                   {"engages", {"first_metatarsal", "tip"}},
                                   {"cortices", 1}})};
  json& steps = block["steps"];
  const auto step = [](const char* id, const char* kind, const char* key, json subject,
                       const char* after) -> json {
    return {{"id", id},      {"kind", kind}, {"title", id},
            {"text", "Do."}, {key, subject}, {"after", {after}}};
  };
  steps.insert(steps.end() - 1, step("move", "shift", "shift", "over", "saw"));
  steps.insert(steps.end() - 1, step("fix", "fix", "implants", {"wire"}, "move"));
  steps.back()["after"] = {"fix"};
  return block;
}

PlannedFixation planned(const json& whole) {
  return plan_on(parse_scenario(whole.dump(), "f.json"), block()).fixation;
}

std::string refusal(const json& whole) { return scenarios_test::plan_refusal_of(whole, block()); }

TEST(Fixation, IsNothingWhereTheScenarioHasNone) {
  const PlannedFixation none = planned(block_json());
  EXPECT_TRUE(none.fragments.empty());
  EXPECT_TRUE(none.shifts.empty());
  EXPECT_TRUE(none.implants.empty());
}

TEST(Fixation, PlansTheWireByTheMiddleOfItsRanges) {
  const PlannedFixation fixation = planned(fixed_block());
  ASSERT_EQ(fixation.implants.size(), 1U);
  const PlannedImplant& wire = fixation.implants[0];
  EXPECT_EQ(wire.kind, ImplantKind::Wire);
  EXPECT_NEAR(wire.diameter_mm, 1.3, rounding);
  EXPECT_NEAR(wire.length_mm, 32.0, rounding);
  EXPECT_LT(length_of(wire.entry_in_bone_mm - Vec3(10.0, 5.0, 0.0)), rounding);
  EXPECT_LT(length_of(wire.tip_in_bone_mm - Vec3(42.0, 5.0, 0.0)), rounding);
  EXPECT_NEAR(fixation.fragments.at(0).volume_mm3, 12000.0, cells_mm3);
}

TEST(Fixation, CarriesAFragmentThroughItsMovesInTheirOrder) {
  json whole = fixed_block();
  whole["shifts"][0]["moves"] = {{{"slide", "lateral"}, {"mm", 4}},
                                 {{"turn", "dorsal"}, {"through", "beside"}, {"deg", 90}}};
  whole["wires"][0]["engages"] = {"first_metatarsal"};
  const PlannedFixation fixation = planned(whole);
  const RigidTransform& moved = fixation.fragments.at(0).bone_from_rest;
  EXPECT_EQ(moved, find_shift(fixation, "over")->bone_from_before);
  // Slid to (60, 0, 4), which is (20, 0, 4) from the pivot at (40, 0, 0); turned about y.
  EXPECT_LT(length_of(transform_point(moved, Vec3(60.0, 0.0, 0.0)) - Vec3(44.0, 0.0, -20.0)),
            rounding);
  EXPECT_LT(length_of(transform_direction(moved, Vec3(1.0, 0.0, 0.0)) - Vec3(0.0, 0.0, -1.0)),
            rounding);
}

TEST(Fixation, ShiftsAFragmentInTheOrderOfTheSteps) {
  json whole = fixed_block();
  whole["shifts"].push_back(
      named("turned", {{"fragment", "tip"},
                       {"moves", {{{"turn", "dorsal"}, {"through", "beside"}, {"deg", 90}}}}}));
  json& steps = whole["steps"];
  json first = steps[steps.size() - 3], second = first;
  EXPECT_EQ(first["id"], "move");
  first["id"] = "turn";
  first["shift"] = "turned";
  second["after"] = {"turn"};
  steps[steps.size() - 3] = second;
  steps.insert(steps.end() - 1, first);
  whole["wires"][0]["engages"] = {"first_metatarsal"};
  const PlannedFixation fixation = planned(whole);
  const PlannedShift &over = *find_shift(fixation, "over"),
                     &turned = *find_shift(fixation, "turned");
  EXPECT_EQ(turned.bone_from_cut(), turned.bone_from_before) << "done first, though listed last";
  EXPECT_EQ(over.bone_from_cut(), over.bone_from_before * turned.bone_from_before);
  EXPECT_EQ(fixation.fragments.at(0).bone_from_rest, over.bone_from_cut());
}

TEST(Fixation, MeetsAFragmentWhereItWasShiftedTo) {
  json whole = fixed_block();
  EXPECT_EQ(refusal(whole), "");
  whole["shifts"][0]["moves"][0]["mm"] = 11;
  EXPECT_EQ(refusal(whole),
            "block: wires[0] \"wire\": its axis misses \"tip\", which it must engage; mend entry, "
            "direction or depth_mm")
      << "the tip lies 1 mm beside it";
  whole["steps"][3]["kind"] = "guide_wire";
  EXPECT_EQ(refusal(whole), "") << "a guide wire is set before anything is cut";
}

TEST(Fixation, KeepsAnAxisOffAJointSurface) {
  json whole = fixed_block();
  whole["joint_surfaces"] = {{{"name", "end_surface"},
                              {"title", "End"},
                              {"around", "end"},
                              {"radius_mm", 40},
                              {"facing_in_bone", {1, 0, 0}},
                              {"within_deg", 10},
                              {"checked", false},
                              {"origin", "author: a test."}}};
  whole["wires"][0]["clear_of"] = {{{"joint_surface", "end_surface"}, {"mm", 2}}};
  EXPECT_NEAR(planned(whole).implants[0].clear_of.at(0).planned_mm, 18.0, rounding);
  whole["wires"][0]["depth_mm"] = {47, 49};
  EXPECT_NEAR(planned(whole).implants[0].clear_of.at(0).planned_mm, 2.0, rounding);
  whole["wires"][0]["depth_mm"] = {47.5, 49};
  EXPECT_EQ(refusal(whole),
            "block: wires[0] \"wire\": its axis comes within 2 mm of the joint surface "
            "\"end_surface\"; mend entry, direction or depth_mm");
  whole["wires"][0]["depth_mm"] = {60, 70};
  EXPECT_NE(refusal(whole).find("comes within 2 mm"), std::string::npos)
      << "it pierces the surface";
}

TEST(Fixation, RefusesFragmentsThatAreNone) {
  json whole = fixed_block();
  whole["cuts"][0]["window"] = {{"beyond", "middle"}, {"along", "lateral"}};
  EXPECT_EQ(refusal(whole),
            "block: fragments[0] \"tip\": no cut parts it from the rest of the bone \"block\"; "
            "mend the cuts or their windows");
  whole = fixed_block();
  whole["fragments"].push_back(named("same", {{"holds", "beside"}}));
  EXPECT_EQ(refusal(whole),
            "block: fragments[1] \"same\": another fragment lies in the same piece of the bone "
            "\"block\"; mend holds or the cuts");
  whole = fixed_block();
  whole["points"][1]["move"][1]["mm"] = 30;
  whole["fragments"][0]["holds"] = "beside";
  EXPECT_EQ(refusal(whole),
            "block: fragments[0] \"tip\": \"beside\" lies outside of the bone \"block\"; mend "
            "holds");
}

}  // namespace
}  // namespace hallux::scenarios
