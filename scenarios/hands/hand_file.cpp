#include "scenarios/hands/hand_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "scenarios/json_node.h"
#include "simulator/base/units.h"
#include "simulator/cutting/hole/implant_set.h"

namespace hallux::scenarios {

namespace {

using simulator::Command;
using simulator::CommandKind;
using simulator::HandCommand;

constexpr std::size_t text_limit = std::size_t{16} << 20U;
constexpr std::size_t key_limit = 200'000;
constexpr std::size_t command_limit = 10'000;
constexpr std::size_t grip_limit = 1000, tool_name_limit = 100;
constexpr std::int32_t piece_limit = 1000, hinge_limit = 31, step_limit = 100;
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

std::int64_t tick_of(const JsonNode& time) {
  return static_cast<std::int64_t>(time.number(0.0, time_limit_s) / step_s + 0.5);
}

simulator::HandKey key_from(const JsonNode& key) {
  key.expect_keys({"time_s", "tip_mm", "direction", "normal"}, {"saw", "tool"});
  const Vec3 direction = direction_at(key, "direction");
  const Vec3 normal = direction_at(key, "normal");
  const Vec3 across = glm::cross(normal, direction);
  const double across_min =
      sine_min * std::sqrt(squared_length(direction) * squared_length(normal));
  if (!(length_of(across) > across_min)) {
    key.at("normal").refuse_value("direction and normal must not be parallel");
  }
  simulator::HandKey parsed;
  parsed.tick = tick_of(key.at("time_s"));
  parsed.world_from_handle = {rotation_from_axes(direction, across),
                              key.at("tip_mm").vector(-tip_limit_mm, tip_limit_mm)};
  if (key.has("saw") && key.at("saw").boolean()) {
    parsed.switches = bit(simulator::Switch::SawRuns);
  }
  return parsed;
}

/// The piece that a command names; the one that came free last where it names none.
std::int32_t piece_of(const JsonNode& command) {
  return command.has("piece") ? command.at("piece").integer(1, piece_limit)
                              : simulator::piece_freed_last;
}

/// Takes the tool of that name into the hand.
Command choose(const JsonNode& tool, const std::vector<LaidOutTool>& tools) {
  const std::optional<std::int32_t> place = place_of(tools, tool.text(1, tool_name_limit));
  if (place) return {CommandKind::ChooseTool, *place, 0};
  std::string names;
  for (const LaidOutTool& each : tools) names += (names.empty() ? "" : ", ") + each.name;
  tool.refuse_value("name one that the operation lays out: " + names);
}

/// What `do` means, without its time.
Command command_from(const JsonNode& node, const std::vector<LaidOutTool>& tools) {
  const std::string what =
      node.at("do").one_of({"take_out", "grip", "impact", "release", "close_hinge", "step_done",
                            "reopen_step", "choose", "leave", "take"});
  if (what == "take_out" || what == "grip") {
    node.expect_keys({"time_s", "do"}, {"piece"});
    return {what == "grip" ? CommandKind::Grip : CommandKind::PickUp, piece_of(node), 0};
  }
  if (what == "close_hinge") {
    node.expect_keys({"time_s", "do"}, {"hinge"});
    const std::int32_t hinge = node.has("hinge") ? node.at("hinge").integer(0, hinge_limit) : 0;
    return {CommandKind::CloseHinge, hinge, 0};
  }
  if (what == "step_done" || what == "reopen_step") {
    node.expect_keys({"time_s", "do", "step"});
    const std::int32_t step = node.at("step").integer(1, step_limit) - 1;
    return {what == "step_done" ? CommandKind::StepDone : CommandKind::ReopenStep, step, 0};
  }
  if (what == "choose") {
    node.expect_keys({"time_s", "do", "tool"});
    return choose(node.at("tool"), tools);
  }
  if (what == "take") {
    node.expect_keys({"time_s", "do", "implant"});
    return {CommandKind::TakeImplant, node.at("implant").integer(0, simulator::implant_limit - 1),
            0};
  }
  node.expect_keys({"time_s", "do"});
  if (what == "leave") return {CommandKind::LeaveImplant, 0, 0};
  return {what == "impact" ? CommandKind::Impact : CommandKind::Release, 0, 0};
}

/// When something may be said in a motion, each after the one before.
class Times {
 public:
  Times(std::int64_t first_tick, std::int64_t last_tick)
      : tick_(first_tick), last_tick_(last_tick) {}

  std::int64_t take(const JsonNode& time) {
    const std::int64_t tick = tick_of(time);
    if (tick <= tick_) {
      time.refuse_value("begin after the first key, and let times grow from one to the next");
    }
    if (tick > last_tick_) time.refuse_value("give a time that is not after the last key's");
    return tick_ = tick;
  }

