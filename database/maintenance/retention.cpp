/// What would go is a list, made by the same question for the dry run and for the act; each piece
/// is asked about once more in its own transaction, because somebody may have decided or asked
/// since. A setting that is no number of days means for ever: nothing goes by mistake.
#include "database/maintenance/retention.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <system_error>

#include "database/audit/audit.h"
#include "database/maintenance/erasures.h"
#include "database/recording/erased_recordings.h"
#include "database/store/settings.h"
#include "database/store/sql.h"
#include "simulator/base/progress.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

/// ?1 and ?2 are the days of practices and of assessments (null: for ever), ?3 is now, ?4 an
/// attempt, or null for all.
constexpr const char* due_recordings =
    "SELECT a.uuid, a.kind, max(a.started_utc, coalesce((SELECT max(d.decided_utc) FROM decision d "
    "WHERE d.attempt_id = a.attempt_id), '')) AS since, (SELECT sum(length(c.bytes)) FROM chunk c "
    "WHERE c.attempt_id = a.attempt_id) AS bytes, coalesce(p.login, '') FROM attempt a "
    "LEFT JOIN person_detail p USING (person_id) WHERE a.state <> 'recording' "
    "AND (?4 IS NULL OR a.uuid = ?4) "
    "AND a.started_utc < strftime('%Y-%m-%dT%H:%M:%fZ', ?3, "
    "'-' || iif(a.kind = 'practice', ?1, ?2) || ' days') "
    "AND since < strftime('%Y-%m-%dT%H:%M:%fZ', ?3, "
    "'-' || iif(a.kind = 'practice', ?1, ?2) || ' days') "
    "AND EXISTS (SELECT 1 FROM chunk c WHERE c.attempt_id = a.attempt_id) "
    "AND NOT EXISTS (SELECT 1 FROM help_request h WHERE h.attempt_id = a.attempt_id "
    "AND h.answered_utc IS NULL) ORDER BY since";

/// ?1 are the days, ?2 is now, ?3 a person's number, or null for all.
constexpr const char* due_accounts =
    "SELECT 'account', p.person_id, d.login, max(u.at_utc) AS since FROM person p "
    "JOIN person_detail d USING (person_id) JOIN audit u ON u.action = 'person_disabled' "
    "AND u.subject_kind = 'person' AND u.outcome = 'done' AND u.subject_id = CAST(p.person_id AS "
    "TEXT) "
    "WHERE p.is_disabled = 1 AND (?3 IS NULL OR p.person_id = ?3) GROUP BY p.person_id "
    "HAVING since < strftime('%Y-%m-%dT%H:%M:%fZ', ?2, '-' || ?1 || ' days') ORDER BY since";

constexpr const char* practice_name = "retain_practice_days";
constexpr const char* assessment_name = "retain_assessment_days";
constexpr const char* account_name = "retain_account_days";
constexpr const char* cache_name = "retain_cache_days";

/// What another program wrote there and is no number of days means for ever: nothing goes by
/// mistake.
std::optional<std::int32_t> days_setting(Database& database, const char* name) {
  const std::optional<std::string> text = read_setting(database, name);
  if (!text) return std::nullopt;
  std::int32_t days = 0;
  const char* end = text->data() + text->size();
  const auto read = std::from_chars(text->data(), end, days);
  const bool is_good =
      read.ec == std::errc{} && read.ptr == end && days >= 1 && days <= retention_days_most;
  return is_good ? std::optional{days} : std::nullopt;
}

std::vector<RetentionPiece> recordings_due(Database& database, const RetentionRules& rules,
                                           const std::optional<std::string>& only = {}) {
  auto rows = prepared(database, due_recordings, rules.practice_days, rules.assessment_days,
                       utc_now(database), only);
  return rows_of(std::move(rows), &RetentionPiece::name, &RetentionPiece::kind,
                 &RetentionPiece::since_utc, &RetentionPiece::bytes, &RetentionPiece::login);
}

std::vector<RetentionPiece> accounts_due(Database& database, const RetentionRules& rules,
                                         const std::optional<std::string>& only = {}) {
  if (!rules.account_days) return {};
  auto rows = prepared(database, due_accounts, *rules.account_days, utc_now(database), only);
  return rows_of(std::move(rows), &RetentionPiece::kind, &RetentionPiece::name,
                 &RetentionPiece::login, &RetentionPiece::since_utc);
}

std::string utc_of(fs::file_time_type written) {
  const auto moment = fs::file_time_type::clock::to_sys(written);
  const auto day = std::chrono::floor<std::chrono::days>(moment);
  const std::chrono::year_month_day date{day};
  std::string text = std::to_string(static_cast<int>(date.year()));
  const auto append = [&text](unsigned number) {
    text += (number < 10 ? "-0" : "-") + std::to_string(number);
  };
  append(static_cast<unsigned>(date.month()));
  append(static_cast<unsigned>(date.day()));
  return text;
}

