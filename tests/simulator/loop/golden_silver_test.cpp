/// The shipped Silver operation by the scripted expert, seed 1: patient, plan, hand, step and jobs together.
#include <gtest/gtest.h>

#include "scenarios/hands/feeling_hand.h"
#include "scenarios/simulation_setup.h"
#include "simulator/loop/replay.h"
#include "tests/simulator/loop/golden.h"
#include "tests/simulator/loop/recorded_run.h"

namespace hallux::simulator {
namespace {

TEST(Golden, TheExpertsFirstSilverGivesTheCommittedHashesAndReplaysIdentical) {
  const scenarios::Scenario scenario = scenarios::load_shipped_scenario("silver");
  const Bone bone = scenarios::make_patient(scenario);
  const scenarios::Plan plan = plan_on(scenario, bone);
  scenarios::FeelingHand hand(scenario, bone, plan, scenarios::hand_skill("expert"), 1);
  const SimulationSetup simulation = simulation_setup(scenario, bone, plan, Guidance::None);
  const AttemptSetup setup{.simulation = simulation,
                           .commands = {},
                           .last_tick = scenarios::FeelingHand::last_tick,
                           .job_delay = {},
                           .attempt_operator = &hand};
  const Recording recording = tests::record(setup, hand).recording;
  tests::expect_golden(bone, recording, tests::golden_silver_expert_1);
  const ReplayResult result = replay(recording, simulation);
  EXPECT_TRUE(result.is_identical) << result.difference;
}

}  // namespace
}  // namespace hallux::simulator
