/// What there may be none of, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace hallux::ui {

template <typename Value>
nlohmann::ordered_json or_null(const std::optional<Value>& value) {
  if (!value) return nullptr;
  return *value;
}

}  // namespace hallux::ui
