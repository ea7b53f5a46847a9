/// What can go wrong with what is kept, as one sentence: what was tried, on which file or row, what to do.
#pragma once

#include <stdexcept>
#include <string>

namespace hallux::database {

enum class DatabaseErrorKind {
  Full,      ///< no space left
  ReadOnly,  ///< the directory or the file cannot be written
  Damaged,  ///< what is stored contradicts itself: a broken page, a broken chain, no database at all
  InputOutput,  ///< the disk answered with an error
  Newer,        ///< written by a newer version of this program
  Locked,       ///< another process kept it busy for longer than the timeout
  Refused,      ///< this person may not do this
  NotFound,     ///< there is no such row
  BadInput      ///< what was given cannot be stored: a login, a password, a name twice
};

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
