#include "database/desks/administrator_desk.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "database/audit/audit.h"
#include "database/records/code_form.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

class Administrator : public testing::Test, protected SomeCourse {
 protected:
  Session redeem(const std::string& login, std::string code, const char* password) {
    return redeem_code(database(), login, secret(std::move(code)), secret(password), cheap);
  }
  Person person(const std::string& login) { return find_person(database(), login); }
};

TEST_F(Administrator, AddsAPersonWhoChoosesAPasswordWithACode) {
  AdministratorDesk desk = administrator();
  const AddedPerson added = desk.add_person_with_code({"new", "", false}, cheap);
  const std::string code{added.issued.code.view()};
  EXPECT_EQ(code.size(), 14U) << "three groups of four";
  EXPECT_FALSE(person("new").has_password);
  EXPECT_EQ(person("new").code_expires_utc, added.issued.expires_utc);
  EXPECT_EQ(kind_thrown([&] { sign_in(database(), "new", secret(code), cheap); }),
            DatabaseErrorKind::Refused)
      << "a code is no password";
  EXPECT_EQ(redeem("new", code, good_password).person().id, added.id);
  EXPECT_NO_THROW(sign_in(database(), "new", secret(good_password), cheap));
  EXPECT_EQ(kind_thrown([&] { redeem("new", code, "another long phrase"); }),
            DatabaseErrorKind::Refused)
      << "once";
  EXPECT_TRUE(person("new").code_expires_utc.empty());
}

TEST_F(Administrator, IssuesCodesThatAreReadAsPeopleTypeThem) {
  AdministratorDesk desk = administrator();
  const AddedPerson added = desk.add_person_with_code({"new", "", false}, cheap);
  std::string typed;
  for (const char letter : added.issued.code.view()) {
    if (letter == '-') continue;
    typed += letter == '0' ? "o" : letter == '1' ? "l " : std::string(1, letter);
  }
  for (char& letter : typed) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter + 32);
  }
  EXPECT_NO_THROW(redeem("new", typed, good_password));
}

TEST_F(Administrator, IssuesCodesThatAreToldFromPasswords) {
  for (int i = 0; i < 50; ++i) {
    const SecretText code = random_code();
    const bool has_digit = code.view().find_first_of("0123456789") != std::string_view::npos;
    EXPECT_EQ(looks_like_code(code.view()), has_digit) << "one in ninety has none";
  }
  EXPECT_TRUE(looks_like_code("7qk2m9xd3vta"));
  EXPECT_TRUE(looks_like_code("7QK2 M9XD 3VTA"));
  for (const char* password : {"sawbonehinge", "saw bone hinge wire", "7QK2-M9XD-3VT",
                               "7QK2-M9XD-3VTAA", "7QU2-M9XD-3VTA", "", "7QK2-M9XD-3VT\xC3\xA4"})
    EXPECT_FALSE(looks_like_code(password)) << password;
}

TEST_F(Administrator, KeepsOfACodeItsHashOnly) {
  const AddedPerson added = administrator().add_person_with_code({"new", "", false}, cheap);
  std::string plain;
  for (const char letter : added.issued.code.view()) {
    if (letter != '-') plain.push_back(letter);
  }
  for (const auto& entry : std::filesystem::directory_iterator{database().directory()}) {
    if (!entry.is_regular_file()) continue;
    std::ifstream stream{entry.path(), std::ios::binary};
    const std::string bytes{std::istreambuf_iterator<char>{stream}, {}};
    EXPECT_EQ(bytes.find(plain), std::string::npos) << entry.path();
    EXPECT_EQ(bytes.find(added.issued.code.view()), std::string::npos) << entry.path();
  }
}

TEST_F(Administrator, IssuesCodesThatExpire) {
  database().pretend_it_is("2026-03-01T10:00:00.000Z");
  const AddedPerson added = administrator().add_person_with_code({"new", "", false}, cheap);
  const std::string code{added.issued.code.view()};
  EXPECT_EQ(added.issued.expires_utc, "2026-03-08T10:00:00.000Z");
  database().pretend_it_is("2026-03-08T10:00:00.001Z");
  EXPECT_EQ(kind_thrown([&] { redeem("new", code, good_password); }), DatabaseErrorKind::Refused);
  EXPECT_EQ(last_audit().action, "code_redeemed");
  EXPECT_TRUE(last_audit().was_refused);
  database().pretend_it_is("2026-03-08T09:59:59.000Z");
  EXPECT_NO_THROW(redeem("new", code, good_password));
}

