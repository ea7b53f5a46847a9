/// Places for letters in a part of the atlas that is kept free for them, shelf by shelf.
/// Inside this corner only.
#pragma once

#include <algorithm>
#include <optional>

namespace hallux::ui {

class LetterShelf {
 public:
  struct Place {
    int x = 0, y = 0;
  };

  LetterShelf(int width, int height) noexcept : width_(width), height_(height) {}

  /// A place of that size with a pixel free around it; nothing where there is no room.
  std::optional<Place> take(int width, int height) noexcept {
    if (x_ + width + gap > width_) {
      y_ += row_height_;
      x_ = row_height_ = 0;
    }
    if (width + gap > width_ || y_ + height + gap > height_) return std::nullopt;
    const Place place{x_ + gap, y_ + gap};
    x_ += width + gap;
    row_height_ = std::max(row_height_, height + gap);
    return place;
  }
  void clear() noexcept { x_ = y_ = row_height_ = 0; }

 private:
  static constexpr int gap = 1;
  int width_, height_, x_ = 0, y_ = 0, row_height_ = 0;
};

}  // namespace hallux::ui
