#include "simulator/device/inverse3/inverse_message.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hallux::simulator {
namespace {

constexpr const char* inventory = R"({"session_id": 7,
 "inverse3": [
  {"device_id": "049D",
   "config": {"type": "inverse3", "port": "COM12", "device_info": {"id": "049D", "device_type": 4},
              "mount": {"position": {"x": 5, "y": 6, "z": 7}}},
   "state": {"cursor_position": {"x": 0.01, "y": -0.12, "z": 0.15},
             "cursor_velocity": {"x": 9, "y": 9, "z": 9},
             "current_cursor_force": {"x": 0.5, "y": 0, "z": -1},
             "transform": {"rotation": {"w": 1, "x": 0, "y": 0, "z": 0}}},
   "status": {"calibrated": false, "in_use": true}}],
 "wireless_verse_grip": [
  {"device_id": "61576", "state": {"orientation": {"w": 0.6, "x": 0, "y": 0.8, "z": 0},
                                   "buttons": {"a": true, "b": false, "c": true}}}]})";

TEST(InverseMessage, AnInventoryIsRead) {
  const auto message = inverse_message(inventory);
  ASSERT_TRUE(message);
  ASSERT_EQ(message->arm_count, 1U);
  const InverseArm* arm = message->arm_with("049D");
  ASSERT_NE(arm, nullptr);
  EXPECT_EQ(arm->type, "inverse3");
  EXPECT_EQ(arm->cursor_m, Vec3(0.01, -0.12, 0.15));
  EXPECT_EQ(arm->force_newton, Vec3(0.5, 0.0, -1.0));
  EXPECT_EQ(arm->is_calibrated, false);
  EXPECT_EQ(message->arm_with("049"), nullptr);
  ASSERT_EQ(message->grip_count, 1U);
  EXPECT_NEAR(message->grips[0].rotation->y, 0.8, 1e-15);
  EXPECT_EQ(message->grips[0].buttons, 0b101U);
  EXPECT_FALSE(message->is_older_form);
}

TEST(InverseMessage, PartsMayBeAbsentAndStandInAnyOrder) {
  const auto message = inverse_message(
      R"({"inverse3":[{"state":{"cursor_position":{"z":3,"x":1,"y":2}},"device_id":"A"},
                      {"device_id":"B","state":{"cursor_position":{"x":1,"y":2}}},
                      {"state":{}}, 5, "x", null, []]})");
  ASSERT_TRUE(message);
  ASSERT_EQ(message->arm_count, 2U) << "one without a name is nobody's";
  EXPECT_EQ(message->arms[0].cursor_m, Vec3(1.0, 2.0, 3.0));
  EXPECT_FALSE(message->arms[1].cursor_m) << "half a place is none";
  EXPECT_FALSE(message->arms[0].is_calibrated);
  EXPECT_TRUE(inverse_message("{}"));
  EXPECT_TRUE(inverse_message("5"));
  EXPECT_TRUE(inverse_message("[[]]"));
}

TEST(InverseMessage, AWiredGripHasOneButton) {
  const auto message = inverse_message(R"({"verse_grip":[{"state":{"button":true,"hall":1}}]})");
  ASSERT_TRUE(message);
  EXPECT_EQ(message->grips[0].buttons, 1U);
}

TEST(InverseMessage, NamesBeforeListsAreTheOlderForm) {
  EXPECT_TRUE(inverse_message(R"({"inverse3":{"049D":{"state":{}}}})")->is_older_form);
}

TEST(InverseMessage, WhatIsHostileIsRefused) {
  const auto state = [](const std::string& x) {
    return R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":)" + x +
           R"(,"y":0,"z":0}}}]})";
  };
  EXPECT_TRUE(inverse_message(state("0")));
  for (const std::string& text :
       {std::string("{"), std::string(), state("NaN"), state("1e999"), state("Infinity"),
        state("1e7"), state("-5000"), std::string(17, '['), std::string(1000000, '['),
        state("\"\\ud800\"")}) {
    EXPECT_FALSE(inverse_message(text)) << text.substr(0, 80);
  }
  EXPECT_TRUE(inverse_message(R"({"session_id":12345678901234567890,"time":1e18})"))
      << "what is none of ours may be large";
}

TEST(InverseMessage, AnIdThatWouldSpeakForItselfIsNone) {
  const auto message = inverse_message(
      R"({"inverse3":[{"device_id":"A\",\"commands\":{}"},{"device_id":""},{"device_id":"A B"}]})");
  ASSERT_TRUE(message);
  EXPECT_EQ(message->arm_count, 0U);
}

TEST(InverseMessage, MoreThanAnyHandHoldsIsLeft) {
  std::string text = R"({"inverse3":[)";
  for (int i = 0; i < 100; ++i) text += R"({"device_id":"A"},)";
  text.back() = ']';
  text += '}';
  EXPECT_EQ(inverse_message(text)->arm_count, inverse_arms_most);
}

TEST(InverseMessage, ARotationThatIsNoneIsLeft) {
  const auto rotation = [](const std::string& w) {
    return inverse_message(R"({"verse_grip":[{"state":{"orientation":{"w":)" + w +
                           R"(,"x":0,"y":0,"z":0}}}]})")
        ->grips[0]
        .rotation;
  };
  EXPECT_FALSE(rotation("0"));
  EXPECT_FALSE(rotation("9"));
  EXPECT_EQ(rotation("1.25"), Quat(1.0, 0.0, 0.0, 0.0)) << "rounded ones are made whole";
}

TEST(InverseMessage, AForceIsSaidUnderEitherWord) {
  EXPECT_EQ(inverse_force("049D", InverseForceKey::Vector, {1.0, -0.25, 0.0}),
            R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":{"vector":)"
            R"({"x":1.0000,"y":-0.2500,"z":0.0000}}}}]})");
  EXPECT_NE(inverse_force("A", InverseForceKey::Values, {}).find(R"("values":{)"),
            std::string::npos);
}

TEST(InverseMessage, VersionsAreRead) {
  using Version = InverseVersion;
  EXPECT_EQ(inverse_version(R"({"project_version":"3.5.0.0"})"), (Version{3, 5}));
  EXPECT_EQ(inverse_version(R"({"project_version":"3.12"})"), (Version{3, 12}));
  for (const char* page : {"", "[]", "{}", R"({"project_version":3})", R"({"project_version":"3"})",
                           R"({"project_version":"three.five"})"}) {
    EXPECT_FALSE(inverse_version(page)) << page;
  }
  EXPECT_FALSE(inverse_version(std::string(100000, '[')));
  EXPECT_TRUE((Version{3, 0}).is_before({3, 1}));
  EXPECT_FALSE((Version{4, 0}).is_before({3, 5}));
}

}  // namespace
}  // namespace hallux::simulator
