// Cohorts and scenario versions, as an administrator uses them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/ui/screens/administrator/some_desk.h"
#include "ui/jobs/course/scenario_jobs.h"
#include "ui/screens/administrator/cohorts_screen.h"
#include "ui/screens/administrator/scenarios_screen.h"

namespace hallux::ui {
namespace {

using testing::Contains;
using testing::IsEmpty;

// -- cohorts

std::vector<std::string> members_of(database::SomeCourse& course, database::CohortId cohort) {
  std::vector<std::string> members;
  for (const database::CohortMember& member : course.administrator().members(cohort))
    members.push_back(member.login +
                      (member.role == database::CohortRole::Instructor ? " teaches" : " learns"));
  return members;
}

TEST(CohortsScreen, AddsACohortAndRefusesItsNameTwice) {
  database::SomeCourse course;
  Desk<CohortsScreen> desk(course);
  desk.press("cohorts.add");
  desk.type("autumn");
  desk.driver().press(Key::Enter);
  desk.visitor.finish_work();
  EXPECT_TRUE(desk.driver().sees("There is a cohort 'autumn' already"));
  desk.driver().click("cohorts.new.name");
  desk.driver().press(Key::End);
  desk.type(" 2027");
  desk.press("cohorts.new.act");
  EXPECT_TRUE(desk.driver().sees("autumn 2027 was added"));
  EXPECT_EQ(course.administrator().cohorts().size(), 3U);
}

TEST(CohortsScreen, LimitsTheAssessmentsOfACohort) {
  database::SomeCourse course;
  Desk<CohortsScreen> desk(course);  // autumn is chosen
  desk.press("cohorts.limits");
  EXPECT_TRUE(desk.driver().sees("Assessments in autumn"));
  EXPECT_TRUE(desk.driver().sees("no limit"));
  desk.press("limits.row.silver");
  desk.press("limits.number");
  desk.type("1001");
  EXPECT_FALSE(desk.driver().widget("limits.act").is_enabled);
  desk.driver().press(Key::Backspace);
  desk.press("limits.act");
  EXPECT_TRUE(desk.driver().sees("Silver: 100 assessments each in autumn"));
  EXPECT_EQ(course.administrator().limits(course.autumn()).at(0).attempts_max, 100);
  desk.press("cohorts.limits");
  desk.press("limits.keep");
  EXPECT_FALSE(desk.driver().has("limits.act"));
}

TEST(CohortsScreen, EnrolsSeveralAtOnce) {
  database::SomeCourse course;
  Desk<CohortsScreen> desk(course);  // autumn is chosen
  desk.press("cohorts.enrol");
  EXPECT_FALSE(desk.driver().has("cohorts.enrolment.row.ada")) << "is in it already";
  desk.press("cohorts.enrolment.row.eve");
  desk.press("cohorts.enrolment.row.max");
  desk.press("cohorts.enrolment.role.1");
  EXPECT_TRUE(desk.driver().sees("Enrol 2 instructors"));
  desk.press("cohorts.enrolment.act");
  EXPECT_THAT(members_of(course, course.autumn()), Contains("eve teaches"));
  EXPECT_THAT(members_of(course, course.autumn()), Contains("max teaches"));
  EXPECT_TRUE(desk.driver().has("cohorts.member.eve"));
}

TEST(CohortsScreen, ChangesARoleAndAsksBeforeItRemoves) {
  database::SomeCourse course;
  Desk<CohortsScreen> desk(course);
  desk.press("cohorts.member.ada");
  desk.press("cohorts.action.0");
  EXPECT_THAT(members_of(course, course.autumn()), Contains("ada teaches"));
  desk.press("cohorts.action.1");
  EXPECT_TRUE(desk.driver().sees("Their attempts stay theirs"));
  desk.press("cohorts.question.keep");
  EXPECT_THAT(members_of(course, course.autumn()), Contains("ada teaches"));
  desk.press("cohorts.action.1");
  desk.press("cohorts.question.act");
  EXPECT_FALSE(desk.driver().has("cohorts.member.ada"));
  EXPECT_EQ(members_of(course, course.autumn()).size(), 3U);
}

TEST(CohortsScreen, ARemovalThatFailsIsSaid) {
  database::SomeCourse course;
  Desk<CohortsScreen> desk(course);
  course.administrator().remove_from_cohort(course.autumn(), "ada");
  desk.press("cohorts.member.ada");
  desk.press("cohorts.action.1");
  desk.press("cohorts.question.act");
  EXPECT_TRUE(desk.driver().sees("Nothing was changed"));
}

TEST(CohortsScreen, IsUsedByKeyboardAlone) {
  database::SomeCourse course;
  Desk<CohortsScreen> desk(course);
  press_by_keyboard(desk.visitor, "cohorts.row." + std::to_string(course.autumn().number));
  desk.driver().press(Key::Down);
  desk.driver().press(Key::Enter);
  press_by_keyboard(desk.visitor, "cohorts.enrol");
  desk.type("bob");
  for (int tab = 0; tab < 20 && desk.driver().focused() != "cohorts.enrolment.row.bob"; ++tab)
    desk.driver().press(Key::Tab);
  desk.driver().press(Key::Space);
  press_by_keyboard(desk.visitor, "cohorts.enrolment.act");
  EXPECT_THAT(members_of(course, course.spring()), Contains("bob learns"));
}

TEST(CohortsScreen, NothingIsCutOffAnywhere) {
  database::SomeCourse course;
  course.administrator().add_cohort("A cohort with quite a long name that somebody gave it");
  const auto make = [&] { return std::make_unique<CohortsScreen>(visit_of(course, "root")); };
  const auto shows = [&](const std::vector<std::string>& ids) {
    return faults_at_every_size(make, [&ids](SomeVisitor& visitor) {
      for (const std::string& id : ids) {
        visitor.driver().click(id);
        visitor.finish_work();
      }
    });
  };
  EXPECT_THAT(shows({}), IsEmpty());
  const std::string autumn = "cohorts.row." + std::to_string(course.autumn().number);
  EXPECT_THAT(shows({autumn, "cohorts.member.ada"}), IsEmpty());
  EXPECT_THAT(shows({"cohorts.enrol"}), IsEmpty());
  EXPECT_THAT(shows({"cohorts.add"}), IsEmpty());
}

// -- scenarios

/// The shipped scenario under another number, in a file of its own.
struct ScenarioFile {
  explicit ScenarioFile(database::SomeCourse& course, const std::string& changed_from = {},
                        const std::string& changed_to = {})
      : path(course.database().directory() / "scenario.json") {
    std::string text = list_scenarios().front().text;
    const std::size_t at = text.find(changed_from);
    if (!changed_from.empty()) text.replace(at, changed_from.size(), changed_to);
    std::ofstream(path) << text;
  }
  std::filesystem::path path;
};

/// An operation of another name whose patient is built and sawn in a moment, with the shipped
/// Silver's rubric and no fault to prove it by. `lists_impossible` adds one that costs nothing of
/// what it is said to cost.
std::filesystem::path quick_scenario(database::SomeCourse& course, bool lists_impossible = false) {
  auto text = nlohmann::ordered_json::parse(scenarios::load_shipped_scenario("silver").text);
  text["name"] = "eminence";
  text["patient"]["bones"][0]["edge_mm"] = 1;
  text.erase("proof");
  if (lists_impossible) text["proof"] = {{{"fault", "dry"}, {"items", {"A1"}}}};
  std::filesystem::path path = course.database().directory() / "eminence.json";
  std::ofstream(path) << text.dump(1);
  return path;
}

void import(Desk<ScenariosScreen>& desk, const std::filesystem::path& file) {
  desk.press("scenarios.import");
  desk.type(file.string());
  desk.press("scenarios.file.act");
}

database::ScenarioVersion version_of(database::SomeCourse& course, const std::string& name) {
  for (const database::ScenarioVersion& version : course.administrator().scenarios())
    if (version.name == name) return version;
  ADD_FAILURE() << "no scenario " << name;
  return {};
}

TEST(ScenariosScreen, AFileIsCheckedImportedReadPublishedAndRetired) {
  database::SomeCourse course;
  const std::filesystem::path file = quick_scenario(course);
  Desk<ScenariosScreen> desk(course);
  import(desk, file);
  EXPECT_TRUE(desk.driver().sees("The scenario was taken in as a draft"));
  const database::ScenarioVersion draft = version_of(course, "eminence");
  EXPECT_EQ(draft.state, database::ScenarioState::Draft);
  EXPECT_TRUE(desk.driver().sees("Indication")) << "its sheet";
  EXPECT_TRUE(desk.driver().sees("Not surgeon-reviewed"));
  desk.press("scenarios.publish");
  EXPECT_TRUE(desk.driver().sees("No surgeon has reviewed this version"));
  EXPECT_TRUE(desk.driver().sees("Its rubric is proven first"));
  desk.press("scenarios.question.keep");
  EXPECT_EQ(version_of(course, "eminence").state, database::ScenarioState::Draft);
  desk.press("scenarios.publish");
  desk.press("scenarios.question.act");
  EXPECT_EQ(version_of(course, "eminence").state, database::ScenarioState::Published);
  EXPECT_TRUE(desk.driver().sees("lists no faults to prove its rubric by"));
  desk.press("scenarios.retire");
  desk.press("scenarios.question.act");
  EXPECT_EQ(version_of(course, "eminence").state, database::ScenarioState::Retired);
}

TEST(ScenariosScreen, ARubricThatIsNotProvenIsNotPublished) {
  database::SomeCourse course;
  Desk<ScenariosScreen> desk(course);
  import(desk, quick_scenario(course, true));
  desk.press("scenarios.publish");
  desk.press("scenarios.question.act");
  EXPECT_EQ(version_of(course, "eminence").state, database::ScenarioState::Draft);
  EXPECT_TRUE(desk.driver().sees("is not published"));
  EXPECT_TRUE(desk.driver().sees("dry: A1 loses 0 of"));
}

TEST(ScenariosScreen, AWrongFileIsRefusedWithTheWholeFault) {
  database::SomeCourse course;
  const ScenarioFile file(course, "\"name\"", "\"nome\"");
  std::string fault;
  try {
    check_scenario_file(file.path);
  } catch (const std::exception& error) {
    fault = error.what();
  }
  ASSERT_FALSE(fault.empty());
  Desk<ScenariosScreen> desk(course);
  const std::size_t known = course.administrator().scenarios().size();
  import(desk, file.path);
  EXPECT_TRUE(desk.driver().sees("The file was not taken in"));
  const std::string shown = all_text(desk.driver());
  for (std::size_t begin = 0; begin < fault.size();) {
    const std::size_t end = std::min(fault.find(' ', begin), fault.size());
    if (end - begin < 20) {  // longer ones are broken between lines
      const std::string word = fault.substr(begin + (begin == 0 ? 1 : 0), end - begin - 1);
      EXPECT_NE(shown.find(word), std::string::npos) << word;
    }
    begin = end + 1;
  }
  EXPECT_EQ(course.administrator().scenarios().size(), known);
  EXPECT_TRUE(desk.driver().sees(file.path.string())) << "what was typed stays";
}

TEST(ScenariosScreen, AFileWhoseStartViewHidesItsCutIsRefusedWithWhatHidesIt) {
  database::SomeCourse course;
  const ScenarioFile file(course, "\"radius_mm\": 36", "\"radius_mm\": 5");
  Desk<ScenariosScreen> desk(course);
  const std::size_t known = course.administrator().scenarios().size();
  import(desk, file.path);
  EXPECT_TRUE(desk.driver().sees("The file was not taken in"));
  EXPECT_TRUE(desk.driver().sees("this view hides its own cut"));
  EXPECT_TRUE(desk.driver().sees("raise radius_mm"));
  EXPECT_EQ(course.administrator().scenarios().size(), known);
}

TEST(ScenariosScreen, PublishingSaysWhatItRetires) {
  database::SomeCourse course;
  course.administrator().import_scenario({"silver", 2, "{\"name\": \"silver\"} ", false});
  Desk<ScenariosScreen> desk(course);
  desk.press("scenarios.publish");  // version 2 is on top and chosen
  EXPECT_TRUE(desk.driver().sees("Silver, version 1 is retired in its place"));
}

TEST(ScenariosScreen, ASheetThatCannotBeReadSaysSo) {
  database::SomeCourse course;  // its scenario is no whole one
  Desk<ScenariosScreen> desk(course);
  EXPECT_TRUE(desk.driver().sees("This could not be read"));
  EXPECT_TRUE(desk.driver().has("scenarios.retire")) << "the rest can be used";
}

TEST(ScenariosScreen, IsUsedByKeyboardAlone) {
  database::SomeCourse course;
  const std::filesystem::path file = quick_scenario(course);
  Desk<ScenariosScreen> desk(course);
  press_by_keyboard(desk.visitor, "scenarios.import");
  desk.type(file.string());
  desk.driver().press(Key::Enter);
  desk.visitor.finish_work();
  press_by_keyboard(desk.visitor, "scenarios.publish");
  EXPECT_EQ(desk.driver().focused(), "scenarios.question.keep") << "the safe answer";
  press_by_keyboard(desk.visitor, "scenarios.question.act");
  EXPECT_EQ(version_of(course, "eminence").state, database::ScenarioState::Published);
}

TEST(ScenariosScreen, NothingIsCutOffAnywhere) {
  database::SomeCourse course;
  const ScenarioFile file(course);
  course.administrator().import_scenario({"akin", 1, list_scenarios().front().text, false});
  const auto make = [&] { return std::make_unique<ScenariosScreen>(visit_of(course, "root")); };
  EXPECT_THAT(faults_at_every_size(make), IsEmpty());
  EXPECT_THAT(faults_at_every_size(make,
                                   [](SomeVisitor& visitor) {
                                     visitor.driver().click("scenarios.import");
                                     visitor.driver().type("/there/is/no/such/file.json");
                                     visitor.driver().press(Key::Enter);
                                   }),
              IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
