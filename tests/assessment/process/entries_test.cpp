#include "assessment/process/entries.h"

#include <gtest/gtest.h>

#include "tests/assessment/examined_attempt.h"

namespace hallux::assessment {
namespace {

using testing::examined;
using testing::ExaminedAttempt;
using testing::Stroke;

/// The blade goes so far away from where it last was, out of any kerf, and comes back into `kerf`.
void draw_back(simulator::Recording& recording, double away_mm, std::int32_t kerf = 0) {
  const simulator::ToolSample inside = recording.samples.back();
  simulator::ToolSample sample = inside;
  for (const double share : {0.5, 1.0, 0.5}) {
    ++sample.tick;
    sample.kerf = -1;
    sample.world_from_tool = inside.world_from_tool;
    sample.world_from_tool.translation_um[2] += um_from_mm(share * away_mm);
    recording.samples.push_back(sample);
  }
  ++sample.tick;
  sample.world_from_tool = inside.world_from_tool;
  sample.kerf = kerf;
  recording.samples.push_back(sample);
}

double restarts_of(const ExaminedAttempt& made) { return measure_restarts(made.evidence()).value; }

TEST(Entries, DrawingBackToClearTheKerfIsNone) {
  ExaminedAttempt made = examined(testing::block_scenario(), {Stroke{}});
  EXPECT_EQ(restarts_of(made), 0.0);
  draw_back(made.recording, 2.9);
  draw_back(made.recording, 2.9);
  EXPECT_EQ(restarts_of(made), 0.0);
}

TEST(Entries, ComingBackFromFurtherAwayIsOne) {
  ExaminedAttempt made = examined(testing::block_scenario(), {Stroke{}});
  draw_back(made.recording, 3.1);
  EXPECT_EQ(restarts_of(made), 1.0);
  EXPECT_EQ(measure_restarts(made.evidence()).last_tick, made.recording.samples.back().tick);
  draw_back(made.recording, 2.9);
  draw_back(made.recording, 30.0);
  EXPECT_EQ(restarts_of(made), 2.0);
}

TEST(Entries, DeepInsideTheKerfTheBladeMayGoWhereItLikes) {
  ExaminedAttempt made = examined(testing::block_scenario(), {Stroke{}});
  simulator::ToolSample sample = made.recording.samples.back();
  for (int step = 0; step < 20; ++step) {
    ++sample.tick;
    sample.world_from_tool.translation_um[0] += 1000;
    made.recording.samples.push_back(sample);
  }
  EXPECT_EQ(restarts_of(made), 0.0);
}

TEST(Entries, AnotherKerfOfTheCutIsOne) {
  EXPECT_EQ(restarts_of(examined(testing::block_scenario(), {Stroke{.face_z_mm = -9.5}, Stroke{}})),
            1.0);
  ExaminedAttempt made = examined(testing::block_scenario(), {Stroke{.face_z_mm = -9.5}, Stroke{}});
  // Back into the first without going anywhere.
  draw_back(made.recording, 0.0, 0);
  EXPECT_EQ(restarts_of(made), 2.0);
}

TEST(Entries, ASectionNeedsThePassesThatThePlanLaysOverIt) {
  scenarios::Scenario scenario = testing::block_scenario();
  for (const auto& [width_mm, needed] :
       {std::pair{62.5, 1}, std::pair{61.5, 2}, std::pair{32.0, 2}, std::pair{31.0, 3}}) {
    scenario.saw.blade.width_mm = width_mm;
    ExaminedAttempt made = examined(scenario, {Stroke{}});
    for (int entry = 1; entry < needed; ++entry) draw_back(made.recording, 20.0);
    EXPECT_EQ(restarts_of(made), 0.0) << width_mm;
    draw_back(made.recording, 20.0);
    EXPECT_EQ(restarts_of(made), 1.0) << width_mm;
  }
}

TEST(Entries, OfNoCutThereAreNone) {
  EXPECT_EQ(restarts_of(examined(testing::block_scenario(), std::vector<testing::Stroke>{})), 0.0);
}

}  // namespace
}  // namespace hallux::assessment
