#include "ui/widgets/texts/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace hallux::ui {

namespace {

/// As long as the longest of fixed decimals.
using Letters = std::array<char, 400>;

std::string written(double value, std::chars_format format, int precision) {
  if (!std::isfinite(value)) return "–";
  Letters letters{};
  const auto end =
      std::to_chars(letters.data(), letters.data() + letters.size(), value, format, precision).ptr;
  return {letters.data(), end};
}

}  // namespace

std::string fixed_text(double value, int decimals) {
  return written(value, std::chars_format::fixed, decimals);
}

std::string short_text(double value) { return written(value, std::chars_format::general, 3); }

}  // namespace hallux::ui
