/// What is killed in tests: a process that records in real time, one that writes as fast as it may,
/// one that only opens.
///
///     kill_course record DIR           a thousand ticks a second for a minute
///     kill_course write DIR NAME N     N writes in all under that name, what an earlier child
///                                      wrote included
///     kill_course open DIR             opens for writing and ends
#include <SQLiteCpp/SQLiteCpp.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <thread>

#include "database/audit/audit.h"
#include "database/course/begin_attempt.h"
#include "database/store/sql.h"
#include "tests/database/killed_child.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

using Kind = ChildWord::Kind;
constexpr int out = STDOUT_FILENO;

/// What another process can read is committed.
void acknowledge_windows(const std::filesystem::path& directory, const std::string& attempt,
                         const std::stop_token& stop) {
  OpenOptions for_reading;
  for_reading.access = Access::ReadOnly;
  Database database = Database::open(directory, for_reading);
  SQLite::Statement row{database.connection(),
                        "SELECT count(DISTINCT seq) FROM chunk JOIN attempt USING (attempt_id) "
                        "WHERE uuid = ?"};
  while (!stop.stop_requested()) {
    row.bind(1, attempt);
    row.executeStep();
    if (!say(out, {Kind::Acknowledged, row.getColumn(0).getInt()})) return;
    row.reset();
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
  }
}

int record_in_real_time(const std::filesystem::path& directory) {
  Database database = Database::open(directory);
  simulator::AttemptChannels channels;
  Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
  const std::jthread reader{[&](const std::stop_token& stop) {
    acknowledge_windows(directory, recorder.attempt().text, stop);
  }};
  const simulator::Recording recording = some_recording(60'000);
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < recording.tape.size(); ++i) {
    std::this_thread::sleep_until(start + std::chrono::milliseconds{i});
    channels.tape.push(recording.tape[i]);
    channels.samples.push(recording.samples[i]);
    if (!say(out, {Kind::Pushed, static_cast<std::int32_t>(i) + 1})) return 1;
  }
  return 0;
}

/// One write as those of the program are: an IMMEDIATE transaction with its audit row.
void write_one(Database& database, const std::string& name, std::int32_t number) {
  in_transaction(database, "write", [&] {
    SQLite::Statement insert{database.connection(), "INSERT INTO setting VALUES (?, '', ?)"};
    insert.bind(1, name + "/" + std::to_string(number));
    insert.bind(2, utc_now(database));
    insert.exec();
    append_audit(database, {std::nullopt, "setting_changed", "setting", name, false, {}, ""});
  });
}

int write_many(const std::filesystem::path& directory, const std::string& name,
               std::int32_t count) {
  Database database = Database::open(directory);
  SQLite::Statement there{database.connection(),
                          "SELECT count(*) FROM setting WHERE name GLOB ? || '/*'"};
  there.bind(1, name);
  there.executeStep();
  std::int32_t written = there.getColumn(0).getInt();
  there.reset();
  say(out, {Kind::Began, written});
  while (written < count) {
    const auto start = std::chrono::steady_clock::now();
    write_one(database, name, written);
    const auto spent = std::chrono::steady_clock::now() - start;
    const auto spent_us = std::chrono::duration_cast<std::chrono::microseconds>(spent).count();
    if (!say(out, {Kind::Acknowledged, ++written})) return 1;
    say(out, {Kind::Waited, static_cast<std::int32_t>(spent_us)});
  }
  return 0;
}

int run(const std::vector<std::string>& words) {
  if (words.size() == 2 && words[0] == "record") return record_in_real_time(words[1]);
  if (words.size() == 4 && words[0] == "write") {
    return write_many(words[1], words[2], std::stoi(words[3]));
  }
  if (words.size() == 2 && words[0] == "open") {
    Database::open(words[1]);
    return 0;
  }
  return 2;
}

}  // namespace

}  // namespace hallux::database

int main(int argc, char** argv) {
  using namespace hallux::database;
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    say(STDOUT_FILENO, {ChildWord::Kind::Failed, 0});
    return 3;
  }
}
