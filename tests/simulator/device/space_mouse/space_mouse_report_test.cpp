#include "simulator/device/space_mouse/space_mouse_report.h"

#include <gtest/gtest.h>

#include <vector>

namespace hallux::simulator {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(SpaceMouseReport, OlderOnesSayTheirTurnsApart) {
  SpaceMouseState state;
  EXPECT_EQ(take_report(state, Bytes{1, 0x5E, 0x01, 0xA2, 0xFE, 7, 0}), SpaceMouseNews::Motion);
  EXPECT_EQ(take_report(state, Bytes{2, 1, 0, 0xFF, 0xFF, 0x5E, 0x01}), SpaceMouseNews::Motion);
  EXPECT_EQ(state.pushed, (std::array<std::int32_t, 3>{350, -350, 7}));
  EXPECT_EQ(state.turned, (std::array<std::int32_t, 3>{1, -1, 350}));
}

TEST(SpaceMouseReport, NewerOnesSayAllAtOnce) {
  SpaceMouseState state;
  EXPECT_EQ(take_report(state, Bytes{1, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0}),
            SpaceMouseNews::Motion);
  EXPECT_EQ(state.pushed, (std::array<std::int32_t, 3>{1, 2, 3}));
  EXPECT_EQ(state.turned, (std::array<std::int32_t, 3>{4, 5, 6}));
}

TEST(SpaceMouseReport, ButtonsAreBitsHoweverManyThereAre) {
  SpaceMouseState state;
  EXPECT_EQ(take_report(state, Bytes{3, 2}), SpaceMouseNews::Buttons);
  EXPECT_EQ(state.buttons, 2U);
  EXPECT_EQ(take_report(state, Bytes{3, 1, 0x10, 0, 0x80, 0xFF, 0xFF}), SpaceMouseNews::Buttons);
  EXPECT_EQ(state.buttons, 0x80001001U);
  EXPECT_EQ(take_report(state, Bytes{3, 0, 0}), SpaceMouseNews::Buttons);
  EXPECT_EQ(state.buttons, 0U);
}

TEST(SpaceMouseReport, WhatIsNoneOfThemChangesNothing) {
  SpaceMouseState state;
  static_cast<void>(take_report(state, Bytes{1, 9, 0, 9, 0, 9, 0}));
  const SpaceMouseState before = state;
  EXPECT_EQ(take_report(state, Bytes{23, 80}), SpaceMouseNews::None);
  for (const Bytes& bytes : {Bytes{}, Bytes{1}, Bytes{1, 0, 0, 0, 0, 0}, Bytes(12, 1), Bytes(64, 1),
                             Bytes{2, 0, 0}, Bytes{3}, Bytes(8, 3)}) {
    EXPECT_EQ(take_report(state, bytes), SpaceMouseNews::Garbled);
  }
  EXPECT_EQ(state, before);
}

TEST(SpaceMouseReport, ADeflectionIsAShareAlongOurAxes) {
  SpaceMouseState state;
  state.pushed = {350, 175, -700};
  state.turned = {0, 35, 70};
  const Deflection deflection = deflection_of(state, 350);
  EXPECT_EQ(deflection.pushed, Vec3(1.0, 1.0, 0.5));
  EXPECT_EQ(deflection.turned, Vec3(0.0, -0.2, 0.1));
}

}  // namespace
}  // namespace hallux::simulator
