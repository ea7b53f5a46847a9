/// Access of reports: a decision about each table of the schema, and what a report's statement may
/// do. Inside this corner only.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace hallux::database {

enum class ReportAccess {
  Open,
  /// Secrets, names, and who was where.
  Closed,
  /// Free text that somebody wrote is closed, the rest open.
  WithoutText
};

/// Nothing for a table about which nothing was decided; such a table is closed.
std::optional<ReportAccess> report_access(std::string_view table) noexcept;

/// Whether a report may read that column.
bool may_report(std::string_view table, std::string_view column) noexcept;

/// For sqlite3_set_authorizer: only SELECT, of what may be reported.
int authorize_report(void* unused, int action, const char* first, const char* second,
                     const char* schema, const char* trigger) noexcept;

}  // namespace hallux::database