TEST_F(Administrator, RefusesAWrongCodeAndAnUnknownLoginInTheSameWords) {
  administrator().add_person_with_code({"new", "", false}, cheap);
  const auto sentence = [&](const char* login) {
    try {
      redeem(login, "0000-0000-0000", good_password);
    } catch (const DatabaseError& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  std::string known = sentence("new");
  EXPECT_EQ(known.replace(known.find("new"), 3, "zoe"), sentence("zoe"));
}

TEST_F(Administrator, LeavesACodeThatWasGivenWithAWeakPassword) {
  const AddedPerson added = administrator().add_person_with_code({"new", "", false}, cheap);
  const std::string code{added.issued.code.view()};
  EXPECT_EQ(kind_thrown([&] { redeem("new", code, "short"); }), DatabaseErrorKind::BadInput);
  EXPECT_NO_THROW(redeem("new", code, good_password));
}

TEST_F(Administrator, ResetsAPersonWhoseOldPasswordIsThenWorthNothing) {
  AdministratorDesk desk = administrator();
  const IssuedCode first = desk.reset("ada", cheap);
  EXPECT_EQ(kind_thrown([&] { sign_in_as("ada"); }), DatabaseErrorKind::Refused);
  const IssuedCode second = desk.reset("ada", cheap);
  EXPECT_EQ(kind_thrown([&] { redeem("ada", std::string{first.code.view()}, good_password); }),
            DatabaseErrorKind::Refused)
      << "the newer code takes the place of the older";
  EXPECT_NO_THROW(redeem("ada", std::string{second.code.view()}, "another long phrase"));
  EXPECT_EQ(kind_thrown([&] { desk.reset("root", cheap); }), DatabaseErrorKind::Refused)
      << "nobody locks themselves out";
}

TEST_F(Administrator, RefusesTheCodeOfADisabledPerson) {
  AdministratorDesk desk = administrator();
  const IssuedCode issued = desk.reset("ada", cheap);
  desk.set_disabled("ada", true);
  EXPECT_EQ(kind_thrown([&] { redeem("ada", std::string{issued.code.view()}, good_password); }),
            DatabaseErrorKind::Refused);
}

TEST_F(Administrator, CorrectsANameOfWhichThePersonIsToldAndTheAuditKeepsTheOneBefore) {
  AdministratorDesk desk = administrator();
  desk.correct_name("ada", "Ada Ünal");
  EXPECT_EQ(person("ada").display_name, "Ada Ünal");
  const AuditEntry act = last_audit();
  EXPECT_EQ(act.action, "name_corrected");
  EXPECT_EQ(act.actor, id_of("root"));
  EXPECT_EQ(act.subject_id, std::to_string(id_of("ada").number));
  EXPECT_EQ(act.text, "ada");
  Session ada = sign_in_as("ada");
  ASSERT_EQ(ada.notices().size(), 1U);
  EXPECT_EQ(ada.notices()[0].kind, NoticeKind::NameCorrected);
  EXPECT_EQ(ada.notices()[0].login, "root");
  EXPECT_EQ(ada.person().display_name, "Ada Ünal");
}

TEST_F(Administrator, CorrectsTheOwnNameWithoutANoticeAndMayTakeANameAway) {
  administrator().correct_name("root", "Root Verwalter");
  EXPECT_TRUE(sign_in_as("root").notices().empty());
  administrator().correct_name("root", "");
  EXPECT_EQ(person("root").display_name, "root") << "the login stands in its place";
}

TEST_F(Administrator, RefusesANameThatHidesSomethingOrChangesNothing) {
  AdministratorDesk desk = administrator();
  const AuditEntry before = last_audit();
  for (const std::string& name : {std::string{"ada"}, std::string{"two\nlines"},
                                  std::string{"\xE2\x80\xAE"
                                              "ada"},
                                  std::string(201, 'a'), std::string{"\xFF"}}) {
    EXPECT_EQ(kind_thrown([&] { desk.correct_name("ada", name); }), DatabaseErrorKind::BadInput);
  }
  EXPECT_EQ(kind_thrown([&] { desk.correct_name("nobody", "N"); }), DatabaseErrorKind::NotFound);
  EXPECT_EQ(person("ada").display_name, "ada");
  EXPECT_EQ(last_audit().action, before.action);
}

TEST_F(Administrator, GivesAndTakesTheRole) {
  AdministratorDesk desk = administrator();
  desk.set_administrator("ada", true);
  Session ada = sign_in_as("ada");
  AdministratorDesk of_ada = *ada.administrator();
  EXPECT_NO_THROW(of_ada.people());
  desk.set_administrator("ada", false);
  EXPECT_EQ(kind_thrown([&] { of_ada.people(); }), DatabaseErrorKind::Refused)
      << "a desk does not outlive the right to it";
  EXPECT_FALSE(ada.administrator());
}

TEST_F(Administrator, CannotBeTheLastToGo) {
  AdministratorDesk desk = administrator();
  desk.set_disabled("max", true);
  desk.add_person_with_code({"new", "", true}, cheap);
  EXPECT_EQ(kind_thrown([&] { desk.set_disabled("root", true); }), DatabaseErrorKind::Refused);
  EXPECT_EQ(kind_thrown([&] { desk.set_administrator("root", false); }),
            DatabaseErrorKind::Refused);
  EXPECT_TRUE(person("root").is_administrator);
  EXPECT_FALSE(person("root").is_disabled);
  desk.set_disabled("max", false);
  EXPECT_NO_THROW(desk.set_administrator("root", false));
}

TEST_F(Administrator, ListsPeopleWithWhatAScreenShows) {
  database().pretend_it_is("2026-03-01T10:00:00.000Z");
  sign_in_as("ada");
  const auto people = administrator().people();
  ASSERT_EQ(people.size(), 7U);
  EXPECT_EQ(people[0].login, "ada");
  EXPECT_EQ(people[1].last_sign_in_utc, "") << "bob never came";
  EXPECT_FALSE(people[0].last_sign_in_utc.empty());
  EXPECT_TRUE(people[0].has_password);
}

TEST_F(Administrator, ReadsTheAuditWithNamesThatCanStillBeNamed) {
  AdministratorDesk desk = administrator();
  desk.enrol(spring(), "ada", CohortRole::Trainee);
  desk.set_disabled("bob", true);
  desk.add_cohort("winter");
  const AuditPage page = desk.audit_page({std::nullopt, 3, false});
  ASSERT_EQ(page.lines.size(), 3U);
  EXPECT_EQ(page.lines[0].subject, "winter");
  EXPECT_EQ(page.lines[1].subject, "bob");
  EXPECT_EQ(page.lines[1].actor, "root");
  EXPECT_EQ(page.lines[2].action, "enrolled_as_trainee");
  EXPECT_EQ(page.lines[2].subject, "ada");
  EXPECT_TRUE(page.older);
}

TEST_F(Administrator, PublishesOneVersionOfAnOperation) {
  AdministratorDesk desk = administrator();
  const ScenarioVersionId second = desk.import_scenario({"silver", 2, "{\"v\": 2}", true});
  const auto state_of = [&](ScenarioVersionId id) {
    return load_scenario_version(database(), id).state;
  };
  EXPECT_EQ(state_of(second), ScenarioState::Draft);
  EXPECT_EQ(trainee("ada").operations()[0].version, 1);
  desk.publish_scenario(second);
  EXPECT_EQ(state_of(published()), ScenarioState::Retired);
  ASSERT_EQ(trainee("ada").operations().size(), 1U);
  EXPECT_EQ(trainee("ada").operations()[0].version, 2);
  EXPECT_FALSE(trainee("ada").operations()[0].is_reviewed) << "whatever its text says of itself";
  desk.retire_scenario(second);
  EXPECT_TRUE(trainee("ada").operations().empty());
  desk.publish_scenario(published());
  EXPECT_EQ(trainee("ada").operations()[0].version, 1) << "a retired version can come back";
  const auto versions = desk.scenarios();
  ASSERT_EQ(versions.size(), 2U);
  EXPECT_EQ(versions[0].version, 2);
  EXPECT_EQ(versions[1].changed_by, "root");
}

TEST_F(Administrator, NeverLetsAPublishedNumberMeanAnotherText) {
  AdministratorDesk desk = administrator();
  constexpr auto bad = DatabaseErrorKind::BadInput;
  EXPECT_EQ(kind_thrown([&] {
              desk.import_scenario({"silver", 1, "{\"other\": 1}", false});
            }),
            bad);
  EXPECT_EQ(desk.import_scenario({"silver", 1, "{\"name\": \"silver\"}", false}), published())
      << "the same text is the same version";
  EXPECT_EQ(desk.scenarios().front().state, ScenarioState::Published);
  const ScenarioVersionId one = desk.import_scenario({"akin", 1, "{\"a\": 1}", false});
  const ScenarioVersionId two = desk.import_scenario({"akin", 1, "{\"a\": 2}", false});
  desk.publish_scenario(one);
  EXPECT_EQ(kind_thrown([&] { desk.publish_scenario(two); }), bad)
      << "drafts may, the published not";
  EXPECT_EQ(kind_thrown([&] { desk.publish_scenario(one); }), bad);
  EXPECT_EQ(kind_thrown([&] { desk.retire_scenario(two); }), bad);
  EXPECT_EQ(kind_thrown([&] { desk.publish_scenario({99}); }), DatabaseErrorKind::NotFound);
}

TEST_F(Administrator, SeesInTheCatalogueOnlyWhatWasImported) {
  NewAttempt attempt = some_attempt(database());
  attempt.scenario = put_scenario_version(database(), {"mine", 1, "{\"mine\": 1}", false});
  record(database(), attempt, some_recording(5));
  EXPECT_EQ(administrator().scenarios().size(), 1U);
}

}  // namespace

}  // namespace hallux::database
