#include "ui/jobs/made_attempt.h"

#include <gtest/gtest.h>

#include "simulator/base/progress.h"

namespace hallux::ui {
namespace {

/// On a coarse bone, which is quick to build.
ScriptedAttempt expert_at(const char* name) {
  ScriptedAttempt attempt;
  attempt.scenario = scenarios::load_shipped_scenario(name);
  attempt.scenario.patient.edge_mm = 1.2;
  return attempt;
}

const StageProgress quiet = [](const std::string&) { return Progress(); };

TEST(MadeAttempt, TheExpertHandIsRecordedFromStartToFinishAndScored) {
  const MadeAttempt made = make_attempt(expert_at("silver"), quiet);
  const simulator::Recording& recording = made.material.recording;
  ASSERT_FALSE(recording.samples.empty());
  EXPECT_EQ(recording.samples.size(), recording.tape.size()) << "none is lost";
  EXPECT_EQ(recording.events.front().kind, simulator::CutEventKind::Started);
  EXPECT_EQ(recording.events.back().kind, simulator::CutEventKind::Finished);
  EXPECT_GT(made.card.score_milli, 39000) << "the eminence came out";
  EXPECT_EQ(made.card.scenario, "silver");
  EXPECT_EQ(made.material.header.begun.hand, "expert");
  EXPECT_FALSE(made.material.header.begun.person.has_value());
}

TEST(MadeAttempt, StopsWhereItsProgressSaysSo) {
  int said = 0;
  const StageProgress stopping = [&](const std::string& stage) {
    return stage == "Operating" ? Progress([&](double) { return ++said < 3; }) : Progress();
  };
  EXPECT_THROW(make_attempt(expert_at("silver"), stopping), Cancelled);
  EXPECT_EQ(said, 3);
}

}  // namespace
}  // namespace hallux::ui
