#include "ui/screens/trainee/briefing_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/scenarios/format_1/format_1.h"
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
using testing::UnorderedElementsAre;

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

/// Another operation in the same course.
database::ScenarioVersionId publish(SomePublished& published, const scenarios::Scenario& scenario) {
  database::AdministratorDesk desk = published.course().administrator();
  const database::ScenarioVersionId id =
      desk.import_scenario({scenario.name, 100, scenario.text, false});
  desk.publish_scenario(id);
  return id;
}

/// Names of the tabs by what they say.
std::map<std::string, std::string> tabs_of(const Driver& driver) {
  std::map<std::string, std::string> tabs;
  for (const Widget& widget : driver.content().widgets)
    if (widget.id.starts_with("brief.tab.")) tabs[widget.label] = widget.id;
  return tabs;
}

std::vector<std::string> tab_labels_of(const Driver& driver) {
  std::vector<std::string> labels;
  for (const auto& [label, id] : tabs_of(driver)) labels.push_back(label);
  return labels;
}

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
  briefed.driver().click(tabs_of(briefed.driver())["Scoring"]);
  briefed.driver().resize(1600.0F, 1800.0F);
  for (const char* words :
       {"Accuracy", "Angle of the wedge", "Margin to the joint", "Smoothness of the free movements",
        "Lateral cortex cut through: at most 69 points", "from 60 points on"}) {
    EXPECT_TRUE(briefed.driver().sees(words)) << words;
  }
}

TEST(BriefingScreen, LaysOutTheTrayAndSaysWhatIsShiftedAndFixedWithWhat) {
  SomePublished published;
  Briefed briefed(published, publish(published, scenarios::load_shipped_scenario("chevron")));
  EXPECT_THAT(all_text(briefed.driver()), HasSubstr("What else is laid out stands under Tray"));
  briefed.driver().click(tabs_of(briefed.driver())["Tray and fixation"]);
  briefed.driver().resize(1600.0F, 1800.0F);
  const std::string told = all_text(briefed.driver());
  for (const char* words :
       {"micro-sagittal 9 x 25 x 0.4, for Dorsal arm, Plantar arm",
        "0.9, 1.1, 1.25, 1.4, 1.6, 2 mm", "1.1, 1.5, 1.8, 2, 2.5, 2.7, 3.2 mm thick",
        "2.7 mm thick, 10 to 40 mm long", "Always at hand"})
    EXPECT_THAT(told, HasSubstr(words)) << "on the tray";
  for (const char* words :
       {"Head to lateral", "Step 9", "5 mm to lateral", "Driven home until the faces touch"})
    EXPECT_THAT(told, HasSubstr(words)) << "shifted";
  for (const char* words :
       {"Axis wire", "Wire 1.1 to 1.4 mm thick, 18 to 30 mm deep", "Wire of 1.1, 1.25, 1.4 mm",
        "Head; 2 walls of cortex", "Comes out again", "Cannulated screw", "Step 11",
        "Screw 2.5 to 3 mm thick, 20 to 24 mm long",
        "Drill of 2 mm, then screw of 2.7 mm, 20, 22, 24 mm long",
        "First metatarsal, Head; 1 wall of cortex", "joint surface of the head, by at least 2 mm"})
    EXPECT_THAT(told, HasSubstr(words)) << "fixed";
  EXPECT_TRUE(briefed.driver().has("brief.implant.screw")) << "keys come to each";
}

TEST(BriefingScreen, NamesTheOtherWayToFixWhereOneSuffices) {
  SomePublished published;
  Briefed briefed(published);
  briefed.driver().click(tabs_of(briefed.driver())["Tray and fixation"]);
  briefed.driver().resize(1600.0F, 1800.0F);
  const std::string told = all_text(briefed.driver());
  EXPECT_THAT(told, HasSubstr("Or instead"));
  EXPECT_THAT(told, HasSubstr("Set two crossed wires"));
  EXPECT_THAT(told, HasSubstr("Set the screw"));
  EXPECT_THAT(told, Not(HasSubstr("What is shifted")));
  EXPECT_THAT(told, Not(HasSubstr("Forceps")));
}

TEST(BriefingScreen, ASawAloneHasNoTray) {
  SomePublished published;
  for (const scenarios::Scenario& scenario :
       {scenarios_test::format_1("silver"), scenarios_test::format_1("akin")}) {
    Briefed briefed(published, publish(published, scenario));
    EXPECT_THAT(tab_labels_of(briefed.driver()),
                UnorderedElementsAre("Why and what", "Steps", "Scoring"));
    EXPECT_THAT(all_text(briefed.driver()), HasSubstr("The saw: " + scenario.blade_name));
    briefed.driver().click("brief.tab.2");
    EXPECT_TRUE(briefed.driver().sees("Accuracy"));
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
  briefed.driver().resize(1440.0F, 1400.0F);
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

/// Each tab at that scale, in the smallest window and in larger ones.
void expect_nothing_cut_off(Briefed& briefed, float scale) {
  Driver& driver = briefed.driver();
  driver.resize(1440.0F * scale, 900.0F * scale);
  for (const auto& [label, tab] : tabs_of(driver)) {
    driver.resize(1440.0F * scale, 900.0F * scale);
    driver.click(tab);
    EXPECT_THAT(driver.faults(), IsEmpty()) << scale << label;
    for (const auto& [width, height] :
         {std::pair(1280.0F, 720.0F), std::pair(1280.0F, 800.0F), std::pair(3840.0F, 2160.0F)}) {
      driver.resize(width, height);
      EXPECT_THAT(driver.faults(), IsEmpty()) << scale << label << width;
    }
  }
}

TEST(BriefingScreen, NothingIsCutOffAtAnyScaleAndSize) {
  SomePublished published;
  const database::ScenarioVersionId chevron =
      publish(published, scenarios::load_shipped_scenario("chevron"));
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    for (const database::ScenarioVersionId scenario : {published.akin(), chevron}) {
      Briefed briefed(published, scenario, scale);
      expect_nothing_cut_off(briefed, scale);
    }
  }
}

}  // namespace
}  // namespace hallux::ui
