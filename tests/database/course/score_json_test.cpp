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
  card.gates.emplace_back();
  card.gates.back().name = "sulcus";
  card.gates.back().cap_milli = 59'000;
  card.gates.back().is_triggered = true;
  card.gates.back().value = 1.25;
  card.gates.back().text = "The cut went 1.25 mm too far.";
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

/// As this program stores it.
ScoreCard card_of_facts() {
  ScoreCard card = some_card();
  card.form = CardForm::Facts;
  card.gates[0].title = "Sulcus";
  card.gates[0].is_measured = true;
  card.ledger[0].facts.title = "Angle";
  card.ledger[0].facts.target = TargetKind::Between;
  card.ledger[0].facts.done_fraction = 0.5;
  card.ledger[0].facts.detail = {DetailKind::WedgeTaken, {15.4, 8.0}, {"one", "two"}};
  card.messages = {{MessageKind::CutUnfinished, 0, "Proximal face", 0.5, 12'300}};
  return card;
}

TEST(CardJson, KeepsWhatWordsAreMadeFromAndNoWords) {
  const std::string json = json_from_card(card_of_facts());
  EXPECT_EQ(json.find("too far"), std::string::npos);
  EXPECT_EQ(json.find("steep"), std::string::npos);
  const ScoreCard back = card_from_json(json);
  EXPECT_EQ(json_from_card(back), json);
  EXPECT_EQ(back.form, CardForm::Facts);
  EXPECT_EQ(back.ledger.at(0).facts.detail, card_of_facts().ledger[0].facts.detail);
  EXPECT_EQ(back.messages.at(0).kind, MessageKind::CutUnfinished);
  EXPECT_TRUE(back.gates.at(0).is_measured);
  EXPECT_TRUE(back.sentences.empty());
}

TEST(CardJson, OfAnOlderProgramHasItsWordsAndIsTheSameScore) {
  const std::string json = json_from_card(some_card());
  for (const char* key : {"facts", "messages", "form", "is_at_least"})
    EXPECT_EQ(json.find(key), std::string::npos) << key;
  EXPECT_EQ(card_from_json(json).ledger.at(0).text, some_card().ledger[0].text);
  EXPECT_TRUE(is_same_score(some_card(), card_of_facts()));
  ScoreCard other = card_of_facts();
  other.ledger[0].value += 1.0e-6;
  EXPECT_FALSE(is_same_score(some_card(), other));
}

TEST(CardJson, SurvivesANumberThatIsNone) {
  ScoreCard card = some_card();
  card.ledger[0].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(card_from_json(json_from_card(card)).ledger.at(0).value, 0.0);
}

TEST(CardJson, RefusesPointsThatDoNotAddUpAndAnUnknownForm) {
  const auto refuses = [](const std::string& from, const std::string& to, const ScoreCard& card) {
    std::string json = json_from_card(card);
    const std::size_t at = json.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    json.replace(at, from.size(), to);
    EXPECT_THROW(card_from_json(json), DatabaseError) << to;
  };
  refuses("\"measured_milli\":50000,", "\"measured_milli\":-9223372036854775808,", some_card());
  refuses("\"measured_milli\":50000,", "\"measured_milli\":1,", some_card());
  refuses("\"points_lost_milli\":6173", "\"points_lost_milli\":9000000000000", some_card());
  refuses("\"shown_losses_milli\":[12346]", "\"shown_losses_milli\":[]", some_card());
  refuses("\"form\":\"facts\"", "\"form\":\"words\"", card_of_facts());
}

TEST(CardJson, RefusesWhatIsNoCard) {
  for (const char* text : {"", "{", "[]", "{}", "{\"score_milli\": \"many\"}"}) {
    EXPECT_THROW(card_from_json(text), DatabaseError) << text;
  }
}

}  // namespace

}  // namespace hallux::database
