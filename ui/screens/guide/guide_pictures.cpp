#include "ui/screens/guide/guide_pictures.h"

#include <algorithm>
#include <span>

#include "simulator/base/check.h"
#include "simulator/base/embedded.h"
#include "ui/render/scene_painter.h"

namespace hallux::ui {

/// docs/pictures/window.
std::span<const EmbeddedText> guide_picture_files() noexcept;

namespace {

/// Empty where there is none.
std::span<const std::byte> bytes_of(std::string_view source) {
  const std::string_view name = source.substr(source.find_last_of('/') + 1);
  for (const EmbeddedText& file : guide_picture_files())
    if (file.name == name) return std::as_bytes(std::span(file.text));
  return {};
}

}  // namespace

std::optional<PixelSize> GuidePictures::size_of(std::string_view source) {
  const std::span<const std::byte> bytes = bytes_of(source);
  if (bytes.empty()) return std::nullopt;
  return png_size(bytes);
}

// Each size is made once: drawn smaller by the graphics, small letters would lose their stems.
std::uint64_t GuidePictures::texture(Shell& shell, const std::string& source, PixelSize size) {
  const auto [place, is_new] = read_.try_emplace(source);
  Read& read = place->second;
  if (is_new || read.size != size) {
    read.size = size;
    const std::span<const std::byte> bytes = bytes_of(source);
    CHECK(!bytes.empty());
    auto made = std::make_shared<std::shared_ptr<const Pixels>>();
    work_.start(
        shell, {},
        [made, bytes, size](WorkReport&) {
          *made = std::make_shared<const Pixels>(shrunk(decode_png(bytes), size));
        },
        [this, made, source, size](WorkEnd end, const std::string& reason) {
          const auto wanted = read_.find(source);
          if (wanted == read_.end() || wanted->second.size != size) return;
          // The program's own bytes: a test reads each of them.
          CHECK(end == WorkEnd::Done && reason.empty());
          wanted->second.pixels = *made;
        });
  }
  return read.pixels == nullptr ? 0 : shell.scenes().show("guide." + source, read.pixels);
}

}  // namespace hallux::ui
