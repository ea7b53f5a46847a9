// What keeping costs: a first backup, the next one, a whole copy beside them, restoring, erasing a
// person, letting recordings go, on a course of so many attempts of one minute; and what goes
// through all of a directory of many people with many short attempts.
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "database/maintenance/backup.h"
#include "database/maintenance/erasures.h"
#include "database/maintenance/restore.h"
#include "database/maintenance/retention.h"
#include "database/maintenance/verify.h"
#include "database/people/people.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/report/table.h"
#include "tests/database/some_database.h"
#include "tests/database/whole_course.h"

namespace hallux::benchmarks {

namespace {

using database::Database;
using database::Medium;
using database::TemporaryDirectory;

constexpr std::int64_t ticks_a_minute = 60'000;
constexpr double bytes_a_megabyte = 1e6;

database::PersonId fill(Database& database, int attempts) {
  const database::PersonId person =
      database::create_person_without_password(database, {"trainee-1", "", false});
  database::NewAttempt attempt = database::some_attempt(database);
  attempt.person = person;
  attempt.hand = "";
  const simulator::Recording recording = database::some_recording(ticks_a_minute);
  for (int i = 0; i < attempts; ++i) database::record(database, attempt, recording);
  return person;
}

template <typename Work>
void add_row(Table& table, const char* what, Work work) {
  const Stopwatch watch;
  const std::int64_t bytes = work();
  table.rows.push_back({what, watch.milliseconds(), watch.worked_milliseconds(),
                        static_cast<double>(bytes) / bytes_a_megabyte});
}

Table keeping(int attempts) {
  const TemporaryDirectory temporary{Medium::Disk};
  Database database = Database::open(temporary.data());
  const database::PersonId person = fill(database, attempts);
  const std::filesystem::path folder = temporary.data() / "backups";
  Table table{
      .name = "keeping",
      .title = std::to_string(attempts) + " attempts of one minute",
      .columns = {"what", "wall ms", "processor ms", "MB written or gone"},
      .rows = {},
      .notes = {"a million square roots in a row take " + text_of(calibration_ms()) + " ms here"}};
  add_row(table, "a first backup", [&] { return database::back_up(database, folder).new_bytes; });
  add_row(table, "the next, nothing new (the snapshot's length)",
          [&] { return database::back_up(database, folder).new_bytes; });
  database::record(database, database::some_attempt(database),
                   database::some_recording(ticks_a_minute));
  add_row(table, "the next, one attempt more",
          [&] { return database::back_up(database, folder).new_bytes; });
  add_row(table, "beside it: a copy of all pages", [&] {
    Database copy = Database::open(temporary.data() / "copy");
    database::copy_whole(database, copy);
    return static_cast<std::int64_t>(std::filesystem::file_size(database.file()));
  });
  add_row(table, "restoring, all checked", [&] {
    database::restore({folder, temporary.data() / "again", {}});
    return static_cast<std::int64_t>(
        std::filesystem::file_size(temporary.data() / "again" / "hallux.db"));
  });
  add_row(table, "erasing a person, without recordings", [&] {
    return database::erase_person(database, {person, false, "measured"}, {}).recording_bytes;
  });
  database::store_retention(database, {1, {}, {}, {}});
  database.pretend_it_is("2099-01-01T00:00:00.000Z");
  add_row(table, "a dry run of retention",
          [&] { return static_cast<std::int64_t>(database::plan_retention(database).size() * 0); });
  add_row(table, "letting all recordings go",
          [&] { return database::apply_retention(database, {}).bytes; });
  return table;
}

/// Made in memory: what is measured is not how it is made.
void make_on_disk(const database::WholeCourse& course, const std::filesystem::path& data) {
  const TemporaryDirectory made{Medium::Memory};
  {
    Database database = Database::open(made.data());
    make_whole_course(database, course, "a long enough phrase");
    clear_log(database);
  }
  std::filesystem::copy(made.data(), data, std::filesystem::copy_options::recursive);
}

Table keeping_many(const database::WholeCourse& course) {
  const TemporaryDirectory temporary{Medium::Disk};
  make_on_disk(course, temporary.data());
  Database database = Database::open(temporary.data());
  const std::filesystem::path folder = temporary.data() / "backups";
  Table table{
      .name = "keeping_many",
      .title = std::to_string(course.trainees) + " people, " + std::to_string(course.attempts) +
               " attempts of " + std::to_string(course.ticks) + " ms, scored",
      .columns = {"what", "wall ms", "processor ms", "MB looked at or written"},
      .rows = {},
      .notes = {"a million square roots in a row take " + text_of(calibration_ms()) + " ms here"}};
  const auto bytes_of = [](const std::filesystem::path& file) {
    return static_cast<std::int64_t>(std::filesystem::file_size(file));
  };
  add_row(table, "verify, all found whole", [&] {
    if (const auto found = database::verify(database); !found.is_whole())
      throw std::runtime_error(*found.first_damage);
    return bytes_of(database.file());
  });
  add_row(table, "a first backup", [&] { return database::back_up(database, folder).new_bytes; });
  add_row(table, "the next, nothing new",
          [&] { return database::back_up(database, folder).new_bytes; });
  add_row(table, "restoring, all checked", [&] {
    database::restore({folder, temporary.data() / "again", {}});
    return bytes_of(temporary.data() / "again" / "hallux.db");
  });
  return table;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int argc, char** argv) {
  using namespace hallux::benchmarks;
  try {
    print_table(std::cout, keeping(argc > 1 ? std::atoi(argv[1]) : 100));
    const std::int32_t attempts = argc > 2 ? std::atoi(argv[2]) : 20'000;
    print_table(std::cout, keeping_many({.trainees = attempts / 10, .attempts = attempts}));
  } catch (const std::exception& error) {
    std::cerr << "keeping_table: " << error.what() << '\n';
    return 2;
  }
  return 0;
}
