/// The pictures of the guides: their sizes at once, their pixels once they were read beside the
/// window. Inside this corner only.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "ui/render/picture.h"
#include "ui/screens/parts/screen_work.h"

namespace hallux::ui {

class GuidePictures {
 public:
  /// Of the picture that a page names as its source; nothing where the program does not carry it.
  static std::optional<PixelSize> size_of(std::string_view source);

  /// The texture of that picture at that size; 0 until it was read.
  /// needs   the program carries it
  std::uint64_t texture(Shell& shell, const std::string& source, PixelSize size);
  /// Another page is read.
  void forget() { read_.clear(); }

 private:
  struct Read {
    PixelSize size;
    /// Null until it was read.
    std::shared_ptr<const Pixels> pixels;
  };

  std::map<std::string, Read> read_;
  ScreenWork work_;
};

}  // namespace hallux::ui
