#include "database/maintenance/verify_progress.h"

namespace hallux::database {

void fail_altered(const Database& database, const std::string& row) {
  throw DatabaseError{DatabaseErrorKind::Damaged,
                      row + " in " + database.file().string() + " was altered; restore a backup"};
}

void VerifyProgress::begin(std::string part, double end) {
  part_ = std::move(part);
  begin_ = end_;
  end_ = end;
}

void VerifyProgress::tell(std::int64_t done, std::int64_t all) {
  // Somebody may add rows meanwhile.
  const double share = all > done ? static_cast<double>(done) / static_cast<double>(all) : 1.0;
  if (!told_ || told_(begin_ + share * (end_ - begin_))) return;
  throw Cancelled{"the check was stopped in " + part_ + "; no damage was found up to there"};
}

}  // namespace hallux::database
