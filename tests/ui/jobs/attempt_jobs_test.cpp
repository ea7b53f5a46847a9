/// What is measured of an attempt whose tape stays as it is stored, beside the same with its lines.
#include "ui/jobs/attempt_jobs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/database/some_database.h"

namespace hallux::ui {
namespace {

using assessment::Measurement;

const StageProgress untold = [](const std::string&) { return Progress(); };

/// A novice's, on a bone that is built and sawn in a moment.
ScriptedAttempt novice() {
  ScriptedAttempt attempt;
  attempt.scenario = scenarios::load_shipped_scenario("akin");
  attempt.scenario.patient.edge_mm = 1.5;
  attempt.hand = "novice";
  attempt.seed = 3;
  return attempt;
}

void expect_same(const Measurement& made, const Measurement& expected) {
  EXPECT_EQ(made.metric, expected.metric);
  EXPECT_EQ(made.cut + made.hinge + made.zone, expected.cut + expected.hinge + expected.zone);
  EXPECT_EQ(made.absence, expected.absence);
  EXPECT_EQ(made.value, expected.value);
  EXPECT_EQ(made.bound, expected.bound);
  EXPECT_EQ(made.start_us, expected.start_us);
  EXPECT_EQ(made.end_us, expected.end_us);
  EXPECT_EQ(made.place_in_bone_mm, expected.place_in_bone_mm);
}

TEST(AttemptJobs, AnAttemptMeasuresTheSameWithItsTapeAsItIsStored) {
  const database::TemporaryDirectory temporary;
  database::Database database = database::Database::open(temporary.data());
  const database::AttemptId id = run_scripted_attempt(database, novice(), untold).attempt;
  database::HouseDesk desk(database);
  const AttemptMaterial whole = load_attempt(database, desk, id);
  const AttemptMaterial packed = load_to_score(database, desk, id);
  EXPECT_TRUE(packed.recording.tape.empty());
  EXPECT_EQ(packed.recorded().tape.count(), whole.recording.tape.size());

  const std::vector<Measurement> expected = score_attempt(whole, untold).measurements;
  const std::vector<Measurement> made = score_attempt(packed, untold).measurements;
  ASSERT_EQ(made.size(), expected.size());
  for (std::size_t i = 0; i < made.size(); ++i) {
    SCOPED_TRACE(expected[i].metric);
    expect_same(made[i], expected[i]);
  }
  for (const char* of_tape : {"sparc", "ldlj", "path_ratio", "piece_out"}) {
    const auto found = std::ranges::find(made, of_tape, &Measurement::metric);
    ASSERT_NE(found, made.end());
    EXPECT_NE(found->value, 0.0) << "a tape that tells nothing of " << of_tape << " proves nothing";
  }
}

}  // namespace
}  // namespace hallux::ui
