/// The journal beside the backups is written before a row is touched: a power cut may leave an
/// erasure that was begun, never a backup that brings somebody back. Recordings go one by one, so
/// that an erasure that was stopped goes on; the rows of the person go in one transaction. Texts of
/// the audit are searched for the name, whichever row they are of.
#include "database/maintenance/erasures.h"

#include <algorithm>
#include <array>

#include "database/audit/audit.h"
#include "database/people/people.h"
#include "database/recording/attempts.h"
#include "database/recording/erased_recordings.h"
#include "database/store/own_directory.h"
#include "database/store/sql.h"
#include "database/text/free_text.h"
#include "simulator/base/progress.h"

namespace hallux::database {

namespace {

/// ?1 is the person. Of and by them: what others wrote about their attempts names them as easily as
/// their own words. The reasons of what they decided about others stay: those are part of the
/// others' grades.
constexpr std::array<const char*, 19> erasing_statements{
    "DELETE FROM person_detail WHERE person_id = ?1", "DELETE FROM password WHERE person_id = ?1",
    "DELETE FROM one_time_code WHERE person_id = ?1", "DELETE FROM session WHERE person_id = ?1",
    "DELETE FROM hand_setting WHERE person_id = ?1",
    "DELETE FROM notice_seen WHERE person_id = ?1 OR notice_id IN "
    "(SELECT notice_id FROM notice WHERE person_id = ?1)",
    "DELETE FROM notice WHERE person_id = ?1",
    "DELETE FROM membership WHERE person_id = ?1 AND role = 'instructor'",
    "UPDATE note SET text = '' WHERE author_person_id = ?1 OR attempt_id IN "
    "(SELECT attempt_id FROM attempt WHERE person_id = ?1)",
    "UPDATE note_reply SET text = '' WHERE author_person_id = ?1 OR note_id IN "
    "(SELECT note_id FROM note JOIN attempt USING (attempt_id) WHERE person_id = ?1)",
    "UPDATE help_request SET question = '', answer = CASE WHEN answer IS NULL THEN NULL ELSE '' "
    "END "
    "WHERE asker_person_id = ?1 OR attempt_id IN "
    "(SELECT attempt_id FROM attempt WHERE person_id = ?1)",
    "UPDATE help_request SET answer = '' WHERE answered_by_person_id = ?1",
    "UPDATE decision SET reason = '' WHERE attempt_id IN "
    "(SELECT attempt_id FROM attempt WHERE person_id = ?1)",
    "DELETE FROM audit_text WHERE audit_id IN (SELECT audit_id FROM audit WHERE "
    "(actor_person_id = ?1 AND subject_kind <> 'decision') "
    "OR (subject_kind = 'person' AND subject_id = CAST(?1 AS TEXT)) "
    "OR (subject_kind = 'membership' AND subject_id LIKE '%/' || ?1))",
    "DELETE FROM audit_text WHERE audit_id IN (SELECT u.audit_id FROM audit u JOIN attempt a "
    "ON u.subject_id = a.uuid WHERE a.person_id = ?1)",
    "DELETE FROM audit_text WHERE audit_id IN (SELECT u.audit_id FROM audit u JOIN decision d "
    "ON d.decision_id = CAST(u.subject_id AS INTEGER) JOIN attempt a USING (attempt_id) "
    "WHERE u.subject_kind = 'decision' AND a.person_id = ?1)",
    // A manifest that an imported attempt came with may name its person.
    "UPDATE attempt SET manifest_digest = NULL WHERE person_id = ?1",
    "DELETE FROM asset WHERE kind = 'manifest' AND ?1 AND NOT EXISTS "
    "(SELECT 1 FROM attempt WHERE manifest_digest = asset.digest)",
    "UPDATE person SET is_administrator = 0, is_disabled = 1 WHERE person_id = ?1"};

std::string in_small_letters(std::string_view text) {
  std::string small{text};
  std::transform(small.begin(), small.end(), small.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return small;
}

bool is_part_of_a_name(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

/// As a word of its own: who is called "ed" is not named by "edited".
bool names(std::string_view text, std::string_view name) {
  if (name.empty()) return false;
  const std::string in = in_small_letters(text), sought = in_small_letters(name);
  for (std::size_t at = in.find(sought); at != std::string::npos; at = in.find(sought, at + 1)) {
    const std::size_t end = at + sought.size();
    const bool begins = at == 0 || !is_part_of_a_name(in[at - 1]);
    if (begins && (end == in.size() || !is_part_of_a_name(in[end]))) return true;
  }
  return false;
}

bool names_any(std::string_view text, const std::vector<std::string>& names_sought) {
  return std::any_of(names_sought.begin(), names_sought.end(),
                     [&](const std::string& name) { return names(text, name); });
}

/// Login, name, and the names before each correction.
std::vector<std::string> names_of(Database& database, const Person& person) {
  std::vector<std::string> all = all_of<std::string>(
      database,
      "SELECT t.text FROM audit u JOIN audit_text t USING (audit_id) "
      "WHERE u.action = 'name_corrected' AND u.subject_kind = 'person' AND u.subject_id = ?",
      std::to_string(person.id.number));
  all.push_back(person.login);
  all.push_back(person.display_name);
  return all;
}

/// Refused sign-ins and requests, statements, reasons: whatever row they are of, their texts may
/// hold the login.
std::int64_t erase_audit_texts_that_name(Database& database, const Person& person) {
  const std::vector<std::string> sought = names_of(database, person);
  std::vector<std::int64_t> naming;
  auto rows = prepared(database, "SELECT audit_id, text FROM audit_text");
  while (rows.executeStep()) {
    if (names_any(rows.getColumn(1).getString(), sought)) {
      naming.push_back(rows.getColumn(0).getInt64());
    }
  }
  auto remove = prepared(database, "DELETE FROM audit_text WHERE audit_id = ?");
  for (const std::int64_t number : naming) run_again(remove, number);
  return static_cast<std::int64_t>(naming.size());
}

std::int64_t erase_rows(Database& database, const Person& person) {
  std::int64_t changed = erase_audit_texts_that_name(database, person);
  for (const char* sql : erasing_statements) {
    changed += execute(database, sql, person.id);
  }
  execute(database, "INSERT INTO erasure (person_id, erased_utc) VALUES (?, ?)", person.id.number,
          utc_now(database));
  return changed;
}

void check_erasable(Database& database, const Person& person, const std::string& reason) {
  const auto refuse = [](const std::string& sentence) {
    throw DatabaseError{DatabaseErrorKind::Refused, sentence};
  };
  if (is_erased(database, person.id)) {
    refuse("person " + std::to_string(person.id.number) + " was erased before; nothing is left");
  }
  if (names_any(reason, names_of(database, person))) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        "the reason names the person who is to be erased, and it is kept; say it "
                        "without the name"};
  }
  for (const AttemptHeader& header : list_attempts(database, {person.id, {}, false, {}})) {
    if (header.state == AttemptState::Recording) {
      refuse("'" + person.login + "' is operating now (attempt " + header.id.text +
             "); erase them when that has ended");
    }
  }
  if (!person.is_administrator) return;
  if (single<std::int32_t>(database,
                           "SELECT count(*) FROM person JOIN password USING (person_id) "
                           "WHERE is_administrator = 1 AND is_disabled = 0 AND person_id <> ?",
                           person.id.number) == 0) {
    refuse("the last administrator who can sign in cannot be erased; make another one first");
  }
}

void erase_recordings_of(Database& database, PersonId person, std::optional<PersonId> actor,
                         const Progress& progress, ErasedPieces& erased) {
  const std::vector<AttemptHeader> headers = list_attempts(database, {person, {}, false, {}});
  double done = 0.0;
  for (const AttemptHeader& header : headers) {
    if (progress && !progress(0.9 * done / static_cast<double>(headers.size()))) {
      throw Cancelled{"the erasure was stopped after " + std::to_string(erased.recordings) +
                      " recordings; the person is still there, once more goes on"};
    }
    const std::int64_t bytes = erase_recording(database, header.id, actor);
    erased.recording_bytes += bytes;
    erased.recordings += bytes > 0 ? 1 : 0;
    done += 1.0;
  }
}

void audit_erasure(Database& database, const Person& person, const ErasureOrder& order,
                   std::optional<PersonId> actor) {
  const std::string number = std::to_string(person.id.number);
  if (person.is_administrator) {
    append_audit(database, {actor, "administrator_unmade", "person", number});
  }
  append_audit(database, {actor, "person_erased", "person", number, false, {}, order.reason});
}

}  // namespace

bool is_erased(Database& database, PersonId person) {
  return translating(database, "look for an erasure", [&] {
    return single<bool>(database, "SELECT EXISTS (SELECT 1 FROM erasure WHERE person_id = ?)",
                        person.number);
  });
}

ErasedPieces erase_person(Database& database, const ErasureOrder& order,
                          std::optional<PersonId> actor, const Progress& progress) {
  check_free_text("the reason", order.reason);
  const JournalLine line{own_directory(database).text, order.person, order.with_recordings,
                         utc_now(database)};
  translating(database, "erase a person",
              [&] { check_erasable(database, load_person(database, order.person), order.reason); });
  add_to_journal(journal_in(database.directory() / "backups"), std::span{&line, 1});
  ErasedPieces erased;
  if (order.with_recordings) {
    erase_recordings_of(database, order.person, actor, progress, erased);
  }
  in_transaction(database, "erase a person", [&] {
    const Person person = load_person(database, order.person);
    check_erasable(database, person, order.reason);
    erased.texts = erase_rows(database, person);
    audit_erasure(database, person, order, actor);
  });
  erased.is_log_cleared = clear_log(database);
  if (progress) progress(1.0);
  return erased;
}

std::vector<JournalLine> list_erasures(Database& database) {
  const std::string directory = own_directory(database).text;
  return translating(database, "list the erasures", [&] {
    auto rows = prepared(database,
                         "SELECT ?, e.person_id, e.erased_utc, NOT EXISTS (SELECT 1 FROM attempt a "
                         "JOIN chunk USING (attempt_id) WHERE a.person_id = e.person_id) "
                         "FROM erasure e ORDER BY e.erased_utc",
                         directory);
    return rows_of(std::move(rows), &JournalLine::directory, &JournalLine::person,
                   &JournalLine::erased_utc, &JournalLine::with_recordings);
  });
}

std::int64_t apply_journal(Database& database, std::span<const JournalLine> lines,
                           bool of_any_directory) {
  const std::string directory = own_directory(database).text;
  std::int64_t people = 0;
  for (const JournalLine& line : lines) {
    if (!of_any_directory && line.directory != directory) continue;
    if (is_erased(database, line.person)) {
      if (line.with_recordings) {
        ErasedPieces erased;
        erase_recordings_of(database, line.person, std::nullopt, {}, erased);
      }
      continue;
    }
    try {
      erase_person(database,
                   {line.person, line.with_recordings,
                    "erased on " + line.erased_utc + ", said the journal"},
                   std::nullopt);
      ++people;
    } catch (const DatabaseError& error) {
      // Added after the backup was made: there is nobody to erase.
      if (error.kind() != DatabaseErrorKind::NotFound) throw;
    }
  }
  return people;
}

bool clear_log(Database& database) {
  return translating(database, "clear the log", [&] {
    return single<std::int32_t>(database, "PRAGMA wal_checkpoint(TRUNCATE)") == 0;
  });
}

}  // namespace hallux::database
