/// SQLite asks for a plan, then for one row after the other. The plan takes the attempt and the
/// bounds on `tick`; they choose the windows, and the chunks of those alone are unpacked, each
/// checked by its own link and the one stored before it. Where they let too many rows pass, SQLite
/// compares each once more.
#include "database/reports/virtual_tables.h"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <string>

#include "database/recording/stored_chunks.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

/// One table: which stream it reads, and what its columns are called. The word that holds switches
/// and faults is two.
struct RecordTable {
  Stream stream = Stream::Sample;
  const char* name = "";
  const char* columns = "";
  int column_count = 0;  ///< as SQL sees them, without the hidden one
};

constexpr std::array record_tables{
    RecordTable{Stream::Tape, "tape_lines",
                "tick, handle_x_in_world_um, handle_y_in_world_um, handle_z_in_world_um, "
                "rotation_w_micro, rotation_x_micro, rotation_y_micro, rotation_z_micro, "
                "switches, faults, covered_ticks, command_count, "
                "command_0, argument_0, detail_0, command_1, argument_1, detail_1, "
                "command_2, argument_2, detail_2, command_3, argument_3, detail_3",
                24},
    RecordTable{Stream::Sample, "pose_samples",
                "tick, tool_x_in_world_um, tool_y_in_world_um, tool_z_in_world_um, "
                "rotation_w_micro, rotation_x_micro, rotation_y_micro, rotation_z_micro, "
                "force_x_in_world_millinewton, force_y_in_world_millinewton, "
                "force_z_in_world_millinewton, status, kerf",
                13},
    RecordTable{Stream::Event, "cut_events",
                "tick, kind, subject, value, x_in_bone_um, y_in_bone_um, z_in_bone_um, "
                "rotation_w_micro, rotation_x_micro, rotation_y_micro, rotation_z_micro",
                11}};

constexpr int switches_column = 8;

/// What SQLite asks for: a table of the connection.
struct Table : sqlite3_vtab {
  Database* database = nullptr;
  const RecordTable* shape = nullptr;
};

/// A statement's place in a table.
struct Cursor : sqlite3_vtab_cursor {
  std::optional<ChunkWalk> walk;
  std::optional<ChunkReader> reader, tape_reader;
  std::optional<StoredChunk> tape;  ///< of the window at hand
  Digest link;
  const Columns* columns = nullptr;
  std::int64_t window = 0;
  std::size_t row = 0;
  std::string attempt;
};

/// What the statement says of `tick`: bits of the plan's number, in the order in which their values
/// come.
enum class TickBound : int { From = 1, After = 2, To = 4, Before = 8, At = 16 };
constexpr std::array tick_bounds{TickBound::From, TickBound::After, TickBound::To,
                                 TickBound::Before, TickBound::At};

std::optional<TickBound> bound_of(unsigned char operation) noexcept {
  switch (operation) {
    case SQLITE_INDEX_CONSTRAINT_GE:
      return TickBound::From;
    case SQLITE_INDEX_CONSTRAINT_GT:
      return TickBound::After;
    case SQLITE_INDEX_CONSTRAINT_LE:
      return TickBound::To;
    case SQLITE_INDEX_CONSTRAINT_LT:
      return TickBound::Before;
    case SQLITE_INDEX_CONSTRAINT_EQ:
      return TickBound::At;
    default:
      return std::nullopt;
  }
}

Table& table_of(sqlite3_vtab* table) noexcept { return *static_cast<Table*>(table); }
Cursor& cursor_of(sqlite3_vtab_cursor* cursor) noexcept { return *static_cast<Cursor*>(cursor); }

/// Runs `work`; what it throws becomes SQLite's code, and the sentence its message.
template <typename Work>
int answered(sqlite3_vtab* table, Work&& work) noexcept {
  int code = SQLITE_ERROR;
  std::string text;
  try {
    std::forward<Work>(work)();
    return SQLITE_OK;
  } catch (const DatabaseError& error) {
    code = error.kind() == DatabaseErrorKind::Damaged ? SQLITE_CORRUPT_VTAB : SQLITE_ERROR;
    text = error.what();
  } catch (const SQLite::Exception& error) {
    code = error.getErrorCode();
    text = error.what();
  } catch (const std::exception& error) {
    text = error.what();
  }
  sqlite3_free(table->zErrMsg);
  table->zErrMsg = sqlite3_mprintf("%s", text.c_str());
  return code;
}

