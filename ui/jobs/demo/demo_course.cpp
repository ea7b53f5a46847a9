#include "ui/jobs/demo/demo_course.h"

#include <algorithm>
#include <system_error>

#include "database/course/simulated_course.h"
#include "database/maintenance/backup.h"
#include "database/store/files.h"
#include "simulator/base/progress.h"
#include "ui/jobs/course/scenario_jobs.h"
#include "ui/jobs/demo/demo_people.h"

namespace hallux::ui {

namespace {

namespace fs = std::filesystem;

constexpr const char* staging_name = "demo-in-the-making";

/// The folder in which the course is made; gone at the end, whatever the end. Only one at a time in
/// a directory.
class Staging {
 public:
  explicit Staging(const fs::path& directory)
      : was_there_(fs::exists(directory)), directory_(directory), lease_(take(directory)) {
    fs::remove_all(folder());
  }
  ~Staging() {
    std::error_code ignored;
    fs::remove_all(folder(), ignored);
    { const database::WriterLease given_back = std::move(lease_); }
    if (was_there_ || fs::exists(directory_ / "hallux.db", ignored)) return;
    fs::remove(directory_ / "writers", ignored);
    fs::remove(directory_, ignored);
  }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  fs::path folder() const { return directory_ / staging_name; }

 private:
  static database::WriterLease take(const fs::path& directory) {
    const database::AttemptId name{staging_name};
    database::make_private_directory(directory);
    if (database::WriterLease::is_held(directory, name)) {
      throw database::DatabaseError{database::DatabaseErrorKind::Locked,
                                    "a simulated course is being made in " + directory.string() +
                                        " by another program; wait for it"};
    }
    database::WriterLease::clear(directory, name);
    return database::WriterLease::take(directory, name);
  }

  bool was_there_;
  fs::path directory_;
  database::WriterLease lease_;
};

/// Said before a minute of work: what is there already stays.
void check_is_empty(const fs::path& directory) {
  if (!fs::exists(directory / "hallux.db")) return;
  database::Database database = database::Database::open(directory);
  database::check_may_be_simulated(database);
}

/// What has the fewest cuts is learned first.
std::vector<scenarios::Scenario> operated_scenarios(const DemoOptions& options) {
  std::vector<scenarios::Scenario> operated =
      options.scenarios.empty() ? list_scenarios() : options.scenarios;
  std::stable_sort(operated.begin(), operated.end(),
                   [](const scenarios::Scenario& a, const scenarios::Scenario& b) {
                     return a.cuts.size() < b.cuts.size();
                   });
  return operated;
}

std::vector<DemoOperation> prepare(const std::vector<scenarios::Scenario>& scenarios,
                                   const StageProgress& progress) {
  const auto report = progress("Building the bones");
  std::vector<DemoOperation> operations;
  for (const scenarios::Scenario& scenario : scenarios) {
    const double before = static_cast<double>(operations.size());
    const auto all = static_cast<double>(scenarios.size());
    std::vector<simulator::Bone> bones =
        cancelled_as("stopped while the bones were built; nothing was kept", [&] {
          return scenarios::make_patient_bones(scenario,
                                               part_of(report, before / all, (before + 1.0) / all));
        });
    DemoOperation operation{scenario, std::move(bones), {}};
    operation.plan = plan_on(operation.scenario, operation.bones);
    operations.push_back(std::move(operation));
  }
  report(1.0);
  return operations;
}

}  // namespace

DemoCourse make_demo_course(const fs::path& directory, const DemoOptions& options,
                            const StageProgress& progress) {
  check_is_empty(directory);
  const Staging staging(directory);
  const std::vector<DemoOperation> operations = prepare(operated_scenarios(options), progress);
  const std::vector<DemoAttempt> planned =
      plan_demo_attempts(operations.size(), options.attempts_max);
  database::Database database = database::Database::open(staging.folder());
  DemoPeople people(database, options);
  people.found(operations);
  const auto report = progress("Operating");
  DemoAttemptLine line(operations, planned);
  for (std::size_t i = 0; i < planned.size(); ++i) people.add(line.take(report));
  database::Database target = database::Database::open(directory);
  database::mark_as_simulated_course(target);
  database::copy_whole(database, target);
  report(1.0);
  return people.take();
}

}  // namespace hallux::ui
