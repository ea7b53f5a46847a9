#include "database/maintenance/verify.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "database/course/scores.h"
#include "simulator/base/progress.h"
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
  // The baseline, the bone, the scenario, the beginning, the seal.
  EXPECT_EQ(found.audit_rows, 5);
  EXPECT_TRUE(found.covered_since_utc.has_value());
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

TEST(Verify, SeesAFactThatListsGoByAltered) {
  EXPECT_TRUE(
      names(damage_after("UPDATE attempt SET is_valid = 0 WHERE attempt_id = 1"), "is valid"));
  EXPECT_TRUE(
      names(damage_after("UPDATE attempt SET is_valid = NULL WHERE attempt_id = 1"), "is valid"));
  EXPECT_TRUE(names(damage_after("UPDATE attempt SET state = 'interrupted' WHERE attempt_id = 1"),
                    "the state of attempt"));
  const std::string without_trigger = "DROP TRIGGER score_is_superseded_not_overwritten; ";
  for (const char* column :
       {"measured_weight_milli", "rubric_version", "scenario_version", "engine_version",
        "rubric_milli", "is_gated", "safety_measured_milli", "safety_earned_milli"}) {
    EXPECT_TRUE(
        names(damage_after(without_trigger + "UPDATE score SET " + column + " = 77"), "score 1 "))
        << column;
  }
}

TEST(Verify, SeesAScoreThatIsGoneOrExchanged) {
  EXPECT_TRUE(names(damage_after("DELETE FROM score"), "score 1, which is missing"));
  const std::string without_trigger = "DROP TRIGGER score_is_superseded_not_overwritten; ";
  EXPECT_TRUE(names(damage_after(without_trigger + "UPDATE score SET attempt_id = 1"), "score 1 "));
}

TEST(Verify, SeesAnOlderScoreInForce) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const AttemptId id = record(database, some_attempt(database), some_recording(5));
  ScoreCard card;
  for (const std::int64_t milli : {90'000, 40'000}) {
    card.score_milli = milli;
    store_score(database, id, card);
  }
  EXPECT_TRUE(verify(database).is_whole());
  tamper(database,
         "UPDATE score SET superseded_by = 2 WHERE score_id = 2; "
         "UPDATE score SET superseded_by = NULL WHERE score_id = 1");
  EXPECT_TRUE(names(verify(database).first_damage.value_or(""), "the order of score"));
}

TEST(Verify, SeesWhatNoAuditRowExplains) {
  EXPECT_TRUE(names(damage_after("INSERT INTO attempt (uuid, scenario_version_id, hand, seed, "
                                 "device_class, pacing, stereo_mode, bone_digest, engine_version, "
                                 "started_utc, state) SELECT 'beef', scenario_version_id, hand, 9, "
                                 "device_class, pacing, stereo_mode, bone_digest, engine_version, "
                                 "started_utc, 'interrupted' FROM attempt WHERE attempt_id = 1"),
                    "the beginning of attempt beef"));
  EXPECT_TRUE(names(damage_after("INSERT INTO score (attempt_id, scenario_version, rubric_version, "
                                 "engine_version, score_milli, measured_weight_milli, card_json, "
                                 "stored_utc, rubric_milli, is_gated, safety_measured_milli, "
                                 "safety_earned_milli) SELECT 1, scenario_version, rubric_version, "
                                 "engine_version, score_milli, measured_weight_milli, card_json, "
                                 "stored_utc, rubric_milli, is_gated, safety_measured_milli, "
                                 "safety_earned_milli FROM score"),
                    "the list of scores with score 2"));
}

TEST(Verify, SeesARecordingThatWasTakenAwayAsIfItHadBeenErased) {
  EXPECT_TRUE(names(damage_after("INSERT INTO erased_recording SELECT 1, link, 3, '' FROM chunk "
                                 "WHERE attempt_id = 1 ORDER BY seq DESC, stream DESC LIMIT 1; "
                                 "DELETE FROM chunk WHERE attempt_id = 1"),
                    "the erasing of the recording of attempt"));
}

TEST(Verify, SeesAnAdministratorWhomNobodyMade) {
  const auto damage = [](const std::string& sql) {
    SomeCourse course;
    course.administrator().set_administrator("lee", true);
    course.administrator().set_administrator("max", false);
    EXPECT_TRUE(verify(course.database()).is_whole()) << *verify(course.database()).first_damage;
    tamper(course.database(), sql);
    return verify(course.database()).first_damage.value_or("");
  };
  const std::string of_login =
      " WHERE person_id = (SELECT person_id FROM person_detail WHERE login = '";
  for (const char* login : {"ada", "max"}) {
    EXPECT_TRUE(names(damage("UPDATE person SET is_administrator = 1" + of_login + login + "')"),
                      "whether somebody is an administrator"))
        << login;
  }
  EXPECT_TRUE(names(damage("UPDATE person SET is_administrator = 0" + of_login + "lee')"),
                    "whether somebody is an administrator"));
}

TEST(Verify, IsNotMisledByWhoWorksMeanwhile) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  record(database, some_attempt(database), some_recording(1200));
  Database other = database.open_again();
  double done_before = 0.0;
  int times = 0;
  const Verification found = verify(database, [&](double done) {
    EXPECT_GE(done, done_before);
    done_before = done;
    if (++times <= 8) {
      store_score(other, record(other, some_attempt(other), some_recording(5)), {});
    }
    return true;
  });
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_EQ(done_before, 1.0);
  EXPECT_GE(times, 4);
}

TEST(Verify, SaysInWhichPartItWasStopped) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  record(database, some_attempt(database), some_recording(10));
  try {
    verify(database, [](double done) { return done < 0.8; });
    ADD_FAILURE() << "it went on";
  } catch (const Cancelled& stopped) {
    EXPECT_TRUE(names(stopped.what(), "stopped in the attempts")) << stopped.what();
  }
}

TEST(Verify, NamesTheAlteredAuditRow) {
  EXPECT_TRUE(names(damage_after("DROP TRIGGER audit_is_never_deleted; "
                                 "DROP TRIGGER audit_row_is_never_deleted; "
                                 "DELETE FROM audit_row WHERE audit_id = 2; "
                                 "DELETE FROM audit WHERE audit_id = 2"),
                    "row 3 of the audit"));
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
  EXPECT_TRUE(names(damage(""), "trigger decision_is_"));
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
                    "attempt "));
  EXPECT_TRUE(
      names(damage_after("UPDATE attempt SET is_simulated = 1 WHERE attempt_id = 1"), "attempt "));
}

TEST(Verify, StoppedIsNotDamaged) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  record(database, some_attempt(database), some_recording(10));
  EXPECT_THROW(verify(database, [](double) { return false; }), Cancelled);
}

}  // namespace

}  // namespace hallux::database