int connect(sqlite3* connection, void* aux, int count, const char* const* words,
            sqlite3_vtab** made, char** message) {
  static_cast<void>(message);
  auto* const database = static_cast<Database*>(aux);
  if (count < 1) return SQLITE_ERROR;
  const auto shape = std::ranges::find_if(record_tables, [&](const RecordTable& table) {
    return std::string_view{table.name} == words[0];
  });
  if (shape == record_tables.end()) return SQLITE_ERROR;
  const std::string declaration =
      "CREATE TABLE record (" + std::string{shape->columns} + ", attempt HIDDEN)";
  if (const int code = sqlite3_declare_vtab(connection, declaration.c_str()); code != SQLITE_OK) {
    return code;
  }
  sqlite3_vtab_config(connection, SQLITE_VTAB_INNOCUOUS);
  auto table = std::make_unique<Table>();
  table->database = database;
  table->shape = &*shape;
  *made = table.release();
  return SQLITE_OK;
}

int disconnect(sqlite3_vtab* table) {
  delete &table_of(table);
  return SQLITE_OK;
}

/// Takes the attempt and the bounds on `tick`; without an attempt there is no plan.
int choose_plan(sqlite3_vtab* table, sqlite3_index_info* plan) {
  const int attempt_column = table_of(table).shape->column_count;
  std::array<int, 32> place_of_bound{};
  int attempt_place = -1;
  for (int i = 0; i < plan->nConstraint; ++i) {
    const auto& constraint = plan->aConstraint[i];
    const bool is_equal = constraint.op == SQLITE_INDEX_CONSTRAINT_EQ;
    if (constraint.iColumn == attempt_column && is_equal) {
      if (constraint.usable == 0) return SQLITE_CONSTRAINT;
      attempt_place = i;
    }
    const auto bound = bound_of(constraint.op);
    if (constraint.iColumn != 0 || constraint.usable == 0 || !bound) continue;
    place_of_bound[static_cast<std::size_t>(*bound)] = i + 1;
  }
  if (attempt_place < 0) return SQLITE_CONSTRAINT;
  int argument = 1;
  plan->aConstraintUsage[attempt_place].argvIndex = argument++;
  plan->aConstraintUsage[attempt_place].omit = 1;
  for (const TickBound bound : tick_bounds) {
    const int place = place_of_bound[static_cast<std::size_t>(bound)];
    if (place == 0) continue;
    plan->aConstraintUsage[place - 1].argvIndex = argument++;
    plan->idxNum |= static_cast<int>(bound);
  }
  plan->orderByConsumed =
      plan->nOrderBy == 1 && plan->aOrderBy[0].iColumn == 0 && plan->aOrderBy[0].desc == 0;
  plan->estimatedCost = plan->idxNum == 0 ? 1e6 : 1e4;
  plan->estimatedRows = plan->idxNum == 0 ? 100'000 : 1'000;
  return SQLITE_OK;
}

int open_cursor(sqlite3_vtab* table, sqlite3_vtab_cursor** made) {
  static_cast<void>(table);
  *made = std::make_unique<Cursor>().release();
  return SQLITE_OK;
}

int close_cursor(sqlite3_vtab_cursor* cursor) {
  delete &cursor_of(cursor);
  return SQLITE_OK;
}

/// The whole ticks from `value` on; SQLite compares each row with what the statement says once
/// more.
std::int64_t tick_near(double value, double rounded) noexcept {
  constexpr double limit = 9e15;
  return static_cast<std::int64_t>(std::isnan(value) ? 0.0 : std::clamp(rounded, -limit, limit));
}

void narrow(TickRange& ticks, TickBound bound, sqlite3_value* value) noexcept {
  const int type = sqlite3_value_numeric_type(value);
  if (type != SQLITE_INTEGER && type != SQLITE_FLOAT) return;
  const double number = sqlite3_value_double(value);
  const std::int64_t low = tick_near(number, std::floor(number));
  const std::int64_t high = tick_near(number, std::ceil(number));
  const bool is_from =
      bound == TickBound::From || bound == TickBound::After || bound == TickBound::At;
  const bool is_to = bound == TickBound::To || bound == TickBound::Before || bound == TickBound::At;
  if (is_from) ticks.first = std::max(ticks.first, low);
  if (is_to) ticks.end = std::min(ticks.end, high + 1);
}

/// Goes to the next chunk of the table's stream; at the end `columns` is nothing.
void read_next_chunk(const Table& table, Cursor& cursor) {
  cursor.columns = nullptr;
  cursor.row = 0;
  while (auto chunk = cursor.walk->next()) {
    const Digest before = cursor.link;
    cursor.link = chunk->link.value_or(Digest{});
    if (chunk->place.stream == table.shape->stream) {
      try {
        const bool has_tape = cursor.tape && cursor.tape->place.seq == chunk->place.seq &&
                              may_need_tape(chunk->bytes);
        const Columns* tape = has_tape ? &cursor.tape_reader->read(*cursor.tape, nullptr) : nullptr;
        cursor.columns = &cursor.reader->read_checked(*chunk, tape, before);
        cursor.window = chunk->place.seq;
      } catch (const DatabaseError& error) {
        fail_chunk(*table.database, {cursor.attempt}, *chunk, error.what());
      }
      return;
    }
    if (chunk->place.stream == Stream::Tape) cursor.tape = std::move(*chunk);
  }
}

