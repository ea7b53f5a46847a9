#include "ui/render/picture.h"

#include <png.h>

#include <fstream>
#include <string>

#include "simulator/base/check.h"

namespace hallux::ui {

Pixels render_picture(Renderer& renderer, const Scene& scene, const Camera& camera,
                      PixelSize size) {
  const RenderQuality before = renderer.quality();
  const RenderTarget target(size);
  renderer.set_quality(still_quality);
  renderer.draw(scene, camera, target.target());
  renderer.set_quality(before);
  return target.read();
}

std::vector<std::byte> encode_png(const Pixels& picture) {
  const auto width = static_cast<std::size_t>(picture.size.width);
  const auto height = static_cast<std::size_t>(picture.size.height);
  CHECK(picture.rgba.size() == 4 * width * height);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * width * height);
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    rgb.insert(rgb.end(), {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]});
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<std::byte> bytes(size);
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0) {
    throw PictureError(std::string("the picture cannot be made a PNG: ") + image.message);
  }
  bytes.resize(size);
  return bytes;
}

void write_png(const std::filesystem::path& file, const Pixels& picture) {
  const std::vector<std::byte> bytes = encode_png(picture);
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) {
    throw PictureError(file.string() +
                       ": the picture could not be written; is there room, and may "
                       "this folder be written to?");
  }
}

}  // namespace hallux::ui
