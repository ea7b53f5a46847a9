#include "scenarios/hands/scripted_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenarios/plan.h"
#include "tests/support/worlds.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;
using simulator::CommandKind;

/// Silver without its frontal tilt on a block 60 x 20 x 20 mm about the x axis: the planned face is z = -1.
struct Patient {
  Patient() : silver(load_shipped_scenario("silver")) {
    silver.cuts.at(0).face.frontal_tilt_rad = 0.0;
    bone.name = "block";
    bone.outer = tests::moved(tests::solid_block({60.0, 20.0, 20.0}), {{}, {30.0, 0.0, 0.0}});
    bone.landmarks = {{"shaft_proximal", Vec3(20.0, 0.0, 0.0)},
                      {"shaft_distal", Vec3(40.0, 0.0, 0.0)},
                      {"med_sulcus", Vec3(52.0, 4.0, 0.0)},
                      {"shaft_medial", Vec3(30.0, 0.0, -10.0)}};
    plan = plan_on(silver, bone);
  }
  ScriptedHand hand(const HandSkill& skill, std::uint64_t seed) const {
    return make_hand(silver, bone, plan, skill, seed);
  }

  Scenario silver;
  Bone bone;
  Plan plan;
};

bool is_same(const simulator::HandMotion& a, const simulator::HandMotion& b) {
  const auto same_key = [](const simulator::HandKey& x, const simulator::HandKey& y) {
    return x.tick == y.tick && x.world_from_handle == y.world_from_handle &&
           x.switches == y.switches;
  };
  const auto same_command = [](const simulator::HandCommand& x, const simulator::HandCommand& y) {
    return x.tick == y.tick && x.command == y.command;
  };
  return std::equal(a.keys.begin(), a.keys.end(), b.keys.begin(), b.keys.end(), same_key) &&
         std::equal(a.commands.begin(), a.commands.end(), b.commands.begin(), b.commands.end(),
                    same_command);
}

std::string refusal_of(const Patient& patient, const HandSkill& skill, std::uint64_t seed) {
  try {
    patient.hand(skill, seed);
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

TEST(ScriptedHand, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const Patient patient;
  for (const char* name : {"expert", "novice"}) {
    const HandSkill skill = hand_skill(name);
    const simulator::HandMotion motion = patient.hand(skill, 7).motion;
    EXPECT_TRUE(is_same(motion, patient.hand(skill, 7).motion)) << name;
    EXPECT_FALSE(is_same(motion, patient.hand(skill, 8).motion)) << name;
  }
}

TEST(ScriptedHand, OfAnUnknownNameIsRefusedWithTheNamesThereAre) {
  try {
    hand_skill("surgeon");
    FAIL() << "a hand of that name was given";
  } catch (const ScenarioError& error) {
    EXPECT_STREQ(error.what(),
                 "there is no hand \"surgeon\"; use expert, novice, or a file with a motion");
  }
}

TEST(ScriptedHand, SaysTheErrorsThatItsFaceHas) {
  const Patient patient;
  for (const char* name : {"expert", "novice"}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const ScriptedHand hand = patient.hand(hand_skill(name), seed);
      const Vec3 planned(0.0, 0.0, -1.0);
      // An arc cosine near 1 loses half of a double's digits.
      EXPECT_NEAR(std::acos(glm::dot(hand.cuts.at(0).face.normal, planned)),
                  hand.cuts.at(0).angle_error_rad, 1.0e-6)
          << name << ' ' << seed;
      // Two planes are farthest apart at a corner of the section.
      double largest_mm = 0.0;
      for (const double x_mm : {0.0, 60.0}) {
        for (const double y_mm : {-10.0, 10.0}) {
          const double stand_off_mm =
              (hand.cuts.at(0).face.offset_mm -
               glm::dot(hand.cuts.at(0).face.normal, Vec3(x_mm, y_mm, -1.0))) /
              glm::dot(hand.cuts.at(0).face.normal, planned);
          largest_mm = std::max(largest_mm, std::abs(stand_off_mm));
        }
      }
      EXPECT_NEAR(largest_mm, hand.cuts.at(0).location_error_mm, 1.0e-9) << name << ' ' << seed;
    }
  }
}

TEST(ScriptedHand, DeclaresEachStepInOrderAndFinishesLast) {
  const Patient patient;
  const simulator::HandMotion motion = patient.hand(hand_skill("novice"), 3).motion;
  std::vector<CommandKind> kinds;
  std::vector<std::int32_t> done;
  for (const simulator::HandCommand& command : motion.commands) {
    kinds.push_back(command.command.kind);
    if (kinds.back() == CommandKind::StepDone) done.push_back(command.command.argument);
  }
  EXPECT_EQ(kinds, (std::vector{CommandKind::Start, CommandKind::StepDone, CommandKind::StepDone,
                                CommandKind::PickUp, CommandKind::StepDone, CommandKind::StepDone,
                                CommandKind::Finish}));
  EXPECT_EQ(done, (std::vector<std::int32_t>{0, 1, 2, 3}));
  const auto is_earlier = [](const auto& a, const auto& b) { return a.tick < b.tick; };
  EXPECT_TRUE(std::is_sorted(motion.keys.begin(), motion.keys.end(), is_earlier));
  EXPECT_TRUE(std::is_sorted(motion.commands.begin(), motion.commands.end(), is_earlier));
  EXPECT_GE(motion.commands.back().tick, motion.keys.back().tick);
}

TEST(ScriptedHand, WhosePlaneMissesTheBoneIsRefused) {
  Patient patient;
  HandSkill far = hand_skill("expert");
  far.location_mean_mm = 100.0;
  // Half of such hands aim beyond the bone's medial side, the others beyond its lateral side: all miss.
  EXPECT_EQ(refusal_of(patient, far, 5),
            "the hand's plane misses the bone for seed 5; choose another seed");
  patient.plan.cuts.at(0).face.offset_mm += 50.0;
  EXPECT_EQ(refusal_of(patient, hand_skill("expert"), 5),
            "the hand's plane misses the bone for seed 5; choose another seed");
}

TEST(ScriptedHand, RefusesASideItCannotComeFrom) {
  Patient patient;
  patient.silver.cuts.at(0).approach = "distal";
  EXPECT_EQ(refusal_of(patient, hand_skill("expert"), 1),
            "a hand cannot approach from \"distal\"; use dorsal, plantar, medial or lateral");
}

}  // namespace
}  // namespace hallux::scenarios
