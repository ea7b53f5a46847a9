#include "simulator/device/rate_control.h"

#include <gtest/gtest.h>

#include "simulator/base/units.h"
#include "simulator/device/station/second_hand.h"

namespace hallux::simulator {
namespace {

const Quat straight(1.0, 0.0, 0.0, 0.0);

void hold(RateControl& control, const Deflection& deflection, int ticks,
          const Quat& world_from_view = straight) {
  for (int i = 0; i < ticks; ++i) control.advance(deflection, world_from_view);
}

TEST(RateControl, PushedFullyItGoesAtFullSpeedAndStopsSoonWhenLetGo) {
  RateControl control({});
  hold(control, {{1.0, 0.0, 0.0}, {}}, 1000);
  const double reached_mm = control.world_from_hand().translation_mm.x;
  // A second at full speed, less what the smoothing takes.
  EXPECT_NEAR(reached_mm, 150.0 * (1.0 - 0.05), 0.5);
  hold(control, {}, 1000);
  EXPECT_NEAR(control.world_from_hand().translation_mm.x - reached_mm, 150.0 * 0.05, 0.5);
}

TEST(RateControl, NearTheMiddleNothingMovesAndBeyondItGently) {
  RateControl control({});
  hold(control, {{0.02, -0.02, 0.0}, {0.0, 0.02, 0.0}}, 1000);
  EXPECT_EQ(control.world_from_hand(), RigidTransform{});
  hold(control, {{0.2, 0.0, 0.0}, {}}, 1000);
  EXPECT_GT(control.world_from_hand().translation_mm.x, 2.0);
  EXPECT_LT(control.world_from_hand().translation_mm.x, 0.05 * 150.0);
}

TEST(RateControl, GoesAndTurnsAsItIsSeen) {
  const Quat from_above = rotation_about({1.0, 0.0, 0.0}, radian_from_degree(-90.0));
  RateControl control({});
  hold(control, {{0.0, 1.0, 0.0}, {}}, 200, from_above);
  EXPECT_NEAR(control.world_from_hand().translation_mm.y, 0.0, 1e-9);
  EXPECT_LT(control.world_from_hand().translation_mm.z, -10.0);
  const Vec3 before_mm = control.world_from_hand().translation_mm;
  RateControl turned({straight, before_mm});
  hold(turned, {{}, {0.0, 0.0, 1.0}}, 1000);
  EXPECT_EQ(turned.world_from_hand().translation_mm, before_mm);
  const Vec3 right = axis_x(turned.world_from_hand());
  EXPECT_NEAR(std::atan2(right.y, right.x), 1.5 * 0.95, 0.01);
}

TEST(RateControl, AFullerPushThanThereIsIsFull) {
  RateControl twice({}), once({});
  hold(twice, {{2.0, 0.0, 0.0}, {}}, 100);
  hold(once, {{1.0, 0.0, 0.0}, {}}, 100);
  EXPECT_EQ(twice.world_from_hand(), once.world_from_hand());
}

// The same deflection leads the same way, whether it holds the saw or turns what another holds.
TEST(SecondHand, TurnsAndMovesAsOneThatLeads) {
  for (const Deflection& deflection :
       {Deflection{{}, {0.0, 1.0, 0.0}}, Deflection{{}, {-0.7, 0.0, 0.0}},
        Deflection{{}, {0.0, 0.0, 0.5}}, Deflection{{0.4, -0.8, 0.6}, {}}}) {
    RateControl control(RigidTransform{}, RateSettings{.smoothing_s = step_s});
    hold(control, deflection, 100);
    RigidTransform turned;
    for (int i = 0; i < 100; ++i) turned = steered(turned, straight, motion_of(deflection, step_s));
    const RigidTransform& wanted = control.world_from_hand();
    EXPECT_LT(length_of(turned.translation_mm - wanted.translation_mm), 1e-9);
    EXPECT_NEAR(std::abs(glm::dot(turned.rotation, wanted.rotation)), 1.0, 1e-9);
  }
}

}  // namespace
}  // namespace hallux::simulator
