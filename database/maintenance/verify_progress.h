/// Progress of a verification, told by its parts, and the error of a row that was altered.
/// Inside this corner only.
#pragma once

#include <string>

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

}  // namespace hallux::database
