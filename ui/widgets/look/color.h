/// Colours as sRGB bytes, how they mix, and how well one can be read on another.
#pragma once

#include <cstdint>

namespace hallux::ui {

/// sRGB, 0-255 each; alpha 255 covers what is below.
struct Color {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;

  friend bool operator==(const Color&, const Color&) = default;
};

/// 0xRRGGBB as it is written in a style guide.
constexpr Color rgb(std::uint32_t hex, std::uint8_t alpha = 255) noexcept {
  return {static_cast<std::uint8_t>(hex >> 16U & 0xFFU),
          static_cast<std::uint8_t>(hex >> 8U & 0xFFU), static_cast<std::uint8_t>(hex & 0xFFU),
          alpha};
}

/// The same colour with `share` (0-1) of its alpha.
Color faded(Color color, float share) noexcept;

/// `a` moved towards `b` by `share` (0-1), byte by byte in sRGB.
Color mixed(Color a, Color b, float share) noexcept;

/// What is seen where `above` lies on the opaque `below`.
Color composed(Color above, Color below) noexcept;

/// Relative luminance, 0 black to 1 white.
/// source  WCAG 2.1, definition of relative luminance
double luminance(Color color) noexcept;

/// 1 (the same) to 21 (black on white); text wants at least 4.5.
/// source  WCAG 2.1, definition of contrast ratio
double contrast(Color a, Color b) noexcept;

}  // namespace hallux::ui
