/// A table is three texts: its name, what it means in plain words, and the SELECT whose only
/// parameter is the person. What is kept about somebody is read off here. Others are named where
/// they spoke to the person, and not where the person decided about them.
#include "database/maintenance/person_export.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "database/people/people.h"
#include "database/store/durable_file.h"
#include "database/store/fresh_directory.h"
#include "database/store/sql.h"
#include "database/text/csv_text.h"
#include "simulator/base/progress.h"

namespace hallux::database {

namespace {

using nlohmann::ordered_json;

/// What is kept about somebody; ?1 in `sql` is the person. `meaning` says what it is, why it is
/// kept, and until when.
struct KeptTable {
  const char* name;
  const char* meaning;
  const char* sql;
};

/// What somebody is and did.
constexpr std::array<KeptTable, 6> tables_of_deeds{{
    {"person",
     "Who you are here: your login, the name shown, and what you may do. Kept so that you can "
     "sign in, until you are erased. Your password is not kept, only a value from which it cannot "
     "be read back (Argon2id); that is not in here, because it would help somebody who wants to "
     "guess it.",
     "SELECT p.person_id AS number, d.login, d.display_name, p.is_administrator, p.is_disabled, "
     "p.created_utc, w.changed_utc AS password_changed_utc, c.expires_utc AS "
     "one_time_code_expires_utc FROM person p LEFT JOIN person_detail d USING (person_id) LEFT "
     "JOIN password w USING (person_id) LEFT JOIN one_time_code c USING (person_id) WHERE "
     "p.person_id = ?1"},
    {"cohorts", "The groups you are in, and as what.",
     "SELECT h.name AS cohort, m.role, m.enrolled_utc FROM membership m JOIN cohort h USING "
     "(cohort_id) WHERE m.person_id = ?1 ORDER BY h.name"},
    {"hand_settings",
     "How you hold the saw: with which hand, and over what is set for a station how far the saw "
     "goes "
     "for your hand and how much of a device's force you feel at most, in thousandths. Kept so "
     "that "
     "it is so wherever you sign in, until you choose otherwise or are erased.",
     "SELECT is_left_handed, motion_scale_milli, force_share_milli, changed_utc FROM hand_setting "
     "WHERE person_id = ?1"},
    {"sign_ins",
     "When you signed in and out. Kept so that somebody else's use of your account can be noticed.",
     "SELECT session_id AS session, started_utc, ended_utc FROM session WHERE person_id = ?1 "
     "ORDER BY session_id"},
    {"attempts",
     "Every operation you began: what, when, with which device, and how well it was recorded. The "
     "recording itself (where the tool was, a thousand times a second) is large: `hallux export` "
     "writes it, attempt by attempt, with which view was on your screen (views.csv). "
     "recording_bytes says how large it is, recording_erased_utc "
     "since when it is gone.",
     "SELECT a.uuid AS attempt, v.name AS operation, v.version, a.kind, a.guidance, a.hand, "
     "a.device_class, a.pacing, a.stereo_mode, a.started_utc, a.state, a.duration_ticks AS "
     "duration_ms, a.is_valid, a.is_simulated, a.quality_json, (SELECT sum(length(c.bytes)) FROM "
     "chunk c WHERE c.attempt_id = a.attempt_id) AS recording_bytes, e.erased_utc AS "
     "recording_erased_utc FROM attempt a JOIN scenario_version v USING (scenario_version_id) "
     "LEFT JOIN erased_recording e USING (attempt_id) WHERE a.person_id = ?1 ORDER BY "
     "a.attempt_id"},
    {"scores",
     "What the machine gave each attempt, in thousandths of a point, and its reasons (card_json). "
     "Where there are several, the one without a successor counts. An instructor decides whether "
     "it is a grade.",
     "SELECT a.uuid AS attempt, s.stored_utc, s.scenario_version, s.rubric_version, "
     "s.engine_version, s.score_milli, s.measured_weight_milli, s.superseded_by IS NULL AS "
     "is_in_force, s.card_json FROM score s JOIN attempt a USING (attempt_id) WHERE a.person_id = "
     "?1 ORDER BY s.score_id"},
}};

/// What was said about it, and by them, and who did what.
constexpr std::array<KeptTable, 7> tables_of_remarks{{
    {"decisions", "What instructors decided about your results, and why.",
     "SELECT a.uuid AS attempt, r.kind, r.score_milli, r.reason, d.display_name AS decided_by, "
     "r.decided_utc, r.superseded_by IS NULL AS is_in_force FROM decision r JOIN attempt a USING "
     "(attempt_id) LEFT JOIN person_detail d ON d.person_id = r.decided_by_person_id WHERE "
     "a.person_id = ?1 ORDER BY r.decision_id"},
    {"decisions_by_you",
     "What you decided as an instructor about the results of others, who are not named here.",
     "SELECT a.uuid AS attempt, r.kind, r.score_milli, r.reason, r.decided_utc FROM decision r "
     "JOIN attempt a USING (attempt_id) WHERE r.decided_by_person_id = ?1 ORDER BY r.decision_id"},
    {"notes",
     "Notes on moments of your attempts that you can see, and those you wrote. Instructors may "
     "keep notes among themselves; their number is under private_notes, ask your course for them.",
     "SELECT a.uuid AS attempt, n.moment_us, n.author_person_id = ?1 AS is_yours, d.display_name "
     "AS author, n.text, n.written_utc FROM note n JOIN attempt a USING (attempt_id) LEFT JOIN "
     "person_detail d ON d.person_id = n.author_person_id WHERE n.author_person_id = ?1 OR "
     "(a.person_id = ?1 AND n.is_private = 0) ORDER BY n.note_id"},
    {"private_notes", "How many notes instructors keep among themselves about your attempts.",
     "SELECT count(*) AS notes FROM note n JOIN attempt a USING (attempt_id) WHERE a.person_id = "
     "?1 AND n.is_private = 1 AND n.author_person_id <> ?1"},
    {"replies", "Answers to those notes, yours and those of others on your attempts.",
     "SELECT a.uuid AS attempt, d.display_name AS author, r.text, r.written_utc FROM note_reply r "
     "JOIN note n USING (note_id) JOIN attempt a USING (attempt_id) LEFT JOIN person_detail d ON "
     "d.person_id = r.author_person_id WHERE r.author_person_id = ?1 OR (a.person_id = ?1 AND "
     "n.is_private = 0) ORDER BY r.note_reply_id"},
    {"questions",
     "What you asked your instructors, what they answered, and what you answered as one.",
     "SELECT a.uuid AS attempt, h.moment_us, h.asker_person_id = ?1 AS is_yours, h.question, "
     "h.asked_utc, h.answer, d.display_name AS answered_by, h.answered_utc FROM help_request h "
     "JOIN attempt a USING (attempt_id) LEFT JOIN person_detail d ON d.person_id = "
     "h.answered_by_person_id WHERE h.asker_person_id = ?1 OR h.answered_by_person_id = ?1 ORDER "
     "BY h.help_request_id"},
    {"log",
     "The lines of the log that are by you or about you: who did what to your account and your "
     "attempts, and who saw them (attempt_viewed, person_exported). It is never altered; names in "
     "it go with an erasure, numbers stay. Texts are in here where the line is by you.",
     "SELECT u.at_utc, u.actor_person_id = ?1 AS is_by_you, d.display_name AS by_whom, u.action, "
     "u.subject_kind, u.subject_id, u.outcome, iif(u.actor_person_id = ?1, t.text, NULL) AS text "
     "FROM audit u LEFT JOIN person_detail d ON d.person_id = u.actor_person_id LEFT JOIN "
     "audit_text t USING (audit_id) WHERE u.actor_person_id = ?1 OR (u.subject_kind = 'person' "
     "AND u.subject_id = CAST(?1 AS TEXT)) OR (u.subject_kind = 'membership' AND u.subject_id "
     "LIKE '%/' || ?1) OR u.subject_id IN (SELECT uuid FROM attempt WHERE person_id = ?1) ORDER "
     "BY u.audit_id"},
}};

constexpr const char* beginning =
    "What this directory keeps about you\r\n\r\nYou, or an administrator for you, asked for a "
    "copy of everything that this training course keeps about you. Each table is here twice: as a "
    ".csv file for a spreadsheet, and all together in person.json for another program. Times are "
    "UTC. The course keeps this to let you practise, to show you and your instructors how you "
    "stand, and to grade assessments. You see your own attempts; the instructors of your cohorts "
    "see them as well; administrators see who there is and what was done, and can export your "
    "attempts or what is kept about you. The log below says who looked and who exported.\r\n\r\nIf "
    "something is wrong, or should go, tell an "
    "administrator of the course: they can correct your name, and erase you, with or without your "
    "recordings. Results then stay as a statistic that names nobody. How long recordings are kept "
    "is set by the course. Copies are made (backups) so that nothing is lost; they are let go by "
    "age, and who was erased does not come back with one.\r\n\r\n";

ordered_json json_of(const SQLite::Column& column) {
  switch (column.getType()) {
    case SQLITE_INTEGER:
      return column.getInt64();
    case SQLITE_FLOAT:
      return column.getDouble();
    case SQLITE_TEXT:
      return column.getString();
    default:
      return nullptr;
  }
}

class PersonWriter {
 public:
  PersonWriter(Database& database, PersonId person, const std::filesystem::path& directory)
      : database_(database),
        person_(person),
        fresh_(directory, database.directory()),
        done_{directory} {}

