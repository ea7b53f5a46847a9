/// Process of its own for a report: whatever its statement does, it ends after its time.
///
///     this process --statement--> child: a report connection of its own, a bounded heap
///                  <---answer----    killed when the time is over, or when this process ends
///
/// SQLite looks at a deadline between its operations only, and one operation may take minutes. The
/// child begins before this process opens a database, because SQLite's connections do not go along.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "database/reports/report_connection.h"

namespace hallux::database {

class ReportProcess {
 public:
  /// needs   one thread, and no connection open: make it first
  /// errors  DatabaseError where the system gives no process
  explicit ReportProcess(const ReportLimits& limits = {});
  /// Ends it, also in the middle.
  ~ReportProcess();
  ReportProcess(const ReportProcess&) = delete;
  ReportProcess& operator=(const ReportProcess&) = delete;

  /// The answer to one SELECT, once.
  /// errors  as ReportConnection; Cancelled where a signal came meanwhile
  Report answer(const std::filesystem::path& directory, const std::string& sql);

 private:
  ReportLimits limits_;
  pid_t child_ = -1;
  /// To the child, from the child.
  int asking_ = -1, answering_ = -1;
};

}  // namespace hallux::database
