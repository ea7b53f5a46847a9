#include "database/recording/attempts.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "database/content/assets.h"
#include "database/course/begin_attempt.h"
#include "database/maintenance/verify.h"
#include "database/recording/recordings.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

TEST(Attempts, KeepWhatTheyBeganWith) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  NewAttempt attempt = some_attempt(database);
  attempt.seed = 0xFFFF'FFFF'FFFF'FFFEULL;
  const WriterLease lease = create_attempt(database, attempt);
  const AttemptHeader header = load_header(database, lease.attempt());
  EXPECT_EQ(header.begun.seed, attempt.seed);
  EXPECT_EQ(header.begun.hand, "expert");
  EXPECT_EQ(header.begun.bone, attempt.bone);
  EXPECT_EQ(header.begun.person, std::nullopt);
  EXPECT_EQ(header.scenario_name, "silver");
  EXPECT_EQ(header.state, AttemptState::Recording);
  EXPECT_EQ(header.duration_ticks, std::nullopt);
  EXPECT_EQ(header.started_utc.size(), std::string{"2026-01-01T00:00:00.000Z"}.size());
}

TEST(Attempts, KeepHowFirmlyTheyWereGuided) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  for (const simulator::Guidance guidance :
       {simulator::Guidance::None, simulator::Guidance::Soft, simulator::Guidance::Slot}) {
    NewAttempt attempt = some_attempt(database);
    attempt.guidance = guidance;
    const AttemptId id = record(database, attempt, some_recording(10));
    EXPECT_EQ(load_header(database, id).begun.guidance, guidance);
  }
  EXPECT_TRUE(verify(database).is_whole());
}

TEST(Attempts, AreNotGuidedInAnAssessment) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  NewAttempt attempt = some_attempt(database);
  attempt.kind = AttemptKind::Assessment;
  attempt.guidance = simulator::Guidance::Soft;
  try {
    create_attempt(database, attempt);
    ADD_FAILURE() << "was begun";
  } catch (const DatabaseError& error) {
    EXPECT_EQ(error.kind(), DatabaseErrorKind::BadInput);
    EXPECT_STREQ(error.what(), "an assessment is not guided; choose practice, or no guide");
  }
  EXPECT_TRUE(list_attempts(database).empty());
}

TEST(Attempts, ThatWereGuidedCannotBeMadeUnguidedUnseen) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  NewAttempt attempt = some_attempt(database);
  attempt.guidance = simulator::Guidance::Slot;
  record(database, attempt, some_recording(10));
  ASSERT_TRUE(verify(database).is_whole());
  for (const char* other : {"none", "soft"}) {
    tamper(database, std::string("UPDATE attempt SET guidance = '") + other + "'");
    EXPECT_FALSE(verify(database).is_whole()) << other;
  }
  // A word that nobody knows stands only where the schema was talked out of its check.
  tamper(database, "PRAGMA ignore_check_constraints = ON; UPDATE attempt SET guidance = 'laser'");
  EXPECT_FALSE(verify(database).is_whole());
}

TEST(Attempts, OfAnAssessmentAreKeptUnguidedByTheSchemaToo) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  NewAttempt assessment = some_attempt(database);
  assessment.kind = AttemptKind::Assessment;
  record(database, assessment, some_recording(10));
  NewAttempt guided = some_attempt(database);
  guided.guidance = simulator::Guidance::Soft;
  record(database, guided, some_recording(10));
  for (const char* change :
       {"guidance = 'soft' WHERE kind = 'assessment'",
        "guidance = 'slot' WHERE kind = 'assessment'",
        "kind = 'assessment' WHERE guidance = 'soft'", "guidance = 'laser' WHERE kind = 'practice'",
        "guidance = NULL WHERE kind = 'practice'"}) {
    EXPECT_THROW(database.connection().exec(std::string("UPDATE attempt SET ") + change),
                 SQLite::Exception)
        << change;
  }
  EXPECT_TRUE(verify(database).is_whole());
}

TEST(Attempts, AreListedNewestFirst) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const simulator::Recording recording = some_recording(10);
  const AttemptId first = record(database, some_attempt(database), recording);
  const AttemptId second = record(database, some_attempt(database), recording);
  const auto headers = list_attempts(database);
  ASSERT_EQ(headers.size(), 2U);
  EXPECT_EQ(headers[0].id, second);
  EXPECT_EQ(headers[1].id, first);
  EXPECT_EQ(headers[0].state, AttemptState::Closed);
  EXPECT_EQ(headers[0].duration_ticks, 10);
}

TEST(Attempts, AreFoundByTheBeginningOfTheirName) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const AttemptId id = record(database, some_attempt(database), some_recording(10));
  EXPECT_EQ(load_header(database, {id.text.substr(0, 8)}).id, id);
}

TEST(Attempts, ThatAreUnknownAreNamedInTheError) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  for (const std::string name : {"deadbeef", "", "x", "%", "'; DROP TABLE attempt; --"}) {
    try {
      load_header(database, {name});
      ADD_FAILURE() << name;
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::NotFound);
      EXPECT_NE(std::string{error.what()}.find("'" + name + "'"), std::string::npos);
    }
  }
}

TEST(Attempts, NeedAStoredBone) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  NewAttempt attempt = some_attempt(database);
  attempt.bone.bytes[0] ^= 1U;
  EXPECT_THROW(create_attempt(database, attempt), DatabaseError);
  EXPECT_TRUE(list_attempts(database).empty());
  EXPECT_TRUE(std::filesystem::is_empty(temporary.data() / "writers"));
}

TEST(Attempts, OfALiveWriterAreNotMarkedByAnotherOpening) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  AttemptId id;
  {
    const WriterLease lease = create_attempt(database, some_attempt(database));
    id = lease.attempt();
    Database other = Database::open(temporary.data());
    EXPECT_EQ(load_header(other, id).state, AttemptState::Recording);
  }
  Database later = Database::open(temporary.data());
  EXPECT_EQ(load_header(later, id).state, AttemptState::Interrupted);
}

TEST(Attempts, AreSealedOnce) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const AttemptId id = record(database, some_attempt(database), some_recording(10));
  EXPECT_THROW(seal_attempt(database, id, 99, "{}", Digest{}), DatabaseError);
  EXPECT_EQ(load_header(database, id).duration_ticks, 10);
}

TEST(Assets, AreStoredOnceAndReadBackByDigest) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const std::vector<std::byte> bytes(100'000, std::byte{42});
  const Digest digest = put_asset(database, "bone", bytes);
  EXPECT_EQ(put_asset(database, "bone", bytes), digest);
  EXPECT_EQ(get_asset(database, digest), bytes);
  EXPECT_THROW(get_asset(database, Digest{}), DatabaseError);
}

TEST(ScenarioVersions, AreTheSameRowForTheSameText) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const ScenarioText text{"akin", 3, "{\"name\": \"akin\"}\n", true};
  const ScenarioVersionId id = put_scenario_version(database, text);
  EXPECT_EQ(put_scenario_version(database, text), id);
  const ScenarioText back = get_scenario_version(database, id);
  EXPECT_EQ(back.json, text.json);
  EXPECT_EQ(back.version, 3);
  EXPECT_TRUE(back.is_reviewed);
  EXPECT_NE(put_scenario_version(database, {"akin", 3, "{}", true}), id);
}

}  // namespace

}  // namespace hallux::database
