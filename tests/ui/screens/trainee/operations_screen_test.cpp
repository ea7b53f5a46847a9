#include "ui/screens/trainee/operations_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/screens/no_patient.h"
#include "tests/ui/screens/some_navigator.h"
#include "tests/ui/screens/some_published.h"
#include "tests/ui/screens/some_visitor.h"

namespace hallux::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// What they said to the first flight.
enum class Flight { Answered, NotAsked };

/// A person who looks for something to operate.
struct Chooser {
  Chooser(SomePublished& published, const std::string& login, float scale = 1.0F,
          Flight flight = Flight::Answered)
      : visitor(std::make_unique<OperationsScreen>(visit_of(published.course(), login), navigator,
                                                   pictures),
                scale) {
    if (flight == Flight::NotAsked) return;
    keep_flight_answer(visitor.shell().preferences(), published.course().id_of(login));
    driver().frame();
  }
  Driver& driver() { return visitor.driver(); }

  SomeNavigator navigator;
  PatientPictures pictures{no_patient};
  SomeVisitor visitor;
};

std::string brief_of(const SomePublished& published) {
  return "brief " + std::to_string(published.akin().number);
}

TEST(OperationsScreen, SaysWhereNothingIsPublished) {
  SomePublished published;
  database::AdministratorDesk desk = published.course().administrator();
  desk.retire_scenario(published.akin());
  desk.retire_scenario(published.course().published());
  Chooser chooser(published, "ada");
  EXPECT_TRUE(chooser.driver().sees("No operations yet"));
  EXPECT_FALSE(chooser.driver().has("operations.start"));
  EXPECT_THAT(chooser.driver().faults(), IsEmpty());
}

TEST(OperationsScreen, SaysWhatAnOperationIsAndThatNoSurgeonReviewedIt) {
  SomePublished published;
  Chooser chooser(published, "ada");
  for (const char* words : {"Akin osteotomy, right hallux", "2 saw cuts, first proximal phalanx",
                            "Easy", "Not surgeon-reviewed", "Not started"}) {
    EXPECT_TRUE(chooser.driver().sees(words)) << words;
  }
}

TEST(OperationsScreen, APersonLearnsByCleanAssessments) {
  SomePublished published;
  published.scored_by("ada", 71250);
  published.assessed("ada", 3, 81400);
  Chooser chooser(published, "ada");
  EXPECT_TRUE(chooser.driver().sees("Learning, 3 of 12"));
  EXPECT_TRUE(chooser.driver().sees("81.4"));
  Chooser other(published, "bob");
  EXPECT_FALSE(other.driver().sees("81.4")) << "somebody else's";
}

TEST(OperationsScreen, PracticeAndGatedAssessmentsAreNoEvidence) {
  SomePublished published;
  published.scored_by("ada", 75000);
  published.scored_by("ada", 69000, database::AttemptKind::Assessment, true);
  Chooser chooser(published, "ada");
  EXPECT_TRUE(chooser.driver().sees("Learning, 0 of 12"));
}

TEST(OperationsScreen, WhereNothingIsDecidedItSaysHowOftenTheyTried) {
  SomePublished published;
  published.scored_by("ada", 95000);
  published.attempted_by("ada", database::AttemptKind::Assessment);
  Chooser chooser(published, "ada");
  EXPECT_TRUE(chooser.driver().sees("Learning, 2 attempts"));
}

TEST(OperationsScreen, WhoFellFarBelowTheirBestIsToldSo) {
  SomePublished published;
  published.scored_by("ada", 95000);
  published.scored_by("ada", 61000);
  Chooser chooser(published, "ada");
  EXPECT_TRUE(chooser.driver().sees("Below your best"));
}

TEST(OperationsScreen, TwelveCleanAssessmentsAreCompetence) {
  SomePublished published;
  published.assessed("ada", 12, 60000);
  Chooser chooser(published, "ada");
  chooser.driver().click("operations.filter.3");
  EXPECT_TRUE(chooser.driver().has("operations.card.akin"));
  EXPECT_FALSE(chooser.driver().has("operations.card.silver"));
  chooser.driver().click("operations.filter.2");
  EXPECT_FALSE(chooser.driver().has("operations.card.akin"));
  EXPECT_TRUE(chooser.driver().sees("Nothing matches"));
}

TEST(OperationsScreen, ACardSaysHowManyAssessmentsAreLeft) {
  SomePublished published;
  published.course().instructor("kim", published.course().autumn()).set_limit("akin", 3);
  published.assessed("ada", 1, 70000);
  Chooser chooser(published, "ada");
  EXPECT_TRUE(chooser.driver().sees("; 2 of 3 left"));
}

TEST(OperationsScreen, ACardLeadsToItsBriefing) {
  SomePublished published;
  Chooser chooser(published, "ada");
  chooser.driver().click("operations.card.akin");
  EXPECT_THAT(chooser.navigator.asked, ElementsAre(brief_of(published)));
}

TEST(OperationsScreen, WhoeverTriedNothingYetIsOfferedTheFirstFlight) {
  SomePublished published;
  Chooser chooser(published, "ada", 1.0F, Flight::NotAsked);
  EXPECT_TRUE(chooser.driver().sees("First flight: one minute on a block"));
  EXPECT_FALSE(chooser.driver().has("operations.start")) << "one thing is next";
  EXPECT_THAT(chooser.driver().faults(), IsEmpty());
  chooser.driver().press(Key::Enter);
  EXPECT_THAT(chooser.navigator.asked, ElementsAre("fly"));
}

