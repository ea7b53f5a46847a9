/// Fields of untrusted JSON, read within bounds and never converted in silence.
/// Inside this room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace hallux::database {

struct JsonBounds {
  std::size_t bytes_max = std::size_t{1} << 20U;
  int depth_max = 12;
};

/// `what` begins the sentence of a refusal: "the manifest".
/// errors  DatabaseError Damaged: too long, too deep, not JSON
nlohmann::json parse_json(std::string_view what, std::string_view text, JsonBounds bounds = {});

[[noreturn]] void refuse_json(const char* what, const char* wanted);

/// A value of one type; where it is of another, the sentence begins with `what`, its name.
/// errors  DatabaseError Damaged; of the others as well
///
/// A whole number between the two: never a fraction, never one that does not fit.
std::int64_t integer_of(const nlohmann::json& value, const char* what,
                        std::int64_t low = std::numeric_limits<std::int64_t>::min(),
                        std::int64_t high = std::numeric_limits<std::int64_t>::max());
/// null is 0: a number that was not finite when it was written.
double number_of(const nlohmann::json& value, const char* what);
bool flag_of(const nlohmann::json& value, const char* what);
const std::string& text_of(const nlohmann::json& value, const char* what,
                           std::size_t bytes_max = std::size_t{1} << 20U);
const nlohmann::json& list_of(const nlohmann::json& value, const char* what, std::size_t count_max);

/// The value of a key, which may be missing.
const nlohmann::json& field_in(const nlohmann::json& object, const char* key);
template <typename... Bounds>
std::int64_t integer_in(const nlohmann::json& object, const char* key, Bounds... low_and_high) {
  return integer_of(field_in(object, key), key, low_and_high...);
}
inline bool flag_in(const nlohmann::json& object, const char* key) {
  return flag_of(field_in(object, key), key);
}
template <typename... Bounds>
const std::string& text_in(const nlohmann::json& object, const char* key, Bounds... bytes_max) {
  return text_of(field_in(object, key), key, bytes_max...);
}
inline const nlohmann::json& list_in(const nlohmann::json& object, const char* key,
                                     std::size_t count_max) {
  return list_of(field_in(object, key), key, count_max);
}

}  // namespace hallux::database
