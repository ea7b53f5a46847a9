#include "database/course/begin_attempt.h"
#include "database/exchange/import_attempt.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <functional>

#include "database/exchange/origins.h"
#include "database/maintenance/verify.h"
#include "database/recording/recordings.h"
#include "database/store/own_directory.h"
#include "tests/database/some_exchange.h"
#include "tests/support/faulty_vfs.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

std::int64_t rows_in(const Database& database, const std::string& table) {
  SQLite::Database other{database.file().string(), SQLite::OPEN_READONLY};
  return other.execAndGet("SELECT count(*) FROM " + table).getInt64();
}

struct Kind {
  std::string name;
  std::function<AttemptId(SomeCourse&)> make;
};

AttemptId recorded(SomeCourse& course, AttemptKind kind, simulator::Guidance guidance) {
  NewAttempt attempt = course.attempt_of("ada");
  attempt.kind = kind;
  attempt.guidance = guidance;
  AttemptId id = record(course.database(), attempt, some_recording(1700));
  store_score(course.database(), id, card_worth(70'000), course.id_of("ada"));
  return id;
}

AttemptId decided(SomeCourse& course, const std::vector<DecisionKind>& kinds) {
  AttemptId id = recorded(course, AttemptKind::Assessment, simulator::Guidance::None);
  std::int64_t worth = 60'000;
  for (const DecisionKind kind : kinds) {
    course.instructor("kim", course.autumn()).decide({id, kind, worth, "seen"});
    store_score(course.database(), id, card_worth(worth += 1000), course.id_of("kim"));
  }
  return id;
}

AttemptId interrupted(SomeCourse& course) {
  simulator::AttemptChannels channels{4096};
  AttemptId id;
  {
    Recorder recorder{course.database(),
                      create_attempt(course.database(), course.attempt_of("ada")), channels};
    id = recorder.attempt();
    produce(some_recording(1700), channels);
    recorder.drain();
  }
  course.database().open_again();
  return id;
}

const std::vector<Kind>& kinds() {
  using simulator::Guidance;
  static const std::vector<Kind> all{
      {"Practice",
       [](SomeCourse& c) { return recorded(c, AttemptKind::Practice, Guidance::None); }},
      {"Guided", [](SomeCourse& c) { return recorded(c, AttemptKind::Practice, Guidance::Slot); }},
      {"Assessment",
       [](SomeCourse& c) { return recorded(c, AttemptKind::Assessment, Guidance::None); }},
      {"Confirmed", [](SomeCourse& c) { return decided(c, {DecisionKind::Confirmed}); }},
      {"Overridden",
       [](SomeCourse& c) {
         return decided(c,
                        {DecisionKind::Confirmed, DecisionKind::Voided, DecisionKind::Overridden});
       }},
      {"Voided",
       [](SomeCourse& c) {
         return decided(c, {DecisionKind::Overridden, DecisionKind::Voided});
       }},
      {"Interrupted", interrupted},
      {"InterruptedWithoutAWindow", [](SomeCourse& c) { return c.interrupted_of("ada"); }},
      {"VoidedInterrupted",
       [](SomeCourse& c) {
         AttemptId id = interrupted(c);
         c.instructor("kim", c.autumn()).decide({id, DecisionKind::Voided, 0, "cut off"});
         return id;
       }},
      {"Simulated",
       [](SomeCourse& c) {
         simulator::AttemptChannels channels{4096};
         Recorder recorder{c.database(), create_attempt(c.database(), c.attempt_of("ada")),
                           channels};
         tamper(c.database(), "UPDATE attempt SET is_simulated = 1");
         produce(some_recording(1700), channels);
         recorder.finish(R"({"complete": true})");
         return recorder.attempt();
       }},
      {"Unscored", [](SomeCourse& c) { return c.recorded_by("ada"); }},
      {"TheRobots", [](SomeCourse& c) { return c.recorded_by_robot(); }}};
  return all;
}

class EveryKind : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryKind, LeavesComesInAndLeavesTheSame) {
  TwoDirectories two;
  const AttemptId id = kinds()[GetParam()].make(two.course());
  const fs::path folder = two.exported(id);
  const AttemptHeader before = load_header(two.course().database(), id);
  EXPECT_TRUE(two.import(folder));
  const TemporaryDirectory second;
  export_attempt(two.there(), id, second.data().parent_path(), some_derived);
  EXPECT_EQ(bytes_below(second.data().parent_path() / id.text), bytes_below(folder));

  const AttemptHeader after = load_header(two.there(), id);
  EXPECT_EQ(after.state, before.state);
  EXPECT_EQ(after.seal, before.seal);
  EXPECT_EQ(after.decided_milli, before.decided_milli);
  EXPECT_EQ(after.origin, own_directory(two.course().database()));
  EXPECT_EQ(after.begun.person.has_value(), before.begun.person.has_value());
  EXPECT_FALSE(is_grade(after));
  EXPECT_TRUE(
      is_same(load_recording(two.there(), id), load_recording(two.course().database(), id)));
  EXPECT_EQ(verify(two.there()).first_damage.value_or(""), "");
}

INSTANTIATE_TEST_SUITE_P(Import, EveryKind, testing::Range(std::size_t{0}, kinds().size()),
                         [](const auto& each) { return kinds()[each.param].name; });

TEST(Import, TwiceMakesNoDuplicate) {
  TwoDirectories two;
  const fs::path folder = two.exported(two.course().scored_by("ada", 50'000));
  EXPECT_TRUE(two.import(folder));
  const std::int64_t scores = rows_in(two.there(), "score");
  EXPECT_FALSE(two.import(folder));
  EXPECT_EQ(rows_in(two.there(), "attempt"), 1);
  EXPECT_EQ(rows_in(two.there(), "score"), scores);
  EXPECT_EQ(rows_in(two.there(), "origin_person"), 1);
}

TEST(Import, WhatWasExportedHereIsHereAlready) {
  TwoDirectories two;
  const AttemptId id = two.course().recorded_by("ada");
  EXPECT_FALSE(
      two.course().administrator().import_attempt(read_exported(two.exported(id)), card_worth(1)));
}

TEST(Import, KeepsWhatTheMachineSaidThereAndScoresAnewHere) {
  TwoDirectories two;
  const AttemptId id = two.course().scored_by("ada", 50'000);
  two.import(two.exported(id));
  const std::vector<KeptScore> scores = kept_scores(two.there(), id);
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_EQ(scores[0].score_milli, 12'345);
  EXPECT_TRUE(scores[0].is_in_force);
  EXPECT_EQ(scores[1].score_milli, 50'000);
}

TEST(Import, AnotherAttemptUnderTheSameUuidIsRefusedAndNamed) {
  TwoDirectories two;
  const AttemptId id = two.course().recorded_by("ada");
  const fs::path folder = two.exported(id);
  two.import(folder);
  tamper(two.there(), "UPDATE attempt SET seal = zeroblob(32)");
  try {
    two.import(folder);
    ADD_FAILURE() << "two attempts share a uuid";
  } catch (const DatabaseError& error) {
    EXPECT_EQ(error.kind(), DatabaseErrorKind::BadInput);
    EXPECT_NE(std::string{error.what()}.find(id.text), std::string::npos);
  }
}

TEST(Import, CarriesItsFirstOriginFurther) {
  TwoDirectories two;
  const AttemptId id = two.course().scored_by("ada", 50'000);
  const fs::path folder = two.exported(id);
  two.import(folder);
  TwoDirectories third;
  export_attempt(two.there(), id, third.out(), some_derived);
  EXPECT_EQ(bytes_below(third.out() / id.text), bytes_below(folder));
  third.import(third.out() / id.text);
  EXPECT_EQ(load_header(third.there(), id).origin, own_directory(two.course().database()));
}

TEST(Import, DerivedFilesOfAnotherProgramAreLeftOut) {
  TwoDirectories two;
  const AttemptId id = two.course().recorded_by("ada");
  const auto before = bytes_below(two.exported(id));
  two.import(two.out() / id.text);
  const TemporaryDirectory second;
  export_attempt(two.there(), id, second.data().parent_path(), [](const ExportMaterial&) {
    return std::vector<DerivedFile>{{"bone.ply", "made otherwise"}, {"new.ply", "and more"}};
  });
  auto after = bytes_below(second.data().parent_path() / id.text);
  EXPECT_FALSE(after.contains("bone.ply"));
  EXPECT_FALSE(after.contains("new.ply"));
  EXPECT_EQ(after.at(manifest_name), before.at(manifest_name));
}

TEST(Import, CountsOnceItsOriginIsAccepted) {
  TwoDirectories two;
  const AttemptId id = decided(two.course(), {DecisionKind::Overridden});
  tamper(two.course().database(), "UPDATE attempt SET is_valid = 1");
  two.import(two.exported(id));
  tamper(two.there(), "UPDATE attempt SET is_valid = 1");
  EXPECT_FALSE(load_header(two.there(), id).is_counted);
  two.administrator_there().set_accepted(own_directory(two.course().database()), true);
  EXPECT_TRUE(load_header(two.there(), id).is_counted);
}

TEST(Import, WhoWasErasedHereDoesNotComeBack) {
  TwoDirectories two;
  const AttemptId first = two.course().recorded_by("ada"), second = two.course().recorded_by("ada");
  two.import(two.exported(first));
  tamper(two.there(),
         "INSERT INTO erasure SELECT person_id, '2026-03-01T00:00:00.000Z' FROM origin_person");
  const std::int64_t attempts = rows_in(two.there(), "attempt");
  EXPECT_EQ(kind_thrown([&] { two.import(two.exported(second)); }), DatabaseErrorKind::Refused);
  EXPECT_EQ(rows_in(two.there(), "attempt"), attempts);
}

TEST(Import, VerifyNamesAnImportedAttemptThatWasAltered) {
  for (const char* sql :
       {"UPDATE attempt SET kind = 'assessment'", "UPDATE attempt SET person_id = 1",
        "UPDATE attempt SET person_id = NULL", "UPDATE attempt SET manifest_digest = bone_digest",
        "UPDATE origin SET directory_uuid = '00000000000000000000000000000000'"}) {
    TwoDirectories two;
    two.import(two.exported(two.course().recorded_by("ada")));
    ASSERT_EQ(verify(two.there()).first_damage.value_or(""), "");
    tamper(two.there(), sql);
    EXPECT_FALSE(verify(two.there()).is_whole()) << sql;
  }
}

TEST(Import, AFullDiskLeavesNothingHalf) {
  TwoDirectories two;
  const AttemptId id = decided(two.course(), {DecisionKind::Confirmed});
  const ImportedAttempt attempt = read_exported(two.exported(id));
  const TemporaryDirectory temporary;
  tests::FaultyVfs vfs{"full_at_import"};
  Database database = Database::open(temporary.data(), {Access::ReadWrite, 200, vfs.name()});
  const PersonId by = OpenHouse::enter(database)->add_first_administrator(
      {"chief", "", true}, secret(good_password), cheap);
  for (int writes = 0; writes < 12; writes += 3) {
    vfs.fail_after(writes, SQLITE_FULL);
    EXPECT_EQ(kind_thrown([&] { store_imported(database, attempt, card_worth(1), by); }),
              DatabaseErrorKind::Full)
        << writes;
    vfs.heal();
    for (const char* table : {"attempt", "chunk", "score", "decision", "origin", "asset"}) {
      EXPECT_EQ(rows_in(database, table), 0) << table;
    }
  }
  store_imported(database, attempt, card_worth(1), by);
  EXPECT_TRUE(is_here(database, attempt));
  EXPECT_TRUE(verify(database).is_whole());
}

TEST(Import, IsAnAdministratorsAct) {
  TwoDirectories two;
  const AttemptId id = two.course().recorded_by("ada");
  AdministratorDesk desk = two.administrator_there();
  const ImportedAttempt attempt = read_exported(two.exported(id));
  tamper(two.there(), "UPDATE person SET is_administrator = 0");
  EXPECT_EQ(kind_thrown([&] { desk.import_attempt(attempt, card_worth(1)); }),
            DatabaseErrorKind::Refused);
}

}  // namespace

}  // namespace hallux::database
