#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenarios/hands/hand_file.h"
#include "scenarios/scenario_error.h"

namespace hallux::scenarios {
namespace {

/// Products of unit vectors and their normalisation: a handful of roundings of numbers of size 1.
constexpr double rounding = 1.0e-14;

constexpr const char* two_keys = R"({"keys": [
  {"time_s": 0.0005, "tip_mm": [1, 2, 3], "direction": [0, -2, 0], "normal": [1, 0, 0]},
  {"time_s": 1.25, "tip_mm": [1, -8, 3], "direction": [0, -1, 0], "normal": [3, 0.5, 0],
   "saw": true}
]})";

std::vector<LaidOutTool> tools() {
  return {{"wide", simulator::Saw{}}, {"wire 1.4", simulator::WireDriver{}}};
}

std::string refusal_of(std::string_view json) {
  try {
    parse_hand_motion(json, "my_hand.json", tools());
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

/// A file of one key, which is the argument.
std::string file_of(const std::string& key) { return R"({"keys": [)" + key + "]}"; }

/// A good key with one field replaced.
std::string key_with(const std::string& field, const std::string& value) {
  std::string key;
  const auto add = [&](const std::string& name, const std::string& usual) {
    key += (key.empty() ? "{\"" : ", \"") + name + "\": " + (name == field ? value : usual);
  };
  add("time_s", "1");
  add("tip_mm", "[0, 0, 0]");
  add("direction", "[1, 0, 0]");
  add("normal", "[0, 0, 1]");
  add("saw", "true");
  return key + "}";
}

void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(a.x, b.x, rounding);
  EXPECT_NEAR(a.y, b.y, rounding);
  EXPECT_NEAR(a.z, b.z, rounding);
}

TEST(HandFile, GivesTheKeysAtTheNearestTicks) {
  const simulator::HandMotion motion = parse_hand_motion(two_keys, "my_hand.json", tools());
  ASSERT_EQ(motion.keys.size(), 2U);
  EXPECT_EQ(motion.keys[0].tick, 1);
  EXPECT_EQ(motion.keys[1].tick, 1250);
  EXPECT_EQ(motion.keys[0].switches, 0U);
  EXPECT_TRUE(has(motion.keys[1].switches, simulator::Switch::SawRuns));
}

TEST(HandFile, PointsTheBladeAlongItsDirectionAndSquaresTheNormalToIt) {
  const simulator::HandMotion motion = parse_hand_motion(two_keys, "my_hand.json", tools());
  for (const simulator::HandKey& key : motion.keys) {
    expect_near(transform_direction(key.world_from_handle, Vec3(1.0, 0.0, 0.0)),
                Vec3(0.0, -1.0, 0.0));
    expect_near(transform_direction(key.world_from_handle, Vec3(0.0, 0.0, 1.0)),
                Vec3(1.0, 0.0, 0.0));
  }
  EXPECT_EQ(motion.keys[0].world_from_handle.translation_mm, Vec3(1.0, 2.0, 3.0));
}

TEST(HandFile, StartsAtItsFirstKeyAndTakesThePieceOutAtItsLast) {
  const simulator::HandMotion motion = parse_hand_motion(two_keys, "my_hand.json", tools());
  ASSERT_EQ(motion.commands.size(), 3U);
  EXPECT_EQ(motion.commands[0].command.kind, simulator::CommandKind::Start);
  EXPECT_EQ(motion.commands[0].tick, 1);
  EXPECT_EQ(motion.commands[1].command.kind, simulator::CommandKind::PickUp);
  EXPECT_EQ(motion.commands[1].tick, 1250);
  EXPECT_EQ(motion.commands[2].command.kind, simulator::CommandKind::Finish);
  EXPECT_EQ(motion.commands[2].tick, 1251);
}

TEST(HandFile, OfOneKeyIsEnough) { EXPECT_EQ(refusal_of(file_of(key_with("", ""))), ""); }

/// Refused with one sentence that names the file, the place, what is wrong and its mend.
void expect_refusal(const std::string& json, const std::vector<std::string>& parts) {
  const std::string refusal = refusal_of(json);
  EXPECT_EQ(refusal.rfind("my_hand.json: ", 0), 0U) << refusal;
  for (const std::string& part : parts) {
    EXPECT_NE(refusal.find(part), std::string::npos) << part << " is not in: " << refusal;
  }
}

TEST(HandFile, ThatIsNoJsonIsRefusedByItsName) {
  expect_refusal("solid bone", {"JSON"});
  expect_refusal("", {"JSON"});
  expect_refusal("[]", {"object with", "keys"});
}

TEST(HandFile, LargerThanItsLimitIsRefusedBeforeItIsRead) {
  expect_refusal(std::string(17U << 20U, '['), {"has more than 16384 KiB"});
}

TEST(HandFile, WithoutAUsableListOfKeysSaysWhatIsWanted) {
  expect_refusal("{}", {"keys"});
  expect_refusal(R"({"keys": 3})", {": keys: ", "list of 1 to 200000"});
  expect_refusal(R"({"keys": []})", {": keys: ", "list of 1 to 200000"});
}

TEST(HandFile, NamesAnUnknownKeyAndWhereItStands) {
  std::string key = key_with("", "");
  expect_refusal(R"({"keys": [)" + key + R"(], "speed": 2})",
                 {"\"speed\"", "unknown", "remove it"});
  key.insert(key.size() - 1, R"(, "tip": 1)");
  expect_refusal(file_of(key), {": keys[0]: ", "\"tip\"", "unknown", "remove it"});
  expect_refusal(file_of("7"), {": keys[0]: ", "object"});
}

TEST(HandFile, NamesTheFieldThatIsMissingOrOutOfRange) {
  expect_refusal(file_of("{}"), {": keys[0]: "});
  for (const std::string value : {"-0.1", "3601", "\"1\"", "null"}) {
    expect_refusal(file_of(key_with("time_s", value)),
                   {": keys[0]", "time_s", "number from 0 to 3600"});
  }
  expect_refusal(file_of(key_with("saw", "1")), {": keys[0]", "saw", "true or false"});
  for (const std::string field : {"tip_mm", "direction", "normal"}) {
    for (const std::string value : {"[1, 2]", "[1, 2, null]", "[1, 2, 3, 4]", "4"}) {
      expect_refusal(file_of(key_with(field, value)), {": keys[0]", field});
    }
  }
}

TEST(HandFile, RefusesABladeWithoutAPlane) {
  expect_refusal(file_of(key_with("normal", "[2, 0, 0]")), {": keys[0]", "parallel"});
  expect_refusal(file_of(key_with("direction", "[0, 0, 0]")), {": keys[0]", "direction"});
}

TEST(HandFile, RefusesTimeThatDoesNotGrow) {
  expect_refusal(file_of(key_with("", "") + ", " + key_with("time_s", "1.0004")),
                 {": keys[1]", "time_s", "grow by at least a millisecond"});
}

/// Two keys, and these commands between them.
std::string said(const std::string& commands) {
  std::string file = two_keys;
  file.insert(file.rfind('}'), R"(, "commands": [)" + commands + "]");
  return file;
}

TEST(HandFile, SaysCommandsAtTheirTimes) {
  const simulator::HandMotion motion = parse_hand_motion(
      said(R"({"time_s": 0.1, "do": "grip", "piece": 2}, {"time_s": 0.2, "do": "impact"},
              {"time_s": 0.3, "do": "release"}, {"time_s": 0.4, "do": "take_out"},
              {"time_s": 0.5, "do": "close_hinge", "hinge": 1},
              {"time_s": 0.6, "do": "step_done", "step": 3})"),
      "my_hand.json", tools());
  using simulator::CommandKind;
  const std::vector<simulator::HandCommand> expected{
      {1, {CommandKind::Start, 0, 0}},
      {100, {CommandKind::Grip, 2, 0}},
      {200, {CommandKind::Impact, 0, 0}},
      {300, {CommandKind::Release, 0, 0}},
      {400, {CommandKind::PickUp, simulator::piece_freed_last, 0}},
      {500, {CommandKind::CloseHinge, 1, 0}},
      {600, {CommandKind::StepDone, 2, 0}},
      {1251, {CommandKind::Finish, 0, 0}}};
  ASSERT_EQ(motion.commands.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(motion.commands[i].tick, expected[i].tick) << i;
    EXPECT_EQ(motion.commands[i].command, expected[i].command) << i;
  }
}

TEST(HandFile, TakesOutNothingByItselfWhereItSaysCommands) {
  EXPECT_EQ(parse_hand_motion(said(""), "my_hand.json", tools()).commands.size(), 2U);
}

TEST(HandFile, RefusesCommandsThatCannotBeCarriedOut) {
  const std::string grip = R"({"time_s": 0.1, "do": "grip"})";
  expect_refusal(said(grip + R"(, {"time_s": 0.2, "do": "grip"})"),
                 {": commands[1].do", "release the piece that they hold first"});
  expect_refusal(said(grip), {": commands", "before the motion ends"});
  expect_refusal(said(R"({"time_s": 0.1, "do": "release"})"),
                 {": commands[0].do", "grip a piece first"});
  expect_refusal(said(R"({"time_s": 0.1, "do": "fly"})"), {": commands[0].do", "grip"});
  expect_refusal(said(R"({"time_s": 0.1, "do": "impact", "piece": 1})"),
                 {": commands[0]", "\"piece\"", "unknown"});
  expect_refusal(said(R"({"time_s": 0.0, "do": "take_out"})"), {": commands[0].time_s", "after"});
  expect_refusal(said(R"({"time_s": 2.0, "do": "take_out"})"), {": commands[0].time_s", "last"});
  expect_refusal(said(R"({"time_s": 0.1, "do": "take_out", "piece": 0})"),
                 {": commands[0].piece", "from 1 to"});
}

/// Two keys, and these fields beside them.
std::string with(const std::string& fields) {
  std::string file = two_keys;
  file.insert(file.rfind('}'), ", " + fields);
  return file;
}

void expect_commands(const std::string& file, const std::vector<simulator::HandCommand>& expected) {
  const simulator::HandMotion motion = parse_hand_motion(file, "my_hand.json", tools());
  ASSERT_EQ(motion.commands.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(motion.commands[i].tick, expected[i].tick) << i;
    EXPECT_EQ(motion.commands[i].command, expected[i].command) << i;
  }
}

TEST(HandFile, ChoosesToolsByName) {
  using simulator::CommandKind;
  expect_commands(with(R"("tool": "wire 1.4", "commands": [
                       {"time_s": 0.2, "do": "leave"}, {"time_s": 0.3, "do": "take", "implant": 0},
                       {"time_s": 0.4, "do": "choose", "tool": "wide"}])"),
                  {{1, {CommandKind::Start, 0, 0}},
                   {1, {CommandKind::ChooseTool, 1, 0}},
                   {200, {CommandKind::LeaveImplant, 0, 0}},
                   {300, {CommandKind::TakeImplant, 0, 0}},
                   {400, {CommandKind::ChooseTool, 0, 0}},
                   {1251, {CommandKind::Finish, 0, 0}}});
  expect_commands(file_of(key_with("saw", R"(true, "tool": "wire 1.4")")),
                  {{1000, {CommandKind::Start, 0, 0}},
                   {1000, {CommandKind::ChooseTool, 1, 0}},
                   {1000, {CommandKind::PickUp, 1, 0}},
                   {1001, {CommandKind::Finish, 0, 0}}});
  expect_refusal(with(R"("tool": "wire 9")"), {": tool", "wide, wire 1.4"});
  expect_refusal(file_of(key_with("saw", R"(true, "tool": "axe")")), {": keys[0].tool", "wide"});
  expect_refusal(said(R"({"time_s": 0.1, "do": "choose"})"), {": commands[0]", "tool"});
  expect_refusal(said(R"({"time_s": 0.1, "do": "take", "implant": 24})"),
                 {": commands[0].implant", "from 0 to"});
}

