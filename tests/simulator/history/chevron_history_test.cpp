/// A whole chevron and a whole Akin by a hand without errors, at each moment again.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <span>

#include "assessment/rebuild/bodies.h"
#include "assessment/rebuild/opened_fields.h"
#include "scenarios/hands/feeling_hand.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/embedded.h"
#include "simulator/history/bone_moment.h"
#include "tests/scenarios/hands/scripted_attempt.h"
#include "tests/simulator/history/shown_solid.h"

namespace hallux::scenarios_test {
std::span<const EmbeddedText> replayed_scenarios() noexcept;
}

namespace hallux::simulator {
namespace {

using testing::shown_mm3;
using testing::standing_count;

/// An operation on a coarse patient, carried out and looked back at.
struct Operated {
  explicit Operated(scenarios::Scenario said) : scenario(std::move(said)) {
    scenario.patient.edge_mm = 0.9;
    bone = make_patient_bones(scenario).front();
    plan = plan_on(scenario, bone);
    scenarios::FeelingHand hand(scenario, bone, plan, scenarios::hand_skill("perfect"), 1);
    recording = tests::run_hand(scenario, bone, plan, hand).recording;
  }

  std::shared_ptr<const BoneHistory> history_of(const Recording& made) const {
    const Tray tray = tray_of(scenario);
    return build_history({bone, made, assessment::opened_fields(tray, bone, made),
                          scenarios::planned_bridges(plan), tray});
  }
  assessment::RebuiltBone rebuilt(const Recording& made) const {
    return assessment::rebuild(bone, tray_of(scenario), made, {}, nullptr, {},
                               {scenarios::planned_bridges(plan), true});
  }
  std::vector<std::int64_t> ticks_of(CutEventKind kind) const {
    std::vector<std::int64_t> ticks;
    for (const CutEvent& event : recording.events)
      if (event.kind == kind) ticks.push_back(event.tick);
    return ticks;
  }
  const ToolSample& sample_at(std::int64_t tick) const {
    return *std::partition_point(recording.samples.begin(), recording.samples.end(),
                                 [tick](const ToolSample& sample) { return sample.tick < tick; });
  }

  scenarios::Scenario scenario;
  Bone bone;
  scenarios::Plan plan;
  Recording recording;
};

double total_mm3(const BoneMoment& moment) {
  double sum_mm3 = 0.0;
  for (std::int32_t number = 0; number < moment.fragment_count(); ++number)
    sum_mm3 += shown_mm3(moment.fragment(number));
  return sum_mm3;
}

/// As scoring leaves it at the end: each fragment's pieces, and where it lies.
void expect_as_rebuilt(const BoneMoment& moment, const Operated& operated,
                       const assessment::RebuiltBone& rebuilt) {
  const auto bodies = assessment::bodies_of(rebuilt, operated.plan, operated.bone);
  ASSERT_EQ(moment.fragment_count(), std::ssize(rebuilt.fragments));
  double all_mm3 = rebuilt.debris_mm3;
  std::vector<double> of_fragment(rebuilt.fragments.size(), 0.0);
  for (const assessment::Body& body : bodies) {
    if (body.fragment < 0) continue;
    const auto number = static_cast<std::size_t>(body.fragment);
    all_mm3 += body.volume_mm3;
    of_fragment[number] += body.volume_mm3;
    const RigidTransform pose = operated.bone.world_from_bone * body.bone_from_piece;
    EXPECT_EQ(moment.world_from_fragment(body.fragment).translation_mm, pose.translation_mm);
    EXPECT_EQ(moment.world_from_fragment(body.fragment).rotation, pose.rotation);
  }
  EXPECT_NEAR(total_mm3(moment), all_mm3, 1.0e-6 * all_mm3);
  for (std::size_t i = 0; i < of_fragment.size(); ++i) {
    EXPECT_NEAR(shown_mm3(moment.fragment(static_cast<std::int32_t>(i))), of_fragment[i],
                1.0e-6 * of_fragment[i] + rebuilt.debris_mm3)
        << "fragment " << i;
  }
}

/// The operation is carried out once.
class ChevronHistory : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const EmbeddedText& file = scenarios_test::replayed_scenarios().front();
    shared_operated = std::make_unique<Operated>(scenarios::parse_scenario(file.text, file.name));
    shared_history = shared_operated->history_of(shared_operated->recording);
  }
  static void TearDownTestSuite() {
    shared_history.reset();
    shared_operated.reset();
  }

  BoneMoment moment_at(std::int64_t tick) const {
    BoneMoment moment(*shared_history);
    moment.move_to(tick);
    return moment;
  }
  const Operated& operated() const { return *shared_operated; }
  const BoneHistory& history() const { return *shared_history; }
  std::int64_t last_tick() const { return shared_operated->recording.samples.back().tick; }

