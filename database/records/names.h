/// Enumerators and the words they are stored as, in the order of the enumeration.
/// Inside this corner only.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace hallux::database {

template <typename Enumeration, std::size_t count>
constexpr std::string_view name_in(const std::array<std::string_view, count>& names,
                                   Enumeration value) noexcept {
  return names[static_cast<std::size_t>(value)];
}

/// Nothing where `name` is none of them.
template <typename Enumeration, std::size_t count>
constexpr std::optional<Enumeration> named_in(const std::array<std::string_view, count>& names,
                                              std::string_view name) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    if (names[i] == name) return static_cast<Enumeration>(i);
  }
  return std::nullopt;
}

}  // namespace hallux::database
