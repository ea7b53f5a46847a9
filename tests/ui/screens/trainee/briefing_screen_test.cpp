#include "ui/screens/trainee/briefing_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/screens/every_size.h"
#include "tests/ui/screens/no_patient.h"
#include "tests/ui/screens/some_navigator.h"
#include "tests/ui/screens/some_published.h"
#include "tests/ui/screens/some_visitor.h"

namespace hallux::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A person who reads the briefing of the Akin, or of another operation.
struct Briefed {
  explicit Briefed(SomePublished& published, float scale = 1.0F)
      : Briefed(published, published.akin(), scale) {}
  Briefed(SomePublished& published, database::ScenarioVersionId scenario, float scale = 1.0F)
      : visitor(std::make_unique<BriefingScreen>(visit_of(published.course(), "ada"), navigator,
                                                 pictures, scenario),
                scale) {}
  Driver& driver() { return visitor.driver(); }

  SomeNavigator navigator;
  PatientPictures pictures{no_patient};
  SomeVisitor visitor;
};

std::string asked(const char* what, database::ScenarioVersionId scenario) {
  return std::string(what) + " " + std::to_string(scenario.number);
}

TEST(BriefingScreen, SaysWhyAndWhatAndThatNoSurgeonReviewedIt) {
  SomePublished published;
  Briefed briefed(published);
  for (const char* words : {"Akin osteotomy, right hallux", "Not surgeon-reviewed", "Version 1",
                            "Hallux valgus interphalangeus", "Flexor hallucis longus tendon",
                            "not checked by an anatomist", "A first proximal phalanx"}) {
    EXPECT_TRUE(briefed.driver().sees(words)) << words;
  }
}

TEST(BriefingScreen, WhoHoldsAnArmMayFeelTheHistoricLawInPractice) {
  SomePublished published;
  Briefed briefed(published);
  EXPECT_FALSE(briefed.driver().has("brief.law")) << "a mouse is pushed by nothing";
  briefed.visitor.shell().preferences().device = "falcon-A1";
  briefed.driver().frame();
  briefed.driver().click("brief.law");
  briefed.driver().click("brief.begin");
  briefed.driver().click("brief.kind.1");
  EXPECT_FALSE(briefed.driver().has("brief.law"));
  briefed.driver().click("brief.begin");
  EXPECT_THAT(briefed.navigator.asked,
              ElementsAre(asked("practise by the historic law", published.akin()),
                          asked("assess", published.akin())));
}

TEST(BriefingScreen, ShowsTheStepsAndWhatIsScored) {
  SomePublished published;
  Briefed briefed(published);
  briefed.driver().click("brief.tab.1");
  EXPECT_TRUE(briefed.driver().sees("Take the wedge out"));
  briefed.driver().click("brief.tab.2");
  briefed.driver().resize(1600.0F, 1800.0F);
  for (const char* words :
       {"Accuracy", "Angle of the wedge", "Margin to the joint", "Smoothness of the free movements",
        "Lateral cortex cut through: at most 69 points", "from 60 points on"}) {
    EXPECT_TRUE(briefed.driver().sees(words)) << words;
  }
}

/// The same patient, with cuts through a bone of 17.2 x 20 mm whose blade needs `count` passes.
PatientView patient_of_passes(const scenarios::Scenario& scenario, std::size_t count) {
  PatientView view = no_patient(scenario, {});
  for (std::size_t cut = 0; cut < scenario.cuts.size(); ++cut) {
    PassesInView& passes = view.passes.emplace_back();
    passes.section.section.bone_mm = {
        {Vec2(0.0, -8.6), Vec2(20.0, -8.6), Vec2(20.0, 8.6), Vec2(0.0, 8.6)}};
    passes.blade_width_mm = 12.0;
    passes.bone_width_mm = 17.2;
    for (std::size_t pass = 0; pass < count; ++pass)
      passes.middles_mm.push_back(-3.6 + 7.2 * static_cast<double>(pass));
  }
  return view;
}

