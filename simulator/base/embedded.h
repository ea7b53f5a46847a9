/// A data file compiled into the program (see cmake/embed.cmake), so that one binary carries all it
/// needs.
#pragma once

#include <span>
#include <string_view>

namespace hallux {

struct EmbeddedText {
  /// File name without folder.
  std::string_view name;
  std::string_view text;
};

}  // namespace hallux
