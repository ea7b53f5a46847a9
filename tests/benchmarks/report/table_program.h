/// A program that prints tables: `NAME [--out DIR]`.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace hallux::benchmarks {

/// Runs with the folder that was named, or with that of the build; returns the exit code, and says
/// on the error stream what went wrong.
int table_program(int count, char** words, const std::string& name,
                  const std::filesystem::path& usual_folder,
                  const std::function<void(const std::filesystem::path& folder)>& run);

}  // namespace hallux::benchmarks