TEST(BriefingScreen, ABladeNarrowerThanTheBoneIsSaidWithItsPassesLaidOut) {
  SomePublished published;
  SomeNavigator navigator;
  PatientPictures pictures{
      [](const auto& scenario, const auto&) { return patient_of_passes(scenario, 2); }};
  for (const float scale : {1.0F, 1.5F}) {
    SomeVisitor visitor(std::make_unique<BriefingScreen>(visit_of(published.course(), "ada"),
                                                         navigator, pictures, published.akin()),
                        scale);
    visitor.finish_work();
    Driver& driver = visitor.driver();
    driver.resize(1440.0F * scale, 1400.0F * scale);
    EXPECT_THAT(all_text(driver), HasSubstr("several passes side by side"));
    driver.click("brief.tab.1");
    EXPECT_THAT(
        all_text(driver),
        HasSubstr(
            "12 mm wide and the bone here 17.2 mm: one pass leaves bone standing. Saw it in 2 "
            "passes"));
    EXPECT_TRUE(driver.has("brief.passes.2"));
    driver.resize(1280.0F, 720.0F);
    EXPECT_THAT(driver.faults(), IsEmpty()) << scale;
  }
}

TEST(BriefingScreen, ABladeAsWideAsTheBoneNeedsNoWordOfPasses) {
  SomePublished published;
  SomeNavigator navigator;
  PatientPictures pictures{
      [](const auto& scenario, const auto&) { return patient_of_passes(scenario, 1); }};
  SomeVisitor visitor(std::make_unique<BriefingScreen>(visit_of(published.course(), "ada"),
                                                       navigator, pictures, published.akin()));
  visitor.finish_work();
  EXPECT_THAT(all_text(visitor.driver()), Not(HasSubstr("several passes")));
  visitor.driver().click("brief.tab.1");
  EXPECT_THAT(all_text(visitor.driver()), Not(HasSubstr("passes side by side")));
}

TEST(BriefingScreen, SaysThatWhatIsSawnAfterDoneCounts) {
  SomePublished published;
  Briefed briefed(published);
  briefed.driver().click("brief.tab.1");
  EXPECT_THAT(all_text(briefed.driver()),
              HasSubstr("sawn in a cut after its Done counts as what was sawn before"));
}

TEST(BriefingScreen, BeginsPracticeUnlessTheAssessmentWasChosen) {
  SomePublished published;
  Briefed briefed(published);
  EXPECT_TRUE(briefed.driver().sees("The planned faces and the angle"));
  briefed.driver().click("brief.begin");
  briefed.driver().click("brief.kind.1");
  EXPECT_TRUE(briefed.driver().sees("Nothing is shown but the bone and the saw"));
  briefed.driver().click("brief.begin");
  EXPECT_THAT(briefed.navigator.asked,
              ElementsAre(asked("practise", published.akin()), asked("assess", published.akin())));
}

TEST(BriefingScreen, SaysHowManyAssessmentsAreLeftAndBeginsNoMore) {
  SomePublished published;
  database::SomeCourse& course = published.course();
  course.instructor("kim", course.autumn()).set_limit("akin", 1);
  Briefed first(published);
  first.driver().click("brief.kind.1");
  EXPECT_TRUE(first.driver().sees("1 assessment is left of the 1 that autumn allows"));
  first.driver().click("brief.begin");
  published.assessed("ada", 1, 70000);
  Briefed second(published);
  second.driver().click("brief.kind.1");
  EXPECT_TRUE(second.driver().sees("None is left of the 1 that autumn allows"));
  EXPECT_FALSE(second.driver().widget("brief.begin").is_enabled);
  second.driver().click("brief.kind.0");
  second.driver().click("brief.begin");
  EXPECT_THAT(first.navigator.asked, ElementsAre(asked("assess", published.akin())));
  EXPECT_THAT(second.navigator.asked, ElementsAre(asked("practise", published.akin())));
}

TEST(BriefingScreen, LetsPracticeBeGuidedAndAnAssessmentNever) {
  SomePublished published;
  Briefed briefed(published);
  EXPECT_TRUE(briefed.driver().sees("Nothing leads your hand"));
  briefed.driver().click("brief.guide.1");
  EXPECT_TRUE(briefed.driver().sees("draws your hand softly"));
  briefed.driver().click("brief.begin");
  briefed.driver().click("brief.guide.2");
  EXPECT_TRUE(briefed.driver().sees("as a guide's slot would"));
  briefed.driver().click("brief.begin");
  briefed.driver().click("brief.kind.1");
  EXPECT_FALSE(briefed.driver().has("brief.guide.0"));
  briefed.driver().click("brief.begin");
  EXPECT_THAT(briefed.navigator.asked,
              ElementsAre(asked("practise guided by soft", published.akin()),
                          asked("practise guided by slot", published.akin()),
                          asked("assess", published.akin())));
  EXPECT_THAT(briefed.driver().faults(), IsEmpty());
}

