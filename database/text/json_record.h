/// Records as JSON and back, each by one list of its fields. Inside this room only.
///
///     template <>
///     inline constexpr std::tuple fields_of<GroupScore>{Field{"name", &GroupScore::name}, ...};
///
/// The same list writes and reads, in its order: a field that is stored cannot be forgotten on one
/// of the two ways. What is read is untrusted; errors are those of json_fields.h.
#pragma once

#include <array>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "database/records/names.h"
#include "database/text/json_fields.h"

namespace hallux::database {

template <typename Record, typename Value>
struct Field {
  const char* key;
  Value Record::*member;
};
template <typename Record, typename Value>
Field(const char*, Value Record::*) -> Field<Record, Value>;

/// Of a struct that is written as an object.
template <typename Record>
inline constexpr std::tuple<> fields_of{};

template <typename Record>
concept Listed = (std::tuple_size_v<decltype(fields_of<Record>)> != 0);

/// Shows each field to `visit`, in their order.
template <Listed Record, typename Visit>
void visit_fields(Visit visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); }, fields_of<Record>);
}

template <typename Value>
nlohmann::ordered_json json_of(const Value& value) {
  if constexpr (Listed<Value>) {
    auto object = nlohmann::ordered_json::object();
    visit_fields<Value>(
        [&](const auto& field) { object[field.key] = json_of(value.*field.member); });
    return object;
  } else if constexpr (Named<Value>) {
    return nlohmann::ordered_json(name_of(value));
  } else {
    return value;
  }
}

template <typename Entry>
nlohmann::ordered_json json_of(const std::vector<Entry>& entries) {
  auto list = nlohmann::ordered_json::array();
  for (const Entry& entry : entries) list.push_back(json_of(entry));
  return list;
}

template <typename Entry>
void read_json(const nlohmann::json& list, const char* what, std::vector<Entry>& entries);
template <std::size_t count>
void read_json(const nlohmann::json& list, const char* what, std::array<double, count>& numbers);

/// Reads a value; `what` names it where it is refused. An `std::int32_t` is a version: not below 0.
template <typename Value>
void read_json(const nlohmann::json& json, const char* what, Value& value) {
  if constexpr (Listed<Value>) {
    visit_fields<Value>([&](const auto& field) {
      read_json(field_in(json, field.key), field.key, value.*field.member);
    });
  } else if constexpr (Named<Value>) {
    const auto found = named<Value>(text_of(json, what));
    if (!found) refuse_json(what, "a name that is known");
    value = *found;
  } else if constexpr (std::is_same_v<Value, bool>) {
    value = flag_of(json, what);
  } else if constexpr (std::is_same_v<Value, std::string>) {
    value = text_of(json, what);
  } else if constexpr (std::is_same_v<Value, double>) {
    value = number_of(json, what);
  } else if constexpr (std::is_same_v<Value, std::int32_t>) {
    value = static_cast<Value>(integer_of(json, what, 0, std::numeric_limits<Value>::max()));
  } else {
    value = integer_of(json, what);
  }
}

template <typename Entry>
void read_json(const nlohmann::json& list, const char* what, std::vector<Entry>& entries) {
  // Far more than any record has: the greatest shipped rubric makes a hundred lines.
  constexpr std::size_t entries_max = 10'000;
  for (const nlohmann::json& entry : list_of(list, what, entries_max)) {
    read_json(entry, what, entries.emplace_back());
  }
}

template <std::size_t count>
void read_json(const nlohmann::json& list, const char* what, std::array<double, count>& numbers) {
  if (list_of(list, what, count).size() != count) refuse_json(what, "as long as it must be");
  for (std::size_t i = 0; i < count; ++i) numbers[i] = number_of(list[i], what);
}

}  // namespace hallux::database
