#include "tests/benchmarks/report/table_program.h"

#include <exception>
#include <iostream>

namespace hallux::benchmarks {

int table_program(int count, char** words, const std::string& name,
                  const std::filesystem::path& usual_folder,
                  const std::function<void(const std::filesystem::path& folder)>& run) {
  const bool is_named = count == 3 && std::string(words[1]) == "--out";
  if (!is_named && count != 1) {
    std::cerr << "usage: " << name << " [--out DIR]\n";
    return 2;
  }
  try {
    run(is_named ? std::filesystem::path(words[2]) : usual_folder);
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 1;
  }
  return 0;
}

}  // namespace hallux::benchmarks