TEST(BriefingScreen, IsSteeredByKeyboardAlone) {
  SomePublished published;
  Briefed briefed(published);
  for (int tab = 0; tab < 12 && briefed.driver().focused() != "brief.kind.0"; ++tab) {
    briefed.driver().press(Key::Tab);
  }
  ASSERT_EQ(briefed.driver().focused(), "brief.kind.0");
  briefed.driver().press(Key::Right);
  briefed.driver().press(Key::Space);
  briefed.driver().press(Key::Tab);
  briefed.driver().press(Key::Enter);
  EXPECT_THAT(briefed.navigator.asked, ElementsAre(asked("assess", published.akin())));
}

TEST(BriefingScreen, LeadsToASimulatedHandAndSaysWhatItIsAndHowLongItTakes) {
  SomePublished published;
  Briefed briefed(published);
  for (const char* words : {"simulated hand", "not surgeon-reviewed", "10 to 40 seconds"})
    EXPECT_THAT(all_text(briefed.driver()), HasSubstr(words));
  briefed.driver().click("brief.watch");
  EXPECT_THAT(briefed.navigator.asked, ElementsAre("watch akin"));
  Briefed by_keyboard(published);
  press_by_keyboard(by_keyboard.visitor, "brief.watch");
  EXPECT_THAT(by_keyboard.navigator.asked, ElementsAre("watch akin"));
}

TEST(BriefingScreen, ShowsNoHandWhileAnAssessmentIsRecordedAndSaysWhy) {
  SomePublished published;
  database::NewAttempt begun = published.course().attempt_of("ada");
  begun.kind = database::AttemptKind::Assessment;
  const auto lease = published.course().trainee("ada").begin_attempt(begun);
  Briefed briefed(published);
  EXPECT_FALSE(briefed.driver().widget("brief.watch").is_enabled);
  EXPECT_THAT(briefed.driver().off_without_reason(), IsEmpty());
}

TEST(BriefingScreen, EnterBegins) {
  SomePublished published;
  Briefed briefed(published);
  briefed.driver().press(Key::Enter);
  EXPECT_THAT(briefed.navigator.asked, ElementsAre(asked("practise", published.akin())));
}

TEST(BriefingScreen, WhatIsPublishedNoLongerSaysSo) {
  SomePublished published;
  published.course().administrator().retire_scenario(published.akin());
  Briefed briefed(published);
  EXPECT_TRUE(briefed.driver().sees("no longer published"));
  EXPECT_FALSE(briefed.driver().has("brief.begin"));
  EXPECT_TRUE(briefed.driver().has("brief.back"));
  EXPECT_THAT(briefed.driver().faults(), IsEmpty());
}

TEST(BriefingScreen, ATextThatCannotBeReadIsNamed) {
  SomePublished published;
  Briefed briefed(published, published.course().published());
  EXPECT_TRUE(briefed.driver().sees("This could not be read"));
  EXPECT_FALSE(briefed.driver().has("brief.begin"));
}

TEST(BriefingScreen, ABoneThatCannotBeBuiltIsSaidAndTheRestStays) {
  SomePublished published;
  SomeNavigator navigator;
  PatientPictures pictures{[](const auto&, const auto&) -> PatientView {
    throw scenarios::ScenarioError("akin: the plane misses the bone");
  }};
  SomeVisitor visitor(std::make_unique<BriefingScreen>(visit_of(published.course(), "ada"),
                                                       navigator, pictures, published.akin()));
  EXPECT_TRUE(visitor.driver().sees("Akin: the plane misses the bone."));
  EXPECT_TRUE(visitor.driver().has("brief.begin"));
  EXPECT_FALSE(visitor.driver().has("brief.picture"));
  EXPECT_THAT(visitor.driver().faults(), IsEmpty());
}

TEST(BriefingScreen, NothingIsCutOffAtAnyScaleAndSize) {
  SomePublished published;
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Briefed briefed(published, scale);
    for (const char* tab : {"brief.tab.0", "brief.tab.1", "brief.tab.2"}) {
      briefed.driver().resize(1440.0F * scale, 900.0F * scale);
      briefed.driver().click(tab);
      EXPECT_THAT(briefed.driver().faults(), IsEmpty()) << scale << tab;
      for (const auto& [width, height] :
           {std::pair(1280.0F, 720.0F), std::pair(3840.0F, 2160.0F)}) {
        briefed.driver().resize(width, height);
        EXPECT_THAT(briefed.driver().faults(), IsEmpty()) << scale << tab << width;
      }
    }
  }
}

}  // namespace
}  // namespace hallux::ui
