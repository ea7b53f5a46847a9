/// Enumerations and the names they are stored as and written with in JSON. Inside this room only.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace hallux::database {

/// The names of an enumeration in its order; said beside each that is stored.
template <typename Enumeration>
inline constexpr std::array<std::string_view, 0> stored_names{};

template <typename Enumeration>
concept Named = !stored_names<Enumeration>.empty();

template <Named Enumeration>
constexpr std::string_view name_of(Enumeration value) noexcept {
  return stored_names<Enumeration>[static_cast<std::size_t>(value)];
}

/// Nothing where `name` is none of them.
template <Named Enumeration>
constexpr std::optional<Enumeration> named(std::string_view name) noexcept {
  for (std::size_t i = 0; i < stored_names<Enumeration>.size(); ++i) {
    if (stored_names<Enumeration>[i] == name) return static_cast<Enumeration>(i);
  }
  return std::nullopt;
}

}  // namespace hallux::database
