/// Pictures that stand still: drawn without a window, kept as PNG.
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <vector>

#include "ui/render/renderer.h"

namespace hallux::ui {

class PictureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The scene in the best quality. Without a window make a HeadlessContext first; one of each serves
/// many pictures.
/// errors  GraphicsError
Pixels render_picture(Renderer& renderer, const Scene& scene, const Camera& camera, PixelSize size);

/// The picture as a PNG file's bytes, without opacity; the same bytes for the same picture.
/// errors  PictureError
std::vector<std::byte> encode_png(const Pixels& picture);
/// The picture of a PNG file's bytes, rows from the top.
/// errors  PictureError
Pixels decode_png(std::span<const std::byte> bytes);
/// What a PNG file's bytes say of its size, without reading the picture.
/// errors  PictureError
PixelSize png_size(std::span<const std::byte> bytes);
/// The picture with fewer pixels: each is the mean of those that it covers. As it is where it is
/// not larger in both directions.
/// needs   no side of `size` is below one pixel
Pixels shrunk(const Pixels& picture, PixelSize size);

/// errors  PictureError naming the file that could not be written
void write_png(const std::filesystem::path& file, const Pixels& picture);

}  // namespace hallux::ui