 private:
  static inline std::unique_ptr<Operated> shared_operated;
  static inline std::shared_ptr<const BoneHistory> shared_history;
};

TEST_F(ChevronHistory, EndsWithTheBodiesThatScoringRebuilds) {
  expect_as_rebuilt(moment_at(last_tick()), operated(), operated().rebuilt(operated().recording));
}

TEST_F(ChevronHistory, TheHeadIsAFragmentFromItsFirstGrip) {
  const std::vector<std::int64_t> parted = operated().ticks_of(CutEventKind::FragmentParted);
  ASSERT_FALSE(parted.empty());
  EXPECT_EQ(standing_count(moment_at(parted[0] - 1)), 1);
  const BoneMoment moment = moment_at(parted[0]);
  EXPECT_EQ(standing_count(moment), 2);
  EXPECT_NEAR(total_mm3(moment), total_mm3(moment_at(parted[0] - 1)), 1.0e-4)
      << "parting takes nothing";
}

TEST_F(ChevronHistory, TheHeadLiesInTheForcepsWhereTheSamplesSay) {
  const HandHistory& hand = history().hand;
  ASSERT_FALSE(hand.grips.empty());
  for (const Grip& grip : hand.grips) {
    for (const std::int64_t tick :
         {grip.from_tick, (grip.from_tick + grip.until_tick) / 2, grip.until_tick - 1}) {
      const RigidTransform said = transform_from(operated().sample_at(tick).world_from_tool);
      const BoneMoment moment = moment_at(tick);
      EXPECT_EQ(moment.world_from_fragment(grip.fragment).translation_mm, said.translation_mm);
      EXPECT_EQ(moment.world_from_fragment(grip.fragment).rotation, said.rotation);
    }
  }
}

TEST_F(ChevronHistory, WiresAndScrewsStandFromWhenTheyAreLeftUntilTheyAreTaken) {
  const std::vector<std::int64_t> left = operated().ticks_of(CutEventKind::ImplantLeft);
  const std::vector<std::int64_t> taken = operated().ticks_of(CutEventKind::ImplantTaken);
  ASSERT_EQ(left.size(), 3U);
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_TRUE(moment_at(left[0] - 1).implants().empty());
  EXPECT_EQ(moment_at(left[0]).implants().size(), 1U);
  const BoneMoment at_last = moment_at(last_tick());
  const std::vector<const ImplantStay*> standing = at_last.implants();
  ASSERT_EQ(standing.size(), 1U);
  EXPECT_TRUE(standing[0]->implant.size.is_screw);
  // One by one, against the rule of the step.
  for (const CutEvent& event : operated().recording.events) {
    ImplantSet rule(tray_of(operated().scenario));
    FragmentPoses poses(operated().bone.world_from_bone);
    if (event.kind != CutEventKind::ImplantLeft && event.kind != CutEventKind::ImplantTaken &&
        event.kind != CutEventKind::FragmentParted)
      continue;
    for (const CutEvent& before : operated().recording.events) {
      if (before.tick > event.tick) break;
      ASSERT_TRUE(poses.apply(before) && rule.apply(before, poses));
    }
    const BoneMoment moment = moment_at(event.tick);
    const auto there =
        std::ranges::count_if(rule.all(), [](const Implant& implant) { return !implant.is_taken; });
    ASSERT_EQ(std::ssize(moment.implants()), there) << event.tick;
    for (const ImplantStay* const stay : moment.implants()) {
      EXPECT_EQ(stay->implant.fragment, rule[stay->number].fragment) << event.tick;
      EXPECT_EQ(stay->implant.fragment_from_tool.translation_mm,
                rule[stay->number].fragment_from_tool.translation_mm);
    }
  }
}

