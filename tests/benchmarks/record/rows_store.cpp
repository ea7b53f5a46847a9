#include "tests/benchmarks/record/rows_store.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>

namespace hallux::benchmarks {

namespace {

constexpr std::int64_t transaction_ticks = 500;

/// A column for each integer of a row; of the commands, which are few, those that are used stand in
/// a table of their own.
constexpr const char* schema =
    "CREATE TABLE tape (attempt_id INTEGER, tick INTEGER, x INTEGER, y INTEGER, z INTEGER, qw "
    "INTEGER, "
    "qx INTEGER, qy INTEGER, qz INTEGER, switches INTEGER, ticks INTEGER, commands INTEGER, "
    "PRIMARY KEY (attempt_id, tick)) STRICT, WITHOUT ROWID;"
    "CREATE TABLE command (attempt_id INTEGER, tick INTEGER, place INTEGER, kind INTEGER, "
    "argument INTEGER, detail INTEGER, PRIMARY KEY (attempt_id, tick, place)) STRICT, WITHOUT "
    "ROWID;"
    "CREATE TABLE sample (attempt_id INTEGER, tick INTEGER, x INTEGER, y INTEGER, z INTEGER, qw "
    "INTEGER, "
    "qx INTEGER, qy INTEGER, qz INTEGER, fx INTEGER, fy INTEGER, fz INTEGER, status INTEGER, "
    "kerf INTEGER, PRIMARY KEY (attempt_id, tick)) STRICT, WITHOUT ROWID;"
    "CREATE TABLE event (event_id INTEGER PRIMARY KEY, attempt_id INTEGER, tick INTEGER, kind "
    "INTEGER, "
    "subject INTEGER, value INTEGER, x INTEGER, y INTEGER, z INTEGER, qw INTEGER, qx INTEGER, "
    "qy INTEGER, qz INTEGER) STRICT;"
    "CREATE INDEX event_by_tick ON event (attempt_id, tick);";

constexpr std::size_t plain_tape_columns = 11;

/// Binds an attempt's number and the first `count` values.
void insert(SQLite::Statement& statement, std::span<const std::int64_t> values) {
  statement.bind(1, 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    statement.bind(static_cast<int>(i) + 2, values[i]);
  }
  statement.exec();
  statement.reset();
}

template <typename Values>
Values values_in(SQLite::Statement& row, std::size_t count) {
  Values values{};
  for (std::size_t i = 0; i < count; ++i) values[i] = row.getColumn(static_cast<int>(i)).getInt64();
  return values;
}

void bind_range(SQLite::Statement& statement, std::int64_t first, std::int64_t end) {
  statement.bind(1, first);
  statement.bind(2, end);
}

}  // namespace

struct RowsStore::Tables {
  explicit Tables(const std::filesystem::path& file) : database(made(file)) {}
  static SQLite::Database made(const std::filesystem::path& file) {
    SQLite::Database database{file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
    database.exec("PRAGMA page_size = 8192; PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;");
    database.exec(schema);
    return database;
  }
  SQLite::Statement statement(const char* sql) { return {database, sql}; }

  SQLite::Database database;
  SQLite::Statement tape = statement("INSERT INTO tape VALUES (?,?,?,?,?,?,?,?,?,?,?,?)");
  SQLite::Statement command = statement("INSERT INTO command VALUES (?,?,?,?,?,?)");
  SQLite::Statement sample = statement("INSERT INTO sample VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  SQLite::Statement event = statement(
      "INSERT INTO event (attempt_id, tick, kind, subject, value, x, y, z, qw, qx, qy, qz) "
      "VALUES (?,?,?,?,?,?,?,?,?,?,?,?)");
};

RowsStore::RowsStore(const std::filesystem::path& file)
    : file_(file), tables_(std::make_unique<Tables>(file)) {}
RowsStore::~RowsStore() = default;

void RowsStore::write(const simulator::Recording& recording) {
  std::size_t line = 0;
  std::size_t sample = 0;
  std::size_t event = 0;
  const std::int64_t last_tick = recording.samples.back().tick;
  for (std::int64_t end = transaction_ticks; end - transaction_ticks <= last_tick;
       end += transaction_ticks) {
    SQLite::Transaction transaction{tables_->database, SQLite::TransactionBehavior::IMMEDIATE};
    for (; line < recording.tape.size() && recording.tape[line].tick < end; ++line) {
      const simulator::TapeLine& row = recording.tape[line];
      const auto columns = simulator::columns_of(row);
      insert(tables_->tape, std::span{columns}.first(plain_tape_columns));
      for (std::uint8_t i = 0; i < row.command_count; ++i) {
        const simulator::Command& command = row.commands[i];
        const std::array<std::int64_t, 5> values{
            row.tick, i, static_cast<std::int64_t>(command.kind), command.argument, command.detail};
        insert(tables_->command, values);
      }
    }
    for (; sample < recording.samples.size() && recording.samples[sample].tick < end; ++sample) {
      insert(tables_->sample, simulator::columns_of(recording.samples[sample]));
    }
    for (; event < recording.events.size() && recording.events[event].tick < end; ++event) {
      insert(tables_->event, simulator::columns_of(recording.events[event]));
    }
    transaction.commit();
  }
}

simulator::Recording RowsStore::read() { return read(0, std::numeric_limits<std::int64_t>::max()); }

simulator::Recording RowsStore::read(std::int64_t first, std::int64_t end) {
  simulator::Recording recording;
  SQLite::Statement tape = tables_->statement(
      "SELECT tick, x, y, z, qw, qx, qy, qz, switches, ticks, commands FROM tape WHERE "
      "attempt_id = 1 AND tick >= ? AND tick < ?");
  bind_range(tape, first, end);
  const auto unused = simulator::columns_of(simulator::TapeLine{});
  while (tape.executeStep()) {
    auto values =
        values_in<std::array<std::int64_t, simulator::tape_columns>>(tape, plain_tape_columns);
    std::copy(unused.begin() + plain_tape_columns, unused.end(),
              values.begin() + plain_tape_columns);
    recording.tape.push_back(simulator::tape_line_from(values));
  }
  SQLite::Statement command = tables_->statement(
      "SELECT tick, place, kind, argument, detail FROM command WHERE attempt_id = 1 AND tick >= ? "
      "AND tick < ?");
  bind_range(command, first, end);
  while (command.executeStep()) {
    const auto values = values_in<std::array<std::int64_t, 5>>(command, 5);
    const auto line =
        std::ranges::lower_bound(recording.tape, values[0], {}, &simulator::TapeLine::tick);
    line->commands[static_cast<std::size_t>(values[1])] = {
        static_cast<simulator::CommandKind>(values[2]), static_cast<std::int32_t>(values[3]),
        values[4]};
  }
  SQLite::Statement sample = tables_->statement(
      "SELECT tick, x, y, z, qw, qx, qy, qz, fx, fy, fz, status, kerf FROM sample WHERE "
      "attempt_id = 1 AND tick >= ? AND tick < ?");
  bind_range(sample, first, end);
  while (sample.executeStep()) {
    recording.samples.push_back(
        simulator::tool_sample_from(values_in<std::array<std::int64_t, simulator::sample_columns>>(
            sample, simulator::sample_columns)));
  }
  SQLite::Statement event = tables_->statement(
      "SELECT tick, kind, subject, value, x, y, z, qw, qx, qy, qz FROM event WHERE attempt_id = 1 "
      "AND tick >= ? AND tick < ? ORDER BY tick");
  bind_range(event, first, end);
  while (event.executeStep()) {
    recording.events.push_back(
        simulator::cut_event_from(values_in<std::array<std::int64_t, simulator::event_columns>>(
            event, simulator::event_columns)));
  }
  return recording;
}

std::int64_t RowsStore::bytes() {
  tables_->database.exec("PRAGMA wal_checkpoint(TRUNCATE)");
  return static_cast<std::int64_t>(std::filesystem::file_size(file_));
}

}  // namespace hallux::benchmarks
