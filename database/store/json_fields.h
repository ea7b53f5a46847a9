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

/// The value of a key; where it is missing or of another type, the sentence names the key.
/// errors  DatabaseError Damaged; of the others as well
const nlohmann::json& field_in(const nlohmann::json& object, const char* key);
/// A whole number between the two: never a fraction, never one that does not fit.
std::int64_t integer_in(const nlohmann::json& object, const char* key,
                        std::int64_t low = std::numeric_limits<std::int64_t>::min(),
                        std::int64_t high = std::numeric_limits<std::int64_t>::max());
/// null is 0: a number that was not finite when it was written.
double number_in(const nlohmann::json& object, const char* key);
bool flag_in(const nlohmann::json& object, const char* key);
const std::string& text_in(const nlohmann::json& object, const char* key,
                           std::size_t bytes_max = std::size_t{1} << 20U);
const nlohmann::json& list_in(const nlohmann::json& object, const char* key, std::size_t count_max);

/// As integer_in and number_in, of an entry of a list; `what` names it.
std::int64_t integer_of(const nlohmann::json& value, const char* what);
double number_of(const nlohmann::json& value, const char* what);

}  // namespace hallux::database
