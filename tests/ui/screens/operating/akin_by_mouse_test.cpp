#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "database/recording/recordings.h"
#include "scenarios/hands/hand_aim.h"
#include "scenarios/hands/stroke_plan.h"
#include "simulator/base/progress.h"
#include "tests/ui/screens/operating/steady_hand.h"
#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {
namespace {

using database::AttemptKind;
using scenarios::Stroke;
using simulator::CutEvent;
using simulator::CutEventKind;
using testing::ElementsAre;

/// Strokes that reach further beyond the bone touch what lies beside it.
constexpr double overlap_mm = 3.0, margin_mm = 0.5, hover_mm = 10.0;
/// How far the pointer runs ahead of the saw: 2/3 N for each millimetre, 16 N.
constexpr double ahead_mm = 24.0;
/// A hand that stops in cortex presses with what the bone takes without giving way.
constexpr double beyond_mm = 3.0, reached_mm = 0.1;

/// Means to hit the plan, and to stop a little before the line.
scenarios::HandSkill exact_hand() {
  scenarios::HandSkill skill;
  skill.angle_mean_deg = skill.angle_deviation_deg = 0.0;
  skill.location_mean_mm = skill.location_deviation_mm = 0.0;
  skill.stop_mean_mm = -0.3;
  skill.stop_deviation_mm = skill.meet_deviation_mm = 0.0;
  return skill;
}

/// Ada with an Akin before her, as she knows it.
class AkinByMouse : public testing::Test {
 protected:
  AkinByMouse() {
    prepared_case_ = course_.prepared_case(*course_.visit_of_ada());
    const scenarios::KnownBones known(prepared_case_->bones);
    aimed_ = scenarios::aim(prepared_case_->scenario, prepared_case_->plan, known, exact_hand(), 1);
    person_.begin();
    person_.press(Key::Digit3);
  }

  RigidTransform world_from_kerf(const scenarios::AimedCut& cut) const {
    return prepared_case_->bone().world_from_bone * cut.plane.bone_from_kerf;
  }
  /// Of the blade in the plane of the cut: how far it was fed, and where along its tooth line.
  static RigidTransform world_from_blade(const RigidTransform& world_from_kerf, double feed_mm,
                                         double along_mm) {
    return world_from_kerf * RigidTransform{{1.0, 0.0, 0.0, 0.0}, {feed_mm, along_mm, 0.0}};
  }

  /// In front of the bone, through it with a push until it is where it should stop, and out again.
  void saw(SteadyHand& hand, const RigidTransform& plane, const Stroke& stroke) {
    const double start_mm = stroke.first_mm - hover_mm;
    ASSERT_TRUE(hand.lead_to(world_from_blade(plane, start_mm, stroke.along_mm)))
        << "the saw does not come to rest before the bone";
    const auto fed_mm = [&] {
      return transform_point(inverse(plane), hand.world_from_tool().translation_mm).x;
    };
    const Vec3 feed = transform_direction(plane, Vec3(1.0, 0.0, 0.0));
    double led_mm = start_mm;
    const auto lead = [&](double wanted_mm) {
      hand.nudge((wanted_mm - led_mm) * feed);
      led_mm = wanted_mm;
    };
    const double end_mm = stroke.end_mm;
    EXPECT_TRUE(person_.until(
        [&] {
          const double wanted_mm = std::min(fed_mm() + ahead_mm, end_mm + beyond_mm);
          if (wanted_mm > led_mm + 0.5) lead(wanted_mm);
          return fed_mm() > end_mm - reached_mm;
        },
        60.0))
        << "stopped at " << fed_mm() << " of " << end_mm;
    lead(start_mm);
    EXPECT_TRUE(person_.until([&] { return fed_mm() < start_mm + 1.0; })) << "the blade is stuck";
  }

