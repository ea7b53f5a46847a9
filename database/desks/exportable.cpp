#include "database/desks/exportable.h"

#include <algorithm>

#include "database/people/cohorts.h"
#include "database/people/people.h"
#include "database/recording/attempts.h"

namespace hallux::database {

namespace {

/// False where the choice names what is not there.
bool fill_filter(Database& database, const ExportChoice& choice, AttemptFilter& filter) {
  if (!choice.login.empty()) {
    const std::optional<Person> person = known_person(database, choice.login);
    if (!person) return false;
    filter.person = person->id;
  }
  if (!choice.cohort.empty()) {
    const std::vector<Cohort> cohorts = list_cohorts(database);
    const auto named = std::find_if(cohorts.begin(), cohorts.end(), [&](const Cohort& cohort) {
      return cohort.name == choice.cohort;
    });
    if (named == cohorts.end()) return false;
    filter.cohort = named->id;
  }
  return true;
}

}  // namespace

std::vector<AttemptId> exportable_attempts(Database& database, Session& session,
                                           const ExportChoice& choice) {
  AttemptFilter filter;
  if (!fill_filter(database, choice, filter)) return {};
  std::vector<AttemptDesk> desks = session.desks();
  std::vector<AttemptId> ids;
  for (const AttemptHeader& header : list_attempts(database, filter)) {
    const bool is_allowed = header.state != AttemptState::Recording &&
                            std::any_of(desks.begin(), desks.end(), [&](AttemptDesk& desk) {
                              return desk.may(Action::ExportAttempt, header);
                            });
    if (is_allowed) ids.push_back(header.id);
  }
  std::reverse(ids.begin(), ids.end());
  return ids;
}

}  // namespace hallux::database
