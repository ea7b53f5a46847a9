/// Old databases, stored as the program of their time wrote them, are opened by the program of
/// today.
#include "database/store/migrations.h"
#include "database/course/measurements.h"
#include "database/course/scores.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "database/maintenance/verify.h"
#include "database/people/hand_settings.h"
#include "database/recording/display_facts.h"
#include "database/recording/recordings.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

/// A stored database of an old schema in a directory of its own.
fs::path place(const TemporaryDirectory& temporary, const char* name) {
  fs::create_directories(temporary.data());
  fs::copy_file(fs::path{HALLUX_OLD_DATABASES} / name, temporary.data() / "hallux.db");
  return temporary.data();
}

std::int64_t number(Database& database, const char* query) {
  SQLite::Statement row{database.connection(), query};
  row.executeStep();
  return row.getColumn(0).getInt64();
}

TEST(Migrations, OpenADatabaseOfSchemaOneAndKeepItsRows) {
  const TemporaryDirectory temporary;
  Database database = Database::open(place(temporary, "schema_1.db"));
  EXPECT_EQ(number(database, "PRAGMA user_version"), newest_schema());
  const auto attempts = list_attempts(database);
  ASSERT_EQ(attempts.size(), 1U);
  EXPECT_EQ(attempts[0].scenario_name, "akin");
  EXPECT_EQ(attempts[0].state, AttemptState::Closed);
  EXPECT_EQ(attempts[0].begun.kind, AttemptKind::Practice);
  EXPECT_FALSE(attempts[0].is_simulated);
  EXPECT_FALSE(attempts[0].decision);
  EXPECT_TRUE(attempts[0].is_complete);
  EXPECT_TRUE(load_score(database, attempts[0].id));
  EXPECT_EQ(load_recording(database, attempts[0].id).samples.size(),
            static_cast<std::size_t>(*attempts[0].duration_ticks));
  EXPECT_FALSE(is_published(database, attempts[0].begun.scenario));
}

TEST(Migrations, OpenADatabaseOfSchemaTwoWhoseAttemptsNothingGuided) {
  const TemporaryDirectory temporary;
  Database database = Database::open(place(temporary, "schema_2.db"));
  EXPECT_EQ(number(database, "PRAGMA user_version"), newest_schema());
  const auto attempts = list_attempts(database);
  ASSERT_EQ(attempts.size(), 1U);
  EXPECT_EQ(attempts[0].begun.guidance, simulator::Guidance::None);
  EXPECT_EQ(attempts[0].begun.kind, AttemptKind::Practice);
  EXPECT_EQ(attempts[0].begun.engine, 4);
  EXPECT_THROW(
      database.connection().exec("UPDATE attempt SET guidance = 'soft', kind = 'assessment'"),
      SQLite::Exception);
  EXPECT_EQ(load_recording(database, attempts[0].id).samples.size(),
            static_cast<std::size_t>(*attempts[0].duration_ticks));
  const Verification found = verify(database);
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_EQ(found.audit_rows, 9);  // with the baseline
  EXPECT_TRUE(found.covered_since_utc.has_value());
  EXPECT_EQ(
      sign_in(database, "ada", secret("saw bone hinge wire")).administrator()->people().size(), 3U);
}

TEST(Migrations, OpenADatabaseOfSchemaThreeWithItsCourseAndDecisions) {
  const TemporaryDirectory temporary;
  Database database = Database::open(place(temporary, "schema_3.db"));
  EXPECT_EQ(number(database, "PRAGMA user_version"), newest_schema());
  EXPECT_EQ(number(database, "SELECT count(*) FROM attempt WHERE is_valid = 1"), 5);
  EXPECT_EQ(number(database, "SELECT count(*) FROM attempt WHERE is_valid IS NULL"), 1)
      << "the interrupted one";
  EXPECT_EQ(number(database, "SELECT count(*) FROM attempt WHERE guidance = 'soft'"), 1);
  EXPECT_EQ(number(database, "SELECT count(*) FROM decision WHERE kind = 'overridden'"), 1);
  const Verification found = verify(database);
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_EQ(found.scores, 6);
  Session kim = sign_in(database, "kim", secret(good_password));
  EXPECT_EQ(kim.instructor_of(CohortId{1})->help_requests().size(), 1U);
}

TEST(Migrations, OpenADatabaseOfSchemaFourAndCoverItFromThenOn) {
  const TemporaryDirectory temporary;
  const fs::path directory = place(temporary, "schema_4.db");
  Database database = Database::open(directory);
  EXPECT_EQ(number(database, "SELECT count(*) FROM attempt"), 1);
  EXPECT_EQ(number(database, "SELECT count(*) FROM person WHERE is_disabled = 1"), 1);
  const Verification found = verify(database);
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_EQ(found.covered_since_utc->substr(0, 2), "20");
  tamper(database, "UPDATE person SET is_disabled = 0");
  EXPECT_NE(verify(database).first_damage.value_or("").find("person "), std::string::npos);
}