  void saw_cut(SteadyHand& hand, std::size_t cut) {
    hand.toggle_saw();
    for (const Stroke& stroke : scenarios::stopped(
             scenarios::plan_strokes(
                 aimed_[cut].region,
                 {prepared_case_->scenario.saw.blade.width_mm, overlap_mm, margin_mm}),
             aimed_[cut].stop_mm.value())) {
      saw(hand, world_from_kerf(aimed_[cut]), stroke);
    }
    hand.toggle_saw();
  }

  bool step_is_ready() {
    return person_.until([&] {
      return person_.driver().has("operate.step") &&
             person_.driver().widget("operate.step").is_enabled;
    });
  }

  OperableCourse course_{"akin", 1.0};
  std::shared_ptr<const PreparedCase> prepared_case_;
  std::vector<scenarios::AimedCut> aimed_;
  Operator person_{course_, AttemptKind::Practice};
};

TEST_F(AkinByMouse, IsOperatedToItsClosedHingeAndScoredWhole) {
  SteadyHand hand(person_);
  person_.press(Key::Enter);
  ASSERT_TRUE(person_.driver().sees("First cut"));
  saw_cut(hand, 0);
  person_.press(Key::Enter);
  ASSERT_TRUE(person_.driver().sees("Second cut"));
  saw_cut(hand, 1);
  person_.press(Key::Enter);
  ASSERT_TRUE(person_.driver().sees("Take it out"));
  ASSERT_TRUE(step_is_ready()) << "no wedge came free";
  person_.press(Key::Enter);
  ASSERT_TRUE(person_.until([&] { return person_.driver().sees("Close the wedge"); }));
  ASSERT_TRUE(step_is_ready());
  const std::size_t bones = person_.scenes.bones;
  person_.click("operate.step");
  ASSERT_TRUE(person_.until([&] { return person_.driver().sees("Check and finish"); }, 60.0));
  EXPECT_TRUE(person_.until([&] { return person_.scenes.bones == bones + 1; }))
      << "the two halves are seen closed";
  person_.press(Key::Enter);
  ASSERT_TRUE(person_.until([&] { return person_.driver().has("operate.ask_finish.act"); }));
  person_.click("operate.ask_finish.act");
  ASSERT_TRUE(person_.until([&] { return person_.is_gone(); }, 120.0));

  const database::AttemptHeader header = course_.attempt();
  ASSERT_TRUE(header.score_milli.has_value());
  database::TraineeDesk desk = course_.course().trainee("ada");
  const simulator::Recording recording = desk.recording(header.id);
  std::vector<std::int32_t> done;
  for (const CutEvent& event : recording.events) {
    if (event.kind == CutEventKind::StepDone) done.push_back(event.subject);
  }
  EXPECT_THAT(done, ElementsAre(0, 1, 2, 3, 4));
  const AttemptMaterial material = load_attempt(course_.course().database(), desk, header.id);
  const database::ScoreCard card =
      score_attempt(material, [](const std::string&) { return Progress(); }).card;
  EXPECT_EQ(card.score_milli, header.score_milli);
  std::int64_t whole_milli = 0;
  for (const scenarios::RubricItem& item : prepared_case_->scenario.rubric.items) {
    whole_milli += item.weight_milli;
  }
  EXPECT_EQ(card.measured_milli, whole_milli) << "every line of the rubric could be measured";
  EXPECT_GT(card.score_milli, 60000);
  for (const database::GateResult& gate : card.gates) EXPECT_FALSE(gate.is_triggered) << gate.text;
  for (const database::LedgerLine& line : card.ledger) {
    // A hand that hardly moves freely is not judged by how smoothly it does.
    EXPECT_TRUE(line.is_measured || line.points_lost_milli == 0) << line.item;
    std::printf("%s\n", line.text.c_str());
  }
  std::printf("score %.1f of %.0f measured, %.0f s\n",
              static_cast<double>(card.score_milli) / 1000.0,
              static_cast<double>(card.measured_milli) / 1000.0,
              static_cast<double>(recording.samples.back().tick) / 1000.0);
}

}  // namespace
}  // namespace hallux::ui
