// Hands that saw through a block of soft bone: the push they keep, the plunge that follows from
// push and reaction, and what water and doubt change.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "simulator/record/sample_force.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/hands/scripted_attempt.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using scenarios::HandSkill;
using simulator::Recording;
using simulator::ToolSample;
using simulator::ToolStatus;

constexpr double far_side_mm = -10.0;

/// Silver without its frontal tilt on a block 10 x 20 x 20 mm: one stroke from y = 10 to y = -10,
/// 10 mm of teeth in bone.
struct Block {
  Block() : silver(scenarios_test::format_1("silver")) {
    silver.cuts.at(0).face.frontal_tilt_rad = 0.0;
    silver.joint_surfaces.clear();
    bone = cancellous_bone(moved(solid_block({10.0, 20.0, 20.0}), {{}, {5.0, 0.0, 0.0}}));
    bone.landmarks = {{"shaft_proximal", Vec3(2.0, 0.0, 0.0)},
                      {"shaft_distal", Vec3(8.0, 0.0, 0.0)},
                      {"med_sulcus", Vec3(5.0, 4.0, 0.0)},
                      {"shaft_medial", Vec3(5.0, 0.0, -10.0)}};
    plan = plan_on(silver, bone);
  }
  Recording operated(const HandSkill& skill, std::uint64_t seed) const {
    scenarios::FeelingHand hand(silver, bone, plan, skill, seed);
    return run_hand(silver, bone, plan, hand).recording;
  }
  Vec3 tip_in_bone_mm(const ToolSample& sample) const {
    const RigidTransform world_from_tool = simulator::transform_from(sample.world_from_tool);
    return transform_point(inverse(bone.world_from_bone), world_from_tool.translation_mm);
  }
  double push_newton(const ToolSample& sample) const {
    const Vec3 on_hand_newton = simulator::force_newton(sample);
    return transform_direction(inverse(bone.world_from_bone), on_hand_newton).y;
  }
  /// How far the teeth ran on beyond the far side.
  double plunge_mm(const HandSkill& skill, std::uint64_t seed) const {
    double lowest_mm = far_side_mm;
    for (const ToolSample& sample : operated(skill, seed).samples) {
      lowest_mm = std::min(lowest_mm, tip_in_bone_mm(sample).y);
    }
    return far_side_mm - lowest_mm;
  }

  scenarios::Scenario silver;
  simulator::Bone bone;
  scenarios::Plan plan;
};

/// The hand of that name, aiming exactly.
HandSkill aiming_exactly(const char* name) {
  HandSkill skill = scenarios::hand_skill(name);
  skill.angle_mean_deg = skill.angle_deviation_deg = 0.0;
  skill.location_mean_mm = skill.location_deviation_mm = 0.0;
  return skill;
}

/// An expert that sees well and pushes evenly until the blade is through.
HandSkill steady(double newton, double reaction_s) {
  HandSkill skill = aiming_exactly("expert");
  skill.push.steady_newton = skill.push.exit_newton = newton;
  skill.push.most_newton_per_mm = 20.0;
  skill.push.unevenness = 0.0;
  skill.perception.reaction_s = reaction_s;
  skill.perception.eye_mm = skill.perception.doubt_mm_per_s = 0.0;
  skill.cooling.burst_s = 60.0;
  return skill;
}

TEST(HandOnBlock, OfAnExpertKeepsThePushItMeans) {
  const Block block;
  const HandSkill skill = aiming_exactly("expert");
  // 10 mm of teeth are not given all that it would push.
  const double meant_newton = 10.0 * skill.push.most_newton_per_mm;
  std::vector<double> pushes;
  std::int64_t ticks_in_bone = 0;
  for (const ToolSample& sample : block.operated(skill, 1).samples) {
    ticks_in_bone = has(sample.status, ToolStatus::InContact) ? ticks_in_bone + 1 : 0;
    const bool is_before_exit =
        block.tip_in_bone_mm(sample).y > far_side_mm + skill.push.exit_mm + 1.0;
    if (ticks_in_bone > 2000 && is_before_exit) pushes.push_back(block.push_newton(sample));
  }
  ASSERT_GT(pushes.size(), 2000U);
  const auto near = std::count_if(pushes.begin(), pushes.end(), [&](double newton) {
    return std::abs(newton - meant_newton) <= 0.15 * meant_newton;
  });
  EXPECT_GT(static_cast<double>(near) / static_cast<double>(pushes.size()), 0.9);
}

TEST(HandOnBlock, PlungesByWhatTheSpringHoldsAndWhatItLeansOnUntilItReacts) {
  const Block block;
  for (const double newton : {6.0, 12.0}) {
    for (const double reaction_s : {0.1, 0.4}) {
      const HandSkill skill = steady(newton, reaction_s);
      const double plunge_mm = block.plunge_mm(skill, 1);
      // The spring of 2 N/mm lets go of its stretch. The handle leans on until the hand has
      // noticed, and is let back.
      const double leant_mm = skill.push.lean_mm_s * (reaction_s + 0.02);
      EXPECT_GT(plunge_mm, 0.8 * (newton / 2.0 + leant_mm)) << newton << ' ' << reaction_s;
      EXPECT_LT(plunge_mm, 1.1 * (newton / 2.0 + leant_mm)) << newton << ' ' << reaction_s;
    }
  }
}

