/// How deep a JSON text nests, known before any parser touches it: a guard for everything that
/// reads a file of others.
#pragma once

#include <string_view>

namespace hallux {

/// The most lists and objects that are open at once, brackets in texts left out; of a text that is
/// no JSON some number that is at least the depth of what a parser would make of it.
/// thread  any; takes no memory, looks at each byte once
constexpr int json_depth(std::string_view text) noexcept {
  int depth = 0, deepest = 0;
  bool is_in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (is_in_text) {
      if (letter == '\\') ++i;
      if (letter == '"') is_in_text = false;
      continue;
    }
    if (letter == '"') is_in_text = true;
    if (letter == '[' || letter == '{') deepest = ++depth > deepest ? depth : deepest;
    if ((letter == ']' || letter == '}') && depth > 0) --depth;
  }
  return deepest;
}

}  // namespace hallux
