/// Lease that shows other processes that an attempt's writer is alive. Inside this room only.
///
/// An advisory lock (flock) on writers/UUID.lock: the kernel gives it back the moment the process
/// ends, however it ends, so no clock, process number or boot id has to be trusted.
#pragma once

#include <filesystem>

#include "database/records/ids.h"

namespace hallux::database {

class WriterLease {
 public:
  /// Takes the lease of an attempt that no other process knows yet.
  /// errors  DatabaseError (ReadOnly, Full, InputOutput) where the lock file cannot be made
  static WriterLease take(const std::filesystem::path& directory, AttemptId attempt);
  /// True while some process, this one included, holds the lease.
  static bool is_held(const std::filesystem::path& directory, const AttemptId& attempt) noexcept;
  /// Removes the lock file of a writer that is gone.
  static void clear(const std::filesystem::path& directory, const AttemptId& attempt) noexcept;

  WriterLease(WriterLease&& other) noexcept;
  WriterLease& operator=(WriterLease&& other) noexcept;
  ~WriterLease();

  const AttemptId& attempt() const noexcept { return attempt_; }

 private:
  WriterLease(std::filesystem::path file, AttemptId attempt, int descriptor);
  void release() noexcept;

  std::filesystem::path file_;
  AttemptId attempt_;
  int descriptor_ = -1;
};

}  // namespace hallux::database
