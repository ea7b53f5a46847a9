// The kernel's table: our cuts beside VTK, CGAL and the thesis's method, all measured in one run on
// one thread.
//
// Every table is printed as Markdown and written as CSV, every chart as SVG. A slow run is no
// failure; a wrong result (another volume, an open mesh) is.
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/benchmarks/kernel/results.h"

namespace hallux::benchmarks {

namespace {

struct Section {
  const char* name;
  void (*measure)(const Effort&, Results&);
};

constexpr std::array<Section, 5> sections{{{"peers", measure_peers},
                                           {"frames", measure_frames},
                                           {"boolean", measure_repeated_boolean},
                                           {"twelve_cuts", measure_twelve_cuts},
                                           {"tree", measure_tree}}};

struct Request {
  std::filesystem::path folder = HALLUX_RESULTS;
  Effort effort;
  std::vector<std::string> names;  ///< of sections; empty: all
  bool is_understood = true;
};

bool is_section(std::string_view name) {
  for (const Section& section : sections) {
    if (name == section.name) return true;
  }
  return false;
}

Request read_request(const std::vector<std::string>& words) {
  Request request;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--quick") {
      request.effort = {50'000, 1'000, 5.0};
    } else if (words[i] == "--out" && i + 1 < words.size()) {
      request.folder = words[++i];
    } else if (is_section(words[i])) {
      request.names.push_back(words[i]);
    } else {
      request.is_understood = false;
    }
  }
  return request;
}

void run_section(const Section& section, const Request& request, std::vector<std::string>& faults) {
  Results results;
  section.measure(request.effort, results);
  for (const Table& table : results.tables) {
    print_table(std::cout, table);
    write_csv(request.folder, table);
  }
  for (const NamedChart& chart : results.charts) {
    write_text(request.folder / (chart.name + ".svg"), chart.svg);
  }
  faults.insert(faults.end(), results.faults.begin(), results.faults.end());
}

int run(const Request& request) {
  std::filesystem::create_directories(request.folder);
  std::vector<std::string> faults;
  run_section({"calibration", measure_calibration}, request, faults);
  for (const Section& section : sections) {
    bool is_wanted = request.names.empty();
    for (const std::string& name : request.names) is_wanted = is_wanted || name == section.name;
    if (is_wanted) run_section(section, request, faults);
  }
  std::cout << "\nCSV and SVG: " << request.folder.string() << '\n';
  for (const std::string& fault : faults) std::cerr << "wrong: " << fault << '\n';
  return faults.empty() ? 0 : 1;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  using namespace hallux::benchmarks;
  try {
    const Request request = read_request(std::vector<std::string>(words + 1, words + count));
    if (request.is_understood) return run(request);
    std::cerr
        << "usage: kernel_table [--out DIR] [--quick] [peers|frames|boolean|twelve_cuts|tree]...\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "kernel_table: " << error.what() << '\n';
    return 1;
  }
}
