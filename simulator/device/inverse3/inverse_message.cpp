#include "simulator/device/inverse3/inverse_message.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace hallux::simulator {

namespace {

/// Farther than any arm reaches, stronger than any pushes.
constexpr double number_most = 1000.0;
constexpr std::size_t id_letters_most = 40, page_bytes_most = 8192;

/// What stands in a message where.
enum class Word : std::uint8_t {
  Other,
  Arms,
  Grips,
  Id,
  Config,
  Type,
  State,
  Status,
  Cursor,
  Force,
  Orientation,
  Buttons,
  OneButton,
  IsCalibrated,
  X,
  Y,
  Z,
  W,
  A,
  B,
  C
};

constexpr std::array<std::pair<std::string_view, Word>, 21> words{{
    {"inverse3", Word::Arms},
    {"wireless_verse_grip", Word::Grips},
    {"verse_grip", Word::Grips},
    {"device_id", Word::Id},
    {"config", Word::Config},
    {"type", Word::Type},
    {"state", Word::State},
    {"status", Word::Status},
    {"cursor_position", Word::Cursor},
    {"current_cursor_force", Word::Force},
    {"orientation", Word::Orientation},
    {"buttons", Word::Buttons},
    {"button", Word::OneButton},
    {"calibrated", Word::IsCalibrated},
    {"x", Word::X},
    {"y", Word::Y},
    {"z", Word::Z},
    {"w", Word::W},
    {"a", Word::A},
    {"b", Word::B},
    {"c", Word::C},
}};

Word word_of(std::string_view key) noexcept {
  const auto* found =
      std::find_if(words.begin(), words.end(), [&](const auto& each) { return each.first == key; });
  return found == words.end() ? Word::Other : found->second;
}

bool is_id(std::string_view text) noexcept {
  return !text.empty() && text.size() <= id_letters_most &&
         std::all_of(text.begin(), text.end(), [](char letter) {
           return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z') ||
                  (letter >= 'A' && letter <= 'Z');
         });
}

/// Numbers of a point or a rotation as they come, whichever of them do.
struct Parts {
  std::array<std::optional<double>, 4> wxyz;

