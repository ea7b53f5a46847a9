// The thesis's figures 7.3 to 7.11 again: what growing and shrinking vertex and index buffers cost.
//
//     buffer_table [--out DIR] [--quick]
//
// Tables are printed as Markdown and written as CSV, charts as SVG. A slow run is no failure; a
// wrong result is.
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "tests/benchmarks/display_buffers/sections.h"
#include "ui/render/gl/headless_context.h"

namespace hallux::benchmarks {

namespace {

int run(const std::filesystem::path& folder, const BufferEffort& effort) {
  std::filesystem::create_directories(folder);
  const ui::HeadlessContext context;
  std::cout << "Drawn by " << ui::renderer_name() << '\n';
  BufferResults results;
  measure_growth(effort, results);
  measure_removal(effort, results);
  measure_uploads(effort, results);
  for (const Table& table : results.tables) {
    print_table(std::cout, table);
    write_csv(folder, table);
  }
  for (const BufferResults::Chart& chart : results.charts) {
    write_text(folder / (chart.name + ".svg"), chart.svg);
  }
  std::cout << "\nCSV and SVG: " << folder.string() << '\n';
  for (const std::string& fault : results.faults) std::cerr << "wrong: " << fault << '\n';
  return results.faults.empty() ? 0 : 1;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  using namespace hallux::benchmarks;
  std::filesystem::path folder = HALLUX_RESULTS;
  BufferEffort effort;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--quick") {
      effort = {true, 3, 4'000};
    } else if (word == "--out" && i + 1 < count) {
      folder = words[++i];
    } else {
      std::cerr << "usage: buffer_table [--out DIR] [--quick]\n";
      return 2;
    }
  }
  try {
    return run(folder, effort);
  } catch (const std::exception& error) {
    std::cerr << "buffer_table: " << error.what() << '\n';
    return 1;
  }
}
