#include "ui/app/write_file.h"

#include <cerrno>
#include <cstdio>
#include <memory>

#include "database/files.h"

namespace hallux::ui {

void write_file_whole(const std::filesystem::path& file, std::string_view bytes) {
  const std::filesystem::path beside = file.string() + ".new";
  const auto fail = [&](int error_number) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    throw database::file_error(file, "write the file", error_number);
  };
  std::FILE* const opened = std::fopen(beside.c_str(), "wb");
  if (opened == nullptr) fail(errno);
  const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), opened) == bytes.size();
  const int write_error = errno;
  const bool is_closed = std::fclose(opened) == 0;
  if (!is_written || !is_closed) fail(is_written ? errno : write_error);
  if (std::rename(beside.c_str(), file.c_str()) != 0) fail(errno);
}

}  // namespace hallux::ui
