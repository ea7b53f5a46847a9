#include "simulator/device/thesis_law.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

const Vec3 up(0.0, 1.0, 0.0);
/// A frame of 20 ms, strong motors.
constexpr ThesisLawSettings settings{
    .mass_kg = 0.15, .frame_ticks = 20, .force_limit_newton = 1000.0};

/// Two frames in air with that motion of the handle a frame; ends at the second's place.
ThesisLawState moving(const Vec3& way_mm, Vec3& handle_mm) {
  ThesisLawState state;
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_EQ(thesis_law_force(state, settings, handle_mm, std::nullopt, 20), Vec3(0.0, 0.0, 0.0));
    handle_mm += way_mm;
  }
  return state;
}

TEST(ThesisLaw, ACollisionGivesTheForceThatTurnsTheVelocityAboutInOneFrame) {
  Vec3 handle_mm(0.0, 0.0, 0.0);
  ThesisLawState state = moving({1.0, -2.0, 0.0}, handle_mm);
  // 2 mm in 20 ms is 0.1 m/s; 0.15 kg turned about in 20 ms takes 1.5 N, and nothing along the
  // surface.
  const Vec3 force_newton = thesis_law_force(state, settings, handle_mm, up, 20);
  EXPECT_NEAR(force_newton.y, 0.15 * 0.2 / 0.02, 1.0e-12);
  EXPECT_NEAR(force_newton.x, 0.0, 1.0e-12);
  EXPECT_NEAR(force_newton.z, 0.0, 1.0e-12);
}

TEST(ThesisLaw, AHandleThatIsHeldInfersThePushAndOpposesIt) {
  // The handle does not move though the device pushes with 2 N: the hand pushes as much.
  Vec3 handle_mm(0.0, 0.0, 0.0);
  ThesisLawState state = moving({0.0, 0.0, 0.0}, handle_mm);
  state.force_newton = {0.0, 2.0, 0.0};
  EXPECT_NEAR(thesis_law_force(state, settings, handle_mm, up, 20).y, 2.0, 1.0e-12);
}

TEST(ThesisLaw, LeavesAHandleAloneThatLeavesTheSurface) {
  Vec3 handle_mm(0.0, 0.0, 0.0);
  ThesisLawState state = moving({0.0, 2.0, 0.0}, handle_mm);
  EXPECT_EQ(thesis_law_force(state, settings, handle_mm, up, 20), Vec3(0.0, 0.0, 0.0));
}

TEST(ThesisLaw, HoldsItsForceBetweenFrames) {
  Vec3 handle_mm(0.0, 0.0, 0.0);
  ThesisLawState state = moving({0.0, -2.0, 0.0}, handle_mm);
  const Vec3 force_newton = thesis_law_force(state, settings, handle_mm, up, 20);
  for (int tick = 1; tick < 20; ++tick) {
    EXPECT_EQ(thesis_law_force(state, settings, {0.0, 50.0, 0.0}, std::nullopt, 1), force_newton);
  }
  EXPECT_EQ(thesis_law_force(state, settings, {0.0, 50.0, 0.0}, std::nullopt, 1),
            Vec3(0.0, 0.0, 0.0));
}

TEST(ThesisLaw, AnEncoderStepIsNewtonsAtAKilohertz) {
  ThesisLawSettings fast = settings;
  fast.frame_ticks = 1;
  ThesisLawState state;
  const auto after_a_step = [&] {
    state = {};
    for (int tick = 0; tick < 3; ++tick) thesis_law_force(state, fast, {0.0, 0.0, 0.0}, up, 1);
    return thesis_law_force(state, fast, {0.0, -0.015, 0.0}, up, 1).y;
  };
  // 15 um in a millisecond: 2.25 N of push are inferred, and 4.5 N turn the velocity about.
  EXPECT_NEAR(after_a_step(), 2.25 + 4.5, 1.0e-9);
}

}  // namespace
}  // namespace hallux::simulator
