#include "database/text/json_fields.h"

#include "database/store/database_error.h"
#include "simulator/base/json_depth.h"

namespace hallux::database {

namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& sentence) {
  throw DatabaseError{DatabaseErrorKind::Damaged, sentence};
}

}  // namespace

void refuse_json(const char* what, const char* wanted) {
  refuse("'" + std::string{what} + "' is not " + wanted);
}

json parse_json(std::string_view what, std::string_view text, JsonBounds bounds) {
  const std::string name{what};
  if (text.size() > bounds.bytes_max) refuse(name + " is longer than it can be");
  if (json_depth(text) > bounds.depth_max) refuse(name + " is nested deeper than it can be");
  try {
    return json::parse(text);
  } catch (const json::exception&) {
    refuse(name + " is not JSON");
  }
}

const json& field_in(const json& object, const char* key) {
  if (!object.is_object()) refuse("an object with '" + std::string{key} + "' is missing");
  const auto found = object.find(key);
  if (found == object.end()) refuse("'" + std::string{key} + "' is missing");
  return *found;
}

std::int64_t integer_of(const json& value, const char* what, std::int64_t low, std::int64_t high) {
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  const bool is_whole = value.is_number_integer() &&
                        (!value.is_number_unsigned() || value.get<std::uint64_t>() <= most);
  if (!is_whole) refuse_json(what, "a whole number");
  const auto number = value.get<std::int64_t>();
  if (number < low || number > high) refuse_json(what, "within its bounds");
  return number;
}

double number_of(const json& value, const char* what) {
  if (value.is_null()) return 0.0;
  if (!value.is_number()) refuse_json(what, "a number");
  return value.get<double>();
}

bool flag_of(const json& value, const char* what) {
  if (!value.is_boolean()) refuse_json(what, "true or false");
  return value.get<bool>();
}

const std::string& text_of(const json& value, const char* what, std::size_t bytes_max) {
  if (!value.is_string()) refuse_json(what, "a text");
  const auto& text = value.get_ref<const std::string&>();
  if (text.size() > bytes_max) refuse_json(what, "as short as it must be");
  return text;
}

const json& list_of(const json& value, const char* what, std::size_t count_max) {
  if (!value.is_array()) refuse_json(what, "a list");
  if (value.size() > count_max) refuse_json(what, "as short as it must be");
  return value;
}

}  // namespace hallux::database
