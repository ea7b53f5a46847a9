#include "database/reports/report_access.h"

#include <sqlite3.h>

#include <algorithm>
#include <string>

namespace hallux::database {

namespace {

struct TableAccess {
  std::string_view table;
  ReportAccess access = ReportAccess::Closed;
};

using enum ReportAccess;

/// By name. A table that is added to the schema is added here, or a test says so.
constexpr std::array decisions{
    TableAccess{"asset", Open},
    TableAccess{"attempt", Open},
    TableAccess{"attempt_limit", Open},
    TableAccess{"attempt_result", Open},
    TableAccess{"audit", Open},
    TableAccess{"audit_row", Open},
    TableAccess{"audit_text", Closed},
    TableAccess{"chunk", Open},
    TableAccess{"cohort", Open},
    TableAccess{"cohort_snapshot", Open},
    TableAccess{"cohort_snapshot_result", Open},
    TableAccess{"decision", WithoutText},
    TableAccess{"directory", Open},
    TableAccess{"display_fact", Open},
    TableAccess{"erased_recording", Open},
    TableAccess{"erasure", Open},
    TableAccess{"hand_setting", Closed},
    TableAccess{"help_request", WithoutText},
    TableAccess{"measurement", Open},
    TableAccess{"measurement_set", Open},
    TableAccess{"membership", Open},
    TableAccess{"note", WithoutText},
    TableAccess{"note_reply", WithoutText},
    TableAccess{"notice", Closed},
    TableAccess{"notice_seen", Closed},
    TableAccess{"one_time_code", Closed},
    TableAccess{"origin", Open},
    TableAccess{"origin_person", Open},
    TableAccess{"password", Closed},
    TableAccess{"person", Open},
    TableAccess{"person_detail", Closed},
    TableAccess{"row_salt", Closed},
    TableAccess{"scenario_state", Open},
    TableAccess{"scenario_version", Open},
    TableAccess{"score", Open},
    TableAccess{"session", Closed},
    TableAccess{"setting", Open},
    TableAccess{"sign_in_guard", Closed},
    TableAccess{"simulated_course", Open},
    TableAccess{"sqlite_sequence", Open},
    TableAccess{"standing", Open},
    TableAccess{"standing_as_counted", Open},
    TableAccess{"standing_to_mend", Open},
};

/// Beside the schema: what SQLite and this room bring.
constexpr std::array<std::string_view, 7> brought{"cut_events",   "json_each",     "json_tree",
                                                  "pose_samples", "sqlite_master", "sqlite_schema",
                                                  "tape_lines"};
/// What computes from values alone, with blanks around each; others take pointers, load code, or
/// tell of the program.
constexpr std::string_view functions =
    " -> ->> abs acos acosh asin asinh atan atan2 avg ceil ceiling char coalesce cos cosh count "
    "cume_dist date datetime degrees dense_rank exp first_value floor format glob group_concat "
    "hex ifnull iif instr json json_array json_array_length json_each json_extract "
    "json_group_array json_group_object json_object json_quote json_tree json_type json_valid "
    "julianday lag last_value lead length like likelihood likely ln log log10 log2 lower ltrim "
    "max min mod nth_value ntile nullif percent_rank pi pow power printf quote radians random "
    "rank replace round row_number rtrim sign sin sinh sqrt strftime substr substring sum tan "
    "tanh time total trim trunc typeof unicode unixepoch unlikely upper ";
constexpr std::array<std::string_view, 4> texts{"answer", "question", "reason", "text"};

bool is_listed(std::string_view function) {
  return functions.find(" " + std::string{function} + " ") != std::string_view::npos;
}

}  // namespace

std::optional<ReportAccess> report_access(std::string_view table) noexcept {
  const auto* const decision = std::ranges::find(decisions, table, &TableAccess::table);
  if (decision == decisions.end()) return std::nullopt;
  return decision->access;
}

bool may_report(std::string_view table, std::string_view column) noexcept {
  if (std::ranges::find(brought, table) != brought.end()) return true;
  const auto access = report_access(table);
  // A statement's own WITH table is named only where its rows are counted and no column is read.
  if (!access) return column.empty();
  if (*access == Closed) return false;
  return *access == Open || std::ranges::find(texts, column) == texts.end();
}

int authorize_report(void* unused, int action, const char* first, const char* second,
                     const char* schema, const char* trigger) noexcept {
  static_cast<void>(unused);
  static_cast<void>(schema);
  static_cast<void>(trigger);
  const std::string_view name = first == nullptr ? "" : first;
  const std::string_view part = second == nullptr ? "" : second;
  switch (action) {
    case SQLITE_SELECT:
    case SQLITE_RECURSIVE:
      return SQLITE_OK;
    case SQLITE_FUNCTION:
      return is_listed(part) ? SQLITE_OK : SQLITE_DENY;
    case SQLITE_READ:
      return may_report(name, part) ? SQLITE_OK : SQLITE_DENY;
    default:
      return SQLITE_DENY;
  }
}

}  // namespace hallux::database
