#include "assessment/sentences.h"

#include <gtest/gtest.h>

#include "assessment/card_facts.h"
#include "assessment/ledger.h"

namespace hallux::assessment {
namespace {

using database::ScoreCard;
using scenarios::Scenario;

scenarios::RubricItem item(const std::string& id, const std::string& metric,
                           std::int64_t weight_milli, double full, double zero) {
  scenarios::RubricItem made;
  made.id = id;
  made.title = "Title of " + id;
  made.group = "accuracy";
  made.metric = metric;
  made.cut = "eminence";
  made.unit = metric.ends_with("_deg") ? "deg" : "mm";
  made.weight_milli = weight_milli;
  made.full = full;
  made.zero = zero;
  return made;
}

Scenario silver_like() {
  Scenario scenario;
  scenario.cuts.resize(1);
  scenario.cuts[0].name = "eminence";
  scenario.rubric.groups = {{"accuracy", "Accuracy", 50000, ""}};
  scenario.rubric.items = {
      item("A1", "angle_deg", 16000, 1.0, 8.0), item("A2", "location_mm", 16000, 0.5, 3.0),
      item("A3", "depth_mm", 10000, 0.5, 2.5), item("A4", "step_mm", 5000, 0.2, 1.5)};
  return scenario;
}

Measurement measured(const std::string& metric, double value, const std::string& direction) {
  Measurement made;
  made.metric = metric;
  made.cut = "eminence";
  made.value = value;
  made.direction = direction;
  return made;
}

ScoreCard explained(const Scenario& scenario, const std::vector<Measurement>& measurements) {
  ScoreCard card = score_rubric(scenario.rubric, measurements);
  add_facts(card, scenario, measurements);
  say(card);
  return card;
}

TEST(Sentences, SayTheNumberTheTargetAndTheLoss) {
  const ScoreCard card = explained(silver_like(), {measured("angle_deg", 4.2, "dorsal")});
  EXPECT_EQ(card.ledger[0].text,
            "The face is tilted 4.2°, deepest at its dorsal edge (full points to 1°): "
            "45.7 of 100 points lost.");
}

TEST(Sentences, SayWhatWasRight) {
  const ScoreCard card = explained(silver_like(), {measured("depth_mm", 0.3, "")});
  EXPECT_EQ(card.ledger[0].text,
            "At the depth landmark the face is 0.30 mm from the planned depth (full points to "
            "0.5 mm): all 100 points.");
}

TEST(Sentences, TheThreeGreatestLossesComeFirst) {
  const ScoreCard card = explained(
      silver_like(), {measured("angle_deg", 2.0, ""), measured("location_mm", 3.0, "lateral"),
                      measured("depth_mm", 1.0, ""), measured("step_mm", 1.5, "medial")});
  ASSERT_EQ(card.sentences.size(), 3U);
  EXPECT_EQ(card.sentences[0], card.ledger[1].text);
  EXPECT_EQ(card.sentences[1], card.ledger[3].text);
  EXPECT_EQ(card.sentences[2], card.ledger[2].text);
}

TEST(Sentences, SayWhyNothingCouldBeMeasured) {
  Measurement absent = measured("angle_deg", 0.0, "");
  absent.absence = Absence::NotMade;
  const ScoreCard card = explained(silver_like(), {absent});
  EXPECT_EQ(card.sentences.at(0), "The cut was not made: 100 points lost.");
  EXPECT_EQ(card.ledger.at(0).text,
            "Title of A1 could not be measured because the cut was not made: 100 of 100 points "
            "lost.");
  const ScoreCard empty = explained(silver_like(), {});
  EXPECT_EQ(empty.sentences.at(0), "Nothing of this attempt could be measured, so its score is 0.");
}

TEST(Sentences, SayThatACutIsUnfinished) {
  Measurement unfinished = measured("location_mm", 1.0, "");
  unfinished.done_fraction = 0.4;
  const ScoreCard card = explained(silver_like(), {unfinished});
  EXPECT_TRUE(card.ledger[0].text.starts_with(
      "Unfinished cut (40 % sawn, so 40 % of the points). The face lies up to 1.00 mm"));
}

TEST(Sentences, AGateSaysItsLimitItsCapAndWhatItTook) {
  Scenario scenario = silver_like();
  scenarios::Gate gate;
  gate.name = "past_sulcus";
  gate.title = "Past the sulcus";
  gate.metric = "past_landmark_mm";
  gate.cut = "eminence";
  gate.unit = "mm";
  gate.limit = 1.0;
  gate.cap_milli = 59000;
  scenario.rubric.gates = {gate};
  const ScoreCard card =
      explained(scenario, {measured("angle_deg", 0.0, ""), measured("past_landmark_mm", 1.4, "")});
  EXPECT_EQ(card.ledger[1].text,
            "Past the sulcus: 1.40 mm (limit 1 mm), so the score is capped at 59: 41 points "
            "lost.");
  EXPECT_EQ(card.gates[0].text,
            "Past the sulcus: 1.40 mm, above the limit of 1 mm; the score is capped at 59.");
}

/// Two cuts, a hinge between them, and a gate on a claim.
Scenario akin_like() {
  Scenario scenario = silver_like();
  scenario.cuts[0].title = "First cut";
  scenario.cuts.resize(2);
  scenario.cuts[1].name = "second";
  scenario.hinges.resize(1);
  scenario.hinges[0].name = "lateral";
  scenario.hinges[0].title = "Lateral hinge";
  scenario.rubric.items = {item("A1", "angle_deg", 16000, 1.0, 8.0),
                           item("A4", "wedge_error_deg", 12000, 0.5, 6.0)};
  scenario.rubric.items[1].cut.clear();
  scenario.rubric.items[1].hinge = "lateral";
  scenarios::Gate gate;
  gate.name = "hinge_lost";
  gate.title = "Lateral cortex cut through";
  gate.metric = "hinge_lost";
  gate.hinge = "lateral";
  gate.cap_milli = 69000;
  scenario.rubric.gates = {gate};
  return scenario;
}

Measurement of_hinge(const std::string& metric, double value) {
  Measurement made = measured(metric, value, "large");
  made.cut.clear();
  made.hinge = "lateral";
  return made;
}

TEST(Sentences, WithSeveralCutsEachLineSaysWhichItIsAbout) {
  Measurement wedge = of_hinge("wedge_error_deg", 5.4);
  wedge.detail = {DetailKind::WedgeTaken, {15.4, 10.0, 3.5, 2.25}, {}};
  const ScoreCard card = explained(akin_like(), {measured("angle_deg", 0.4, "dorsal"), wedge});
  EXPECT_EQ(card.ledger[0].text,
            "First cut: The face is tilted 0.4° (full points to 1°): all 57.1 points.");
  EXPECT_EQ(card.ledger[1].text,
            "Lateral hinge: The wedge is 5.4° off the planned angle, too large: 15.4° were "
            "taken out, the plan was 10.0°; the base is 3.50 mm wide, the plan was 2.25 mm "
            "(full points to 0.5°): 38.2 of 42.9 points lost.");
}

TEST(Sentences, AMetricOfACutIsNotOneOfAHingeOfTheSameName) {
  Scenario scenario = akin_like();
  scenario.cuts[0].name = scenario.rubric.items[0].cut = "lateral";
  Measurement of_cut = measured("wedge_error_deg", 9.0, "");
  of_cut.cut = "lateral";
  const ScoreCard card = explained(scenario, {of_cut});
  EXPECT_TRUE(card.ledger.empty());
}

TEST(Sentences, AllThatOneUnfinishedCutCostsIsOneSentence) {
  std::vector<Measurement> measurements{measured("angle_deg", 4.2, "dorsal"),
                                        measured("location_mm", 1.0, ""),
                                        measured("depth_mm", 0.3, "")};
  for (Measurement& each : measurements) each.done_fraction = 0.8;
  measurements.push_back(measured("step_mm", 0.9, ""));
  measurements.back().done_fraction = 0.8;
  const ScoreCard card = explained(silver_like(), measurements);
  ASSERT_EQ(card.sentences.size(), 1U);
  EXPECT_EQ(card.sentences[0],
            "Unfinished cut: 80 % was sawn, so what it is worth counts 80 %. With its other losses "
            "that is 42.5 points lost.");
  for (std::size_t line = 0; line < 4; ++line)
    EXPECT_TRUE(card.ledger[line].text.starts_with("Unfinished cut")) << card.ledger[line].text;
}

TEST(Sentences, WhatAHingeLosesIsLaidToTheLessFinishedOfItsCuts) {
  Scenario scenario = akin_like();
  scenario.hinges[0].first_cut = scenario.cuts[0].name;
  scenario.hinges[0].second_cut = "second";
  scenario.cuts[1].title = "Second cut";
  Measurement wedge = of_hinge("wedge_error_deg", 2.0);
  Measurement second = measured("angle_deg", 1.0, "");
  second.cut = "second";
  wedge.done_fraction = second.done_fraction = 0.5;
  const ScoreCard half = explained(scenario, {measured("angle_deg", 8.0, ""), second, wedge});
  ASSERT_EQ(half.sentences.size(), 2U);
  EXPECT_TRUE(half.sentences[0].starts_with("First cut: The face is tilted 8.0°"));
  EXPECT_TRUE(half.sentences[1].starts_with("Second cut: Unfinished cut: 50 % was sawn"));
  second.absence = wedge.absence = Absence::NotMade;
  const ScoreCard none = explained(scenario, {measured("angle_deg", 1.0, ""), second, wedge});
  EXPECT_EQ(none.sentences[0], "Second cut: The cut was not made: 42.9 points lost.");
}

TEST(Sentences, AGateOnAClaimHasNoNumber) {
  const Scenario scenario = akin_like();
  const Measurement angle = measured("angle_deg", 0.0, "");
  const ScoreCard lost = explained(scenario, {angle, of_hinge("hinge_lost", 1.0)});
  EXPECT_EQ(lost.ledger[1].text,
            "Lateral cortex cut through, so the score is capped at 69: 31 points lost.");
  EXPECT_EQ(lost.gates[0].text, "Lateral cortex cut through: yes; the score is capped at 69.");
  const ScoreCard kept = explained(scenario, {angle, of_hinge("hinge_lost", 0.0)});
  EXPECT_EQ(kept.gates[0].text, "Lateral cortex cut through: no.");
}

}  // namespace
}  // namespace hallux::assessment
