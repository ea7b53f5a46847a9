/// Keeps a picture of the window as a PNG file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace hallux::ui {

/// Writes rows of RGB from the top, 3 * width * height bytes.
/// errors  std::runtime_error naming the file and what to do
void write_png(const std::filesystem::path& file, int width, int height,
               const std::vector<std::uint8_t>& rgb);

}  // namespace hallux::ui
