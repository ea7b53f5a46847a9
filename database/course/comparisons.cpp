/// A median that follows each result would tell those who know the others what one person got. So
/// what is shown is a snapshot that stays until five people's results differ, counted in whole
/// points. Whether it is due is looked at without a lock, and once more inside the transaction that
/// replaces it.
#include "database/course/comparisons.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "database/people/cohorts.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

struct Place {
  CohortId cohort;
  std::string scenario_name, device_class;
};

/// Points by person.
using Results = std::map<std::int64_t, std::int64_t>;

auto columns_of(const Place& place) {
  return std::tie(place.cohort, place.scenario_name, place.device_class);
}

Results results_in(Database& database, const char* query, const Place& place) {
  auto rows = prepared(database, query, columns_of(place));
  Results results;
  while (rows.executeStep())
    results.emplace(rows.getColumn(0).getInt64(), rows.getColumn(1).getInt64());
  return results;
}

Results results_now(Database& database, const Place& place) {
  return results_in(database,
                    "SELECT t.person_id, t.confirmed_milli FROM membership m "
                    "JOIN standing t USING (person_id) WHERE m.cohort_id = ?1 AND m.role = "
                    "'trainee' AND t.scenario_name = ?2 AND t.device_class = ?3 "
                    "AND t.confirmed_milli IS NOT NULL",
                    place);
}

Results results_kept(Database& database, const Place& place) {
  return results_in(database,
                    "SELECT person_id, milli FROM cohort_snapshot_result WHERE cohort_id = ?1 "
                    "AND scenario_name = ?2 AND device_class = ?3",
                    place);
}

/// How many people's results came, went or changed.
std::int32_t changed_people(const Results& before, const Results& after) {
  std::int32_t changed = 0;
  for (const auto& [person, milli] : after) {
    const auto old = before.find(person);
    if (old == before.end() || old->second != milli) ++changed;
  }
  for (const auto& [person, milli] : before) changed += after.contains(person) ? 0 : 1;
  return changed;
}

bool is_due(const Results& kept, const Results& now) {
  return std::ssize(now) >= compared_people_min && changed_people(kept, now) >= changed_people_min;
}

void replace_snapshot(Database& database, const Place& place, const Results& results) {
  execute(database,
          "INSERT INTO cohort_snapshot (cohort_id, scenario_name, device_class, made_utc) "
          "VALUES (?, ?, ?, ?) ON CONFLICT DO UPDATE SET made_utc = excluded.made_utc",
          columns_of(place), utc_now(database));
  execute(database,
          "DELETE FROM cohort_snapshot_result WHERE cohort_id = ? AND "
          "scenario_name = ? AND device_class = ?",
          columns_of(place));
  auto row = prepared(database,
                      "INSERT INTO cohort_snapshot_result (cohort_id, scenario_name, "
                      "device_class, person_id, milli) VALUES (?, ?, ?, ?, ?)");
  for (const auto& [person, milli] : results) run_again(row, columns_of(place), person, milli);
}

Results renewed(Database& database, const Place& place) {
  Results kept = results_kept(database, place);
  if (!is_due(kept, results_now(database, place))) return kept;
  // Looked at once more: another window may have made it meanwhile.
  return in_transaction_of_caller(database, "compare a cohort", [&] {
    Results before = results_kept(database, place);
    Results now = results_now(database, place);
    if (!is_due(before, now)) return before;
    replace_snapshot(database, place, now);
    return now;
  });
}

std::int64_t whole_points_milli(double points) {
  return static_cast<std::int64_t>(std::llround(points)) * 1000;
}

CohortComparison comparison_of(const Place& place, const Results& results) {
  std::vector<double> points;
  for (const auto& [person, milli] : results) points.push_back(static_cast<double>(milli) / 1000.0);
  std::sort(points.begin(), points.end());
  CohortComparison comparison;
  comparison.cohort = place.cohort;
  comparison.scenario_name = place.scenario_name;
  comparison.device_class = place.device_class;
  comparison.people = static_cast<std::int32_t>(points.size());
  comparison.median_milli = whole_points_milli(quantile(points, 0.5));
  if (comparison.people >= quartile_people_min) {
    comparison.lower_milli = whole_points_milli(quantile(points, 0.25));
    comparison.upper_milli = whole_points_milli(quantile(points, 0.75));
  }
  return comparison;
}

std::vector<std::string> device_classes(Database& database, CohortId cohort,
                                        const std::string& scenario_name) {
  return all_of<std::string>(
      database,
      "SELECT t.device_class FROM standing t JOIN membership m USING (person_id) WHERE "
      "m.cohort_id = ?1 AND m.role = 'trainee' AND t.scenario_name = ?2 AND t.confirmed_milli IS "
      "NOT NULL UNION SELECT device_class FROM cohort_snapshot WHERE cohort_id = ?1 AND "
      "scenario_name = ?2 ORDER BY 1",
      cohort.number, scenario_name);
}

std::string made_utc_of(Database& database, const Place& place) {
  return found<std::string>(database,
                            "SELECT made_utc FROM cohort_snapshot WHERE cohort_id = ? AND "
                            "scenario_name = ? AND device_class = ?",
                            columns_of(place))
      .value_or("");
}

}  // namespace

double quantile(const std::vector<double>& values, double part) noexcept {
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

std::vector<CohortComparison> cohort_comparisons(Database& database, CohortId cohort,
                                                 const std::string& scenario_name) {
  return translating(database, "compare a cohort", [&] {
    std::vector<CohortComparison> comparisons;
    const std::string name = load_cohort(database, cohort).name;
    for (const std::string& device_class : device_classes(database, cohort, scenario_name)) {
      const Place place{cohort, scenario_name, device_class};
      const Results results = renewed(database, place);
      if (results.empty()) continue;
      comparisons.push_back(comparison_of(place, results));
      comparisons.back().cohort_name = name;
      comparisons.back().made_utc = made_utc_of(database, place);
    }
    return comparisons;
  });
}

}  // namespace hallux::database
