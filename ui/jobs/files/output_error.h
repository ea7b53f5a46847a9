/// What went wrong with a file or folder that the user named for an answer, as one sentence: what
/// was tried, on which file, what to do.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace hallux::ui {

enum class OutputErrorKind {
  /// The name itself is the mistake: it leads nowhere, or something else has it.
  Name,
  /// Full, read-only, or the disk answered with an error.
  Storage
};

class OutputError : public std::runtime_error {
 public:
  OutputError(OutputErrorKind kind, const std::string& sentence)
      : std::runtime_error(sentence), kind_(kind) {}
  OutputErrorKind kind() const noexcept { return kind_; }

 private:
  OutputErrorKind kind_;
};

/// What `error_number` of the operating system means for `file`.
OutputError output_error(const std::filesystem::path& file, int error_number);

}  // namespace hallux::ui