  PersonExport write(const Progress& progress) {
    std::string explanation = beginning;
    translating(database_, "export a person", [&] {
      const SQLite::Transaction snapshot{database_.connection()};
      double part = 0.0;
      const auto add = [&](const KeptTable& table) {
        if (progress && !progress(part))
          throw Cancelled{"the export was stopped; nothing was left"};
        write_table(table);
        explanation += std::string{table.name} + ".csv\r\n  " + table.meaning + "\r\n\r\n";
        part += 1.0 / static_cast<double>(tables_of_deeds.size() + tables_of_remarks.size());
      };
      for (const KeptTable& table : tables_of_deeds) add(table);
      for (const KeptTable& table : tables_of_remarks) add(table);
    });
    write_file("person.json",
               all_.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n");
    write_file("explanation.txt", explanation);
    fresh_.finish();
    if (progress) progress(1.0);
    return done_;
  }

 private:
  void write_table(const KeptTable& table) {
    auto rows = prepared(database_, table.sql, person_.number);
    std::string csv;
    for (int i = 0; i < rows.getColumnCount(); ++i) {
      csv += (i > 0 ? "," : "") + csv_cell(rows.getColumnName(i));
    }
    csv += "\r\n";
    ordered_json& all = all_[table.name] = ordered_json::array();
    for (; rows.executeStep(); ++done_.rows) {
      ordered_json row;
      for (int i = 0; i < rows.getColumnCount(); ++i) {
        const SQLite::Column value = rows.getColumn(i);
        row[value.getName()] = json_of(value);
        csv +=
            (i > 0 ? "," : "") + csv_cell(value.getString(), value.isInteger() || value.isFloat());
      }
      csv += "\r\n";
      all.push_back(std::move(row));
    }
    write_file(std::string{table.name} + ".csv", csv);
  }

  void write_file(const std::string& name, const std::string& content) {
    DurableFile file = DurableFile::create(fresh_.path() / name);
    file.write(std::as_bytes(std::span{content.data(), content.size()}));
    file.sync();
    ++done_.files;
  }

  Database& database_;
  PersonId person_;
  FreshDirectory fresh_;
  PersonExport done_;
  ordered_json all_;
};

}  // namespace

PersonExport export_person(Database& database, PersonId person,
                           const std::filesystem::path& directory, const Progress& progress) {
  load_person(database, person);
  return PersonWriter{database, person, directory}.write(progress);
}

}  // namespace hallux::database
