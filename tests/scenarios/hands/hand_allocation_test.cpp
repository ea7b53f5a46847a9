// On the haptic thread a hand takes no memory.
#include <gtest/gtest.h>

#include "scenarios/hands/feeling_hand.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/worlds.h"

namespace hallux::scenarios {
namespace {

TEST(FeelingHand, TakesNoMemoryInAHundredThousandTicks) {
  Scenario silver = scenarios_test::format_1("silver");
  silver.cuts.at(0).face.frontal_tilt_rad = 0.0;
  silver.joint_surfaces.clear();
  simulator::Bone bone;
  bone.outer = tests::moved(tests::solid_block({30.0, 20.0, 20.0}), {{}, {15.0, 0.0, 0.0}});
  bone.landmarks = {{"shaft_proximal", Vec3(10.0, 0.0, 0.0)},
                    {"shaft_distal", Vec3(20.0, 0.0, 0.0)},
                    {"med_sulcus", Vec3(26.0, 4.0, 0.0)},
                    {"shaft_medial", Vec3(15.0, 0.0, -10.0)}};
  FeelingHand hand(silver, bone, plan_on(silver, bone), hand_skill("novice"), 1);
  // A world that is a spring from the bone's surface downwards.
  simulator::StepOutput output;
  simulator::RawDeviceState state;
  simulator::Command command;
  int commands = 0, ticks_sawn = 0;
  Vec3 force_newton(0.0, 0.0, 0.0);
  const std::uint64_t before = tests::allocations_of_this_thread();
  for (std::int64_t tick = 0; tick < 100000; ++tick) {
    hand.exchange(force_newton, tick, state);
    while (hand.take_command(command)) ++commands;
    if (has(state.switches, simulator::Switch::SawRuns)) ++ticks_sawn;
    force_newton.y = 2.0 * std::max(0.0, 10.0 - state.world_from_handle.translation_mm.y);
    output.sample.world_from_tool = simulator::quantise(state.world_from_handle);
    hand.observe(output);
  }
  EXPECT_EQ(tests::allocations_of_this_thread() - before, 0U);
  EXPECT_GE(commands, 2);
  EXPECT_GT(ticks_sawn, 50000) << "it pushed against the spring";
}

}  // namespace
}  // namespace hallux::scenarios
