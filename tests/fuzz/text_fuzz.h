/// Bytes as the text that a reader of JSON gets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hallux::tests {

inline std::string_view text_of(const std::uint8_t* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

}  // namespace hallux::tests
