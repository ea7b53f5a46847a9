/// A simulated hand's chevron as a replay shows it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "simulator/base/embedded.h"
#include "simulator/base/units.h"
#include "tests/support/temporary_directory.h"
#include "ui/screens/replay/pinned_places.h"
#include "ui/screens/replay/replay_material.h"

namespace hallux::scenarios_test {
std::span<const EmbeddedText> watched_scenarios() noexcept;
}

namespace hallux::ui {
namespace {

/// Made once.
class ChevronReplay : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const EmbeddedText& file = scenarios_test::watched_scenarios().front();
    scenarios::Scenario scenario = scenarios::parse_scenario(file.text, file.name);
    scenario.patient.edge_mm = 0.9;
    const tests::TemporaryDirectory directory;
    WorkReport report;
    shared_material = make_replay(scenario, directory.path(), report);
  }
  static void TearDownTestSuite() { shared_material.reset(); }

  const ReplayMaterial& material() const { return *shared_material; }
  const simulator::BoneHistory& history() const { return *shared_material->bone->history; }
  /// What is drawn at a tick.
  Scene scene_at(std::int64_t tick) {
    moment_ = std::make_unique<simulator::BoneMoment>(history());
    moment_->move_to(tick);
    const HandAtMoment hand = hand_at(material(), second_from_tick(tick));
    Scene scene;
    scene.bones = bones_of(*material().bone, *moment_);
    add_metal(scene, *moment_, material().tray);
    add_tool(scene, hand.tool, {hand.world_from_tool, hand.is_running, second_from_tick(tick)},
             *moment_, history());
    return scene;
  }
  std::int64_t last_tick() const { return material().samples.back().tick; }

 private:
  static inline std::shared_ptr<const ReplayMaterial> shared_material;
  /// Whose patches the scene borrows.
  std::unique_ptr<simulator::BoneMoment> moment_;
};

TEST_F(ChevronReplay, ShowsTheHeadWhereItWasLed) {
  EXPECT_EQ(scene_at(0).bones.size(), 1U);
  const Scene at_last = scene_at(last_tick());
  ASSERT_EQ(at_last.bones.size(), 2U);
  EXPECT_GT(length_of(at_last.bones[1].world_from_bone.translation_mm -
                      at_last.bones[0].world_from_bone.translation_mm),
            1.0);
  EXPECT_NE(at_last.bones[0].mesh->id, at_last.bones[1].mesh->id);
}

TEST_F(ChevronReplay, ShowsTheWiresThatStandAndTheHolesThatTheyLeave) {
  const std::vector<simulator::ImplantStay>& stays = history().metal.implants;
  ASSERT_FALSE(stays.empty());
  EXPECT_TRUE(scene_at(0).holes.empty());
  for (const simulator::ImplantStay& stay : stays) {
    const Scene scene = scene_at(stay.from_tick);
    ASSERT_EQ(scene.implants.size(), 1U) << "one after the other";
    EXPECT_FALSE(scene.implants[0].is_planned);
    EXPECT_EQ(scene.implants[0].tool, material().tray[stay.implant.tool]);
    EXPECT_FALSE(scene.holes.empty());
    const bool is_taken = stay.until_tick <= last_tick();
    if (is_taken) {
      EXPECT_TRUE(scene_at(stay.until_tick).implants.empty());
    }
  }
  EXPECT_GE(scene_at(last_tick()).holes.size(), stays.size());
}

TEST_F(ChevronReplay, ShowsTheToolThatIsInTheHand) {
  ASSERT_FALSE(history().hand.grips.empty());
  const simulator::Grip& grip = history().hand.grips.front();
  const Scene held = scene_at((grip.from_tick + grip.until_tick) / 2);
  ASSERT_TRUE(held.forceps.has_value());
  EXPECT_FALSE(held.saw || held.driver);
  const simulator::Bvh& piece =
      history().fragments[static_cast<std::size_t>(grip.fragment)].whole->tree;
  const Vec3 jaws_in_piece_mm = transform_point(inverse(held.bones.back().world_from_bone),
                                                held.forceps->world_from_tool.translation_mm);
  EXPECT_NEAR(piece.signed_distance_mm(jaws_in_piece_mm), 1.0, 0.05);
  bool has_driver = false;
  for (const simulator::HandHistory::Choice& choice : history().hand.choices) {
    const Scene scene = scene_at(choice.tick + 1);
    const bool is_saw = material().tray.saw(choice.tool) != nullptr;
    EXPECT_EQ(scene.saw.has_value(), is_saw);
    EXPECT_EQ(scene.driver.has_value(), !is_saw);
    if (is_saw) {
      EXPECT_EQ(scene.saw->blade, material().tray.saw(choice.tool)->blade);
    }
    has_driver = has_driver || !is_saw;
  }
  EXPECT_TRUE(has_driver);
}

TEST_F(ChevronReplay, TellsTheWayToThePlannedFaceOfTheSawAlone) {
  const Curves curves = curves_of(material(), {0.0, material().duration_s});
  std::size_t of_saw = 0;
  for (const ChartPoint& point : curves.to_plan_mm) {
    const auto tick = static_cast<std::int64_t>(std::llround(point.x / step_s));
    const ToolAtMoment tool = tool_at(history().hand, material().tray, tick);
    EXPECT_TRUE(tool.held == HeldTool::Saw || std::isnan(point.y)) << point.x;
    if (std::isfinite(point.y)) ++of_saw;
  }
  EXPECT_GT(of_saw, 100U);
}

TEST_F(ChevronReplay, ComparesADriverWithWhatIsPlannedForIt) {
  const auto bored = std::ranges::find_if(
      history().metal.implants,
      [](const simulator::ImplantStay& stay) { return !stay.implant.size.is_screw; });
  ASSERT_NE(bored, history().metal.implants.end());
  const HandAtMoment hand = hand_at(material(), second_from_tick(bored->from_tick - 1));
  ASSERT_EQ(hand.tool.held, HeldTool::Driver);
  EXPECT_LT(hand.to_plan.distance_mm, 3.0);
  EXPECT_LT(hand.to_plan.tilt_rad, radian_from_degree(10.0));
  EXPECT_GT(hand.to_plan.depth_mm, 5.0);
}

TEST_F(ChevronReplay, APlaceOnTheHeadIsKeptAsOneOfItsPiece) {
  const simulator::PlaceOnFragment on_head{
      1, history().fragments[1].whole->solid.mesh.points_mm.front()};
  const database::BonePoint kept = bone_point_of(history(), on_head);
  EXPECT_EQ(kept.body, history().fragments[1].origin.piece);
  PinnedPlaces places;
  EXPECT_EQ(places.of(history(), kept).fragment, 1);
  database::BonePoint on_bone = kept;
  on_bone.body = 0;
  EXPECT_EQ(places.of(history(), on_bone).fragment, 1) << "the same place, kept before it parted";
}

TEST_F(ChevronReplay, NamesWhatHappened) {
  std::set<std::string> said;
  for (const AttemptEvent& event : material().events) said.emplace(event.words);
  for (const char* words : {"fragment_parted", "gripped", "released", "tool_chosen", "bore_begun",
                            "bore_through", "implant_left", "implant_taken"})
    EXPECT_TRUE(said.contains("replay.event." + std::string(words))) << words;
}

}  // namespace
}  // namespace hallux::ui
