#include "database/course/score_json.h"

#include <gtest/gtest.h>

#include <limits>

#include "database/store/database_error.h"

namespace hallux::database {

namespace {

ScoreCard some_card() {
  ScoreCard card;
  card.score_milli = 87'654;
  card.earned_milli = 43'827;
  card.measured_milli = 50'000;
  card.rubric_milli = 100'000;
  card.groups = {{"accuracy", 50'000, 50'000, 43'827}, {"safety", 22'000, 0, 0}};
  card.gates = {{"sulcus", 59'000, true, 1.25, 1.0, "mm", "The cut went 1.25 mm too far."}};
  LedgerLine line;
  line.kind = LedgerKind::Damping;
  line.item = "A1";
  line.metric = "angle_deg";
  line.value = 3.141593;
  line.target = 1.0;
  line.points_lost_milli = 6173;
  line.end_us = 9'000'000;
  line.place_in_bone_mm = {0.1, 1.0 / 3.0, -7.25};
  line.text = "Angle 3.1° \"too\" steep";
  card.ledger = {line};
  card.shown_losses_milli = {12'346};
  card.sentences = {"one", "two"};
  card.scenario = "silver";
  card.scenario_version = 2;
  card.is_reviewed = true;
  return card;
}

TEST(CardJson, GivesBackTheSameCard) {
  const std::string json = json_from_card(some_card());
  const ScoreCard back = card_from_json(json);
  EXPECT_EQ(json_from_card(back), json);
  EXPECT_EQ(back.ledger.at(0).kind, LedgerKind::Damping);
  EXPECT_EQ(back.ledger.at(0).place_in_bone_mm, some_card().ledger[0].place_in_bone_mm);
  EXPECT_EQ(back.gates.at(0).is_triggered, true);
  EXPECT_EQ(back.groups.at(1).name, "safety");
  EXPECT_EQ(back.sentences, some_card().sentences);
}

TEST(CardJson, SurvivesANumberThatIsNone) {
  ScoreCard card = some_card();
  card.ledger[0].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(card_from_json(json_from_card(card)).ledger.at(0).value, 0.0);
}

TEST(CardJson, RefusesWhatIsNoCard) {
  for (const char* text : {"", "{", "[]", "{}", "{\"score_milli\": \"many\"}"}) {
    EXPECT_THROW(card_from_json(text), DatabaseError) << text;
  }
}

}  // namespace

}  // namespace hallux::database
