/// For database/maintenance/verify.cpp only: its parts. Each reads a piece at a time, so that no reading holds up a writer's log for long.
#pragma once

#include <string>

#include "database/audit/audit.h"
#include "database/maintenance/verify.h"
#include "simulator/base/progress.h"

namespace hallux::database {

[[noreturn]] void fail_altered(const Database& database, const std::string& row);

/// Tells how far a verification is, and ends it where that is asked for.
class VerifyProgress {
 public:
  explicit VerifyProgress(const Progress& told) : told_(told) {}

  /// The part that begins, and where it ends in the whole [0, 1].
  void begin(std::string part, double end);
  /// `done` of `all` pieces of this part.
  /// errors  Cancelled
  void tell(std::int64_t done, std::int64_t all);

 private:
  const Progress& told_;
  std::string part_;
  double begin_ = 0.0, end_ = 0.0;
};

/// SQLite's own checks, table by table, and of the chunks that each row stands in the indices that reading goes by.
/// errors  DatabaseError Damaged; Cancelled
void check_pages(Database& database, VerifyProgress& progress);

/// Every score is what its card says, and the newest of an attempt is in force.
/// errors  DatabaseError Damaged; Cancelled
void check_scores(Database& database, VerifyProgress& progress, Verification& found);

/// The chain of the audit, and that what it names as begun, sealed, stored and decided is still so and nothing else is.
/// errors  DatabaseError Damaged; Cancelled
void check_audit(Database& database, VerifyProgress& progress, Verification& found);

}  // namespace hallux::database
