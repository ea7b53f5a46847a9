#include "ui/screens/administrator/people_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <thread>

#include "database/people/people.h"
#include "tests/ui/screens/every_size.h"
#include "ui/widgets/ui_map.h"

namespace hallux::ui {
namespace {

using database::cheap;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// An administrator in front of the people.
struct Office {
  explicit Office(database::SomeCourse& of, const std::string& login = "root")
      : course(of), visitor(std::make_unique<PeopleScreen>(visit_of(of, login), cheap)) {}
  Driver& driver() { return visitor.driver(); }
  void press(std::string_view id) {
    driver().click(id);
    visitor.finish_work();
  }
  void choose(const std::string& login) { press("people.row." + login); }
  database::Person person(const std::string& login) {
    return database::find_person(course.database(), login);
  }

  database::SomeCourse& course;
  SomeVisitor visitor;
};

TEST(PeopleScreen, ListsEverybodyWithRoleAndCohorts) {
  database::SomeCourse course;
  Office office(course);
  for (const char* words : {"root", "ada", "kim", "Administrator", "Trainee", "Instructor",
                            "autumn, spring", "All 7", "Active 7"})
    EXPECT_TRUE(office.driver().sees(words)) << words;
  EXPECT_THAT(office.driver().faults(), IsEmpty());
}

TEST(PeopleScreen, SearchesByLoginAndName) {
  database::SomeCourse course;
  course.administrator().add_person_with_code({"trainee-9", "Mara Quill", false}, cheap);
  Office office(course);
  office.driver().press(Key::Slash);
  office.driver().type("mara");
  EXPECT_TRUE(office.driver().has("people.row.trainee-9"));
  EXPECT_FALSE(office.driver().has("people.row.ada"));
  office.driver().type("xyz");
  EXPECT_TRUE(office.driver().sees("Nobody found"));
}

TEST(PeopleScreen, SortsByItsHeadsAndSortsBack) {
  database::SomeCourse course;
  Office office(course);
  const auto is_above = [&](const char* a, const char* b) {
    return office.driver().widget(std::string("people.row.") + a).rect.y <
           office.driver().widget(std::string("people.row.") + b).rect.y;
  };
  office.press("people.row.sort.1");
  EXPECT_TRUE(is_above("ada", "root"));
  office.press("people.row.sort.1");
  EXPECT_TRUE(is_above("root", "ada"));
}

TEST(PeopleScreen, ANewPersonComesInWithTheCodeThatIsShownOnce) {
  database::SomeCourse course;
  Office office(course);
  office.press("people.add");
  office.driver().type("trainee-9");
  office.driver().press(Key::Tab);
  office.driver().type("Mara Quill");
  office.driver().press(Key::Enter);
  office.visitor.finish_work();
  ASSERT_TRUE(office.driver().has("people.code.copy"));
  EXPECT_TRUE(office.driver().sees("One-time code of trainee-9"));
  office.press("people.code.copy");
  std::string code = office.driver().clipboard().read();
  ASSERT_FALSE(code.empty());
  for (const std::string& text : office.driver().texts()) EXPECT_THAT(text, Not(HasSubstr(code)));
  EXPECT_THAT(ui_map_json(office.driver().content(), 1.0F), Not(HasSubstr(code)));
  EXPECT_EQ(database::redeem_code(course.database(), "trainee-9", database::SecretText::take(code),
                                  database::secret(database::good_password), cheap)
                .person()
                .display_name,
            "Mara Quill");
  office.press("people.code.done");
  EXPECT_FALSE(office.driver().has("people.code.copy"));
  EXPECT_TRUE(office.driver().has("people.row.trainee-9"));
}

TEST(PeopleScreen, ALoginThatIsTakenIsSaidAndWhatWasTypedStays) {
  database::SomeCourse course;
  Office office(course);
  office.press("people.add");
  office.driver().type("ada");
  office.driver().press(Key::Enter);
  office.visitor.finish_work();
  EXPECT_TRUE(office.driver().sees("The login 'ada' is taken"));
  EXPECT_TRUE(office.driver().has("people.add.act"));
  office.driver().click("people.add.login");
  office.driver().press(Key::End);
  office.driver().type("-2");
  office.press("people.add.act");
  EXPECT_TRUE(office.driver().has("people.code.copy")) << "the rest was still there";
  EXPECT_EQ(office.person("ada-2").login, "ada-2");
}

TEST(PeopleScreen, DisablingAsksFirst) {
  database::SomeCourse course;
  Office office(course);
  office.choose("ada");
  office.press("people.disable");
  office.press("people.question.keep");
  EXPECT_FALSE(office.person("ada").is_disabled);
  office.press("people.disable");
  office.press("people.question.act");
  EXPECT_TRUE(office.person("ada").is_disabled);
  EXPECT_TRUE(office.driver().sees("ada is disabled"));
  EXPECT_TRUE(office.driver().sees("Disabled 1"));
  office.press("people.enable");
  EXPECT_FALSE(office.person("ada").is_disabled);
}

/// Fills the dialog by keyboard; the login's field has the focus.
void write_erasure(Office& office, const char* login, const char* reason, const char* password) {
  office.press("people.erase");
  office.driver().type(login);
  for (const char* words : {reason, password}) {
    office.driver().press(Key::Tab);
    office.driver().type(words);
  }
}

TEST(PeopleScreen, ErasesOnceLoginReasonAndOwnPasswordAreThere) {
  database::SomeCourse course;
  Office office(course);
  office.choose("ada");
  write_erasure(office, "bob", "asked for it", database::good_password);
  EXPECT_FALSE(office.driver().widget("people.erase.act").is_enabled) << "not the login of ada";
  office.press("people.erase.keep");
  write_erasure(office, "ada", "asked for it", database::good_password);
  office.press("people.erase.act");
  EXPECT_THAT(all_text(office.driver()), HasSubstr("The person was erased"));
  EXPECT_FALSE(office.driver().has("people.row.ada"));
  EXPECT_FALSE(database::known_person(course.database(), "ada"));
  EXPECT_THAT(office.driver().faults(), IsEmpty());
}

TEST(PeopleScreen, AWrongPasswordErasesNobodyAndWhatWasTypedStays) {
  database::SomeCourse course;
  Office office(course);
  office.choose("ada");
  write_erasure(office, "ada", "asked for it", "not my password");
  office.press("people.erase.act");
  EXPECT_THAT(all_text(office.driver()), HasSubstr("password is wrong"));
  EXPECT_TRUE(office.driver().has("people.erase.act"));
  EXPECT_TRUE(database::known_person(course.database(), "ada"));
}

TEST(PeopleScreen, CorrectsANameOfWhichThePersonIsTold) {
  database::SomeCourse course("Bbo");
  Office office(course);
  office.choose("bob");
  office.press("people.rename");
  EXPECT_FALSE(office.driver().widget("people.rename.act").is_enabled) << "nothing was changed yet";
  office.driver().press(Key::A, {.control = true});
  office.driver().type("Bob Žižka");
  office.press("people.rename.act");
  EXPECT_EQ(office.person("bob").display_name, "Bob Žižka");
  EXPECT_TRUE(office.driver().sees("bob is called Bob Žižka now"));
  office.visitor.finish_work();
  EXPECT_TRUE(office.driver().sees("Bob Žižka"));
  EXPECT_EQ(course.sign_in_as("bob").notices().at(0).kind, database::NoticeKind::NameCorrected);
}

TEST(PeopleScreen, ANameThatIsRefusedStaysWritten) {
  database::SomeCourse course;
  Office office(course);
  office.choose("ada");
  office.press("people.rename");
  office.driver().press(Key::A, {.control = true});
  office.driver().type("a\u202Eda");
  office.press("people.rename.act");
  EXPECT_THAT(all_text(office.driver()), HasSubstr("letters that nobody sees"));
  EXPECT_TRUE(office.driver().has("people.rename.name"));
  EXPECT_EQ(office.person("ada").display_name, "ada");
}

TEST(PeopleScreen, ExportsWhatIsKeptOfSomebody) {
  database::SomeCourse course;
  Office office(course);
  office.choose("ada");
  office.press("people.export");
  const std::filesystem::path folder = course.database().directory().parent_path() / "of-ada";
  office.driver().press(Key::A, {.control = true});
  office.driver().type(folder.string());
  office.press("people.export.act");
  EXPECT_TRUE(std::filesystem::exists(folder / "explanation.txt"));
  EXPECT_EQ(course.last_audit().action, "person_exported");
}

TEST(PeopleScreen, NamesOfEveryLengthAndScriptAreShown) {
  database::SomeCourse course;
  const std::string name = "Ґалаґан 漢字 שלום \U0001F600 " + std::string(140, 'W');
  course.administrator().correct_name("ada", name);
  const auto make = [&] { return std::make_unique<PeopleScreen>(visit_of(course, "root"), cheap); };
  EXPECT_THAT(faults_at_every_size(
                  make, [](SomeVisitor& visitor) { visitor.driver().click("people.row.ada"); }),
              IsEmpty());
}

TEST(PeopleScreen, ALoginThatIsNotAllowedIsToldAtOnce) {
  database::SomeCourse course;
  Office office(course);
  office.press("people.add");
  office.driver().type("Trainee");
  EXPECT_TRUE(office.driver().sees("with a letter first"));
  EXPECT_FALSE(office.driver().widget("people.add.act").is_enabled);
}

TEST(PeopleScreen, NobodyErasesThemselves) {
  database::SomeCourse course;
  Office office(course);
  office.choose("root");
  EXPECT_FALSE(office.driver().widget("people.erase").is_enabled);
  EXPECT_TRUE(office.driver().sees("Nobody erases themselves"));
}

TEST(PeopleScreen, TheLastAdministratorCannotBeDisabledAndTheButtonSaysWhy) {
  database::SomeCourse course;
  course.administrator().set_disabled("max", true);
  Office office(course);
  office.choose("root");
  EXPECT_FALSE(office.driver().widget("people.disable").is_enabled);
  EXPECT_FALSE(office.driver().widget("people.administrator").is_enabled);
  EXPECT_TRUE(office.driver().sees("The last administrator who can"));
}

TEST(PeopleScreen, WhatTheDeskRefusesIsSaidAndChangesNothing) {
  database::SomeCourse course;
  Office office(course);  // lists root and max
  course.administrator().set_administrator("max", false);
  office.choose("root");
  office.press("people.administrator");
  office.press("people.question.act");
  EXPECT_TRUE(office.driver().sees("Nothing was changed"));
  EXPECT_THAT(all_text(office.driver()), HasSubstr("make another administrator first"));
  EXPECT_TRUE(office.person("root").is_administrator);
}

TEST(PeopleScreen, AResetAsksAndShowsANewCode) {
  database::SomeCourse course;
  Office office(course);
  office.choose("bob");
  office.press("people.reset");
  EXPECT_TRUE(office.driver().sees("stops working at once"));
  office.press("people.question.act");
  EXPECT_TRUE(office.driver().sees("One-time code of bob"));
  EXPECT_FALSE(office.person("bob").has_password);
  office.press("people.code.done");
  EXPECT_TRUE(office.driver().sees("Invited 1"));
  office.choose("root");
  EXPECT_FALSE(office.driver().widget("people.reset").is_enabled) << "not oneself";
}

TEST(PeopleScreen, IsUsedByKeyboardAlone) {
  database::SomeCourse course;
  Office office(course);
  press_by_keyboard(office.visitor, "people.row.ada");
  press_by_keyboard(office.visitor, "people.administrator");
  EXPECT_TRUE(office.person("ada").is_administrator);
  press_by_keyboard(office.visitor, "people.disable");
  EXPECT_EQ(office.driver().focused(), "people.question.keep") << "the safe answer";
  office.driver().press(Key::Escape);
  office.visitor.finish_work();
  EXPECT_FALSE(office.person("ada").is_disabled);
  press_by_keyboard(office.visitor, "people.add");
  office.driver().type("trainee-9");
  office.driver().press(Key::Enter);
  office.visitor.finish_work();
  EXPECT_EQ(office.driver().focused(), "people.code.copy");
  press_by_keyboard(office.visitor, "people.code.done");
  EXPECT_TRUE(office.driver().has("people.row.trainee-9"));
}

TEST(PeopleScreen, WhoIsNoAdministratorSeesNobody) {
  database::SomeCourse course;
  Office office(course, "ada");
  EXPECT_TRUE(office.driver().sees("This could not be read"));
  EXPECT_FALSE(office.driver().sees("bob"));
  EXPECT_TRUE(office.driver().has("people.failed.action"));
}

TEST(PeopleScreen, ShowsNoListWhileItIsRead) {
  database::SomeCourse course;
  const std::shared_ptr<SignedInSession> signed_in = visit_of(course, "root");
  std::promise<void> may_go_on;
  std::promise<void> has_turn;
  const std::jthread other([&] {
    signed_in->in_turn([&](auto&, auto&) {
      has_turn.set_value();
      may_go_on.get_future().wait();
    });
  });
  has_turn.get_future().wait();
  {
    Shell shell;
    const Texts texts = english_texts();
    Driver driver(texts, [&](Ui& ui) { shell.draw(ui); });
    shell.push(std::make_unique<PeopleScreen>(signed_in, cheap));
    driver.frame();
    driver.wait(0.4);
    EXPECT_FALSE(driver.has("people.row.ada"));
    EXPECT_FALSE(driver.sees("This could not be read"));
    EXPECT_TRUE(driver.has("people.search")) << "the page is there meanwhile";
    EXPECT_THAT(driver.faults(), IsEmpty());
    may_go_on.set_value();
  }
}

TEST(PeopleScreen, ScrollsOnlyForReasonsThatHaveNoRoom) {
  database::SomeCourse course;
  Office office(course);
  EXPECT_FALSE(office.driver().has("people.page"));
  office.choose("ada");
  EXPECT_FALSE(office.driver().has("people.page")) << "her card is half as high as the window";
  office.driver().resize(1280.0F, 720.0F);
  office.driver().settle();
  EXPECT_FALSE(office.driver().has("people.page"));
  office.choose("root");
  EXPECT_TRUE(office.driver().has("people.page")) << "four reasons stand below the buttons";
}

TEST(PeopleScreen, NothingIsCutOffAnywhere) {
  database::SomeCourse course;
  course.administrator().add_person_with_code(
      {"a-very-long-login-that-somebody-chose", "Somebody With A Very Long Name Of Many Words",
       false},
      cheap);
  course.administrator().set_disabled("max", true);
  const auto make = [&] { return std::make_unique<PeopleScreen>(visit_of(course, "root"), cheap); };
  EXPECT_THAT(faults_at_every_size(make), IsEmpty());
  EXPECT_THAT(faults_at_every_size(
                  make, [](SomeVisitor& visitor) { visitor.driver().click("people.row.root"); }),
              IsEmpty());
  EXPECT_THAT(faults_at_every_size(make,
                                   [](SomeVisitor& visitor) {
                                     visitor.driver().click("people.add");
                                     visitor.driver().type("ada");
                                     visitor.driver().press(Key::Enter);
                                   }),
              IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
