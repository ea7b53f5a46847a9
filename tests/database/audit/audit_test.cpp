#include "database/audit/audit.h"

#include <gtest/gtest.h>

#include "database/audit/audit_page.h"
#include "database/course/begin_attempt.h"
#include "database/people/people.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

/// Three rows: with a person, refused with a text, with a digest.
void fill(Database& database) {
  append_audit(database, {PersonId{3}, "signed_in", "session", "1", false, {}, ""});
  append_audit(database, {std::nullopt, "signed_in", "login", "", true, {}, "eve"});
  append_audit(database, {std::nullopt, "score_stored", "score", "9", false, Digest{{1}}, ""});
}

std::string damage_after(const std::string& sql) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  fill(database);
  tamper(database,
         "DROP TRIGGER audit_is_never_altered; DROP TRIGGER audit_is_never_deleted;" + sql);
  try {
    read_audit(database);
  } catch (const DatabaseError& error) {
    EXPECT_EQ(error.kind(), DatabaseErrorKind::Damaged);
    return error.what();
  }
  return "";
}

TEST(Audit, KeepsRowsInOrder) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  fill(database);
  const auto rows = read_audit(database);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].entry.action, "baseline_taken");
  EXPECT_EQ(rows[1].entry.actor, PersonId{3});
  EXPECT_EQ(rows[2].entry.text, "eve");
  EXPECT_TRUE(rows[2].entry.was_refused);
  EXPECT_EQ(rows[3].entry.subject_id, "9");
}

TEST(Audit, CanNeitherBeAlteredNorDeleted) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  fill(database);
  EXPECT_ANY_THROW(tamper(database, "UPDATE audit SET action = 'nothing'"));
  EXPECT_ANY_THROW(tamper(database, "DELETE FROM audit"));
  EXPECT_EQ(read_audit(database).size(), 4U);
}

TEST(Audit, NamesTheFirstAlteredRow) {
  EXPECT_NE(damage_after("UPDATE audit SET actor_person_id = 4 WHERE audit_id = 2")
                .find("row 2 of the audit"),
            std::string::npos);
  EXPECT_NE(damage_after("UPDATE audit SET outcome = 'done' WHERE audit_id = 3")
                .find("row 3 of the audit"),
            std::string::npos);
  EXPECT_NE(damage_after("UPDATE audit SET at_utc = '2020' WHERE audit_id = 4")
                .find("row 4 of the audit"),
            std::string::npos);
  EXPECT_NE(damage_after("DELETE FROM audit_text; DELETE FROM audit WHERE audit_id = 3")
                .find("row 4 of the audit"),
            std::string::npos);
  EXPECT_NE(damage_after("UPDATE audit_text SET text = 'bob'").find("row 3 of the audit"),
            std::string::npos);
}

TEST(Audit, StaysWholeWhenItsTextsAreErased) {
  EXPECT_EQ(damage_after("DELETE FROM audit_text"), "");
}

TEST(Audit, IsReadInPagesFromTheNewest) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  for (int i = 0; i < 3; ++i) fill(database);
  const AuditPage first = read_audit_page(database, {std::nullopt, 4, false});
  ASSERT_EQ(first.lines.size(), 4U);
  EXPECT_EQ(first.lines.front().number, 10);
  EXPECT_EQ(first.total, 10);
  ASSERT_EQ(first.older, 7);
  const AuditPage last = read_audit_page(database, {2, 4, false});
  ASSERT_EQ(last.lines.size(), 1U);
  EXPECT_FALSE(last.older);
  const AuditPage refused = read_audit_page(database, {std::nullopt, 50, true});
  EXPECT_EQ(refused.total, 3);
  ASSERT_EQ(refused.lines.size(), 3U);
  EXPECT_EQ(refused.lines[0].text, "eve");
  EXPECT_TRUE(refused.lines[0].was_refused);
}

TEST(Audit, IsSearchedForPeopleAndWords) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const PersonId ada = create_person_without_password(database, {"ada", "Ada Bone", false});
  const PersonId bob = create_person_without_password(database, {"bob", "Bob Wire", false});
  const auto number = [](PersonId id) { return std::to_string(id.number); };
  append_audit(database, {ada, "signed_in", "session", "1"});
  append_audit(database, {ada, "password_set", "person", number(bob)});
  append_audit(database, {bob, "enrolled_as_trainee", "membership", "7/" + number(ada)});
  append_audit(database, {bob, "report_run", "database", "", true, {}, "SELECT Bone"});
  append_audit(database, {bob, "signed_in", "session", "2"});
  const auto found = [&](const std::string& search, bool refused_only) {
    std::string actions;
    const AuditPage page = read_audit_page(database, {std::nullopt, 50, refused_only, search});
    EXPECT_EQ(page.total, std::ssize(page.lines));
    for (const AuditLine& line : page.lines) actions += line.action + " ";
    return actions;
  };
  EXPECT_EQ(found("ADA", false), "enrolled_as_trainee password_set signed_in ");
  EXPECT_EQ(found("bone", false), "report_run enrolled_as_trainee password_set signed_in ");
  EXPECT_EQ(found("bone", true), "report_run ");
  EXPECT_EQ(found("100%", false), "");
}

TEST(Audit, IsUndoneWithTheTransactionItIsIn) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  NewAttempt attempt = some_attempt(database);
  attempt.scenario.number = 99;
  EXPECT_THROW(create_attempt(database, attempt), DatabaseError);
  EXPECT_EQ(read_audit(database).back().entry.action, "rows_changed");
}

}  // namespace

}  // namespace hallux::database
