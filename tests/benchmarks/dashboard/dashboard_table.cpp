// What the screens ask of a course of 1,000 trainees with 100 attempts each, question by question
// as they ask it: the goal is that none takes 50 ms.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>

#include "database/desks/session.h"
#include "simulator/base/random.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/report/table.h"
#include "tests/database/big_course.h"

namespace hallux::benchmarks {

namespace {

constexpr const char* password = "a long enough phrase";

struct Desks {
  explicit Desks(database::Database& database)
      : own(sign_in_as(database, "trainee-1")),
        teaching(sign_in_as(database, "kim")),
        idle_teaching(sign_in_as(database, "lee")),
        administering(sign_in_as(database, "root")),
        trainee(*own.trainee()),
        instructor(*teaching.instructor_of({1})),
        idle(*idle_teaching.instructor_of({2})),
        administrator(*administering.administrator()) {}

  static database::Session sign_in_as(database::Database& database, const std::string& login) {
    return database::sign_in(database, login, database::secret(password), database::cheap);
  }

  database::Session own, teaching, idle_teaching, administering;
  database::TraineeDesk trainee;
  database::InstructorDesk instructor, idle;
  database::AdministratorDesk administrator;
};

/// By the clock, not the processor: what somebody waits for, the disk and the other programs of the
/// machine with it.
Percentiles waited_ms(int times, const std::function<void()>& ask) {
  std::vector<double> waits_ms;
  ask();
  for (int i = 0; i < times; ++i) {
    const Stopwatch watch;
    ask();
    waits_ms.push_back(watch.milliseconds());
  }
  return percentiles_of(std::move(waits_ms));
}

class Asking {
 public:
  explicit Asking(Table& table) : table_(table) {}

  void ask(const char* what, const std::function<void()>& question) {
    const Percentiles spread = waited_ms(100, question);
    table_.rows.push_back(
        {what, static_cast<double>(spread.count), spread.median, spread.p99, spread.greatest});
    greatest_p99_ms_ = std::max(greatest_p99_ms_, spread.p99);
  }
  double greatest_p99_ms() const noexcept { return greatest_p99_ms_; }

 private:
  Table& table_;
  double greatest_p99_ms_ = 0.0;
};

void ask_trainees_questions(Asking& asking, Desks& desks) {
  asking.ask("operations of a trainee", [&] { desks.trainee.operations(); });
  asking.ask("history of a trainee", [&] { desks.trainee.attempts(); });
  asking.ask("own questions", [&] { desks.trainee.help_requests(); });
  asking.ask("how the cohort stands", [&] { desks.trainee.cohort_comparisons("akin"); });
}

void ask_instructors_questions(Asking& asking, Desks& desks) {
  Random random{3};
  const auto anybody = [&] {
    return database::PersonId{4 + static_cast<std::int64_t>(random.uniform(0.0, 900.0))};
  };
  asking.ask("cohort: head", [&] { desks.instructor.cohort(); });
  asking.ask("cohort: grid of 1,000", [&] { desks.instructor.trainees(); });
  asking.ask("cohort: newest attempts", [&] { desks.instructor.newest_attempts(6); });
  asking.ask("cohort: newest attempts, idle cohort", [&] { desks.idle.newest_attempts(6); });
  asking.ask("cohort: open questions", [&] { desks.instructor.help_requests(true); });
  asking.ask("inbox, answered ones too", [&] { desks.instructor.help_requests(); });
  asking.ask("a trainee's page: standing", [&] { desks.instructor.trainee(anybody()); });
  asking.ask("a trainee's page: attempts", [&] { desks.instructor.attempts_of(anybody()); });
  asking.ask("attempts list, newest 200", [&] { desks.teaching.attempts(200); });
  asking.ask("attempts list, idle cohort", [&] { desks.idle_teaching.attempts(200); });
}

void ask_administrators_questions(Asking& asking, Desks& desks) {
  asking.ask("people", [&] { desks.administrator.people(); });
  asking.ask("cohorts", [&] { desks.administrator.cohorts(); });
  asking.ask("members of a cohort", [&] { desks.administrator.members({1}); });
  asking.ask("scenario versions", [&] { desks.administrator.scenarios(); });
  asking.ask("a page of the audit", [&] { desks.administrator.audit_page({}); });
  database::AuditRequest refused;
  refused.refused_only = true;
  asking.ask("a page of refusals", [&] { desks.administrator.audit_page(refused); });
}

Table dashboard(const database::BigCourse& course) {
  database::TemporaryDirectory temporary{database::Medium::Disk};
  database::Database database = database::Database::open(temporary.data());
  const Stopwatch making;
  make_big_course(database, course, password);
  Table table{.name = "dashboard",
              .title = "What screens ask of " + std::to_string(course.trainees) +
                       " trainees with " + std::to_string(course.attempts_each) +
                       " attempts each, waited for",
              .columns = {"question", "times", "p50 ms", "p99 ms", "greatest ms"},
              .rows = {},
              .notes = {}};
  Desks desks{database};
  Asking asking{table};
  ask_trainees_questions(asking, desks);
  ask_instructors_questions(asking, desks);
  ask_administrators_questions(asking, desks);
  const auto file_mb =
      static_cast<double>(std::filesystem::file_size(database.file())) / (1024.0 * 1024.0);
  table.notes = {"the file has " + text_of(file_mb) + " MB; making it took " +
                     text_of(making.milliseconds() / 1000.0) + " s",
                 "a million square roots in a row take " + text_of(calibration_ms()) + " ms here",
                 std::string(asking.greatest_p99_ms() < 50.0 ? "every" : "NOT every") +
                     " question has its p99 under 50 ms"};
  return table;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  using namespace hallux::benchmarks;
  try {
    hallux::database::BigCourse course;
    if (count == 3) course = {std::stoi(words[1]), std::stoi(words[2])};
    print_table(std::cout, dashboard(course));
  } catch (const std::exception& error) {
    std::cerr << "dashboard_table: " << error.what()
              << "\nusage: dashboard_table [TRAINEES ATTEMPTS_EACH]\n";
    return 2;
  }
  return 0;
}
