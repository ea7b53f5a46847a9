#include "ui/window/screenshot.h"

#include <png.h>

#include <cstring>
#include <stdexcept>

namespace hallux::ui {

void write_png(const std::filesystem::path& file, int width, int height,
               const std::vector<std::uint8_t>& rgb) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, file.c_str(), 0, rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error(file.string() + ": the picture cannot be written there (" +
                             image.message + "); name another place");
}

}  // namespace hallux::ui
