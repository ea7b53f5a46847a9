/// A scenario may come from anywhere: size, depth and doubled keys are bounded while the text is
/// parsed, before any value is looked at. Values are shown in refusals as ASCII and cut short, so
/// that no file reaches a terminal as it is.
#include "scenarios/json_node.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

namespace hallux::scenarios {
namespace {

using nlohmann::json;

/// The value as ASCII without control characters, cut short: what a file holds may not reach a
/// terminal as it is.
std::string shown(const json& value) {
  constexpr std::size_t length_max = 60;
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > length_max) text = text.substr(0, length_max) + "...";
  return text;
}

std::string joined(std::initializer_list<std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) {
    if (!text.empty()) text += ", ";
    text += word;
  }
  return text;
}

bool contains(std::initializer_list<std::string_view> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// "line 3, column 5" of a byte, counted from 1.
std::string place_of_byte(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n');
  const std::size_t column =
      line_start == std::string_view::npos ? before.size() + 1 : before.size() - line_start;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// Watches the parser: how deep it is, and which keys each open object already has.
class ParseGuard {
 public:
  explicit ParseGuard(std::string_view file) : file_(file) {}

  bool operator()(int depth, json::parse_event_t event, const json& parsed) {
    switch (event) {
      case json::parse_event_t::object_start:
        check_depth(depth);
        keys_.emplace_back();
        break;
      case json::parse_event_t::array_start:
        check_depth(depth);
        break;
      case json::parse_event_t::object_end:
        keys_.pop_back();
        break;
      case json::parse_event_t::key:
        if (!keys_.back().insert(parsed.get<std::string>()).second) {
          refuse(file_, shown(parsed), "is twice in the same object", "remove one of them");
        }
        break;
      default:
        break;
    }
    return true;
  }

 private:
  void check_depth(int depth) const {
    if (depth < json_depth_max) return;
    refuse(file_, "depth", "lists and objects lie deeper than " + std::to_string(json_depth_max),
           "write it flatter");
  }

  std::string_view file_;
  std::vector<std::set<std::string>> keys_;
};

}  // namespace

void refuse(std::string_view file, std::string_view path, std::string_view what,
            std::string_view mend) {
  std::string sentence(file);
  sentence.append(": ").append(path.empty() ? "top" : path);
  sentence.append(": ").append(what).append("; ").append(mend);
  throw ScenarioError(sentence);
}

std::string text_of_number(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

json parse_bounded_json(std::string_view text, std::string_view file, std::size_t bytes_max) {
  if (text.size() > bytes_max) {
    refuse(file, "size", "has more than " + std::to_string(bytes_max / 1024) + " KiB",
           "is this the right file?");
  }
  try {
    // The parser takes a copy of its callback, so the guard is handed over by reference.
    ParseGuard guard(file);
    return json::parse(text.begin(), text.end(),
                       [&guard](int depth, json::parse_event_t event, const json& parsed) {
                         return guard(depth, event, parsed);
                       });
  } catch (const json::parse_error& error) {
    refuse(file, place_of_byte(text, error.byte), "is not JSON from here on",
           "mend the commas, quotes and brackets at this place");
  } catch (const json::exception&) {
    refuse(file, "number", "is too large for a number", "write numbers below 1e308");
  }
}

void JsonNode::refuse_value(std::string_view mend) const {
  refuse(file_, path_, "is " + shown(*value_), mend);
}

void JsonNode::expect_keys(std::initializer_list<std::string_view> required,
                           std::initializer_list<std::string_view> optional) const {
  if (!value_->is_object()) refuse_value("give an object with the keys " + joined(required));
  for (const std::string_view key : required) {
    if (has(key)) continue;
    refuse(file_, path_, "the key \"" + std::string(key) + "\" is missing", "add it");
  }
  for (const auto& entry : value_->items()) {
    if (contains(required, entry.key()) || contains(optional, entry.key())) continue;
    refuse(file_, path_, "the key " + shown(json(entry.key())) + " is unknown",
           "remove it, or use one of: " + joined(required) +
               (optional.size() == 0 ? "" : ", " + joined(optional)));
  }
}

bool JsonNode::has(std::string_view key) const {
  return value_->find(std::string(key)) != value_->end();
}

JsonNode JsonNode::at(std::string_view key) const {
  std::string path = path_.empty() ? std::string(key) : path_ + "." + std::string(key);
  return {value_->at(std::string(key)), file_, std::move(path)};
}

std::vector<JsonNode> JsonNode::list(std::size_t count_min, std::size_t count_max) const {
  const std::string mend = "give a list of " + std::to_string(count_min) + " to " +
                           std::to_string(count_max) + " entries";
  if (!value_->is_array()) refuse_value(mend);
  if (value_->size() < count_min || value_->size() > count_max) {
    refuse(file_, path_, "has " + std::to_string(value_->size()) + " entries", mend);
  }
  std::vector<JsonNode> nodes;
  nodes.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i) {
    nodes.push_back(JsonNode((*value_)[i], file_, path_ + "[" + std::to_string(i) + "]"));
  }
  return nodes;
}

double JsonNode::number(double low, double high) const {
  const std::string mend =
      "give a number from " + text_of_number(low) + " to " + text_of_number(high);
  if (!value_->is_number()) refuse_value(mend);
  const double value = value_->get<double>();
  if (!(value >= low && value <= high)) refuse_value(mend);
  return value;
}

std::int32_t JsonNode::integer(std::int32_t low, std::int32_t high) const {
  const std::string mend =
      "give a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  if (!value_->is_number_integer()) refuse_value(mend);
  const double value = value_->get<double>();
  if (!(value >= low && value <= high)) refuse_value(mend);
  return static_cast<std::int32_t>(value);
}

std::int64_t JsonNode::milli(double low, double high) const {
  const double thousandths = number(low, high) * 1000.0;
  const double whole = std::floor(thousandths + 0.5);
  // A decimal with three places is at most one rounding away from a whole number of thousandths.
  if (std::abs(thousandths - whole) > 1.0e-6) refuse_value("give points with at most 3 decimals");
  return static_cast<std::int64_t>(whole);
}

bool JsonNode::boolean() const {
  if (!value_->is_boolean()) refuse_value("give true or false");
  return value_->get<bool>();
}

std::string JsonNode::text(std::size_t length_min, std::size_t length_max) const {
  const std::string mend = "give a text of " + std::to_string(length_min) + " to " +
                           std::to_string(length_max) + " bytes without control characters";
  if (!value_->is_string()) refuse_value(mend);
  std::string text = value_->get<std::string>();
  const bool is_clean = std::none_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
  });
  if (!is_clean || text.size() < length_min || text.size() > length_max) refuse_value(mend);
  return text;
}

std::string JsonNode::name() const {
  constexpr std::string_view mend =
      "give a name of lower-case letters, digits and underscores, a letter first, at most 64";
  if (!value_->is_string()) refuse_value(mend);
  std::string name = value_->get<std::string>();
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto is_allowed = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
  };
  const bool is_name = !name.empty() && name.size() <= 64 && is_letter(name.front()) &&
                       std::all_of(name.begin(), name.end(), is_allowed);
  if (!is_name) refuse_value(mend);
  return name;
}

std::string JsonNode::one_of(std::initializer_list<std::string_view> allowed) const {
  if (!value_->is_string() || !contains(allowed, value_->get_ref<const std::string&>())) {
    refuse_value("use one of: " + joined(allowed));
  }
  return value_->get<std::string>();
}

Vec3 JsonNode::vector(double low, double high) const {
  const std::vector<JsonNode> entries = list(3, 3);
  return {entries[0].number(low, high), entries[1].number(low, high), entries[2].number(low, high)};
}

}  // namespace hallux::scenarios
