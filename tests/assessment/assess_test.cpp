#include "assessment/assess.h"

#include <gtest/gtest.h>

#include "assessment/ledger.h"
#include "simulator/base/units.h"
#include "tests/assessment/block_attempt.h"

namespace hallux::assessment {
namespace {

using database::ScoreCard;
using simulator::Recording;
using testing::Stroke;

/// Poses are recorded to 1 um and quaternions to 1e-6, which over 35 mm of blade is 0.07 mm at
/// worst.
constexpr double pose_mm = 0.001;
constexpr double pose_deg = 2e-4;

Examination examination_of(const std::vector<Stroke>& strokes) {
  const simulator::Bone bone = testing::block_bone();
  Recording recording;
  for (const Stroke& stroke : strokes) add_stroke(recording, bone, stroke);
  return assess_fully(testing::block_scenario(), bone, recording, "scripted");
}

double value_of(const Examination& examination, const char* metric) {
  return find_measurement(examination.measurements, metric, "eminence")->value;
}

TEST(Assess, TheExactCutEarnsEveryPoint) {
  const ScoreCard card = examination_of({Stroke{}}).card;
  EXPECT_EQ(card.score_milli, 100000);
  EXPECT_EQ(card.measured_milli, 50000);
  EXPECT_EQ(card.rubric_milli, 100000);
  EXPECT_TRUE(card.sentences.empty());
  EXPECT_EQ(card.scenario, "block");
}

TEST(Assess, NoCutLosesEverythingAndSaysSo) {
  const ScoreCard card = examination_of({}).card;
  EXPECT_EQ(card.score_milli, 0);
  EXPECT_EQ(card.measured_milli, 50000);
  EXPECT_NE(card.sentences.at(0).find("cut was not made"), std::string::npos);
}

TEST(Assess, ACutTooFarMedialIsALedge) {
  const Examination examination = examination_of({Stroke{.face_z_mm = -9.0}});
  EXPECT_NEAR(value_of(examination, "location_mm"), 1.0, pose_mm);
  EXPECT_NEAR(value_of(examination, "depth_mm"), 1.0, pose_mm);
  EXPECT_NEAR(value_of(examination, "step_mm"), 1.0, pose_mm);
  EXPECT_EQ(value_of(examination, "past_landmark_mm"), 0.0);
  EXPECT_EQ(value_of(examination, "notch_mm"), 0.0);
  EXPECT_EQ(find_measurement(examination.measurements, "depth_mm", "eminence")->direction,
            "medial");
}

TEST(Assess, ACutPastTheSulcusIsCapped) {
  const Examination examination = examination_of({Stroke{.face_z_mm = -5.5}});
  EXPECT_NEAR(value_of(examination, "past_landmark_mm"), 1.5, pose_mm);
  EXPECT_NEAR(value_of(examination, "notch_mm"), 2.5, pose_mm);
  EXPECT_TRUE(examination.card.gates.at(0).is_triggered);
  EXPECT_TRUE(examination.card.gates.at(1).is_triggered);
  EXPECT_LE(examination.card.score_milli, 59000);
}

TEST(Assess, ATiltIsMeasuredWithItsDirection) {
  const Examination examination = examination_of({Stroke{.tilt_rad = radian_from_degree(4.0)}});
  EXPECT_NEAR(value_of(examination, "angle_deg"), 4.0, pose_deg);
  // Deepest distally: there the face lies 30 mm x tan 4 degrees further lateral than in the middle.
  EXPECT_EQ(find_measurement(examination.measurements, "angle_deg", "eminence")->direction,
            "distal");
  EXPECT_NE(examination.card.ledger.at(0).text.find("deepest at its distal edge"),
            std::string::npos);
}

TEST(Assess, AScratchInTheRightPlaneEarnsAlmostNothing) {
  const ScoreCard card = examination_of({Stroke{.last_y_mm = 9.0}}).card;
  EXPECT_LT(card.score_milli, 10000);
  EXPECT_NE(card.sentences.at(0).find("Unfinished cut"), std::string::npos);
}

TEST(Assess, APlaneFrozenWithoutACutMeasuresNothing) {
  const ScoreCard card = examination_of({Stroke{.last_y_mm = 9.8}}).card;
  EXPECT_EQ(card.score_milli, 0);
  EXPECT_FALSE(card.ledger.at(0).is_measured);
}

TEST(Assess, AnUnfinishedCutBeyondTheSulcusCountsOnlyWhereItWas) {
  const Examination scratch =
      examination_of({Stroke{}, Stroke{.face_z_mm = -5.5, .last_y_mm = 8.0}});
  EXPECT_NEAR(value_of(scratch, "past_landmark_mm"), 1.5, pose_mm);
  EXPECT_EQ(value_of(scratch, "notch_mm"), 0.0);
  EXPECT_NEAR(value_of(scratch, "location_mm"), 0.0, pose_mm);
}

TEST(Assess, MomentsAreThoseOfFreezingAndOfCutting) {
  const Examination examination = examination_of({Stroke{}});
  const auto& ledger = examination.card.ledger;
  EXPECT_EQ(ledger.at(0).start_us, 10000);
  EXPECT_EQ(ledger.at(0).end_us, 11000);
  EXPECT_EQ(ledger.at(1).start_us, 10000);
  // 20.7 mm at 0.05 mm a tick.
  EXPECT_NEAR(static_cast<double>(ledger.at(1).end_us), 10000.0 + 414000.0, 1000.0);
}

TEST(Assess, TheSameRecordingGivesTheSameCard) {
  const ScoreCard first = examination_of({Stroke{.tilt_rad = 0.05}}).card;
  const ScoreCard second = examination_of({Stroke{.tilt_rad = 0.05}}).card;
  ASSERT_EQ(first.ledger.size(), second.ledger.size());
  for (std::size_t line = 0; line < first.ledger.size(); ++line) {
    EXPECT_EQ(first.ledger[line].value, second.ledger[line].value);
    EXPECT_EQ(first.ledger[line].points_lost_milli, second.ledger[line].points_lost_milli);
  }
  EXPECT_EQ(first.shown_losses_milli, second.shown_losses_milli);
}

/// The exact cut of 414 ticks from tick 10 on, with these events of its step.
ScoreCard card_with(const std::vector<std::pair<std::int64_t, simulator::CutEventKind>>& said) {
  const simulator::Bone bone = testing::block_bone();
  Recording recording;
  add_stroke(recording, bone, Stroke{.face_z_mm = -9.0});
  for (const auto& [tick, kind] : said) {
    simulator::CutEvent event;
    event.tick = tick;
    event.kind = kind;
    event.subject = 0;
    recording.events.push_back(event);
  }
  return assess_fully(testing::block_scenario(), bone, recording, "scripted").card;
}

constexpr const char* after_done = "sawn after Done; it counts as well";

// The rule of docs/metrics.md, Deeds: whenever Done was said, the bone is measured as it was left.
TEST(Assess, WhatIsSawnAfterDoneCountsAsWhatWasSawnBefore) {
  using simulator::CutEventKind;
  const ScoreCard before = card_with({{900, CutEventKind::StepDone}});
  const ScoreCard after = card_with({{200, CutEventKind::StepDone}});
  const ScoreCard again =
      card_with({{200, CutEventKind::StepDone}, {220, CutEventKind::StepReopened}});
  for (const ScoreCard* card : {&after, &again}) {
    EXPECT_EQ(card->score_milli, before.score_milli);
    ASSERT_EQ(card->ledger.size(), before.ledger.size());
    for (std::size_t line = 0; line < before.ledger.size(); ++line) {
      EXPECT_EQ(card->ledger[line].value, before.ledger[line].value);
      EXPECT_EQ(card->ledger[line].points_lost_milli, before.ledger[line].points_lost_milli);
    }
  }
}

TEST(Assess, TheLedgerTellsOnceThatSomeWasSawnAfterDone) {
  using simulator::CutEventKind;
  const auto told = [](const ScoreCard& card) {
    std::size_t count = 0;
    for (const database::LedgerLine& line : card.ledger)
      count += line.text.find(after_done) == std::string::npos ? 0U : 1U;
    return count;
  };
  EXPECT_EQ(told(card_with({{200, CutEventKind::StepDone}})), 1U);
  EXPECT_EQ(told(card_with({{900, CutEventKind::StepDone}})), 0U);
  EXPECT_EQ(told(card_with({})), 0U);
  EXPECT_EQ(told(card_with({{5, CutEventKind::StepDone}, {8, CutEventKind::StepReopened}})), 0U)
      << "a step that was taken up again is not done";
  EXPECT_EQ(told(card_with({{5, CutEventKind::StepDone},
                            {8, CutEventKind::StepReopened},
                            {200, CutEventKind::StepDone}})),
            1U);
}

}  // namespace
}  // namespace hallux::assessment