/// By the day: files know no pretended time, so that the clock's is taken here.
std::vector<RetentionPiece> cache_due(const Database& database, const RetentionRules& rules) {
  std::vector<RetentionPiece> pieces;
  if (!rules.cache_days) return pieces;
  const auto oldest = fs::file_time_type::clock::now() - std::chrono::days{*rules.cache_days};
  std::error_code error;
  for (fs::directory_iterator entry{database.directory() / "cache", error}, end;
       !error && entry != end; entry.increment(error)) {
    std::error_code unknown;
    const fs::file_time_type written = entry->last_write_time(unknown);
    if (unknown || !entry->is_regular_file(unknown) || written >= oldest) continue;
    const std::uintmax_t bytes = entry->file_size(unknown);
    pieces.push_back({RetainedKind::Cache, entry->path().filename().string(), "", utc_of(written),
                      unknown ? 0 : static_cast<std::int64_t>(bytes)});
  }
  return pieces;
}

void remove_recording(Database& database, const RetentionRules& rules, const RetentionPiece& piece,
                      std::optional<PersonId> actor, RetentionDone& done) {
  const std::int64_t bytes = in_transaction(database, "let a recording go", [&] {
    // Somebody may have decided or asked since the plan was made.
    if (recordings_due(database, rules, piece.name).empty()) return std::int64_t{0};
    return erase_recording(database, {piece.name}, actor);
  });
  done.bytes += bytes;
  done.recordings += bytes > 0 ? 1 : 0;
}

void remove_account(Database& database, const RetentionRules& rules, const RetentionPiece& piece,
                    std::optional<PersonId> actor, RetentionDone& done) {
  if (accounts_due(database, rules, piece.name).empty()) return;
  std::int64_t number = 0;
  std::from_chars(piece.name.data(), piece.name.data() + piece.name.size(), number);
  erase_person(database,
               {{number},
                false,
                "closed for more than " + std::to_string(rules.account_days.value_or(0)) + " days"},
               actor);
  ++done.accounts;
}

void remove_cached(const Database& database, const RetentionPiece& piece, RetentionDone& done) {
  std::error_code ignored;
  if (!fs::remove(database.directory() / "cache" / piece.name, ignored)) return;
  ++done.cached;
  done.bytes += piece.bytes;
}

void remove_piece(Database& database, const RetentionRules& rules, const RetentionPiece& piece,
                  std::optional<PersonId> actor, RetentionDone& done) {
  switch (piece.kind) {
    case RetainedKind::Practice:
    case RetainedKind::Assessment:
      return remove_recording(database, rules, piece, actor, done);
    case RetainedKind::Account:
      return remove_account(database, rules, piece, actor, done);
    case RetainedKind::Cache:
      return remove_cached(database, piece, done);
  }
}

std::string sentence_of(const RetentionDone& done) {
  return std::to_string(done.recordings) + " recordings, " + std::to_string(done.accounts) +
         " accounts, " + std::to_string(done.cached) + " cached files, " +
         std::to_string(done.bytes) + " bytes";
}

}  // namespace

RetentionRules load_retention(Database& database) {
  return {days_setting(database, practice_name), days_setting(database, assessment_name),
          days_setting(database, account_name), days_setting(database, cache_name)};
}

void store_retention(Database& database, const RetentionRules& rules) {
  const auto store = [&](const char* name, const std::optional<std::int32_t>& days) {
    if (days && (*days < 1 || *days > retention_days_most)) {
      throw DatabaseError{DatabaseErrorKind::BadInput,
                          "what is kept is kept for 1 to 36500 days, or for ever; choose a number "
                          "in between"};
    }
    store_setting(database, name, days ? std::to_string(*days) : "ever");
  };
  in_transaction_of_caller(database, "store how long what is kept", [&] {
    store(practice_name, rules.practice_days);
    store(assessment_name, rules.assessment_days);
    store(account_name, rules.account_days);
    store(cache_name, rules.cache_days);
  });
}

std::vector<RetentionPiece> plan_retention(Database& database) {
  return translating(database, "look for what need not be kept", [&] {
    const RetentionRules rules = load_retention(database);
    std::vector<RetentionPiece> pieces = recordings_due(database, rules);
    for (RetentionPiece& piece : accounts_due(database, rules)) pieces.push_back(std::move(piece));
    for (RetentionPiece& piece : cache_due(database, rules)) pieces.push_back(std::move(piece));
    return pieces;
  });
}

RetentionDone apply_retention(Database& database, std::optional<PersonId> actor,
                              const Progress& progress) {
  const RetentionRules rules = load_retention(database);
  const std::vector<RetentionPiece> pieces = plan_retention(database);
  RetentionDone done;
  const auto say_what_went = [&] {
    append_audit(database,
                 {actor, "retention_applied", "database", "", false, {}, sentence_of(done)});
    clear_log(database);
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (progress && !progress(static_cast<double>(i) / static_cast<double>(pieces.size()))) {
      say_what_went();
      throw Cancelled{"it was stopped after " + sentence_of(done) + "; once more goes on"};
    }
    remove_piece(database, rules, pieces[i], actor, done);
  }
  say_what_went();
  if (progress) progress(1.0);
  return done;
}

}  // namespace hallux::database
