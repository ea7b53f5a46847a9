#include "database/verify.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "database/scores.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

/// What verify says about two closed attempts, one of them scored, after `sql` was run on them.
std::string damage_after(const std::string& sql) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const simulator::Recording recording = some_recording(1200);
  record(database, some_attempt(database), recording);
  const AttemptId second = record(database, some_attempt(database), recording);
  ScoreCard card;
  card.score_milli = 50'000;
  store_score(database, second, card);
  tamper(database, sql);
  return verify(database).first_damage.value_or("");
}

bool names(const std::string& sentence, const std::string& part) {
  return sentence.find(part) != std::string::npos;
}

TEST(Verify, FindsAnUntouchedDatabaseWhole) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  record(database, some_attempt(database), some_recording(1200));
  const Verification found = verify(database);
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_EQ(found.attempts, 1);
  EXPECT_EQ(found.chunks, 9);
  EXPECT_EQ(found.assets, 1);
  EXPECT_EQ(found.audit_rows, 2);
}

TEST(Verify, NamesTheChunkWhoseByteWasAltered) {
  const std::string damage = damage_after(
      "UPDATE chunk SET bytes = CAST(substr(bytes, 1, 40) || x'55' || substr(bytes, 42) AS BLOB) "
      "WHERE chunk_id = 5");
  EXPECT_TRUE(names(damage, "chunk 5 (samples of window 1 of attempt ")) << damage;
}

TEST(Verify, NamesTheChunkWhosePlaceWasAltered) {
  EXPECT_TRUE(
      names(damage_after("UPDATE chunk SET first_tick = 501 WHERE chunk_id = 4"), "chunk 4 "));
  EXPECT_TRUE(
      names(damage_after("UPDATE chunk SET row_count = 499 WHERE chunk_id = 4"), "chunk 4 "));
  EXPECT_TRUE(
      names(damage_after("UPDATE chunk SET link = zeroblob(32) WHERE chunk_id = 1"), "chunk 1 "));
}

TEST(Verify, SeesAChunkThatIsGone) {
  EXPECT_TRUE(names(damage_after("DELETE FROM chunk WHERE chunk_id = 4"), "chunk 5 "));
  EXPECT_TRUE(names(damage_after("DELETE FROM chunk WHERE chunk_id = 9"), "does not fit its seal"));
}

TEST(Verify, SeesAnAlteredFactOfAnAttempt) {
  EXPECT_TRUE(names(damage_after("UPDATE attempt SET seed = 8 WHERE attempt_id = 1"), "its seal"));
  EXPECT_TRUE(names(damage_after("UPDATE attempt SET duration_ticks = 1 WHERE attempt_id = 2"),
                    "its seal"));
  EXPECT_TRUE(names(damage_after("INSERT INTO person VALUES (9, 0, 0, ''); "
                                 "UPDATE attempt SET person_id = 9 WHERE attempt_id = 2"),
                    "the person of attempt"));
  EXPECT_TRUE(names(damage_after("DELETE FROM chunk WHERE attempt_id = 1; "
                                 "DELETE FROM attempt WHERE attempt_id = 1"),
                    "which is missing"));
}

TEST(Verify, SeesAnAlteredScoreAssetAndScenario) {
  const std::string without_trigger = "DROP TRIGGER score_is_superseded_not_overwritten; ";
  EXPECT_TRUE(
      names(damage_after(without_trigger + "UPDATE score SET score_milli = 99000"), "score 1 "));
  EXPECT_TRUE(
      names(damage_after(without_trigger +
                         "UPDATE score SET card_json = replace(card_json, '\"\"', '\"x\"')"),
            "score 1 "));
  EXPECT_TRUE(names(damage_after("UPDATE asset SET zstd = x'00'"), "asset "));
  EXPECT_TRUE(names(damage_after("UPDATE scenario_version SET json = '{}'"), "scenario version 1"));
}

TEST(Verify, NamesTheAlteredAuditRow) {
  EXPECT_TRUE(names(damage_after("DROP TRIGGER audit_is_never_altered; "
                                 "UPDATE audit SET action = 'attempt_lost' WHERE audit_id = 2"),
                    "row 2 of the audit"));
}

/// What verify says about an overridden result and a voided attempt after `sql` was run on them.
std::string damage_of_decisions_after(const std::string& sql) {
  SomeCourse course;
  const AttemptId overridden = course.scored_by("ada", 50'000);
  const AttemptId voided = course.scored_by("ada", 60'000);
  InstructorDesk desk = course.instructor("kim", course.autumn());
  desk.decide({overridden, DecisionKind::Confirmed, 0, "seen"});
  desk.decide({overridden, DecisionKind::Overridden, 70'000, "the station slipped"});
  desk.decide({voided, DecisionKind::Voided, 0, "the power went"});
  tamper(course.database(), sql);
  return verify(course.database()).first_damage.value_or("");
}

TEST(Verify, SeesAnAlteredDecision) {
  const std::string without_trigger =
      "DROP TRIGGER decision_is_superseded_not_overwritten; "
      "DROP TRIGGER decision_is_never_deleted; ";
  const auto damage = [&](const std::string& sql) {
    return damage_of_decisions_after(without_trigger + sql);
  };
  EXPECT_EQ(damage(""), "");
  EXPECT_TRUE(names(damage("UPDATE decision SET score_milli = 99000 WHERE decision_id = 2"),
                    "decision 2 "));
  EXPECT_TRUE(
      names(damage("UPDATE decision SET kind = 'confirmed' WHERE decision_id = 2"), "decision 2 "));
  EXPECT_TRUE(names(damage("UPDATE decision SET reason = 'a favour'"), "decision 1 "));
  EXPECT_TRUE(names(damage("UPDATE decision SET decided_by_person_id = 1 WHERE decision_id = 2"),
                    "decision 2 "));
  EXPECT_TRUE(names(damage("DELETE FROM decision WHERE decision_id = 3; "
                           "UPDATE attempt SET state = 'closed'"),
                    "the list of decisions"));
  EXPECT_TRUE(
      names(damage("UPDATE attempt SET state = 'closed' WHERE state = 'void'"), "decision 3 "));
  EXPECT_TRUE(
      names(damage("UPDATE attempt SET state = 'void' WHERE attempt_id = 1"), "decision 2 "));
  EXPECT_TRUE(names(damage("UPDATE decision SET superseded_by = 2 WHERE decision_id = 2; "
                           "UPDATE decision SET superseded_by = NULL WHERE decision_id = 1"),
                    "decision 1 "));
}

TEST(Verify, SeesWhatAnAttemptWasForAltered) {
  EXPECT_TRUE(names(damage_after("UPDATE attempt SET kind = 'assessment' WHERE attempt_id = 1"),
                    "was for"));
  EXPECT_TRUE(
      names(damage_after("UPDATE attempt SET is_simulated = 1 WHERE attempt_id = 1"), "was for"));
}

TEST(Verify, StoppedIsNotDamaged) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  record(database, some_attempt(database), some_recording(10));
  EXPECT_THROW(verify(database, [](double) { return false; }), VerificationStopped);
}

}  // namespace

}  // namespace hallux::database
