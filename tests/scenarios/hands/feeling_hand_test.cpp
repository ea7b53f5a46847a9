#include "scenarios/hands/feeling_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenarios/plan.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/hands/scripted_attempt.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;
using simulator::CommandKind;
using simulator::Recording;

/// Silver without its frontal tilt on a soft block 30 x 20 x 20 mm about the x axis: the planned
/// face is z = -1.
struct Patient {
  Patient() : silver(scenarios_test::format_1("silver")) {
    silver.cuts.at(0).face.frontal_tilt_rad = 0.0;
    silver.joint_surfaces.clear();
    bone = tests::cancellous_bone(
        tests::moved(tests::solid_block({30.0, 20.0, 20.0}), {{}, {15.0, 0.0, 0.0}}));
    bone.landmarks = {{"shaft_proximal", Vec3(10.0, 0.0, 0.0)},
                      {"shaft_distal", Vec3(20.0, 0.0, 0.0)},
                      {"med_sulcus", Vec3(26.0, 4.0, 0.0)},
                      {"shaft_medial", Vec3(15.0, 0.0, -10.0)}};
    plan = plan_on(silver, bone);
  }
  FeelingHand hand(const HandSkill& skill, std::uint64_t seed) const {
    return {silver, bone, plan, skill, seed};
  }
  Recording operated(const HandSkill& skill, std::uint64_t seed) const {
    FeelingHand operating = hand(skill, seed);
    return tests::run_hand(silver, bone, plan, operating).recording;
  }

  Scenario silver;
  Bone bone;
  Plan plan;
};

std::string refusal_of(const Patient& patient, const HandSkill& skill, std::uint64_t seed) {
  try {
    patient.hand(skill, seed);
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

TEST(FeelingHand, DoesTheSameForTheSameSeedAndAnotherForAnother) {
  const Patient patient;
  const HandSkill skill = hand_skill("novice");
  const Recording recording = patient.operated(skill, 7);
  EXPECT_EQ(recording.tape, patient.operated(skill, 7).tape);
  EXPECT_NE(recording.tape, patient.operated(skill, 8).tape);
}

TEST(FeelingHand, OfAnUnknownNameIsRefusedWithTheNamesThereAre) {
  try {
    hand_skill("surgeon");
    FAIL() << "a hand of that name was given";
  } catch (const ScenarioError& error) {
    EXPECT_STREQ(
        error.what(),
        "there is no hand \"surgeon\"; use expert, novice, perfect, or a file with a motion");
  }
}

TEST(FeelingHand, SaysTheErrorsThatItsFaceHas) {
  const Patient patient;
  for (const char* name : {"expert", "novice"}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const FeelingHand hand = patient.hand(hand_skill(name), seed);
      const Vec3 planned(0.0, 0.0, -1.0);
      // An arc cosine near 1 loses half of a double's digits.
      EXPECT_NEAR(std::acos(glm::dot(hand.cuts().at(0).face.normal, planned)),
                  hand.cuts().at(0).angle_error_rad, 1.0e-6)
          << name << ' ' << seed;
      // Two planes are farthest apart at a corner of the section.
      double largest_mm = 0.0;
      for (const double x_mm : {0.0, 30.0}) {
        for (const double y_mm : {-10.0, 10.0}) {
          const double stand_off_mm =
              (hand.cuts().at(0).face.offset_mm -
               glm::dot(hand.cuts().at(0).face.normal, Vec3(x_mm, y_mm, -1.0))) /
              glm::dot(hand.cuts().at(0).face.normal, planned);
          largest_mm = std::max(largest_mm, std::abs(stand_off_mm));
        }
      }
      EXPECT_NEAR(largest_mm, hand.cuts().at(0).location_error_mm, 1.0e-9) << name << ' ' << seed;
    }
  }
}

TEST(FeelingHand, DeclaresEachStepInOrderAndFinishesLast) {
  const Patient patient;
  const Recording recording = patient.operated(hand_skill("novice"), 3);
  std::vector<CommandKind> kinds;
  std::vector<std::int32_t> done;
  for (const simulator::TapeLine& line : recording.tape) {
    for (std::size_t i = 0; i < line.command_count; ++i) {
      const simulator::Command& command = line.commands[i];
      if (command.kind == CommandKind::ApplyJob) continue;
      kinds.push_back(command.kind);
      if (command.kind == CommandKind::StepDone) done.push_back(command.argument);
    }
  }
  EXPECT_EQ(kinds, (std::vector{CommandKind::Start, CommandKind::StepDone, CommandKind::StepDone,
                                CommandKind::PickUp, CommandKind::StepDone, CommandKind::StepDone,
                                CommandKind::Finish}));
  EXPECT_EQ(done, (std::vector<std::int32_t>{0, 1, 2, 3}));
  EXPECT_EQ(recording.events.back().kind, simulator::CutEventKind::Finished);
  // By itself, long before its limit.
  EXPECT_LT(recording.tape.size(), static_cast<std::size_t>(FeelingHand::last_tick / 2));
}

TEST(FeelingHand, ThatNeverMeetsTheBoneIsRefused) {
  Patient patient;
  HandSkill far = hand_skill("expert");
  far.location_mean_mm = 100.0;
  // Half of such hands aim beyond the bone's medial side, the others beyond its lateral side: all
  // miss.
  EXPECT_EQ(refusal_of(patient, far, 5),
            "cut \"eminence\": a hand that errs so far never meets the bone with seed 5; choose "
            "another seed");
  patient.plan.cuts.at(0).face.offset_mm += 50.0;
  EXPECT_EQ(refusal_of(patient, hand_skill("expert"), 5),
            "cut \"eminence\": its planned face misses the bone; mend the plan");
}

}  // namespace
}  // namespace hallux::scenarios
