/// Rows that a transaction changed, until an act of the audit accounts for them.
/// Inside this room only.
///
///     statement --preupdate hook--> rows by table and key --settle--> act with their digests
///                                        commit hook: nothing leaves unaccounted
///
/// So nobody who writes has to name what they wrote, and nobody can forget it.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

struct sqlite3;

namespace hallux::database {

class Database;

/// A table whose rows the audit accounts for.
struct AccountedTable {
  std::string_view name;
  /// The columns of its key, with commas; they are its first.
  std::string_view keys;
  int key_count = 1;
  /// Names and words of people: their digest is salted, and the salt goes with the row.
  bool holds_words = false;
  /// A column that the rest of the row vouches for by a digest; or none.
  std::string_view left_out = {};
};

/// In the order in which they are verified.
inline constexpr std::array accounted_tables{
    AccountedTable{"directory", "directory_id"},
    AccountedTable{"simulated_course", "simulated_course_id"},
    AccountedTable{"setting", "name"},
    AccountedTable{"person", "person_id"},
    AccountedTable{"person_detail", "person_id", 1, true},
    AccountedTable{"password", "person_id"},
    AccountedTable{"one_time_code", "person_id"},
    AccountedTable{"hand_setting", "person_id"},
    AccountedTable{"cohort", "cohort_id"},
    AccountedTable{"membership", "cohort_id, person_id", 2},
    AccountedTable{"attempt_limit", "cohort_id, scenario_name", 2},
    AccountedTable{"scenario_version", "scenario_version_id", 1, false, "json"},
    AccountedTable{"scenario_state", "scenario_state_id"},
    AccountedTable{"asset", "asset_id", 1, false, "zstd"},
    AccountedTable{"attempt", "attempt_id"},
    AccountedTable{"score", "score_id"},
    AccountedTable{"measurement_set", "measurement_set_id"},
    AccountedTable{"decision", "decision_id", 1, true},
    AccountedTable{"note", "note_id", 1, true},
    AccountedTable{"note_reply", "note_reply_id", 1, true},
    AccountedTable{"help_request", "help_request_id", 1, true},
    AccountedTable{"notice", "notice_id"},
    AccountedTable{"notice_seen", "notice_id, person_id", 2},
    AccountedTable{"origin", "origin_id"},
    AccountedTable{"origin_person", "origin_id, number_there", 2},
    AccountedTable{"erased_recording", "attempt_id"},
    AccountedTable{"erasure", "person_id"},
    AccountedTable{"audit_text", "audit_id"}};

/// A table that no act accounts for, and what stands for it.
struct ExemptTable {
  std::string_view name, reason;
};

inline constexpr std::array exempt_tables{
    ExemptTable{"audit", "it is the chain itself"},
    ExemptTable{"audit_row", "each act's link is of its rows"},
    ExemptTable{"row_salt", "a wrong salt gives a wrong digest of its row"},
    ExemptTable{"measurement", "the digest of its set"},
    ExemptTable{"chunk", "the chain and the seal of its recording"},
    ExemptTable{"display_fact", "not scored, and outside the seal: another view is shown, no more"},
    ExemptTable{"session", "rewritten; who came and went stands in the audit"},
    ExemptTable{"sign_in_guard", "rewritten; refusals stand in the audit"},
    ExemptTable{"standing", "computed anew from attempts, scores and decisions, and compared"},
    ExemptTable{"cohort_snapshot", "rewritten; it follows from results"},
    ExemptTable{"cohort_snapshot_result", "rewritten; it follows from results"},
    ExemptTable{"sqlite_sequence", "SQLite's own; it gives numbers to rows to come"}};

/// By name; nothing where no act accounts for it.
const AccountedTable* accounted_table(std::string_view name) noexcept;

/// The values of a row's key with strokes between: "3/12".
using RowName = std::pair<std::string, std::string>;

/// Watches one connection.
/// thread  the connection's
class ChangedRows {
 public:
  explicit ChangedRows(sqlite3* connection);
  ~ChangedRows();
  ChangedRows(const ChangedRows&) = delete;
  ChangedRows& operator=(const ChangedRows&) = delete;

  bool is_empty() const noexcept { return rows_.empty(); }
  /// By table and key, each once.
  std::set<RowName> take();
  /// One that is accounted for elsewhere.
  void forget(const RowName& row) { rows_.erase(row); }

 private:
  friend struct ChangeHooks;
  sqlite3* connection_;
  std::set<RowName> rows_;
};

/// Accounts for what no act of this transaction did: an act of the program itself. Defined in
/// database/audit, which knows what an act is: the one call of this corner to one above it.
void settle_changes(Database& database);

/// An act that accounts for every row there is, so that a directory of an older program is covered
/// from then on. Nothing where it is covered: a second one would vouch for what was altered since.
/// Defined there as well.
/// needs   the caller's transaction
void take_baseline(Database& database);

}  // namespace hallux::database