TEST(Migrations, OpenADatabaseOfSchemaFiveInWhichNobodySawAnything) {
  const TemporaryDirectory temporary;
  Database database = Database::open(place(temporary, "schema_5.db"));
  EXPECT_EQ(number(database, "PRAGMA user_version"), newest_schema());
  const auto attempts = list_attempts(database);
  ASSERT_EQ(attempts.size(), 2U);
  for (const AttemptHeader& attempt : attempts)
    EXPECT_TRUE(load_display_facts(database, attempt.id).empty());
  EXPECT_EQ(number(database, "SELECT count(*) FROM help_request WHERE answer IS NULL"), 1);
  const Verification found = verify(database);
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_EQ(found.audit_rows, 37) << "covered before, and by no second baseline";
}

TEST(Migrations, OpenADatabaseOfSchemaSixInWhichNobodyChoseAHand) {
  const TemporaryDirectory temporary;
  Database database = Database::open(place(temporary, "schema_6.db"));
  EXPECT_EQ(number(database, "PRAGMA user_version"), newest_schema());
  EXPECT_EQ(number(database, "SELECT count(*) FROM display_fact"), 1);
  EXPECT_EQ(load_hand_settings(database, PersonId{2}), HandSettings{});
  EXPECT_EQ(verify(database).first_damage.value_or("none"), "none");
  EXPECT_EQ(number(database, "SELECT count(*) FROM standing"),
            number(database, "SELECT count(*) FROM standing_as_counted"));
  store_hand_settings(database, PersonId{2}, {true, 500, 250});
  EXPECT_EQ(load_hand_settings(database, PersonId{2}), (HandSettings{true, 500, 250}));
  EXPECT_EQ(verify(database).first_damage.value_or("none"), "none");
}

TEST(Migrations, OpenADatabaseOfSchemaEightWhoseCardsHaveTheirWords) {
  const TemporaryDirectory temporary;
  Database database = Database::open(place(temporary, "schema_8.db"));
  EXPECT_EQ(number(database, "PRAGMA user_version"), newest_schema());
  const auto attempts = list_attempts(database);
  ASSERT_EQ(attempts.size(), 1U);
  const auto kept = load_score(database, attempts[0].id);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->card.form, CardForm::Words);
  EXPECT_FALSE(kept->card.ledger.at(0).text.empty());
  ScoreCard said_today = kept->card;
  said_today.form = CardForm::Facts;
  EXPECT_EQ(store_score(database, attempts[0].id, said_today), kept->id) << "the same score";
  const MeasuredBy by{Digest{{1}}, 1};
  EXPECT_FALSE(load_measurements(database, attempts[0].id, by));
  store_measurements(database, attempts[0].id, by, some_measurements(), std::nullopt);
  EXPECT_TRUE(load_measurements(database, attempts[0].id, by));
  EXPECT_EQ(verify(database).first_damage.value_or("none"), "none");
}

/// What the program of schema 9 wrote has neither of the columns that came with schema 10.
void take_back_to_schema_nine(const fs::path& directory) {
  SQLite::Database tool{(directory / "hallux.db").string(), SQLite::OPEN_READWRITE};
  tool.exec("ALTER TABLE measurement DROP COLUMN implant");
  tool.exec("ALTER TABLE measurement DROP COLUMN fragment");
  tool.exec("PRAGMA user_version = 9");
}

TEST(Migrations, OpenADatabaseOfSchemaNineWhoseMeasurementsKeepTheirDigest) {
  const TemporaryDirectory temporary;
  const MeasuredBy by{Digest{{1}}, 1};
  std::vector<Measurement> rows = some_measurements();
  {
    Database database = Database::open(temporary.data());
    const AttemptId id = record(database, some_attempt(database), some_recording(100));
    store_measurements(database, id, by, rows, std::nullopt);
  }
  take_back_to_schema_nine(temporary.data());
  Database database = Database::open(temporary.data());
  EXPECT_EQ(number(database, "PRAGMA user_version"), newest_schema());
  const auto attempts = list_attempts(database);
  ASSERT_EQ(attempts.size(), 1U);
  const auto kept = load_measurements(database, attempts[0].id, by);
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->size(), rows.size());
  for (const Measurement& each : *kept) EXPECT_TRUE(each.fragment.empty() && each.implant.empty());
  EXPECT_EQ(verify(database).first_damage.value_or("none"), "none");
}

