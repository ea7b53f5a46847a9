#include "simulator/cutting/hole/bore_set.h"

#include <gtest/gtest.h>

#include <array>

namespace hallux::simulator {
namespace {

constexpr std::int32_t wire = 1, drill = 2;
constexpr std::uint32_t in_bore = bit(ToolStatus::InBore) | bit(ToolStatus::DriveOn);

Tray tray() {
  const std::array<Tool, 2> further{WireDriver{}, Drill{}};
  return {Saw{}, further};
}

QuantisedPose at(double x_mm, double y_mm = 0.0) {
  return quantise({Quat{1.0, 0.0, 0.0, 0.0}, Vec3{x_mm, y_mm, 0.0}});
}

/// Two bones in the world's own frame, and a set that a wire bores.
class Bores : public testing::Test {
 protected:
  Bores() { EXPECT_TRUE(say(CutEventKind::ToolChosen, wire)); }

  bool say(CutEventKind kind, std::int32_t subject, std::int64_t value = 0,
           const QuantisedPose& pose = {}) {
    const CutEvent event{0, kind, subject, value, pose};
    return fragments_.apply(event) && bores_.apply(event, fragments_);
  }
  void tip_at(double x_mm, std::uint32_t status = in_bore) {
    ToolSample sample;
    sample.world_from_tool = at(x_mm);
    sample.status = status;
    bores_.apply(sample, fragments_);
  }
  double depth_mm(std::size_t place) const { return bores_.places()[place].bore.depth_mm; }

  std::array<RigidTransform, 2> world_from_bones_{};
  FragmentPoses fragments_{world_from_bones_};
  BoreSet bores_{tray()};
};

TEST_F(Bores, AreOpenedToTheTipByTheRunningToolInThem) {
  ASSERT_TRUE(say(CutEventKind::BoreBegun, 0, 0, at(0.0)));
  EXPECT_EQ(bores_.places()[0].bore.radius_mm, 0.8);
  tip_at(3.0);
  tip_at(2.0);
  EXPECT_NEAR(depth_mm(0), 3.0, 1e-9) << "drawn back closes nothing";
  tip_at(5.0, static_cast<std::uint32_t>(ToolStatus::InBore));
  EXPECT_NEAR(depth_mm(0), 3.0, 1e-9) << "the drive stood still";
  tip_at(7.0, static_cast<std::uint32_t>(ToolStatus::DriveOn));
  tip_at(9.0);
  EXPECT_NEAR(depth_mm(0), 3.0, 1e-9) << "out of the bore, and none was entered since";
  ASSERT_TRUE(say(CutEventKind::BoreEntered, 0, 0));
  tip_at(9.0);
  EXPECT_NEAR(depth_mm(0), 9.0, 1e-9);
}

TEST_F(Bores, OfOneAxisAreOpenedTogetherInTwoBones) {
  ASSERT_TRUE(say(CutEventKind::BoreBegun, 0, 0, at(0.0)));
  tip_at(3.0);
  ASSERT_TRUE(say(CutEventKind::BoreBegun, 1, 1, at(0.0, 0.001)));
  EXPECT_TRUE(bores_.is_entered_in(0));
  EXPECT_TRUE(bores_.is_entered_in(1));
  tip_at(8.0);
  EXPECT_NEAR(depth_mm(0), 8.0, 1e-6);
  EXPECT_NEAR(depth_mm(1), 8.0, 1e-6);
}

TEST_F(Bores, OfAnotherThicknessOrAxisAreNotOpened) {
  ASSERT_TRUE(say(CutEventKind::BoreBegun, 0, 0, at(0.0)));
  ASSERT_TRUE(say(CutEventKind::BoreBegun, 1, 0, at(0.0, 2.0)));
  ASSERT_TRUE(say(CutEventKind::ToolChosen, drill));
  ASSERT_TRUE(say(CutEventKind::BoreBegun, 2, 0, at(0.0)));
  tip_at(4.0);
  EXPECT_EQ(depth_mm(0), 0.0);
  EXPECT_EQ(depth_mm(1), 0.0);
  EXPECT_NEAR(depth_mm(2), 4.0, 1e-9);
}

TEST_F(Bores, GoAlongWithAFragmentThatParts) {
  ASSERT_TRUE(say(CutEventKind::BoreBegun, 0, 0, at(0.0)));
  tip_at(4.0);
  ASSERT_TRUE(say(CutEventKind::FragmentParted, 1, 0));
  ASSERT_EQ(bores_.places().size(), 2U);
  EXPECT_EQ(bores_.places()[1].fragment, 2);
  EXPECT_NEAR(depth_mm(1), 4.0, 1e-9);
  tip_at(4.0, 0);
  ASSERT_TRUE(say(CutEventKind::Released, 2, 0, at(0.0, 5.0)));
  ASSERT_TRUE(say(CutEventKind::BoreEntered, 0, 0));
  tip_at(6.0);
  EXPECT_NEAR(depth_mm(0), 6.0, 1e-9);
  EXPECT_NEAR(depth_mm(1), 4.0, 1e-9) << "it lies elsewhere now";
}

TEST_F(Bores, RefuseWhatCannotBe) {
  EXPECT_FALSE(say(CutEventKind::BoreBegun, 1, 0, at(0.0))) << "not the next";
  EXPECT_FALSE(say(CutEventKind::BoreBegun, 0, 2, at(0.0))) << "no such fragment";
  EXPECT_FALSE(say(CutEventKind::BoreEntered, 0, 0)) << "none was begun";
  EXPECT_FALSE(say(CutEventKind::ToolChosen, 3)) << "no such tool";
  ASSERT_TRUE(say(CutEventKind::ToolChosen, 0));
  EXPECT_FALSE(say(CutEventKind::BoreBegun, 0, 0, at(0.0))) << "a saw bores nothing";
  EXPECT_EQ(bores_.count(), 0);
  ASSERT_TRUE(say(CutEventKind::ToolChosen, wire));
  for (std::int32_t bore = 0; bore < bore_limit; ++bore)
    ASSERT_TRUE(say(CutEventKind::BoreBegun, bore, 0, at(0.0, bore)));
  EXPECT_TRUE(bores_.is_full());
  EXPECT_FALSE(say(CutEventKind::BoreBegun, bore_limit, 0, at(0.0)));
}

}  // namespace
}  // namespace hallux::simulator
