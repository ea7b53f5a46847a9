#include "simulator/loop/lent_results.h"

#include <gtest/gtest.h>

#include <memory>

#include "simulator/loop/jobs.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;

std::unique_ptr<JobResult> with_piece() {
  auto result = std::make_unique<JobResult>();
  FoundPiece piece;
  piece.id = 1;
  piece.body = std::make_unique<const Bvh>(tests::solid_block({1.0, 1.0, 1.0}));
  result->pieces.push_back(std::move(piece));
  return result;
}

TEST(LentResults, KeepsAResultUntilItComesBack) {
  LentResults results;
  JobResult* const first = results.lend(with_piece());
  JobResult* const second = results.lend(with_piece());
  EXPECT_EQ(results.count(), 2U);
  results.take_back(first);
  EXPECT_EQ(results.count(), 1U);
  results.take_back(second);
  EXPECT_EQ(results.count(), 0U);
}

TEST(LentResults, KeepsTheBodyOfAPieceThatWasTakenOut) {
  LentResults results;
  JobResult* const result = results.lend(with_piece());
  const Bvh* const body = result->pieces[0].body.get();
  result->pieces[0].is_taken_out = true;
  results.take_back(result);
  EXPECT_EQ(results.count(), 0U);
  EXPECT_TRUE(body->contains({0.0, 0.0, 0.0}));
}

TEST(LentResultsDeathTest, AResultComesBackOnce) {
  LentResults results;
  JobResult* const result = results.lend(with_piece());
  results.take_back(result);
  EXPECT_DEATH(results.take_back(result), "found != lent_.end");
}

/// In and out of one kerf, a little deeper each time.
void saw_in_strokes(tests::SimulationRun& run, double x_mm, int strokes, double deepest_y_mm) {
  for (int stroke = 1; stroke <= strokes; ++stroke) {
    const double deep_mm = 2.0 + (deepest_y_mm - 2.0) * stroke / strokes;
    run.glide(blade_down({x_mm, 3.0, 0.0}), 50);
    run.glide(blade_down({x_mm, deep_mm, 0.0}), 300);
    run.glide(blade_down({x_mm, 4.0, 0.0}), 100);
  }
}

TEST(JobResultsOfAnAttempt, AreLetGoHoweverOftenTheBladeIsWithdrawn) {
  const Bone bone = tests::cancellous_bone(tests::solid_block({20.0, 4.0, 6.0}));
  tests::SimulationRun run(bone, blade_down({5.0, 4.0, 0.0}));
  saw_in_strokes(run, 5.0, 30, -4.0);
  ASSERT_GE(run.requests().size(), 10U);
  EXPECT_LE(run.jobs().kept_count(), 1U) << "the pieces as they are known now";
}

TEST(JobResultsOfAnAttempt, ATakenPieceIsAirAfterItsResultWasLetGo) {
  const Bone bone = tests::cancellous_bone(tests::solid_block({20.0, 4.0, 6.0}));
  tests::SimulationRun run(bone, blade_down({5.0, 4.0, 0.0}));
  run.glide(blade_down({5.0, -8.0, 0.0}), 1000);
  run.hold(1000);
  run.glide(blade_down({5.0, 4.0, 0.0}), 200);
  run.hold(10);
  ASSERT_EQ(run.events(CutEventKind::PieceFreed).size(), 1U);
  run.step({{CommandKind::PickUp, piece_freed_last, 0}});
  ASSERT_EQ(run.events(CutEventKind::PieceRemoved).size(), 1U);
  saw_in_strokes(run, -5.0, 6, 0.0);
  EXPECT_LE(run.jobs().kept_count(), 1U);
  run.switches = 0;
  run.glide(blade_down({8.0, 6.0, 0.0}), 50);
  run.glide(blade_down({8.0, -4.0, 0.0}), 100);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.y, -4.0, 0.01) << "nothing is in the way";
}

}  // namespace
}  // namespace hallux::simulator