TEST(HandOnBlock, WithoutErrorsRunsOnByNoMoreThanItsLastPushStretches) {
  const Block block;
  const HandSkill perfect = scenarios::hand_skill("perfect");
  const double plunge_mm = block.plunge_mm(perfect, 1);
  EXPECT_GE(plunge_mm, perfect.beyond_mm) << "it saws through";
  EXPECT_LT(plunge_mm, 0.5 * perfect.push.exit_newton + 0.3);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

TEST(HandOnBlock, OfANovicePlungesTwiceAsDeepAsAnExperts) {
  const Block block;
  std::vector<double> expert_mm, novice_mm;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    expert_mm.push_back(block.plunge_mm(aiming_exactly("expert"), seed));
    novice_mm.push_back(block.plunge_mm(aiming_exactly("novice"), seed));
  }
  std::printf("plunge on the block: expert %.1f mm, novice %.1f mm\n", median(expert_mm),
              median(novice_mm));
  EXPECT_GT(median(novice_mm), 2.0 * median(expert_mm));
}

/// Ticks in bone, deeper than its surface, with hardly a push.
std::int64_t hesitated_ticks(const Block& block, const Recording& recording) {
  return std::count_if(recording.samples.begin(), recording.samples.end(),
                       [&](const ToolSample& sample) {
                         const double tip_y_mm = block.tip_in_bone_mm(sample).y;
                         return has(sample.status, ToolStatus::InContact) && tip_y_mm < 8.0 &&
                                tip_y_mm > far_side_mm && block.push_newton(sample) < 4.0;
                       });
}

TEST(HandOnBlock, InDoubtHowDeepItIsHesitatesInTheBone) {
  const Block block;
  HandSkill skill = aiming_exactly("novice");
  skill.push.unevenness = 0.0;
  const std::int64_t in_doubt = hesitated_ticks(block, block.operated(skill, 2));
  skill.perception.doubt_mm_per_s = 0.0;
  const std::int64_t sure = hesitated_ticks(block, block.operated(skill, 2));
  EXPECT_GT(in_doubt, sure + 300);
}

std::size_t hot_patches(const Recording& recording) {
  return static_cast<std::size_t>(std::count_if(
      recording.events.begin(), recording.events.end(),
      [](const auto& event) { return event.kind == simulator::CutEventKind::BoneHot; }));
}

TEST(HandOnBlock, KeepsTheBoneCoolWithWaterAndHeatsItWithout) {
  const Block block;
  HandSkill skill = aiming_exactly("expert");
  EXPECT_EQ(hot_patches(block.operated(skill, 3)), 0U);
  skill.cooling.forgets_water = 1.0;
  skill.cooling.notices_dry_s = 1000.0;
  EXPECT_GT(hot_patches(block.operated(skill, 3)), 0U);
}

TEST(HandOnBlock, ThatNoticesHowDryItSawsLetsTheWaterRunFromThenOn) {
  const Block block;
  HandSkill skill = aiming_exactly("expert");
  skill.cooling.forgets_water = 1.0;
  skill.cooling.notices_dry_s = 0.5;
  std::int64_t dry = 0, rinsed = 0;
  for (const ToolSample& sample : block.operated(skill, 3).samples) {
    if (!has(sample.status, ToolStatus::InContact)) continue;
    (has(sample.status, ToolStatus::Irrigated) ? rinsed : dry) += 1;
    EXPECT_TRUE(rinsed == 0 || has(sample.status, ToolStatus::Irrigated)) << sample.tick;
  }
  EXPECT_GT(dry, 0);
  EXPECT_GT(rinsed, dry);
}

TEST(HandOnBlock, DrawsTheBladeBackToClearItWithinTheBone) {
  const Block block;
  HandSkill skill = aiming_exactly("expert");
  skill.cooling.burst_s = 2.0;
  int withdrawals = 0;
  double highest_mm = -100.0, deepest_mm = 100.0;
  for (const ToolSample& sample : block.operated(skill, 4).samples) {
    if (sample.kerf < 0) continue;
    const double tip_y_mm = block.tip_in_bone_mm(sample).y;
    if (tip_y_mm < far_side_mm) break;
    if (tip_y_mm < deepest_mm) {
      if (highest_mm > deepest_mm + 1.0) ++withdrawals;
      deepest_mm = highest_mm = tip_y_mm;
    }
    highest_mm = std::max(highest_mm, tip_y_mm);
    EXPECT_LT(tip_y_mm, 10.0);
  }
  EXPECT_GE(withdrawals, 2);
}

}  // namespace
}  // namespace hallux::tests