TEST(OperationsScreen, AnAnsweredOfferDoesNotComeAgainAndTheFlightStaysReachable) {
  for (const char* answer : {"flight.offer.fly", "flight.offer.not_now"}) {
    SomePublished published;
    Chooser chooser(published, "ada", 1.0F, Flight::NotAsked);
    chooser.driver().click(answer);
    EXPECT_FALSE(chooser.driver().sees("one minute on a block")) << answer;
    EXPECT_TRUE(chooser.driver().has("operations.start"));
    chooser.navigator.asked.clear();
    chooser.driver().click("operations.fly");
    EXPECT_THAT(chooser.navigator.asked, ElementsAre("fly"));
    EXPECT_THAT(chooser.visitor.shell().preferences().offered_flight,
                ElementsAre(published.course().id_of("ada").number));
  }
}

TEST(OperationsScreen, TheFlightIsOfferedToEachPersonAndToNobodyWhoHasOperated) {
  SomePublished published;
  published.attempted_by("bob", database::AttemptKind::Practice);
  Chooser bob(published, "bob", 1.0F, Flight::NotAsked);
  EXPECT_FALSE(bob.driver().sees("one minute on a block"));
  EXPECT_TRUE(bob.driver().has("operations.fly"));
  Chooser ada(published, "ada", 1.0F, Flight::NotAsked);
  keep_flight_answer(ada.visitor.shell().preferences(), published.course().id_of("bob"));
  ada.driver().frame();
  EXPECT_TRUE(ada.driver().sees("one minute on a block")) << "bob's answer is not hers";
}

TEST(OperationsScreen, EnterStartsTheNextThingToDo) {
  SomePublished published;
  Chooser chooser(published, "ada");
  EXPECT_TRUE(chooser.driver().sees("Next: Akin osteotomy, right hallux"));
  chooser.driver().press(Key::Enter);
  EXPECT_THAT(chooser.navigator.asked, ElementsAre(brief_of(published)));
}

TEST(OperationsScreen, ACardIsReachedAndOpenedByKeyboardAlone) {
  SomePublished published;
  Chooser chooser(published, "ada");
  for (int tab = 0; tab < 12 && chooser.driver().focused() != "operations.card.akin"; ++tab) {
    chooser.driver().press(Key::Tab);
  }
  ASSERT_EQ(chooser.driver().focused(), "operations.card.akin");
  chooser.driver().press(Key::Right);
  EXPECT_EQ(chooser.driver().focused(), "operations.card.silver");
  chooser.driver().press(Key::Left);
  chooser.driver().press(Key::Space);
  EXPECT_THAT(chooser.navigator.asked, ElementsAre(brief_of(published)));
}

TEST(OperationsScreen, WhatCannotBeReadIsShownAndLeadsNowhere) {
  SomePublished published;
  Chooser chooser(published, "ada");
  EXPECT_TRUE(chooser.driver().sees("This version cannot read it."));
  chooser.driver().click("operations.card.silver");
  EXPECT_THAT(chooser.navigator.asked, IsEmpty());
}

TEST(OperationsScreen, TheSearchFindsByWordsAndForgetsThem) {
  SomePublished published;
  Chooser chooser(published, "ada");
  chooser.driver().click("operations.search");
  chooser.driver().type("HALLUX");
  EXPECT_TRUE(chooser.driver().has("operations.card.akin"));
  EXPECT_FALSE(chooser.driver().has("operations.card.silver"));
  chooser.driver().type("x");
  EXPECT_TRUE(chooser.driver().sees("Nothing matches"));
  chooser.driver().click("operations.no_match.action");
  EXPECT_TRUE(chooser.driver().has("operations.card.silver"));
}

TEST(OperationsScreen, AfterAnAttemptItIsReadAnew) {
  SomePublished published;
  Chooser chooser(published, "ada");
  published.scored_by("ada", 81400);
  EXPECT_FALSE(chooser.driver().sees("81.4"));
  chooser.visitor.shell().top()->enter(chooser.visitor.shell());
  chooser.driver().frame();
  chooser.visitor.finish_work();
  EXPECT_TRUE(chooser.driver().sees("81.4"));
}

TEST(OperationsScreen, APersonDisabledSinceIsToldSo) {
  SomePublished published;
  auto signed_in = visit_of(published.course(), "ada");
  published.course().administrator().set_disabled("ada", true);
  SomeNavigator navigator;
  PatientPictures pictures{no_patient};
  SomeVisitor visitor(std::make_unique<OperationsScreen>(signed_in, navigator, pictures));
  EXPECT_TRUE(visitor.driver().sees("This could not be read"));
  EXPECT_TRUE(visitor.driver().has("operations.failed.action"));
  EXPECT_THAT(visitor.driver().faults(), IsEmpty());
}

TEST(OperationsScreen, NothingIsCutOffAtAnyScaleAndSize) {
  SomePublished published;
  published.assessed("ada", 2, 81400);
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Chooser chooser(published, "ada", scale);
    EXPECT_THAT(chooser.driver().faults(), IsEmpty()) << scale;
    for (const auto& [width, height] : {std::pair(1280.0F, 720.0F), std::pair(3840.0F, 2160.0F)}) {
      chooser.driver().resize(width, height);
      EXPECT_THAT(chooser.driver().faults(), IsEmpty()) << scale << " " << width;
    }
    Chooser first(published, "bob", scale, Flight::NotAsked);
    EXPECT_THAT(first.driver().faults(), IsEmpty()) << scale << ", with the offer";
    first.driver().resize(1280.0F, 720.0F);
    EXPECT_THAT(first.driver().faults(), IsEmpty())
        << scale << ", with the offer in a small window";
  }
}

}  // namespace
}  // namespace hallux::ui