int begin(sqlite3_vtab_cursor* at, int bounds, const char* unused, int count,
          sqlite3_value** values) {
  static_cast<void>(unused);
  const Table& table = table_of(at->pVtab);
  Cursor& cursor = cursor_of(at);
  return answered(at->pVtab, [&] {
    cursor.columns = nullptr;
    if (count < 1 || sqlite3_value_type(values[0]) != SQLITE_TEXT) return;
    const auto* const text = static_cast<const void*>(sqlite3_value_text(values[0]));
    const AttemptId id{static_cast<const char*>(text)};
    TickRange ticks{0, std::numeric_limits<std::int64_t>::max()};
    int argument = 1;
    for (const TickBound bound : tick_bounds) {
      if ((bounds & static_cast<int>(bound)) == 0) continue;
      narrow(ticks, bound, values[argument++]);
    }
    cursor.attempt = id.text;
    cursor.tape.reset();
    cursor.reader.emplace(id);
    cursor.tape_reader.emplace(id);
    const WindowRange windows = windows_around(*table.database, id, ticks);
    cursor.link = link_before(*table.database, id, windows.first);
    cursor.walk.emplace(*table.database, id, windows);
    read_next_chunk(table, cursor);
  });
}

int advance(sqlite3_vtab_cursor* at) {
  Cursor& cursor = cursor_of(at);
  ++cursor.row;
  if (cursor.row < cursor.columns->row_count()) return SQLITE_OK;
  return answered(at->pVtab, [&] { read_next_chunk(table_of(at->pVtab), cursor); });
}

int is_at_end(sqlite3_vtab_cursor* at) { return cursor_of(at).columns == nullptr ? 1 : 0; }

int column_value(sqlite3_vtab_cursor* at, sqlite3_context* context, int index) {
  const Cursor& cursor = cursor_of(at);
  const RecordTable& shape = *table_of(at->pVtab).shape;
  if (index == shape.column_count) {
    sqlite3_result_text(context, cursor.attempt.c_str(), -1, SQLITE_TRANSIENT);
    return SQLITE_OK;
  }
  const bool is_tape = shape.stream == Stream::Tape;
  const int source = is_tape && index > switches_column ? index - 1 : index;
  std::int64_t value = cursor.columns->column(static_cast<std::size_t>(source))[cursor.row];
  if (is_tape && index == switches_column) value &= 0xFFFFFFFFLL;
  if (is_tape && index == switches_column + 1) value = (value >> 32U) & 0xFFFFFFFFLL;
  sqlite3_result_int64(context, value);
  return SQLITE_OK;
}

/// A window and a place in its chunk tell a row.
int row_number(sqlite3_vtab_cursor* at, sqlite3_int64* number) {
  const Cursor& cursor = cursor_of(at);
  *number = cursor.window * static_cast<std::int64_t>(rows_per_chunk_max) +
            static_cast<std::int64_t>(cursor.row);
  return SQLITE_OK;
}

/// Without a way to be made by name: such a table is there once its name is used.
constexpr sqlite3_module record_module = [] {
  sqlite3_module module{};
  module.xConnect = &connect;
  module.xDisconnect = &disconnect;
  module.xBestIndex = &choose_plan;
  module.xOpen = &open_cursor;
  module.xClose = &close_cursor;
  module.xFilter = &begin;
  module.xNext = &advance;
  module.xEof = &is_at_end;
  module.xColumn = &column_value;
  module.xRowid = &row_number;
  return module;
}();

}  // namespace

void add_record_tables(Database& database) {
  for (const RecordTable& table : record_tables) {
    const int code = sqlite3_create_module_v2(database.connection().getHandle(), table.name,
                                              &record_module, &database, nullptr);
    if (code != SQLITE_OK) {
      throw DatabaseError{
          DatabaseErrorKind::InputOutput,
          "could not add the table " + std::string{table.name} + " to " + database.file().string()};
    }
    // Made now: an authorizer that comes later would take its declaration for a change of the
    // schema.
    translating(database, "add a table of the record", [&] {
      const auto first_use =
          prepared(database, "SELECT tick FROM " + std::string{table.name} + "('')");
    });
  }
}

}  // namespace hallux::database
