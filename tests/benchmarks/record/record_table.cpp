// The record as chunks beside the record as rows: what a millisecond takes on the disk, what
// writing it takes of a core, and how fast an attempt, or a second of it, is back.
#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <thread>

#include "database/course/begin_attempt.h"
#include "database/recording/recordings.h"
#include "database/recording/window_writer.h"
#include "database/reports/report_connection.h"
#include "simulator/base/random.h"
#include "tests/benchmarks/record/rows_store.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/report/table.h"
#include "tests/database/some_database.h"

namespace hallux::benchmarks {

namespace {

using database::Database;
using database::Medium;
using database::TemporaryDirectory;

constexpr std::int64_t ticks_a_minute = 60'000;
constexpr int random_places = 200;

/// Takes the write-ahead log in and counts the file's bytes.
std::int64_t bytes_of(const std::filesystem::path& file) {
  {
    Database settled = Database::open(file.parent_path());
    database::tamper(settled, "PRAGMA wal_checkpoint(TRUNCATE)");
  }
  return static_cast<std::int64_t>(std::filesystem::file_size(file));
}

/// What one way of keeping took.
struct Kept {
  double bytes_a_tick = 0.0, write_ms_a_second = 0.0, read_ms_a_minute = 0.0;
};

void require_same(const simulator::Recording& a, const simulator::Recording& b) {
  if (!database::is_same(a, b)) throw std::runtime_error{"what was read is not what was written"};
}

double milliseconds_a_second(double worked_ms, const simulator::Recording& recording) {
  return 1000.0 * worked_ms / static_cast<double>(recording.samples.size());
}

/// As the recorder does once it has the rows.
void write_windows(const Database& database, const database::AttemptId& attempt,
                   const simulator::Recording& recording) {
  database::WindowWriter pen{database.open_again(), attempt};
  const auto rows_of = [](const auto& rows, auto& next, std::int64_t end_tick) {
    std::remove_cvref_t<decltype(rows)> taken;
    for (; next < rows.size() && rows[next].tick < end_tick; ++next) taken.push_back(rows[next]);
    return taken;
  };
  std::size_t line = 0;
  std::size_t sample = 0;
  std::size_t event = 0;
  for (std::int64_t window = 0; line < recording.tape.size(); ++window) {
    const std::int64_t end_tick = (window + 1) * database::window_ticks;
    pen.commit(window, {rows_of(recording.tape, line, end_tick),
                        rows_of(recording.samples, sample, end_tick),
                        rows_of(recording.events, event, end_tick),
                        {}});
  }
}

Kept kept_as_chunks(const simulator::Recording& recording) {
  const TemporaryDirectory temporary{Medium::Disk};
  Database database = Database::open(temporary.data());
  const auto attempt = database::some_attempt(database);
  const std::int64_t empty_bytes = bytes_of(database.file());
  const auto lease = database::create_attempt(database, attempt);
  Kept kept;
  const Stopwatch writing;
  write_windows(database, lease.attempt(), recording);
  kept.write_ms_a_second = milliseconds_a_second(writing.worked_milliseconds(), recording);
  kept.bytes_a_tick = static_cast<double>(bytes_of(database.file()) - empty_bytes) /
                      static_cast<double>(recording.samples.size());
  const Stopwatch watch;
  const simulator::Recording back = database::load_recording(database, lease.attempt());
  kept.read_ms_a_minute = watch.worked_milliseconds();
  require_same(back, recording);
  return kept;
}

Kept kept_as_rows(const simulator::Recording& recording) {
  const TemporaryDirectory temporary{Medium::Disk};
  std::filesystem::create_directory(temporary.data());
  RowsStore store{temporary.data() / "rows.db"};
  const std::int64_t empty_bytes = store.bytes();
  Kept kept;
  const Stopwatch writing;
  store.write(recording);
  kept.write_ms_a_second = milliseconds_a_second(writing.worked_milliseconds(), recording);
  kept.bytes_a_tick = static_cast<double>(store.bytes() - empty_bytes) /
                      static_cast<double>(recording.samples.size());
  const Stopwatch reading;
  const simulator::Recording back = store.read();
  kept.read_ms_a_minute = reading.worked_milliseconds();
  require_same(back, recording);
  return kept;
}

void add_measures(Table& table, const char* what, double rows, double chunks) {
  table.rows.push_back({what, rows, chunks, rows / chunks});
}

Table side_by_side() {
  const simulator::Recording recording = database::some_recording(ticks_a_minute);
  const Kept rows = kept_as_rows(recording);
  const Kept chunks = kept_as_chunks(recording);
  Table table{
      .name = "record_rows_and_chunks",
      .title = "A minute of a trembling hand: tape, samples and events",
      .columns = {"what", "rows", "chunks", "rows / chunks"},
      .rows = {},
      .notes = {"a million square roots in a row take " + text_of(calibration_ms()) + " ms here",
                "both with pages of 8 KB, WAL, synchronous FULL, a commit each half second; "
                "chunks also with their chain, and read with it checked"}};
  add_measures(table, "bytes a millisecond on the disk", rows.bytes_a_tick, chunks.bytes_a_tick);
  add_measures(table, "processor ms a recorded second", rows.write_ms_a_second,
               chunks.write_ms_a_second);
  add_measures(table, "processor ms to read it back", rows.read_ms_a_minute,
               chunks.read_ms_a_minute);
  return table;
}

/// Pushes a recording at 1 kHz; how long each tick's pushes took.
Percentiles produce_in_real_time(const simulator::Recording& recording,
                                 simulator::AttemptChannels& channels) {
  std::vector<double> push_us;
  auto next = std::chrono::steady_clock::now();
  std::size_t event = 0;
  for (std::size_t i = 0; i < recording.tape.size(); ++i) {
    std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
    const Stopwatch watch;
    bool is_pushed = channels.tape.push(recording.tape[i]);
    is_pushed = channels.samples.push(recording.samples[i]) && is_pushed;
    for (;
         event < recording.events.size() && recording.events[event].tick <= recording.tape[i].tick;
         ++event) {
      is_pushed = channels.events.push(recording.events[event]) && is_pushed;
    }
    if (!is_pushed) throw std::runtime_error{"a ring was full"};
    push_us.push_back(1000.0 * watch.milliseconds());
  }
  channels.closed.store(true);
  return percentiles_of(std::move(push_us));
}

Table real_time() {
  const simulator::Recording recording = database::some_recording(10'000);
  const TemporaryDirectory temporary{Medium::Disk};
  Database database = Database::open(temporary.data());
  simulator::AttemptChannels channels;
  database::Recorder recorder{
      database, database::create_attempt(database, database::some_attempt(database)), channels};
  const Percentiles push_us = produce_in_real_time(recording, channels);
  const auto statistics = recorder.finish("{}");
  Table table{.name = "record_real_time",
              .title = "Ten seconds recorded as they happen",
              .columns = {"what", "value"},
              .rows = {},
              .notes = {}};
  const double seconds = static_cast<double>(recording.samples.size()) / 1000.0;
  table.rows.push_back({"recorder, percent of a core", 100.0 * statistics.cpu_s / seconds});
  table.rows.push_back({"a commit, mean ms",
                        1000.0 * statistics.commit_s / static_cast<double>(statistics.commits)});
  table.rows.push_back({"a commit, longest ms", 1000.0 * statistics.commit_max_s});
  table.rows.push_back({"a tick's pushes, p50 us", push_us.median});
  table.rows.push_back({"a tick's pushes, p99 us", push_us.p99});
  table.rows.push_back({"a tick's pushes, longest us", push_us.greatest});
  return table;
}

/// The time on the wall, and of the processor, of `work(place)` for each place.
template <typename Work>
void add_times(Table& table, const char* what, std::size_t times, Work work) {
  std::vector<double> wall_ms;
  std::vector<double> worked_ms;
  for (std::size_t i = 0; i < times; ++i) {
    const Stopwatch watch;
    work();
    wall_ms.push_back(watch.milliseconds());
    worked_ms.push_back(watch.worked_milliseconds());
  }
  const Percentiles wall = percentiles_of(std::move(wall_ms));
  const Percentiles worked = percentiles_of(std::move(worked_ms));
  table.rows.push_back(
      {what, static_cast<double>(times), wall.least, wall.median, wall.p99, worked.median});
}

Table reading() {
  const std::int64_t ticks = 10 * ticks_a_minute;
  const simulator::Recording recording = database::some_recording(ticks);
  const TemporaryDirectory temporary{Medium::Disk};
  Database database = Database::open(temporary.data());
  const auto id = database::record(database, database::some_attempt(database), recording);
  Table table{.name = "record_reading",
              .title = "Ten minutes of a trembling hand read back, chain checked",
              .columns = {"what", "times", "least ms", "p50 ms", "p99 ms", "p50 processor ms"},
              .rows = {},
              .notes = {}};
  require_same(database::load_recording(database, id), recording);
  add_times(table, "the whole attempt", 9, [&] { database::load_recording(database, id); });
  Random random{7};
  const auto any_tick = [&] { return static_cast<std::int64_t>(random.uniform(0.0, 599'000.0)); };
  database::ReportConnection report{database.directory()};
  add_times(table, "pose_samples, any 10 ms", random_places, [&] {
    const std::string first = std::to_string(any_tick());
    const auto rows = report
                          .answer("SELECT * FROM pose_samples('" + id.text +
                                  "') WHERE tick >= " + first + " AND tick < " + first + " + 10")
                          .rows;
    if (rows.size() != 10) throw std::runtime_error{"10 ms have not 10 rows"};
  });
  return table;
}

}  // namespace

}  // namespace hallux::benchmarks

int main() {
  using namespace hallux::benchmarks;
  try {
    print_table(std::cout, side_by_side());
    print_table(std::cout, real_time());
    print_table(std::cout, reading());
  } catch (const std::exception& error) {
    std::cerr << "record_table: " << error.what() << '\n';
    return 2;
  }
  return 0;
}
