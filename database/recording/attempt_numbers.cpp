/// All attempts of a person at an operation are read at once, from an index that holds all that is
/// asked: a list names many of them.
#include "database/recording/attempt_numbers.h"

#include <algorithm>

#include "database/store/sql.h"

namespace hallux::database {

std::int64_t AttemptNumbers::number_of(const CountedAttempt& attempt) {
  const Key key{attempt.person.value_or(PersonId{}).number, attempt.scenario_name};
  auto known = orders_.find(key);
  if (known == orders_.end()) {
    known =
        orders_
            .emplace(key, all_of<std::int64_t>(
                              *database_,
                              "SELECT attempt_id FROM attempt WHERE person_id IS ?1 "
                              "AND scenario_version_id IN "
                              "(SELECT scenario_version_id FROM scenario_version WHERE name = ?2) "
                              "ORDER BY attempt_id",
                              attempt.person, attempt.scenario_name))
            .first;
  }
  const std::vector<std::int64_t>& orders = known->second;
  return std::lower_bound(orders.begin(), orders.end(), attempt.order) - orders.begin() + 1;
}

}  // namespace hallux::database
