#include "simulator/cutting/hole/implant_set.h"

#include <gtest/gtest.h>

#include <array>

namespace hallux::simulator {
namespace {

constexpr std::int32_t wire = 1, screw = 2;

class Implants : public testing::Test {
 protected:
  bool say(CutEventKind kind, std::int32_t subject, std::int64_t value = 0,
           const QuantisedPose& pose = {}) {
    const CutEvent event{0, kind, subject, value, pose};
    return fragments_.apply(event) && implants_.apply(event, fragments_);
  }
  static Tray tray() {
    const std::array<Tool, 2> further{WireDriver{}, Screwdriver{}};
    return {Saw{}, further};
  }

  FragmentPoses fragments_{RigidTransform{}};
  ImplantSet implants_{tray()};
};

TEST_F(Implants, AreWhatTheDriverInTheHandLeaves) {
  ASSERT_TRUE(say(CutEventKind::ToolChosen, wire));
  const QuantisedPose pose = quantise({Quat{1.0, 0.0, 0.0, 0.0}, Vec3{7.0, 1.0, 0.0}});
  ASSERT_TRUE(say(CutEventKind::ImplantLeft, 0, 0, pose));
  ASSERT_TRUE(say(CutEventKind::ToolChosen, screw));
  ASSERT_TRUE(say(CutEventKind::ImplantLeft, 1));
  EXPECT_EQ(implants_[0].tool, wire);
  EXPECT_FALSE(implants_[0].size.is_screw);
  EXPECT_TRUE(implants_[1].size.is_screw);
  const Capsule capsule = capsule_of(implants_[0].size, implants_[0].fragment_from_tool);
  EXPECT_NEAR(capsule.to_in_body_mm.x + capsule.radius_mm, 7.0, 1e-9) << "to the tip";
  EXPECT_NEAR(capsule.from_in_body_mm.x - capsule.radius_mm, 7.0 - 120.0, 1e-9);
  EXPECT_NEAR(capsule.from_in_body_mm.y, 1.0, 1e-9);
}

TEST_F(Implants, AreThereUntilTheyAreTaken) {
  ASSERT_TRUE(say(CutEventKind::ToolChosen, wire));
  ASSERT_TRUE(say(CutEventKind::ImplantLeft, 0));
  EXPECT_TRUE(implants_.is_there(0));
  ASSERT_TRUE(say(CutEventKind::ImplantTaken, 0));
  EXPECT_FALSE(implants_.is_there(0));
  EXPECT_FALSE(say(CutEventKind::ImplantTaken, 0)) << "it is in the driver";
  ASSERT_TRUE(say(CutEventKind::ImplantLeft, 1)) << "the same again counts as the next";
}

TEST_F(Implants, GoAlongWithTheFragmentThatIsSaid) {
  ASSERT_TRUE(say(CutEventKind::ToolChosen, wire));
  ASSERT_TRUE(say(CutEventKind::ImplantLeft, 0));
  ASSERT_TRUE(say(CutEventKind::FragmentParted, 1, 0));
  EXPECT_EQ(implants_[0].fragment, 0);
  ASSERT_TRUE(say(CutEventKind::ImplantCarried, 0, 1));
  EXPECT_EQ(implants_[0].fragment, 1);
  EXPECT_FALSE(say(CutEventKind::ImplantCarried, 0, 2)) << "no such fragment";
}

TEST_F(Implants, RefuseWhatCannotBe) {
  EXPECT_FALSE(say(CutEventKind::ImplantLeft, 0)) << "a saw leaves nothing";
  ASSERT_TRUE(say(CutEventKind::ToolChosen, wire));
  EXPECT_FALSE(say(CutEventKind::ImplantLeft, 1)) << "not the next";
  EXPECT_FALSE(say(CutEventKind::ImplantLeft, 0, 1)) << "no such fragment";
  EXPECT_FALSE(say(CutEventKind::ImplantCarried, 0)) << "none is there";
  for (std::int32_t i = 0; i < implant_limit; ++i) ASSERT_TRUE(say(CutEventKind::ImplantLeft, i));
  EXPECT_TRUE(implants_.is_full());
  EXPECT_FALSE(say(CutEventKind::ImplantLeft, implant_limit));
}

}  // namespace
}  // namespace hallux::simulator