  void take(Word word, double value) noexcept {
    if (word == Word::W) wxyz[0] = value;
    if (word == Word::X) wxyz[1] = value;
    if (word == Word::Y) wxyz[2] = value;
    if (word == Word::Z) wxyz[3] = value;
  }
  std::optional<Vec3> point() const noexcept {
    if (!wxyz[1] || !wxyz[2] || !wxyz[3]) return std::nullopt;
    return Vec3(*wxyz[1], *wxyz[2], *wxyz[3]);
  }
  std::optional<Quat> rotation() const noexcept {
    if (!wxyz[0] || !point()) return std::nullopt;
    const Quat all(*wxyz[0], *wxyz[1], *wxyz[2], *wxyz[3]);
    const double length = glm::length(all);
    constexpr double unit_least = 0.5, unit_most = 2.0;
    if (!(length >= unit_least && length <= unit_most)) return std::nullopt;
    return all / length;
  }
};

/// Picks what is known out of a message, whatever else stands there; false ends the reading.
class Reader final : public nlohmann::json::json_sax_t {
 public:
  bool null() override { return true; }
  bool boolean(bool value) override {
    take(value);
    return true;
  }
  bool number_integer(std::int64_t value) override { return take(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) override { return take(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) override { return take(value); }
  bool string(std::string& value) override {
    take(value);
    return true;
  }
  bool binary(nlohmann::json::binary_t&) override { return false; }
  bool key(std::string& name) override {
    path_[depth_ - 1] = word_of(name);
    return true;
  }
  bool start_object(std::size_t) override {
    if (!go_down()) return false;
    // Where the list should be.
    if (depth_ == list_depth && list() == Word::Arms) message_.is_older_form = true;
    if (depth_ == entry_depth) begin_entry();
    if (depth_ == part_depth) parts_ = {};
    return true;
  }
  bool end_object() override {
    if (depth_ == part_depth) end_part();
    if (depth_ == entry_depth) end_entry();
    --depth_;
    return true;
  }
  bool start_array(std::size_t) override { return go_down(); }
  bool end_array() override {
    --depth_;
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;
  }

  const InverseMessage& message() const noexcept { return message_; }

 private:
  // {"inverse3": [ {"state": {"cursor_position": {...
  //  1            2 3         4                  5
  static constexpr std::size_t list_depth = 2, entry_depth = 3, group_depth = 4, part_depth = 5;

  bool go_down() {
    if (depth_ >= inverse_depth_most) return false;
    path_[depth_++] = Word::Other;
    return true;
  }
  Word list() const noexcept { return path_[0]; }
  Word group() const noexcept { return path_[entry_depth - 1]; }
  Word part() const noexcept { return path_[group_depth - 1]; }
  Word last() const noexcept { return depth_ == 0 ? Word::Other : path_[depth_ - 1]; }

  void begin_entry() {
    arm_ = {};
    grip_ = {};
  }
  void end_part() {
    if (group() != Word::State) return;
    if (part() == Word::Cursor) arm_.cursor_m = parts_.point();
    if (part() == Word::Force) arm_.force_newton = parts_.point();
    if (part() == Word::Orientation) grip_.rotation = parts_.rotation();
  }
  void end_entry() {
    if (list() == Word::Arms && !arm_.id.empty() && message_.arm_count < inverse_arms_most)
      message_.arms[message_.arm_count++] = arm_;
    if (list() == Word::Grips && message_.grip_count < inverse_grips_most)
      message_.grips[message_.grip_count++] = grip_;
  }

  bool take(double value) {
    if (!(std::abs(value) <= number_most)) return last() == Word::Other;
    if (depth_ == part_depth) parts_.take(last(), value);
    return true;
  }
  void take(const std::string& value) {
    if (depth_ == entry_depth && last() == Word::Id && is_id(value)) arm_.id = value;
    if (depth_ == group_depth && group() == Word::Config && last() == Word::Type && is_id(value))
      arm_.type = value;
  }
  void take(bool value) {
    if (depth_ == group_depth && group() == Word::Status && last() == Word::IsCalibrated)
      arm_.is_calibrated = value;
    if (depth_ == group_depth && group() == Word::State && last() == Word::OneButton)
      press(0, value);
    if (depth_ != part_depth || group() != Word::State || part() != Word::Buttons) return;
    if (last() == Word::A) press(0, value);
    if (last() == Word::B) press(1, value);
    if (last() == Word::C) press(2, value);
  }
  void press(unsigned button, bool is_down) {
    grip_.buttons = grip_.buttons.value_or(0) | (is_down ? 1U << button : 0U);
  }

  std::array<Word, inverse_depth_most> path_{};
  std::size_t depth_ = 0;
  InverseArm arm_;
  InverseGrip grip_;
  Parts parts_;
  InverseMessage message_;
};

void append_number(std::string& text, double value) {
  constexpr int digits = 4;
  std::array<char, 32> letters{};
  const auto written = std::to_chars(letters.data(), letters.data() + letters.size(), value,
                                     std::chars_format::fixed, digits);
  text.append(letters.data(), written.ptr);
}

}  // namespace

const InverseArm* InverseMessage::arm_with(std::string_view id) const noexcept {
  const auto* const end = arms.begin() + arm_count;
  const auto* const found =
      std::find_if(arms.begin(), end, [&](const InverseArm& each) { return each.id == id; });
  return found == end ? nullptr : &*found;
}

std::optional<InverseMessage> inverse_message(std::string_view text) {
  Reader reader;
  if (!nlohmann::json::sax_parse(text, &reader)) return std::nullopt;
  return reader.message();
}

std::string inverse_force(const std::string& id, InverseForceKey key, const Vec3& force_newton) {
  std::string text = R"({"inverse3":[{"device_id":")";
  text += id;
  text += R"(","commands":{"set_cursor_force":{")";
  text += key == InverseForceKey::Vector ? "vector" : "values";
  text += R"(":{"x":)";
  append_number(text, force_newton.x);
  text += R"(,"y":)";
  append_number(text, force_newton.y);
  text += R"(,"z":)";
  append_number(text, force_newton.z);
  text += "}}}}]}";
  return text;
}

std::string inverse_inventory() { return R"({"session":{"force_render_full_state":{}}})"; }

std::optional<InverseVersion> inverse_version(std::string_view page) {
  if (page.size() > page_bytes_most) return std::nullopt;
  const nlohmann::json all = nlohmann::json::parse(page, nullptr, false);
  const auto found = all.is_object() ? all.find("project_version") : all.end();
  if (found == all.end() || !found->is_string()) return std::nullopt;
  const std::string text = found->get<std::string>();
  InverseVersion version;
  const char* const end = text.data() + text.size();
  const auto major = std::from_chars(text.data(), end, version.major);
  if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.') return std::nullopt;
  if (std::from_chars(major.ptr + 1, end, version.minor).ec != std::errc()) return std::nullopt;
  return version;
}

}  // namespace hallux::simulator
