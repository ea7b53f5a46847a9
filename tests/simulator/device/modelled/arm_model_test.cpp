#include "simulator/device/modelled/arm_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/units.h"

namespace hallux::simulator {
namespace {

const HandGrip no_hand{.stiffness_newton_per_mm = 0.0, .damping_newton_s_per_mm = 0.0};

TEST(ArmModel, ADamperTakesTheSpeedAsItsEquationSays) {
  const ArmTraits traits{.transport_ticks = 0, .substeps = 100};
  ArmState arm;
  arm.velocity_mm_s.x = 100.0;
  for (int tick = 0; tick < 75; ++tick) advance(arm, traits, no_hand);
  // v = v0 exp(-b t / m): 2 N s/m on 0.15 kg is 75 ms.
  EXPECT_NEAR(arm.velocity_mm_s.x, 100.0 * std::exp(-1.0), 0.01);
}

TEST(ArmModel, SwingsOnItsHandWithTheFrequencyOfMassAndSpring) {
  const ArmTraits traits{.damping_newton_s_per_mm = 0.0, .transport_ticks = 0};
  const HandGrip spring{.stiffness_newton_per_mm = 0.3, .damping_newton_s_per_mm = 0.0};
  ArmState arm;
  arm.place_mm.x = 1.0;
  int crossings = 0;
  for (int tick = 0; tick < 10000; ++tick) {
    const double before_mm = arm.place_mm.x;
    advance(arm, traits, spring);
    if (before_mm * arm.place_mm.x < 0.0) ++crossings;
  }
  // sqrt(300 / 0.15) / 2 pi = 7.118 Hz, two crossings a period.
  EXPECT_NEAR(crossings, 2.0 * 10.0 * std::sqrt(300.0 / 0.15) / (2.0 * pi), 1.5);
}

TEST(ArmModel, AForceActsAfterTheTransport) {
  for (std::int32_t transport = 0; transport <= 2; ++transport) {
    const ArmTraits traits{.transport_ticks = transport};
    ArmState arm;
    std::int32_t still_ticks = 0;
    for (std::int32_t tick = 0; tick < 5; ++tick) {
      send_force(arm, {1.0, 0.0, 0.0});
      advance(arm, traits, no_hand);
      if (arm.velocity_mm_s.x == 0.0) ++still_ticks;
    }
    EXPECT_EQ(still_ticks, transport);
  }
}

TEST(ArmModel, ItsMotorsGiveWhatTheyCanAndNoMore) {
  const ArmTraits traits{.motor_limit_newton = 8.0, .transport_ticks = 0};
  ArmState strong, limited;
  send_force(strong, {80.0, 60.0, 0.0});
  send_force(limited, {6.4, 4.8, 0.0});
  advance(strong, traits, no_hand);
  advance(limited, traits, no_hand);
  EXPECT_NEAR(strong.velocity_mm_s.x, limited.velocity_mm_s.x, 1.0e-12);
  EXPECT_NEAR(strong.velocity_mm_s.y, limited.velocity_mm_s.y, 1.0e-12);
}

TEST(ArmModel, WorkDoneIsMotionGained) {
  const ArmTraits traits{
      .mass_kg = 0.2, .damping_newton_s_per_mm = 0.0, .transport_ticks = 0, .substeps = 1000};
  const HandGrip push{.stiffness_newton_per_mm = 0.0,
                      .damping_newton_s_per_mm = 0.0,
                      .push_newton = {0.0, 1.0, 0.0}};
  ArmState arm;
  for (int tick = 0; tick < 100; ++tick) {
    send_force(arm, {0.5, 0.0, 0.0});
    advance(arm, traits, push);
  }
  // m v^2 / 2 with mm/s: kg mm^2/s^2 are microjoules.
  EXPECT_NEAR(arm.work.of_motors_millijoule, 0.5 * 0.2 * 250.0 * 250.0 / 1000.0, 0.01);
  EXPECT_NEAR(arm.work.of_hand_millijoule, 0.5 * 0.2 * 500.0 * 500.0 / 1000.0, 0.01);
}

TEST(ArmModel, ItsEncodersSayWholeSteps) {
  const ArmTraits traits;
  ArmState arm;
  arm.place_mm = {0.0074, 0.0076, -0.0226};
  const Vec3 read_mm = read_encoders(arm, traits);
  EXPECT_NEAR(read_mm.x, 0.0, 1.0e-12);
  EXPECT_NEAR(read_mm.y, 0.015, 1.0e-12);
  EXPECT_NEAR(read_mm.z, -0.030, 1.0e-12);
}

}  // namespace
}  // namespace hallux::simulator
