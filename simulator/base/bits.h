/// Enumerations whose values are single bits, and words of several. Inside this room only.
#pragma once

#include <cstdint>
#include <type_traits>

namespace hallux {

template <typename Enumeration>
requires std::is_enum_v<Enumeration>
constexpr std::uint32_t bit(Enumeration value) noexcept {
  return static_cast<std::uint32_t>(value);
}
template <typename Enumeration>
requires std::is_enum_v<Enumeration>
constexpr bool has(std::uint32_t bits, Enumeration value) noexcept {
  return (bits & bit(value)) != 0;
}

}  // namespace hallux