TEST(Migrations, MeasurementsHaveTheDigestThatSchemaNineGaveThem) {
  // As the program of schema 9 wrote it.
  const MeasurementKey key{AttemptId{"afef5cb4-0b19-4e4d-b4be-f71e341a517a"},
                           Digest{{0x9D, 0x57, 0x68, 0xAB, 0x63, 0x24, 0x65, 0x57, 0xAA, 0xC9, 0xC3,
                                   0x45, 0x53, 0xA9, 0x95, 0x58, 0xBB, 0x49, 0xD3, 0x7B, 0xDF, 0x60,
                                   0xAD, 0xCD, 0x09, 0xC8, 0xAF, 0x5E, 0x0E, 0x11, 0x6B, 0xDB}},
                           {Digest{{1}}, 1}};
  EXPECT_EQ(hex_from_digest(measurements_digest(key, some_measurements())),
            "5a41ab96d288a84a53731bef685aec70fd1884200ef4ad1ec5ce07a5a42a53ef");
}

TEST(Migrations, VouchForNothingThatWasAlteredBefore) {
  const TemporaryDirectory temporary;
  const fs::path directory = place(temporary, "schema_5.db");
  {
    SQLite::Database tool{(directory / "hallux.db").string(), SQLite::OPEN_READWRITE};
    tool.exec("UPDATE person SET is_administrator = 1 WHERE person_id = 3");
  }
  Database database = Database::open(directory);
  EXPECT_NE(verify(database).first_damage.value_or("").find("person 3"), std::string::npos);
}

TEST(Migrations, AnAdministratorOfNoDateIsNamedOnceItIsCovered) {
  const TemporaryDirectory temporary;
  Database database = Database::open(place(temporary, "schema_4.db"));
  tamper(
      database,
      "INSERT INTO person (is_administrator, created_utc) VALUES (1, '2020-01-01T00:00:00.000Z'); "
      "INSERT INTO person_detail VALUES ((SELECT max(person_id) FROM person), 'eve', 'Eve'); "
      "INSERT INTO password SELECT (SELECT max(person_id) FROM person), argon2id, changed_utc "
      "FROM password WHERE person_id = 2");
  EXPECT_NE(verify(database).first_damage.value_or("").find("without an act"), std::string::npos);
}

TEST(Migrations, GiveEachDirectoryAnIdentityOfItsOwnForGood) {
  const TemporaryDirectory first, second;
  Database one = Database::open(place(first, "schema_3.db"));
  Database other = Database::open(place(second, "schema_3.db"));
  const auto identity = [](Database& database) {
    SQLite::Statement row{database.connection(), "SELECT uuid FROM directory"};
    row.executeStep();
    return row.getColumn(0).getString();
  };
  EXPECT_EQ(identity(one).size(), 32U);
  EXPECT_NE(identity(one), identity(other));
  EXPECT_THROW(one.connection().exec("UPDATE directory SET uuid = lower(hex(randomblob(16)))"),
               SQLite::Exception);
}

TEST(Migrations, LeaveEveryChainOfSchemaOneWhole) {
  const TemporaryDirectory temporary;
  Database database = Database::open(place(temporary, "schema_1.db"));
  const Verification found = verify(database);
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_EQ(found.attempts, 1);
  EXPECT_EQ(found.scores, 1);
  EXPECT_EQ(found.audit_rows, 10);  // with the baseline
}

TEST(Migrations, LetThePeopleOfSchemaOneInAsBefore) {
  const TemporaryDirectory temporary;
  Database database = Database::open(place(temporary, "schema_1.db"));
  Session ada = sign_in(database, "ada", secret("saw bone hinge wire"));
  AdministratorDesk desk = *ada.administrator();
  EXPECT_EQ(desk.people().size(), 3U);
  ASSERT_EQ(desk.cohorts().size(), 1U);
  const auto members = desk.members(desk.cohorts()[0].id);
  ASSERT_EQ(members.size(), 2U);
  EXPECT_EQ(members[0].login, "kim");
  EXPECT_EQ(members[0].role, CohortRole::Instructor);
  EXPECT_EQ(members[0].enrolled_utc, "") << "was not noted then";
  EXPECT_THROW(sign_in(database, "ada", secret("not the password")), DatabaseError);
}

TEST(Migrations, AreDoneOnce) {
  const TemporaryDirectory temporary;
  const fs::path directory = place(temporary, "schema_1.db");
  { Database::open(directory); }
  Database database = Database::open(directory);
  EXPECT_EQ(number(database, "SELECT count(*) FROM audit"), 10);
  EXPECT_TRUE(verify(database).is_whole());
}

}  // namespace

}  // namespace hallux::database
