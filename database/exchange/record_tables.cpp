/// A table is read as strictly as it is written: one spelling of each number, ticks that rise,
/// windows in order, no pose outside of a room. Where a line is refused it is named. What is read
/// back gives the same rows, and from them and the windows the same chunks, links and seal.
#include "database/exchange/record_tables.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "database/exchange/integer_line.h"

namespace hallux::database {

namespace {

constexpr std::array<std::string_view, 3> headers{
    "window,tick_ms,handle_x_um,handle_y_um,handle_z_um,handle_qw_micro,handle_qx_micro,"
    "handle_qy_micro,handle_qz_micro,switches_and_faults_bits,covered_ms,commands_count,"
    "command_1,argument_1,detail_1,command_2,argument_2,detail_2,"
    "command_3,argument_3,detail_3,command_4,argument_4,detail_4",
    "window,tick_ms,tool_x_um,tool_y_um,tool_z_um,tool_qw_micro,tool_qx_micro,tool_qy_micro,"
    "tool_qz_micro,force_x_mn,force_y_mn,force_z_mn,status_bits,kerf",
    "window,tick_ms,kind,subject,value,pose_x_um,pose_y_um,pose_z_um,pose_qw_micro,"
    "pose_qx_micro,pose_qy_micro,pose_qz_micro"};

/// A day: no operation takes longer, and no sum of ticks leaves its integer.
constexpr std::int64_t tick_max = 86'400'000;
/// A hand, an arm and a room fit in: what leaves it is no pose of a tool.
constexpr std::int32_t translation_max_um = 100'000'000;
/// The pose of an older device may be rounded; a length that far from 1 is no rotation.
constexpr double rotation_square_min = 0.5e12, rotation_square_max = 2.0e12;
constexpr std::int32_t force_max_mn = 10'000'000;

template <typename Row>
void write_rows(ExchangeWriter& writer, std::int64_t window, std::span<const Row> rows) {
  std::string line;
  for (const Row& row : rows) {
    line.clear();
    append_integer(line, window);
    for (const std::int64_t value : simulator::columns_of(row)) {
      line.push_back(',');
      append_integer(line, value);
    }
    line.append("\r\n");
    writer.write(line);
  }
}

bool is_pose(const simulator::QuantisedPose& pose) noexcept {
  double square = 0.0;
  for (const std::int32_t part : pose.rotation_micro) {
    square += static_cast<double>(part) * static_cast<double>(part);
  }
  return square > rotation_square_min && square < rotation_square_max &&
         std::all_of(pose.translation_um.begin(), pose.translation_um.end(), [](std::int32_t part) {
           return part >= -translation_max_um && part <= translation_max_um;
         });
}

bool is_sane(const simulator::TapeLine& line) noexcept {
  return is_pose(line.device.world_from_handle) && line.ticks >= 1 && line.ticks <= 3 &&
         line.command_count <= simulator::commands_per_tick;
}

bool is_sane(const simulator::ToolSample& sample) noexcept {
  constexpr std::int32_t kerfs_max = 1024;
  return is_pose(sample.world_from_tool) && sample.kerf >= -1 && sample.kerf < kerfs_max &&
         std::all_of(sample.force_mn.begin(), sample.force_mn.end(), [](std::int32_t part) {
           return part >= -force_max_mn && part <= force_max_mn;
         });
}

bool is_sane(const simulator::CutEvent& event) noexcept {
  constexpr std::int64_t value_max = std::int64_t{1} << 40U;
  return is_pose(event.pose) && event.value >= -value_max && event.value <= value_max;
}

auto row_from(const std::array<std::int64_t, simulator::tape_columns>& columns) noexcept {
  return simulator::tape_line_from(columns);
}
auto row_from(const std::array<std::int64_t, simulator::sample_columns>& columns) noexcept {
  return simulator::tool_sample_from(columns);
}
auto row_from(const std::array<std::int64_t, simulator::event_columns>& columns) noexcept {
  return simulator::cut_event_from(columns);
}

/// A row begins a chunk where its window is another than that of the row before.
void note_row(const ForeignLines& lines, std::int64_t window, std::int64_t tick, Stream stream,
              std::vector<ChunkPlace>& places, bool is_first) {
  const bool is_new = is_first || places.back().seq != window;
  if (window < 0 || window > tick_max || tick < 0 || tick > tick_max) {
    lines.refuse("its window or its tick is none of an attempt");
  }
  if (is_new) {
    if (!is_first && window < places.back().seq)
      lines.refuse("its window is before that of the line above");
    places.push_back({stream, window, tick, 0});
  }
  if (++places.back().row_count > static_cast<std::int64_t>(rows_per_chunk_max)) {
    lines.refuse("its window holds more rows than one can");
  }
}

template <typename Row>
void read_table(const ForeignFolder& folder, const ExchangeFile& file, Stream stream,
                std::vector<Row>& rows, std::vector<ChunkPlace>& places) {
  using Columns = decltype(simulator::columns_of(std::declval<const Row&>()));
  constexpr std::size_t column_count = std::tuple_size_v<Columns>;
  ForeignLines lines(folder, file);
  std::string_view line;
  if (!lines.next(line) || line != headers[static_cast<std::size_t>(stream)]) {
    lines.refuse("it is not the header of this table");
  }
  std::array<std::int64_t, column_count + 1> numbers{};
  while (lines.next(line)) {
    take_integers(lines, line, numbers);
    Columns columns{};
    std::copy(numbers.begin() + 1, numbers.end(), columns.begin());
    note_row(lines, numbers[0], columns[0], stream, places, rows.empty());
    if (!rows.empty() && columns[0] < rows.back().tick + (stream == Stream::Event ? 0 : 1)) {
      lines.refuse("its tick is not after that of the line above");
    }
    rows.push_back(row_from(columns));
    if (simulator::columns_of(rows.back()) != columns || !is_sane(rows.back())) {
      lines.refuse("a number is none that a recording holds");
    }
    if (static_cast<std::int64_t>(rows.size()) > rows_per_table_max) {
      lines.refuse("the table has more rows than an attempt can");
    }
  }
}

const ExchangeFile& file_named(const ForeignFolder& folder, const std::vector<ExchangeFile>& files,
                               std::string_view name) {
  for (const ExchangeFile& file : files) {
    if (file.name == name) return file;
  }
  throw DatabaseError{DatabaseErrorKind::BadInput, folder.path().string() +
                                                       ": the manifest names no " +
                                                       std::string{name} + "; it is no export"};
}

}  // namespace

std::vector<ExchangeFile> write_record_tables(const std::filesystem::path& folder,
                                              const simulator::Recording& recording,
                                              const std::vector<ChunkPlace>& places) {
  std::vector<ExchangeWriter> writers;
  writers.reserve(headers.size());
  for (std::size_t i = 0; i < headers.size(); ++i) {
    writers.emplace_back(folder, std::string{record_table_names[i]});
    writers.back().write(headers[i]);
    writers.back().write("\r\n");
  }
  visit_chunks(recording, places, [&](const ChunkPlace& place, const auto& rows) {
    write_rows(writers[static_cast<std::size_t>(place.stream)], place.seq, rows);
  });
  std::vector<ExchangeFile> files;
  files.reserve(writers.size());
  for (ExchangeWriter& writer : writers) files.push_back(writer.finish());
  return files;
}

ReadTables read_record_tables(const ForeignFolder& folder, const std::vector<ExchangeFile>& files) {
  ReadTables read;
  std::vector<ChunkPlace>& places = read.places;
  read_table(folder, file_named(folder, files, record_table_names[0]), Stream::Tape,
             read.recording.tape, places);
  read_table(folder, file_named(folder, files, record_table_names[1]), Stream::Sample,
             read.recording.samples, places);
  read_table(folder, file_named(folder, files, record_table_names[2]), Stream::Event,
             read.recording.events, places);
  std::sort(places.begin(), places.end(), [](const ChunkPlace& a, const ChunkPlace& b) {
    return std::tie(a.seq, a.stream) < std::tie(b.seq, b.stream);
  });
  return read;
}

Digest last_link_of(const AttemptId& attempt, const simulator::Recording& recording,
                    const std::vector<ChunkPlace>& places) {
  Digest link;
  std::vector<std::byte> payload;
  visit_chunks(recording, places, [&](const ChunkPlace& place, const auto& rows) {
    link = link_of(link, attempt, place, payload_in(payload, columns_from(rows)));
  });
  return link;
}

}  // namespace hallux::database
