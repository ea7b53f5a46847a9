// A replay that ought to differ says so, and where: an altered input, an altered output, another
// constant of the step.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/simulation_setup.h"
#include "simulator/loop/replay.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::tests {
namespace {

using simulator::Recording;
using simulator::ToolSample;
using simulator::ToolStatus;

class ReplayDifference : public testing::Test {
 protected:
  // The shape is the same at any edge length; a coarse one replays as long an attempt.
  ReplayDifference() : silver_(scenarios_test::format_1("silver")) {
    silver_.patient.edge_mm = 1.0;
    bone_ = make_patient_bones(silver_).front();
    recording_ = run_hand(silver_, bone_, "expert", 1).recording;
  }

  simulator::SimulationSetup setup() const {
    return simulation_setup(silver_, bone_, plan_on(silver_, bone_), simulator::Guidance::None);
  }
  /// The first tick of which the tool has this status.
  std::int64_t first_tick(ToolStatus status) const {
    const auto found =
        std::find_if(recording_.samples.begin(), recording_.samples.end(),
                     [&](const ToolSample& sample) { return has(sample.status, status); });
    return found == recording_.samples.end() ? -1 : found->tick;
  }

  scenarios::Scenario silver_;
  simulator::Bone bone_;
  Recording recording_;
};

TEST_F(ReplayDifference, IsNoneWhereNothingWasChanged) {
  const simulator::ReplayResult result = replay(recording_, setup());
  EXPECT_TRUE(result.is_identical) << result.difference;
  EXPECT_EQ(result.first_difference_tick, -1);
  EXPECT_EQ(result.samples, static_cast<std::int64_t>(recording_.samples.size()));
  EXPECT_EQ(result.outputs, digest_outputs(recording_));
}

TEST_F(ReplayDifference, OfOneInputInAirIsFoundAtItsOwnTick) {
  // In air the tool is where the handle is: a tenth of a millimetre shows at once.
  const std::int64_t tick = first_tick(ToolStatus::Running) + 100;
  recording_.tape.at(static_cast<std::size_t>(tick)).device.world_from_handle.translation_um[0] +=
      100;
  const simulator::ReplayResult result = replay(recording_, setup());
  EXPECT_FALSE(result.is_identical);
  EXPECT_EQ(result.first_difference_tick, tick) << result.difference;
}

TEST_F(ReplayDifference, OfTheSmallestInputWhileCuttingIsFound) {
  const std::int64_t tick = first_tick(ToolStatus::Cutting) + 1000;
  // One unit along each axis: whichever way the spring pulls, it pulls otherwise by half a
  // millinewton or more.
  for (std::int32_t& part :
       recording_.tape.at(static_cast<std::size_t>(tick)).device.world_from_handle.translation_um) {
    part += 1;
  }
  const simulator::ReplayResult result = replay(recording_, setup());
  EXPECT_FALSE(result.is_identical);
  EXPECT_GE(result.first_difference_tick, tick);
}

TEST_F(ReplayDifference, OfAnAlteredOutputIsFoundAtItsOwnTick) {
  recording_.samples.back().force_mn[1] += 1;
  const simulator::ReplayResult result = replay(recording_, setup());
  EXPECT_FALSE(result.is_identical);
  EXPECT_EQ(result.first_difference_tick, recording_.samples.back().tick);
}

TEST_F(ReplayDifference, OfOneConstantBeginsWhereItFirstMatters) {
  // The handle's spring does nothing until bone holds the tool back.
  simulator::SimulationSetup altered = setup();
  altered.contact.coupling_newton_per_mm *= 1.001;
  const simulator::ReplayResult result = replay(recording_, altered);
  EXPECT_FALSE(result.is_identical);
  EXPECT_GE(result.first_difference_tick, first_tick(ToolStatus::InContact));
  EXPECT_LT(result.first_difference_tick, recording_.samples.back().tick);
}

TEST_F(ReplayDifference, OfTheSawsRateBeginsWithTheCut) {
  simulator::SimulationSetup altered = setup();
  simulator::Saw saw = altered.tray.first_saw();
  saw.cycles_per_minute += 1.0;
  altered.tray = saw;
  const simulator::ReplayResult result = replay(recording_, altered);
  EXPECT_FALSE(result.is_identical);
  EXPECT_GE(result.first_difference_tick, first_tick(ToolStatus::InContact));
}

}  // namespace
}  // namespace hallux::tests
