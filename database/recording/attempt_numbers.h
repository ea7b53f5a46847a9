/// The number by which everybody calls an attempt: 5 is the fifth of its person at its operation.
/// Inside this room only.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "database/records/ids.h"
#include "database/store/connection.h"

namespace hallux::database {

/// Whose attempt it is, at what, and its place among all attempts of the directory.
struct CountedAttempt {
  /// Nothing: the robot.
  std::optional<PersonId> person;
  std::string scenario_name;
  std::int64_t order = 0;
};

/// Counts over all versions of an operation, in the order in which attempts were begun here: a
/// number never changes, whatever is begun, decided or imported later.
class AttemptNumbers {
 public:
  explicit AttemptNumbers(Database& database) : database_(&database) {}

  std::int64_t number_of(const CountedAttempt& attempt);

 private:
  /// Of a person, 0 for the robot, and an operation.
  using Key = std::pair<std::int64_t, std::string>;

  Database* database_;
  /// Read once for each.
  std::map<Key, std::vector<std::int64_t>> orders_;
};

}  // namespace hallux::database
