/// The tremble of a saw in an arm that can render it: what two arms are given whose hands do the
/// same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/contact/vibration.h"
#include "simulator/device/scripted.h"
#include "tests/simulator/loop/recorded_run.h"
#include "tests/simulator/loop/watched_device.h"

namespace hallux::simulator {
namespace {

constexpr std::int64_t last_tick = 3000;
constexpr std::size_t started_tick = 600;  ///< the soft start is over

/// An arm in a hand that nothing moves.
class HeldArm final : public HapticDevice {
 public:
  HeldArm(const HandMotion& motion, double force_newton, bool renders_vibration)
      : hand_(motion), limits_{.force_newton = force_newton} {
    limits_.continuous_force_newton = force_newton;
    limits_.stiffness_newton_per_mm = 3.0;
    limits_.slew_newton_per_s = 5000.0;
    limits_.renders_vibration = renders_vibration;
  }
  DeviceDescription description() const override { return {"held arm", "arm", limits_}; }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override {
    return hand_.exchange(force_in_world_newton, tick, state);
  }

 private:
  ScriptedDevice hand_;
  DeviceLimits limits_;
};

struct TwoArms {
  explicit TwoArms(double force_newton, std::int64_t off_tick = last_tick)
      : motion(motion_until(bone, off_tick)),
        held_still(motion, force_newton, false),
        held_trembling(motion, force_newton, true) {
    const AttemptSetup setup = tests::setup_for(bone, motion, last_tick);
    of_still = tests::record(setup, still).recording;
    of_trembling = tests::record(setup, trembling).recording;
  }
  /// The saw is switched off at that tick.
  static HandMotion motion_until(const Bone& bone, std::int64_t off_tick) {
    HandMotion motion = tests::sawing_motion(bone, last_tick);
    if (off_tick == last_tick) return motion;
    HandKey off = motion.keys[1];
    off.tick = off_tick;
    off.switches = 0;
    motion.keys.insert(motion.keys.begin() + 2, off);
    for (std::size_t key = 2; key < motion.keys.size(); ++key) motion.keys[key].switches = 0;
    return motion;
  }
  /// Along the tooth line, at the exchange after that tick.
  double vibration_newton(std::size_t tick) const {
    const Vec3 difference = trembling.given_newton[tick + 1] - still.given_newton[tick + 1];
    const Vec3 along = transform_direction(
        transform_from(of_trembling.samples[tick].world_from_tool), Vec3(0.0, 1.0, 0.0));
    EXPECT_NEAR(glm::dot(difference, difference), std::pow(glm::dot(difference, along), 2.0), 1e-9)
        << "it is nowhere but along the teeth";
    return glm::dot(difference, along);
  }
  double most_newton(ToolStatus status, bool is_set) const {
    double most = 0.0;
    for (std::size_t tick = started_tick; tick + 1 < of_still.samples.size(); ++tick) {
      const std::uint32_t bits = of_still.samples[tick].status;
      if (has(bits, ToolStatus::SawOn) && has(bits, status) == is_set)
        most = std::max(most, std::abs(vibration_newton(tick)));
    }
    return most;
  }

  Bone bone = tests::loop_block();
  HandMotion motion;
  HeldArm held_still, held_trembling;
  tests::WatchedDevice still{held_still}, trembling{held_trembling};
  Recording of_still, of_trembling;
};

TEST(ArmVibration, IsFeltAndNeverRecorded) {
  const TwoArms arms(8.0);
  EXPECT_EQ(arms.of_still.samples, arms.of_trembling.samples);
  EXPECT_EQ(arms.of_still.events, arms.of_trembling.events);
}

TEST(ArmVibration, IsStrongerWhereBoneIsTakenAway) {
  const TwoArms arms(8.0);
  const double free_newton = arms.most_newton(ToolStatus::InContact, false);
  const double cutting_newton = arms.most_newton(ToolStatus::Cutting, true);
  EXPECT_GT(free_newton, 0.09);
  EXPECT_GT(cutting_newton, 1.1 * free_newton);
  EXPECT_LE(cutting_newton, vibration_full_newton * (1.0 + vibration_noise));
}

TEST(ArmVibration, HasHalfTheRateOfTheSaw) {
  const TwoArms arms(8.0);
  int crossings = 0;
  for (std::size_t tick = 1001; tick < 2001; ++tick) {
    if (arms.vibration_newton(tick - 1) < 0.0 && arms.vibration_newton(tick) >= 0.0) ++crossings;
  }
  EXPECT_NEAR(crossings, vibration_hz(12000.0), 2.0);
}

TEST(ArmVibration, IsStillSoonAfterTheSawIs) {
  const TwoArms arms(8.0, 1500);
  double before_newton = 0.0;
  for (std::size_t tick = 1400; tick < 1490; ++tick) {
    before_newton = std::max(before_newton, std::abs(arms.vibration_newton(tick)));
  }
  EXPECT_GT(before_newton, 0.05);
  for (std::size_t tick = 1525; tick < 2900; ++tick) EXPECT_EQ(arms.vibration_newton(tick), 0.0);
}

TEST(ArmVibration, TakesAtMostItsShareOfASmallArm) {
  const TwoArms arms(1.0);
  const double most_newton = arms.most_newton(ToolStatus::SawOn, true);
  EXPECT_GT(most_newton, 0.0);
  EXPECT_LE(most_newton, vibration_share_of_force * 1.0);
  for (const Vec3& given : arms.trembling.given_newton) {
    EXPECT_LE(std::sqrt(glm::dot(given, given)), 1.0 + 1.0e-12);
  }
}

}  // namespace
}  // namespace hallux::simulator
