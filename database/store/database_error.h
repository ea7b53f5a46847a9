/// Errors of the database as one sentence: what was tried, on which file or row, what to do.
#pragma once

#include <stdexcept>
#include <string>

namespace hallux::database {

/// The reason, for those who answer one kind otherwise than another.
enum class DatabaseErrorKind {
  /// No space left.
  Full,
  /// The directory or the file cannot be written.
  ReadOnly,
  /// What is stored contradicts itself: a broken page, a broken chain, no database at all.
  Damaged,
  /// The disk answered with an error.
  InputOutput,
  /// Written by a newer version of this program.
  Newer,
  /// Another process kept it busy for longer than the timeout.
  Locked,
  /// This person may not do this.
  Refused,
  /// There is no such row.
  NotFound,
  /// What was given cannot be stored: a login, a password, a name twice.
  BadInput
};

/// Thrown by every function of this room whose comment names it; what() is the sentence.
class DatabaseError : public std::runtime_error {
 public:
  DatabaseError(DatabaseErrorKind kind, const std::string& sentence)
      : std::runtime_error(sentence), kind_(kind) {}
  DatabaseErrorKind kind() const noexcept { return kind_; }

 private:
  DatabaseErrorKind kind_;
};

/// True for the kinds that the disk causes, not the user.
bool is_storage_failure(DatabaseErrorKind kind) noexcept;

}  // namespace hallux::database
