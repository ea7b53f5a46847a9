#include "database/exchange/view_table.h"

#include <algorithm>
#include <array>

#include "database/exchange/integer_line.h"

namespace hallux::database {

namespace {

constexpr std::string_view header =
    "tick_ms,target_x_um,target_y_um,target_z_um,view_qw_micro,view_qx_micro,view_qy_micro,"
    "view_qz_micro,magnification_milli,target_depth_um,width_over_height_milli,stereo,layout,"
    "lost_before";

/// Ten a second for a day, and some more: what a reader takes memory for.
constexpr std::size_t facts_max = 1'000'000;
constexpr std::int64_t code_max = 255;

bool is_code(std::int64_t value) noexcept { return value >= 0 && value <= code_max; }

bool is_sane(const simulator::DisplayFact& fact) noexcept {
  return simulator::is_view(fact) && is_code(static_cast<std::int64_t>(fact.stereo)) &&
         is_code(static_cast<std::int64_t>(fact.layout));
}

}  // namespace

ExchangeFile write_view_table(const std::filesystem::path& folder,
                              std::span<const simulator::DisplayFact> facts) {
  ExchangeWriter writer(folder, view_table_name);
  writer.write(header);
  writer.write("\r\n");
  std::string line;
  for (const simulator::DisplayFact& fact : facts) {
    // Another tool wrote it; whoever imports would refuse the whole attempt.
    if (!is_sane(fact)) continue;
    line.clear();
    for (const std::int64_t value : columns_of(fact)) {
      if (!line.empty()) line.push_back(',');
      append_integer(line, value);
    }
    line.append("\r\n");
    writer.write(line);
  }
  return writer.finish();
}

std::vector<simulator::DisplayFact> read_view_table(const ForeignFolder& folder,
                                                    const std::vector<ExchangeFile>& files) {
  std::vector<simulator::DisplayFact> facts;
  const auto file = std::ranges::find(files, view_table_name, &ExchangeFile::name);
  if (file == files.end()) return facts;
  ForeignLines lines(folder, *file);
  std::string_view line;
  if (!lines.next(line) || line != header) lines.refuse("it is not the header of this table");
  std::array<std::int64_t, simulator::display_columns> columns{};
  while (lines.next(line)) {
    take_integers(lines, line, columns);
    const simulator::DisplayFact fact = simulator::display_fact_from(columns);
    if (!is_sane(fact)) lines.refuse("a number is none that a view has");
    if (!facts.empty() && fact.tick <= facts.back().tick)
      lines.refuse("its tick is not after that of the line above");
    facts.push_back(fact);
    if (facts.size() > facts_max) lines.refuse("the table has more rows than an attempt can");
  }
  return facts;
}

}  // namespace hallux::database
