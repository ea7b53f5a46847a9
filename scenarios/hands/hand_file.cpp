#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scenarios/hands/scripted_hand.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {

namespace {

using nlohmann::json;

constexpr std::size_t text_limit = std::size_t{16} << 20U;
constexpr std::size_t key_limit = 200'000;
constexpr double time_limit_s = 3600.0;

[[noreturn]] void refuse(std::string_view name, const std::string& where, const std::string& what) {
  throw ScenarioError(std::string(name) + ": " + where + ": " + what);
}

Vec3 vector_at(const json& key, const char* field, std::string_view name,
               const std::string& where) {
  const auto found = key.find(field);
  const bool is_vector =
      found != key.end() && found->is_array() && found->size() == 3 &&
      std::all_of(found->begin(), found->end(), [](const json& part) { return part.is_number(); });
  if (!is_vector) refuse(name, where, std::string(field) + " must be three numbers");
  return {(*found)[0].get<double>(), (*found)[1].get<double>(), (*found)[2].get<double>()};
}

void refuse_unknown(const json& object, std::initializer_list<std::string_view> known,
                    std::string_view name, const std::string& where) {
  for (const auto& item : object.items()) {
    if (std::find(known.begin(), known.end(), item.key()) == known.end()) {
      refuse(name, where, "unknown key \"" + item.key() + "\"; remove it");
    }
  }
}

simulator::HandKey key_from(const json& key, std::string_view name, const std::string& where) {
  if (!key.is_object()) refuse(name, where, "must be an object");
  refuse_unknown(key, {"time_s", "tip_mm", "direction", "normal", "saw"}, name, where);
  const auto time = key.find("time_s");
  const bool has_time = time != key.end() && time->is_number() && time->get<double>() >= 0.0 &&
                        time->get<double>() <= time_limit_s;
  if (!has_time) refuse(name, where, "time_s must be a number from 0 to 3600");
  const auto saw = key.find("saw");
  if (saw != key.end() && !saw->is_boolean()) refuse(name, where, "saw must be true or false");
  const Vec3 direction = vector_at(key, "direction", name, where);
  const Vec3 normal = vector_at(key, "normal", name, where);
  const Vec3 across = glm::cross(normal, direction);
  if (!(glm::dot(across, across) > 1.0e-6)) {
    refuse(name, where, "direction and normal must not be parallel or zero");
  }
  simulator::HandKey parsed;
  parsed.tick = static_cast<std::int64_t>(time->get<double>() / step_s + 0.5);
  parsed.world_from_handle = {rotation_from_axes(direction, across),
                              vector_at(key, "tip_mm", name, where)};
  if (saw != key.end() && saw->get<bool>()) {
    parsed.switches = static_cast<std::uint32_t>(simulator::Switch::SawRuns);
  }
  return parsed;
}

}  // namespace

simulator::HandMotion parse_hand_motion(std::string_view text, std::string_view name) {
  if (text.size() > text_limit) refuse(name, "file", "is larger than 16 MiB; use fewer keys");
  json document;
  try {
    document = json::parse(text);
  } catch (const json::exception& error) {
    refuse(name, "file", std::string("is not JSON (") + error.what() + ")");
  }
  if (!document.is_object()) refuse(name, "file", "must be an object with \"keys\"");
  refuse_unknown(document, {"keys"}, name, "file");
  const auto keys = document.find("keys");
  const bool is_usable =
      keys != document.end() && keys->is_array() && !keys->empty() && keys->size() <= key_limit;
  if (!is_usable) refuse(name, "keys", "must be a list of 1 to 200000 keys");
  simulator::HandMotion motion;
  for (std::size_t i = 0; i < keys->size(); ++i) {
    const std::string where = "keys[" + std::to_string(i) + "]";
    motion.keys.push_back(key_from((*keys)[i], name, where));
    if (i > 0 && motion.keys[i].tick <= motion.keys[i - 1].tick) {
      refuse(name, where, "time_s must grow by at least a millisecond from key to key");
    }
  }
  motion.commands = {{motion.keys.front().tick, {simulator::CommandKind::Start, 0, 0}},
                     {motion.keys.back().tick, {simulator::CommandKind::PickUp, 1, 0}},
                     {motion.keys.back().tick + 1, {simulator::CommandKind::Finish, 0, 0}}};
  return motion;
}

}  // namespace hallux::scenarios
