/// A strict view of one JSON value that knows its file and path, so that each refusal says where
/// and what to mend.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scenario_error.h"
#include "simulator/base/vector.h"

namespace hallux::scenarios {

inline constexpr std::size_t json_bytes_max = 256 * 1024;
inline constexpr int json_depth_max = 12;

/// The JSON in `text`, read within fixed bounds.
/// errors  ScenarioError with the line: too long, too deep, not JSON, a key twice in one object
nlohmann::json parse_bounded_json(std::string_view text, std::string_view file,
                                  std::size_t bytes_max = json_bytes_max);

/// Throws ScenarioError: "FILE: PATH: WHAT; MEND".
[[noreturn]] void refuse(std::string_view file, std::string_view path, std::string_view what,
                         std::string_view mend);

/// The shortest decimal text that reads back as the same number.
std::string text_of_number(double value);

/// Borrows the JSON value and the file's name: both must outlive it. All members throw
/// ScenarioError naming the path.
class JsonNode {
 public:
  JsonNode(const nlohmann::json& value, std::string_view file) noexcept
      : value_(&value), file_(file) {}

  /// Refuses another type, a missing key, and a key that is in neither list.
  void expect_keys(std::initializer_list<std::string_view> required,
                   std::initializer_list<std::string_view> optional = {}) const;
  bool has(std::string_view key) const;
  /// needs   the value is an object that has the key (see expect_keys, has)
  JsonNode at(std::string_view key) const;
  std::vector<JsonNode> list(std::size_t count_min, std::size_t count_max) const;

  double number(double low, double high) const;
  std::int32_t integer(std::int32_t low, std::int32_t high) const;
  /// Points as integer thousandths; refuses more than three decimals.
  std::int64_t milli(double low, double high) const;
  bool boolean() const;
  std::string text(std::size_t length_min, std::size_t length_max) const;
  /// A name: lower-case letters, digits and underscores, a letter first, at most 64 characters.
  std::string name() const;
  /// The name under that key; empty where the key is not there.
  std::string name_where_given(std::string_view key) const {
    return has(key) ? at(key).name() : std::string();
  }
  std::string one_of(std::initializer_list<std::string_view> allowed) const;
  Vec3 vector(double low, double high) const;

  [[noreturn]] void refuse_value(std::string_view mend) const;

 private:
  JsonNode(const nlohmann::json& value, std::string_view file, std::string path)
      : value_(&value), file_(file), path_(std::move(path)) {}

  const nlohmann::json* value_;
  std::string_view file_;
  std::string path_;
};

}  // namespace hallux::scenarios
