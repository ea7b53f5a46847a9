/// Writes a file as a whole: what was there before stays until the new one is complete.
#pragma once

#include <filesystem>
#include <string_view>

namespace hallux::ui {

/// errors  OutputError naming the file; nothing is left behind, and no other file is touched
void write_file_whole(const std::filesystem::path& file, std::string_view bytes);

}  // namespace hallux::ui
