#include "ui/render/picture.h"

#include <png.h>

#include <algorithm>
#include <cmath>
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

namespace {

/// A PNG that is being read.
class PngReading {
 public:
  explicit PngReading(std::span<const std::byte> bytes) {
    image_.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image_, bytes.data(), bytes.size()) == 0) fail();
    image_.format = PNG_FORMAT_RGBA;
  }
  PngReading(const PngReading&) = delete;
  PngReading& operator=(const PngReading&) = delete;
  ~PngReading() { png_image_free(&image_); }

  PixelSize size() const noexcept {
    return {static_cast<int>(image_.width), static_cast<int>(image_.height)};
  }
  Pixels read() {
    Pixels picture{size(), std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image_))};
    if (png_image_finish_read(&image_, nullptr, picture.rgba.data(), 0, nullptr) == 0) fail();
    return picture;
  }

 private:
  [[noreturn]] void fail() const {
    throw PictureError(std::string("the bytes are no PNG that can be read: ") + image_.message);
  }

  png_image image_{};
};

/// A pixel of a long side and how much of it a pixel of a short side covers.
struct Covered {
  std::size_t at = 0;
  float share = 0.0F;
};

/// Of each of `few` pixels what it covers of `many`; the shares of each add up to 1.
std::vector<std::vector<Covered>> covered_by_each(std::size_t few, std::size_t many) {
  std::vector<std::vector<Covered>> covered(few);
  const float step = static_cast<float>(many) / static_cast<float>(few);
  for (std::size_t i = 0; i < few; ++i) {
    const float begin = static_cast<float>(i) * step, end = begin + step;
    for (auto at = static_cast<std::size_t>(begin); at < many && static_cast<float>(at) < end;
         ++at) {
      const float inside =
          std::min(end, static_cast<float>(at + 1)) - std::max(begin, static_cast<float>(at));
      covered[i].push_back({at, inside / step});
    }
  }
  return covered;
}

}  // namespace

PixelSize png_size(std::span<const std::byte> bytes) { return PngReading(bytes).size(); }
Pixels decode_png(std::span<const std::byte> bytes) { return PngReading(bytes).read(); }

Pixels shrunk(const Pixels& picture, PixelSize size) {
  CHECK(size.width > 0 && size.height > 0);
  if (size.width >= picture.size.width || size.height >= picture.size.height) return picture;
  const auto width = static_cast<std::size_t>(size.width);
  const auto height = static_cast<std::size_t>(size.height);
  const auto columns = static_cast<std::size_t>(picture.size.width);
  const auto rows = static_cast<std::size_t>(picture.size.height);
  Pixels small{size, std::vector<std::uint8_t>(4 * width * height)};
  const auto across = covered_by_each(width, columns), down = covered_by_each(height, rows);
  for (std::size_t i = 0; i < 4 * width * height; ++i) {
    float mean = 0.0F;
    for (const Covered& row : down[i / 4 / width])
      for (const Covered& column : across[i / 4 % width])
        mean += row.share * column.share * picture.rgba[4 * (row.at * columns + column.at) + i % 4];
    small.rgba[i] = static_cast<std::uint8_t>(std::lround(std::clamp(mean, 0.0F, 255.0F)));
  }
  return small;
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