 private:
  /// Of the one before; at first of the key that starts the attempt.
  std::int64_t tick_;
  std::int64_t last_tick_;
};

/// What is said in a motion, in its order; the forceps hold one piece at a time.
class Commands {
 public:
  /// has_grips  grips of their own say what the forceps do
  Commands(const Times& times, bool has_grips, const std::vector<LaidOutTool>& tools)
      : times_(times), has_grips_(has_grips), tools_(tools) {}

  HandCommand take(const JsonNode& node) {
    node.expect_keys({"time_s", "do"}, {"piece", "hinge", "step", "tool", "implant"});
    const std::int64_t tick = times_.take(node.at("time_s"));
    const Command command = command_from(node, tools_);
    watch_forceps(node, command);
    return {tick, command};
  }
  /// needs   the last of them was taken
  void expect_open_forceps(const JsonNode& list) const {
    if (is_gripped_) list.refuse_value("let the forceps release the piece before the motion ends");
  }

 private:
  void watch_forceps(const JsonNode& node, const Command& command) {
    const bool is_grip = command.kind == CommandKind::Grip;
    const bool needs_piece =
        command.kind == CommandKind::Release || command.kind == CommandKind::Impact;
    if (has_grips_ && (is_grip || needs_piece))
      node.at("do").refuse_value("say it in grips, or leave grips out");
    if (is_grip && is_gripped_)
      node.at("do").refuse_value("let the forceps release the piece that they hold first");
    if (needs_piece && !is_gripped_)
      node.at("do").refuse_value("let the forceps grip a piece first");
    if (is_grip) is_gripped_ = true;
    if (command.kind == CommandKind::Release) is_gripped_ = false;
  }

  Times times_;
  bool has_grips_;
  const std::vector<LaidOutTool>& tools_;
  bool is_gripped_ = false;
};

/// One holding of a piece, as its commands.
void add_grip(const JsonNode& grip, Times& times, std::vector<HandCommand>& commands) {
  grip.expect_keys({"from_s", "to_s"}, {"piece", "impact_s"});
  commands.push_back({times.take(grip.at("from_s")), {CommandKind::Grip, piece_of(grip), 0}});
  if (grip.has("impact_s"))
    commands.push_back({times.take(grip.at("impact_s")), {CommandKind::Impact, 0, 0}});
  commands.push_back({times.take(grip.at("to_s")), {CommandKind::Release, 0, 0}});
}

/// The keys in their order, and the tools that they choose.
void read_keys(const JsonNode& root, const std::vector<LaidOutTool>& tools,
               simulator::HandMotion& motion) {
  for (const JsonNode& key : root.at("keys").list(1, key_limit)) {
    const simulator::HandKey parsed = key_from(key);
    if (!motion.keys.empty() && parsed.tick <= motion.keys.back().tick) {
      key.at("time_s").refuse_value("let time_s grow by at least a millisecond from key to key");
    }
    const bool is_first = motion.keys.empty();
    motion.keys.push_back(parsed);
    if (is_first) motion.commands.push_back({parsed.tick, {CommandKind::Start, 0, 0}});
    if (is_first && root.has("tool"))
      motion.commands.push_back({parsed.tick, choose(root.at("tool"), tools)});
    if (key.has("tool")) motion.commands.push_back({parsed.tick, choose(key.at("tool"), tools)});
  }
}

}  // namespace

simulator::HandMotion parse_hand_motion(std::string_view text, std::string_view name,
                                        const std::vector<LaidOutTool>& tools) {
  const nlohmann::json document = parse_bounded_json(text, name, text_limit);
  const JsonNode root(document, name);
  root.expect_keys({"keys"}, {"tool", "grips", "commands"});
  simulator::HandMotion motion;
  read_keys(root, tools, motion);
  const std::int64_t last_tick = motion.keys.back().tick;
  const Times times(motion.keys.front().tick, last_tick);
  if (root.has("grips")) {
    Times gripped = times;
    for (const JsonNode& grip : root.at("grips").list(0, grip_limit))
      add_grip(grip, gripped, motion.commands);
  }
  if (root.has("commands")) {
    const JsonNode list = root.at("commands");
    Commands commands(times, root.has("grips"), tools);
    for (const JsonNode& command : list.list(0, command_limit))
      motion.commands.push_back(commands.take(command));
    commands.expect_open_forceps(list);
  } else {
    motion.commands.push_back({last_tick, {CommandKind::PickUp, 1, 0}});
  }
  std::stable_sort(motion.commands.begin(), motion.commands.end(),
                   [](const HandCommand& a, const HandCommand& b) { return a.tick < b.tick; });
  motion.commands.push_back({last_tick + 1, {CommandKind::Finish, 0, 0}});
  return motion;
}

}  // namespace hallux::scenarios
