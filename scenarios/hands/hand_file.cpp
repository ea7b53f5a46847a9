#include "scenarios/hands/hand_file.h"

#include <cmath>
#include <cstdint>

#include "scenarios/json_node.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {

namespace {

constexpr std::size_t text_limit = std::size_t{16} << 20U;
constexpr std::size_t key_limit = 200'000;
constexpr double time_limit_s = 3600.0;
constexpr double tip_limit_mm = 1000.0;
constexpr double length_min = 1.0e-3, length_max = 1.0e3;
/// Below this sine, direction and normal do not say how the blade is turned.
constexpr double sine_min = 1.0e-3;

/// A direction of any length that is neither lost in rounding nor absurd.
Vec3 direction_at(const JsonNode& key, std::string_view field) {
  const JsonNode node = key.at(field);
  const Vec3 direction = node.vector(-length_max, length_max);
  const double length = length_of(direction);
  if (!(length >= length_min && length <= length_max)) {
    node.refuse_value("give a vector with a length from 0.001 to 1000");
  }
  return direction;
}

simulator::HandKey key_from(const JsonNode& key) {
  key.expect_keys({"time_s", "tip_mm", "direction", "normal"}, {"saw"});
  const Vec3 direction = direction_at(key, "direction");
  const Vec3 normal = direction_at(key, "normal");
  const Vec3 across = glm::cross(normal, direction);
  const double across_min =
      sine_min * std::sqrt(squared_length(direction) * squared_length(normal));
  if (!(length_of(across) > across_min)) {
    key.at("normal").refuse_value("direction and normal must not be parallel");
  }
  simulator::HandKey parsed;
  parsed.tick =
      static_cast<std::int64_t>(key.at("time_s").number(0.0, time_limit_s) / step_s + 0.5);
  parsed.world_from_handle = {rotation_from_axes(direction, across),
                              key.at("tip_mm").vector(-tip_limit_mm, tip_limit_mm)};
  if (key.has("saw") && key.at("saw").boolean()) {
    parsed.switches = bit(simulator::Switch::SawRuns);
  }
  return parsed;
}

}  // namespace

simulator::HandMotion parse_hand_motion(std::string_view text, std::string_view name) {
  const nlohmann::json document = parse_bounded_json(text, name, text_limit);
  const JsonNode root(document, name);
  root.expect_keys({"keys"});
  simulator::HandMotion motion;
  for (const JsonNode& key : root.at("keys").list(1, key_limit)) {
    const simulator::HandKey parsed = key_from(key);
    if (!motion.keys.empty() && parsed.tick <= motion.keys.back().tick) {
      key.at("time_s").refuse_value("let time_s grow by at least a millisecond from key to key");
    }
    motion.keys.push_back(parsed);
  }
  motion.commands = {{motion.keys.front().tick, {simulator::CommandKind::Start, 0, 0}},
                     {motion.keys.back().tick, {simulator::CommandKind::PickUp, 1, 0}},
                     {motion.keys.back().tick + 1, {simulator::CommandKind::Finish, 0, 0}}};
  return motion;
}

}  // namespace hallux::scenarios