TEST(HandFile, HoldsPiecesByGrips) {
  using simulator::CommandKind;
  expect_commands(with(R"("grips": [{"from_s": 0.1, "to_s": 0.4, "piece": 2, "impact_s": 0.3},
                       {"from_s": 0.5, "to_s": 0.6}],
                       "commands": [{"time_s": 0.45, "do": "take_out", "piece": 2}])"),
                  {{1, {CommandKind::Start, 0, 0}},
                   {100, {CommandKind::Grip, 2, 0}},
                   {300, {CommandKind::Impact, 0, 0}},
                   {400, {CommandKind::Release, 0, 0}},
                   {450, {CommandKind::PickUp, 2, 0}},
                   {500, {CommandKind::Grip, simulator::piece_freed_last, 0}},
                   {600, {CommandKind::Release, 0, 0}},
                   {1251, {CommandKind::Finish, 0, 0}}});
  expect_refusal(with(R"("grips": [{"from_s": 0.4, "to_s": 0.1}])"), {": grips[0].to_s", "grow"});
  expect_refusal(with(R"("grips": [{"from_s": 0.1, "to_s": 0.4, "impact_s": 0.5}])"),
                 {": grips[0].to_s", "grow"});
  expect_refusal(with(R"("grips": [{"from_s": 0.1, "to_s": 9}])"), {": grips[0].to_s", "last"});
  expect_refusal(with(R"("grips": [], "commands": [{"time_s": 0.1, "do": "grip"}])"),
                 {": commands[0].do", "leave grips out"});
}

TEST(HandFile, GivesFinitePosesOrNone) {
  for (const std::string direction : {"[1e200, 0, 0]", "[1e-200, 0, 0]", "[1e308, 1e308, 0]"}) {
    const std::string file = file_of(key_with("direction", direction));
    if (!refusal_of(file).empty()) continue;
    const Quat rotation =
        parse_hand_motion(file, "far", tools()).keys.at(0).world_from_handle.rotation;
    EXPECT_NEAR(glm::dot(rotation, rotation), 1.0, rounding) << direction;
  }
}

}  // namespace
}  // namespace hallux::scenarios
