#include "ui/screens/result/result_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "assessment/assess.h"
#include "assessment/number_text.h"
#include "tests/ui/screens/result/some_reader.h"
#include "ui/jobs/attempt_jobs.h"
#include "ui/report/effects_text.h"
#include "ui/screens/result/effects_card.h"
#include "ui/screens/result/recording_card.h"
#include "ui/screens/result/result_text.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {
namespace {

using database::AttemptId;
using database::DecisionKind;
using database::SomeCourse;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(ResultScreen, ATraineeReadsScoreLedgerAndMarks) {
  OperatedCourse akin;
  database::TraineeDesk ada = akin.course.trainee("ada");
  const auto stored = told_score(ada, akin.attempt);
  Reader reader(akin.course, "ada", akin.attempt);
  Driver& driver = reader.driver();
  EXPECT_TRUE(driver.sees(points_text(stored->card.score_milli)));
  for (const char* words :
       {"Score advisory until signed", "Partial", "Not surgeon-reviewed",
        "Pass mark 60, provisional", "not reached", "Angle of the first face", "not yet measured"})
    EXPECT_TRUE(driver.sees(words)) << words;
  EXPECT_TRUE(driver.sees(stored->card.sentences.front().substr(0, 40)));
  EXPECT_FALSE(driver.has("result.decide")) << "a trainee decides nothing";
  EXPECT_FALSE(driver.sees("Computed again now")) << "the same score is no difference";
  EXPECT_THAT(driver.faults(), IsEmpty());
}

TEST(ResultMarks, SayHowAnAttemptWasGuided) {
  const Texts texts = english_texts();
  const auto guided_marks = [&](simulator::Guidance guidance) {
    ResultFacts facts;
    facts.header.begun.guidance = guidance;
    std::vector<std::string> found;
    for (const ScoreMark& mark : score_marks(texts, facts)) {
      if (mark.words.starts_with("Guided")) found.push_back(mark.words);
    }
    return found;
  };
  EXPECT_THAT(guided_marks(simulator::Guidance::None), IsEmpty());
  EXPECT_THAT(guided_marks(simulator::Guidance::Soft), ElementsAre("Guided softly"));
  EXPECT_THAT(guided_marks(simulator::Guidance::Slot), ElementsAre("Guided like a slot"));
}

TEST(ResultScreen, OfThreeThingsToTakeAwayOneWasDoneWell) {
  OperatedCourse akin;
  database::TraineeDesk ada = akin.course.trainee("ada");
  const auto stored = told_score(ada, akin.attempt);
  ASSERT_EQ(stored->card.sentences.size(), 3U) << "three losses, and still";
  Reader reader(akin.course, "ada", akin.attempt);
  int kept = 0;
  for (const std::string& text : reader.driver().texts())
    kept +=
        text.find("points lost.") == std::string::npos && text.find(": all ") != std::string::npos;
  EXPECT_EQ(kept, 1);
  EXPECT_FALSE(reader.driver().sees(stored->card.sentences[2].substr(0, 60)));
}

/// The number of points after these words, in tenths.
int tenths_after(Driver& driver, const std::string& words) {
  for (const std::string& text : driver.texts())
    if (text.starts_with(words))
      return static_cast<int>(std::lround(10.0 * std::stod(text.substr(words.size()))));
  ADD_FAILURE() << "no text begins with " << words;
  return 0;
}

TEST(ResultScreen, OnePointMeansTheSameInScoreLedgerGroupsAndSentences) {
  OperatedCourse akin;
  Reader reader(akin.course, "ada", akin.attempt);
  Driver& driver = reader.driver();
  database::TraineeDesk ada = akin.course.trainee("ada");
  const database::ScoreCard card = told_score(ada, akin.attempt)->card;
  ASSERT_LT(card.measured_milli, card.rubric_milli) << "else there is but one scale";
  const assessment::ShownPoints shown = assessment::shown_points(card);
  EXPECT_TRUE(driver.sees(points_text(shown.score_milli)));
  EXPECT_EQ(tenths_after(driver, "Where ") + static_cast<int>(shown.score_milli / 100), 1000);
  EXPECT_TRUE(driver.sees("/ 86.2")) << "accuracy has 50 of the 58 rubric points measured";
  EXPECT_TRUE(driver.sees("/ 13.8"));
  EXPECT_TRUE(driver.sees("58 % of the rubric"));
  const std::size_t dearest = lines_by_loss(card).front();
  const std::string lost = assessment::points_text(shown.lines[dearest].lost_milli);
  EXPECT_THAT(card.ledger[dearest].text, HasSubstr(": " + lost + " "));
  EXPECT_TRUE(driver.sees(lost + " points lost"));
}

TEST(ResultScreen, ALedgerEntryLeadsToItsMomentByMouse) {
  OperatedCourse akin;
  Reader reader(akin.course, "ada", akin.attempt);
  reader.driver().click("result.moment.A1");
  ASSERT_THAT(reader.asked(), SizeIs(1));
  EXPECT_THAT(reader.asked().front(), HasSubstr("replay " + akin.attempt.text + " at 0.01"));
}

TEST(ResultScreen, ALedgerEntryLeadsToItsMomentByKeyboard) {
  OperatedCourse akin;
  Reader reader(akin.course, "ada", akin.attempt);
  Driver& driver = reader.driver();
  reader.tab_to("result.ledger.");
  driver.press(Key::Down);
  ASSERT_TRUE(driver.focused().starts_with("result.ledger."));
  driver.press(Key::Enter);
  EXPECT_THAT(reader.asked(), IsEmpty()) << "the first press shows it here";
  EXPECT_FALSE(driver.sees("Choose an entry"));
  driver.press(Key::Enter);
  EXPECT_THAT(reader.asked(), SizeIs(1));
}

TEST(ResultScreen, StandardViewsAreChosenByMouseAndByKey) {
  OperatedCourse akin;
  Reader reader(akin.course, "ada", akin.attempt);
  Driver& driver = reader.driver();
  EXPECT_TRUE(driver.sees("left standing"));
  driver.click("result.views");
  EXPECT_TRUE(driver.sees("From plantar"));
  EXPECT_THAT(driver.faults(), IsEmpty());
  driver.click("result.view.4");
  EXPECT_FALSE(driver.has("result.view.4"));
  driver.press(Key::Digit2);
  driver.click("result.cut.2");
  EXPECT_FALSE(driver.sees("left standing")) << "the whole bone has no map";
  EXPECT_THAT(driver.faults(), IsEmpty());
}

TEST(ResultScreen, EnterIsTheReplayOfTheWholeAttempt) {
  OperatedCourse akin;
  Reader reader(akin.course, "ada", akin.attempt);
  reader.driver().press(Key::Enter);
  EXPECT_THAT(reader.asked(), ElementsAre("replay " + akin.attempt.text + " at 0.000000"));
}

TEST(ResultScreen, AnInstructorConfirmsByMouse) {
  OperatedCourse akin;
  Reader reader(akin.course, "kim", akin.attempt);
  Driver& driver = reader.driver();
  driver.click("result.decide");
  expect_reason_by_keyboard(driver, "decide.act");
  driver.click("decide.reason");
  driver.type("Seen in the replay.");
  driver.click("decide.act");
  reader.finish();
  EXPECT_FALSE(driver.has("decide.act"));
  EXPECT_TRUE(driver.sees("Confirmed by an instructor"));
  EXPECT_FALSE(driver.sees("Score advisory until signed"));
  const auto decisions = akin.course.trainee("ada").decisions(akin.attempt);
  ASSERT_THAT(decisions, SizeIs(1));
  EXPECT_EQ(decisions.front().kind, DecisionKind::Confirmed);
  EXPECT_EQ(decisions.front().reason, "Seen in the replay.");
}

TEST(ResultScreen, AnInstructorOverridesByKeyboardAlone) {
  OperatedCourse akin;
  Reader reader(akin.course, "kim", akin.attempt);
  Driver& driver = reader.driver();
  reader.tab_to("result.decide");
  driver.press(Key::Space);
  driver.press(Key::Tab, {.shift = true});
  driver.press(Key::Right);
  driver.press(Key::Space);
  reader.tab_to("decide.score");
  driver.press(Key::A, {.control = true});
  driver.type("101");
  EXPECT_TRUE(driver.sees("A number from 0 to 100"));
  driver.press(Key::A, {.control = true});
  driver.type("72.5");
  driver.press(Key::Tab);
  driver.type("The table was moved.");
  driver.press(Key::Enter, {.control = true});
  reader.finish();
  const auto decisions = akin.course.trainee("ada").decisions(akin.attempt);
  ASSERT_THAT(decisions, SizeIs(1));
  EXPECT_EQ(decisions.front().score_milli, 72'500);
  EXPECT_TRUE(driver.sees("72.5"));
  EXPECT_TRUE(driver.sees("Machine\xE2\x80\x99s score"));
  EXPECT_THAT(driver.faults(), IsEmpty());
}

TEST(ResultScreen, AVoidAsksFirstAndIsReadByTheTrainee) {
  OperatedCourse akin;
  {
    Reader reader(akin.course, "kim", akin.attempt);
    Driver& driver = reader.driver();
    driver.click("result.decide");
    driver.click("decide.kind.2");
    driver.click("decide.reason");
    driver.type("The station was restarted.");
    driver.click("decide.act");
    EXPECT_TRUE(driver.sees("Void this attempt?"));
    driver.press(Key::Enter);  // the safe answer has the focus
    reader.finish();
    EXPECT_THAT(akin.course.trainee("ada").decisions(akin.attempt), IsEmpty());
    driver.click("decide.act");
    driver.click("decide.void.act");
    reader.finish();
    EXPECT_TRUE(driver.sees("kim set this attempt aside; it does not count. The station"));
  }
  Reader trainee(akin.course, "ada", akin.attempt);
  EXPECT_TRUE(trainee.driver().sees("kim set this attempt aside; it does not count. The station"));
  EXPECT_TRUE(trainee.driver().sees("does not count"));
  EXPECT_THAT(trainee.driver().faults(), IsEmpty());
}

TEST(ResultScreen, EscLeavesTheFormAndDecidesNothing) {
  OperatedCourse akin;
  Reader reader(akin.course, "kim", akin.attempt);
  reader.driver().click("result.decide");
  reader.driver().type("A reason");
  reader.driver().press(Key::Escape);
  EXPECT_FALSE(reader.driver().has("decide.act"));
  EXPECT_THAT(akin.course.trainee("ada").decisions(akin.attempt), IsEmpty());
}

TEST(ResultScreen, ATraineeAsksAboutTheMomentOfAnEntry) {
  OperatedCourse akin;
  Reader reader(akin.course, "ada", akin.attempt);
  Driver& driver = reader.driver();
  driver.click("result.ledger.A3");
  driver.click("result.ask");
  driver.type("Why here?");
  driver.press(Key::Enter, {.control = true});
  reader.finish();
  const auto requests = akin.course.trainee("ada").help_requests();
  ASSERT_THAT(requests, SizeIs(1));
  EXPECT_EQ(requests.front().question, "Why here?");
  EXPECT_GT(requests.front().moment.moment_us, 300'000) << "the second cut";
  EXPECT_TRUE(requests.front().moment.place.has_value());
  EXPECT_TRUE(driver.sees("Your instructors have the question"));
}

TEST(ResultScreen, AnAttemptOfSomebodyElseIsRefused) {
  OperatedCourse akin;
  Reader reader(akin.course, "bob", akin.attempt);
  EXPECT_TRUE(reader.driver().sees("This could not be read"));
  EXPECT_FALSE(reader.driver().sees("Akin"));
  EXPECT_THAT(reader.driver().faults(), IsEmpty());
}

TEST(ResultScreen, AnAttemptThatIsNotThereCanBeTriedAgain) {
  SomeCourse course;
  Reader reader(course, "ada", AttemptId{"00000000-0000-4000-8000-000000000000"});
  EXPECT_TRUE(reader.driver().sees("This could not be read"));
  reader.driver().click("result.failed.action");
  reader.finish();
  EXPECT_TRUE(reader.driver().sees("This could not be read"));
}

TEST(ResultScreen, AStoredScoreIsShownThoughTheBoneCannotBeCut) {
  SomeCourse course;
  const AttemptId attempt = course.scored_by("ada", 76'830);
  Reader reader(course, "ada", attempt);
  EXPECT_TRUE(reader.driver().sees("76.8"));
  EXPECT_TRUE(reader.driver().has("result.unseen.action"));
  EXPECT_TRUE(reader.driver().has("result.effects.unseen.action"));
  EXPECT_THAT(reader.driver().faults(), IsEmpty());
}

TEST(ResultScreen, WhatTheStoreLacksIsComputedAndKept) {
  SomeCourse course;
  const AttemptId attempt = operated_by(course, "ada", some_operation(), false);
  Reader reader(course, "ada", attempt);
  reader.finish();
  const auto stored = course.trainee("ada").score(attempt);
  ASSERT_TRUE(stored.has_value());
  EXPECT_TRUE(reader.driver().sees(points_text(stored->card.score_milli)));
  EXPECT_FALSE(reader.driver().sees("Not scored yet"));
}

TEST(ResultScreen, ADifferenceToTheStoredScoreIsNeverHidden) {
  OperatedCourse akin;
  database::ScoreCard older = akin.course.trainee("ada").score(akin.attempt)->card;
  older.score_milli = 12'300;
  older.engine = 1;
  store_score(akin.course.database(), akin.attempt, older, akin.course.id_of("ada"));
  Reader reader(akin.course, "ada", akin.attempt);
  EXPECT_TRUE(reader.driver().sees("12.3"));
  EXPECT_TRUE(reader.driver().sees("what is shown is the stored score, 12.3 (engine 1)"));
  EXPECT_EQ(akin.course.trainee("ada").score(akin.attempt)->card.score_milli, 12'300)
      << "and stays";
}

TEST(ResultScreen, AScoreOfAnOlderProgramIsSaidInTodaysWords) {
  OperatedCourse akin;
  database::ScoreCard older = akin.course.trainee("ada").score(akin.attempt)->card;
  for (database::LedgerLine& line : older.ledger)
    line.text = "In other words " + line.item + ": 4.7 of 8 points lost.";
  older.sentences = {older.ledger[0].text};
  older.form = database::CardForm::Words;
  store_score_as_it_was(akin.course.database(), akin.attempt, older, akin.course.id_of("ada"));
  Reader reader(akin.course, "ada", akin.attempt);
  EXPECT_FALSE(reader.driver().sees("In other words"));
  EXPECT_FALSE(reader.driver().sees("Computed again now")) << "the same score is no difference";
}

/// Ada's Akin in which the running saw touched a tendon from 0.2 s on, for 0.1 s.
struct SawnCourse {
  SawnCourse() {
    const auto touch = [&](std::int64_t tick, simulator::CutEventKind kind) {
      simulator::CutEvent event;
      event.tick = tick;
      event.kind = kind;
      event.subject = 0;
      auto& events = operation.recording.events;
      events.insert(std::find_if(events.begin(), events.end(),
                                 [&](const auto& each) { return each.tick > tick; }),
                    event);
    };
    touch(200, simulator::CutEventKind::DangerContact);
    touch(300, simulator::CutEventKind::DangerLeft);
    // The feed is lateral: pushed hard, and dry.
    for (simulator::ToolSample& sample : operation.recording.samples) {
      if (!has(sample.status, simulator::ToolStatus::Cutting)) continue;
      sample.status |= static_cast<std::uint32_t>(simulator::ToolStatus::InContact);
      sample.force_mn = {0, 0, -60'000};
    }
    attempt = operated_by(course, "ada", operation);
  }

  SomeCourse course;
  SomeOperation operation = some_operation();
  AttemptId attempt;
};

TEST(ResultScreen, TellsHeatBendAndDangerZonesAsTheReportDoes) {
  SawnCourse akin;
  const assessment::Examination examination = assessment::assess_fully(
      akin.operation.scenario, akin.operation.bone, akin.operation.recording, "scripted");
  const Traces traces =
      traces_of(akin.operation.recording, akin.operation.bone, false, examination.rebuilt.fields);
  ASSERT_TRUE(was_hot(traces.heat)) << traces.heat.hottest_celsius;
  Reader reader(akin.course, "ada", akin.attempt);
  Driver& driver = reader.driver();
  driver.resize(1600.0F, 1600.0F);
  reader.finish();
  for (const std::string& words :
       {hottest_text(traces.heat), hot_time_text(traces.heat),
        bend_text(traces.greatest_deflection_mm), std::string("Flexor hallucis longus tendon"),
        std::string("1 contact, 0.1 s"), std::string("Not scored"),
        std::string("no surgeon has reviewed")})
    EXPECT_TRUE(driver.sees(words)) << words;
  EXPECT_THAT(driver.faults(), IsEmpty());
}

TEST(ResultScreen, AContactWithADangerZoneLeadsToItsMomentByMouseAndByKeyboard) {
  SawnCourse akin;
  const std::string expected = "replay " + akin.attempt.text + " at 0.200000";
  Reader by_mouse(akin.course, "ada", akin.attempt);
  by_mouse.driver().resize(1600.0F, 1600.0F);
  by_mouse.finish();
  by_mouse.driver().click("result.effects.zone.0");
  EXPECT_THAT(by_mouse.asked(), ElementsAre(expected));
  Reader by_keyboard(akin.course, "ada", akin.attempt);
  by_keyboard.tab_to("result.effects.zone.0");
  by_keyboard.driver().press(Key::Enter);
  EXPECT_THAT(by_keyboard.asked(), ElementsAre(expected));
}

TEST(ResultScreen, AnAttemptThatTouchedNothingSaysSo) {
  OperatedCourse akin;
  Reader reader(akin.course, "ada", akin.attempt);
  reader.driver().resize(1600.0F, 1600.0F);
  reader.finish();
  EXPECT_TRUE(reader.driver().sees("none touched"));
  EXPECT_FALSE(reader.driver().has("result.effects.zone.0"));
}

TEST(ResultScreen, WhoDecidesReadsHowItWasRecorded) {
  OperatedCourse akin;
  Reader instructor(akin.course, "kim", akin.attempt), trainee(akin.course, "ada", akin.attempt);
  for (Reader* each : {&instructor, &trainee}) {
    each->driver().resize(1600.0F, 2400.0F);
    each->finish();
  }
  EXPECT_TRUE(instructor.driver().sees("How it was recorded"));
  EXPECT_FALSE(trainee.driver().sees("How it was recorded"));
}

TEST(RecordingCard, SaysOfADeviceHowItAnsweredAndHowItWasHeld) {
  const Texts texts = english_texts();
  ResultFacts facts;
  facts.header.begun.device_class = "arm3";
  facts.quality = Quality{};
  facts.quality->force_scale = 0.18;
  Driver driver(texts, [&](Ui& ui) {
    draw_recording_card(ui, {0.0F, 0.0F, 900.0F, recording_card_height(ui, facts, 900.0F)}, facts);
  });
  EXPECT_FALSE(driver.sees("Device answered in"));
  simulator::DeviceFacts device{"inverse3", "Haply Inverse3", "arm3", "libwebsockets", 1.5, {}};
  device.figures.packets = 61'234;
  device.figures.late_packets = 12;
  device.figures.round_trip_p50_us = 48.4;
  device.figures.round_trip_p99_us = 105.6;
  device.figures.calibration_age_s = 75.0;
  facts.quality->device = device;
  driver.frame();
  for (const char* words :
       {"Haply Inverse3 (arm3)", "48 µs, 99 % in 106 µs", "12 late, 0 bad", "× 1.50", "1:15"})
    EXPECT_TRUE(driver.sees(words)) << words;
  EXPECT_FALSE(driver.sees("Force by its own service"));
  EXPECT_FALSE(driver.sees("In the other hand"));
  facts.quality->device->figures.own_force_scale = 0.5;
  facts.quality->second_device = "space_mouse";
  driver.frame();
  EXPECT_TRUE(driver.sees("50 %"));
  EXPECT_TRUE(driver.sees("3Dconnexion SpaceMouse"));
}

TEST(RecordingCard, SaysWhetherAnArmPushedAndWhatHeldItBack) {
  const Texts texts = english_texts();
  ResultFacts facts;
  facts.header.begun.device_class = "mouse";
  float width = 900.0F;
  Driver driver(texts, [&](Ui& ui) {
    draw_recording_card(ui, {0.0F, 0.0F, width, recording_card_height(ui, facts, width)}, facts);
  });
  EXPECT_TRUE(driver.sees("How it was recorded is not known"));
  facts.quality = Quality{};
  facts.quality->certificate.expected_samples = 12'000;
  facts.quality->certificate.received_samples = 11'999;
  facts.quality->certificate.missed_ticks = 3;
  facts.quality->certificate.pauses = 2;
  facts.quality->certificate.late_p99_us = 65.25;
  facts.quality->certificate.has_priority = true;
  driver.frame();
  EXPECT_TRUE(driver.sees("nobody was pushed back"));
  EXPECT_FALSE(driver.sees("Held back by"));
  EXPECT_TRUE(driver.sees("Valid for grading"));
  EXPECT_FALSE(driver.sees("no: samples were lost")) << "what was sealed counts";
  facts.header.is_valid = false;
  driver.frame();
  EXPECT_TRUE(driver.sees("no: samples were lost"));
  facts.quality->force_scale = 0.24;
  driver.frame();
  EXPECT_TRUE(driver.sees("24 %"));
  EXPECT_TRUE(driver.sees("nothing"));
  EXPECT_TRUE(driver.sees("as simulated"));
  facts.quality->force_law = simulator::ForceLaw::Thesis;
  facts.quality->force_limits = (1U << 7U) - 1U;
  for (const float each : {400.0F, 640.0F, 900.0F, 1400.0F}) {
    width = each;
    driver.frame();
    EXPECT_TRUE(driver.sees("a stop, its speed")) << width;
    EXPECT_TRUE(driver.sees("historic, of the thesis")) << width;
    EXPECT_THAT(driver.faults(), IsEmpty()) << width;
  }
}

TEST(ResultScreen, NothingIsCutOffAtAnyScaleOrSize) {
  SawnCourse akin;
  akin.course.instructor("kim", akin.course.autumn())
      .decide(
          {akin.attempt, DecisionKind::Overridden, 60'000, "The table was moved during the cut."});
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Reader reader(akin.course, "kim", akin.attempt, scale);
    EXPECT_THAT(reader.driver().faults(), IsEmpty()) << scale;
    reader.driver().resize(1280.0F, 720.0F);
    reader.driver().settle();
    EXPECT_THAT(reader.driver().faults(), IsEmpty()) << "1280 x 720 at " << scale;
    reader.driver().click("result.decide");
    reader.driver().click("decide.kind.1");
    EXPECT_THAT(reader.driver().faults(), IsEmpty()) << "the form at " << scale;
    reader.driver().press(Key::Escape);
    reader.driver().resize(3840.0F, 2160.0F);
    reader.driver().settle();
    EXPECT_THAT(reader.driver().faults(), IsEmpty()) << "3840 x 2160 at " << scale;
  }
}

}  // namespace
}  // namespace hallux::ui
