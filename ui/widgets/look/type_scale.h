/// The sizes of text in the product, by use, and how a line is aligned.
#pragma once

#include <cstdint>

namespace hallux::ui {

/// The type scale. The number behind each is its em in logical pixels.
enum class Type : std::uint8_t {
  Caption,        ///< 12.4: axes, heads of tables
  CaptionMedium,  ///< 12.4: pills, keys
  Small,          ///< 13.2: secondary text
  SmallMedium,    ///< 13.2: segmented, messages
  Body,           ///< 14
  BodyMedium,     ///< 14: buttons, cells
  BodyStrong,     ///< 14: emphasis
  CardTitle,      ///< 15.7
  Section,        ///< 19.8
  Title,          ///< 26.4: the page's name
  Number,         ///< 29.8: figures in the view
  Score,          ///< 47.9: digits and basic Latin only, as Number
};
inline constexpr int type_count = 12;

enum class Align : std::uint8_t { Left, Centre, Right };

}  // namespace hallux::ui
