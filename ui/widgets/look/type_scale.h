/// The sizes of text in the product, by use, and how a line is aligned. Inside this corner only.
#pragma once

#include <cstdint>

namespace hallux::ui {

/// The type scale. The number behind each is its em in logical pixels.
enum class Type : std::uint8_t {
  /// 12.4: axes, heads of tables.
  Caption,
  /// 12.4: pills, keys.
  CaptionMedium,
  /// 13.2: secondary text.
  Small,
  /// 13.2: segmented, messages.
  SmallMedium,
  /// 14.
  Body,
  /// 14: buttons, cells.
  BodyMedium,
  /// 14: emphasis.
  BodyStrong,
  /// 15.7.
  CardTitle,
  /// 19.8.
  Section,
  /// 26.4: the page's name.
  Title,
  /// 29.8: figures in the view.
  Number,
  /// 47.9: digits and basic Latin only, as Number.
  Score,
};
inline constexpr int type_count = 12;

enum class Align : std::uint8_t { Left, Centre, Right };

}  // namespace hallux::ui
