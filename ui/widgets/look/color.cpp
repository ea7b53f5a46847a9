#include "ui/widgets/look/color.h"

#include <algorithm>
#include <cmath>

namespace hallux::ui {
namespace {

std::uint8_t byte_of(float value) noexcept {
  return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}

std::uint8_t between(std::uint8_t a, std::uint8_t b, float share) noexcept {
  return byte_of(static_cast<float>(a) + (static_cast<float>(b) - static_cast<float>(a)) * share);
}

double linear(std::uint8_t value) noexcept {
  const double channel = value / 255.0;
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

}  // namespace

Color faded(Color color, float share) noexcept {
  color.alpha = byte_of(static_cast<float>(color.alpha) * share);
  return color;
}

Color mixed(Color a, Color b, float share) noexcept {
  return {between(a.red, b.red, share), between(a.green, b.green, share),
          between(a.blue, b.blue, share), between(a.alpha, b.alpha, share)};
}

Color composed(Color above, Color below) noexcept {
  const float share = static_cast<float>(above.alpha) / 255.0F;
  above.alpha = 255;
  below.alpha = 255;
  return mixed(below, above, share);
}

double luminance(Color color) noexcept {
  return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

double contrast(Color a, Color b) noexcept {
  const double first = luminance(a), second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

}  // namespace hallux::ui
