#include "simulator/jobs/recorded_jobs.h"

#include <gtest/gtest.h>

#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::SimulationRun;

constexpr double above_mm = 3.0;

Bone block() { return tests::cancellous_bone(tests::solid_block({20.0, 4.0, 6.0})); }

/// One stroke at x through the whole block, and the blade withdrawn.
void saw_off(SimulationRun& run, double x_mm) {
  run.glide(blade_down({x_mm, above_mm + 2.0, 0.0}), 50);
  run.glide(blade_down({x_mm, -8.0, 0.0}), 200);
  run.hold(900);
  run.glide(blade_down({x_mm, above_mm + 2.0, 0.0}), 50);
}

/// The jobs of the recording, each held against what the step asked for.
void expect_known(const SimulationRun& run) {
  const std::vector<RecordedJob> jobs = recorded_jobs(run.recording(), 1);
  ASSERT_EQ(jobs.size(), run.requests().size());
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    EXPECT_EQ(jobs[i].request.id, run.requests()[i].id);
    EXPECT_EQ(jobs[i].request.kind, run.requests()[i].kind) << i;
    EXPECT_EQ(jobs[i].request.tick, run.requests()[i].tick) << i;
    EXPECT_GT(jobs[i].applied_tick, jobs[i].request.tick);
  }
}

TEST(RecordedJobs, AreThoseThatTheStepAskedFor) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  saw_off(run, 5.0);
  saw_off(run, -5.0);
  run.step({{CommandKind::CloseHinge, 0, 0}});
  run.hold(3);
  expect_known(run);
  EXPECT_EQ(recorded_jobs(run.recording(), 1).back().request.kind, JobKind::Hinge);
}

TEST(RecordedJobs, AreKnownWhereSeveralAreAppliedAtOnce) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  run.applies_jobs = false;
  saw_off(run, 5.0);
  run.applies_jobs = true;
  run.hold(5);
  expect_known(run);
}

TEST(RecordedJobs, AreNoneWithoutATape) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  saw_off(run, 5.0);
  Recording recording = run.recording();
  recording.tape.clear();
  EXPECT_TRUE(recorded_jobs(recording, 1).empty());
}

}  // namespace
}  // namespace hallux::simulator
