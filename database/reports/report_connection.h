/// Plain SQL for reports: reads, and nothing else, for a bounded time. Inside this corner only.
///
/// A connection of its own, opened read-only and defensive. An authorizer lets SELECT pass and
/// decides about each table and column (database/reports/report_access.h): passwords, codes, names,
/// sign-ins and free text stay closed, whoever asks. SQLite's limits bound what one statement may
/// take. What SQL cannot hide: a report speaks of people by number.
/// source  docs/data_format.md, "Reports"; https://www.sqlite.org/security.html
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "database/records/report.h"
#include "database/store/connection.h"

namespace hallux::database {

struct ReportLimits {
  /// No read transaction may be longer: the write-ahead log of a recording cannot be taken in
  /// before it ends.
  int time_ms = 1000;
  std::size_t rows = 100'000;
  /// Of texts and blobs together.
  std::size_t bytes = std::size_t{64} << 20U;
};

class ReportConnection {
 public:
  /// errors  DatabaseError NotFound where there is no database
  explicit ReportConnection(const std::filesystem::path& directory,
                            const ReportLimits& limits = {});

  /// The answer to one SELECT.
  /// errors  DatabaseError: Refused for what a report may not read or do; BadInput: not one
  ///         statement, wrong SQL, more rows or bytes or time than the limits; Damaged with the
  ///         place of a damaged chunk
  Report answer(const std::string& sql);

 private:
  std::unique_ptr<Database> database_;
  ReportLimits limits_;
};

}  // namespace hallux::database