TEST_F(ChevronHistory, HolesOpenAsTheyAreBored) {
  const std::vector<std::int64_t> begun = operated().ticks_of(CutEventKind::BoreBegun);
  ASSERT_FALSE(begun.empty());
  EXPECT_TRUE(moment_at(begun[0] - 1).rims().empty());
  BoreSet rule(tray_of(operated().scenario));
  FragmentPoses poses(operated().bone.world_from_bone);
  auto event = operated().recording.events.begin();
  for (const ToolSample& sample : operated().recording.samples) {
    for (; event != operated().recording.events.end() && event->tick <= sample.tick; ++event)
      ASSERT_TRUE(poses.apply(*event) && rule.apply(*event, poses));
    rule.apply(sample, poses);
    if (sample.tick % 500 != 0) continue;
    for (std::size_t i = 0; i < rule.places().size(); ++i) {
      ASSERT_LT(i, history().metal.bores.size());
      EXPECT_EQ(history().metal.bores[i].depth_mm_at(sample.tick), rule.places()[i].bore.depth_mm);
    }
  }
  const BoneMoment at_last = moment_at(last_tick());
  const std::vector<RimInMoment> rims = at_last.rims();
  EXPECT_FALSE(rims.empty());
  for (const RimInMoment& rim : rims) {
    const FragmentHistory& fragment = history().fragments[static_cast<std::size_t>(rim.fragment)];
    const Bvh skin(fragment.stretches[at_last.fragment(rim.fragment).stretch()].solid.mesh);
    for (const Vec3& point_mm : rim.rim->points_mm)
      EXPECT_NEAR(skin.signed_distance_mm(point_mm), 0.0, 1.0e-6);
  }
}

TEST_F(ChevronHistory, TheToolInTheHandIsTheOneThatWasChosen) {
  EXPECT_EQ(history().hand.tool_at(0), 0);
  std::int32_t tool = 0;
  for (const CutEvent& event : operated().recording.events) {
    if (event.kind != CutEventKind::ToolChosen) continue;
    EXPECT_EQ(history().hand.tool_at(event.tick - 1), tool);
    tool = event.subject;
    EXPECT_EQ(history().hand.tool_at(event.tick), tool);
  }
  EXPECT_FALSE(history().hand.choices.empty());
}

TEST_F(ChevronHistory, IsTheSameForwardsAndBackwards) {
  const auto all_at = [&](BoneMoment& moment, std::int64_t tick) {
    moment.move_to(tick);
    std::vector<double> values;
    for (std::int32_t number = 0; number < moment.fragment_count(); ++number) {
      values.push_back(shown_mm3(moment.fragment(number)));
      values.push_back(moment.world_from_fragment(number).translation_mm.z);
    }
    values.push_back(static_cast<double>(moment.implants().size()));
    values.push_back(static_cast<double>(moment.rims().size()));
    return values;
  };
  constexpr std::int64_t moments = 60;
  std::vector<std::vector<double>> forwards;
  BoneMoment played(history()), scrubbed(history());
  for (std::int64_t i = 0; i <= moments; ++i)
    forwards.push_back(all_at(played, i * last_tick() / moments));
  for (std::int64_t i = moments; i >= 0; --i)
    EXPECT_EQ(all_at(scrubbed, i * last_tick() / moments), forwards[static_cast<std::size_t>(i)]);
}

TEST_F(ChevronHistory, APlaceOnTheHeadGoesWithIt) {
  const Vec3 on_head_mm = operated().plan.fixation.fragments.front().holds_in_bone_mm;
  const PlaceOnFragment place = history().place_at_last({0, on_head_mm});
  EXPECT_EQ(place.fragment, 1);
  const Vec3 before_mm = moment_at(0).world_place_mm(place);
  const Vec3 after_mm = moment_at(last_tick()).world_place_mm(place);
  EXPECT_GT(length_of(after_mm - before_mm), 3.0);
}

/// The same recording as engine 7 said it: the half that turned was no fragment.
Recording as_engine_7(Recording recording) {
  recording.engine = 7;
  std::erase_if(recording.events,
                [](const CutEvent& event) { return event.kind == CutEventKind::FragmentParted; });
  for (CutEvent& event : recording.events)
    if (event.kind == CutEventKind::HingeClosed) event.subject = -1;
  return recording;
}

TEST(ClosedHingeHistory, IsTwoFragmentsAlsoOfEngine7) {
  const Operated akin(scenarios::load_shipped_scenario("akin"));
  const std::vector<std::int64_t> closed = akin.ticks_of(CutEventKind::HingeClosed);
  ASSERT_EQ(closed.size(), 1U);
  const assessment::RebuiltBone rebuilt = akin.rebuilt(akin.recording);
  for (const Recording& recording : {akin.recording, as_engine_7(akin.recording)}) {
    const auto history = akin.history_of(recording);
    BoneMoment moment(*history);
    moment.move_to(closed[0] - 1);
    EXPECT_EQ(standing_count(moment), 1);
    moment.move_to(closed[0]);
    EXPECT_EQ(standing_count(moment), 2);
    moment.move_to(akin.recording.samples.back().tick);
    ASSERT_EQ(standing_count(moment), 2);
    expect_as_rebuilt(moment, akin, rebuilt);
    EXPECT_EQ(moment.fragment(1).patch(), nullptr);
    EXPECT_NE(moment.world_from_fragment(1).rotation, akin.bone.world_from_bone.rotation);
  }
}

}  // namespace
}  // namespace hallux::simulator
