/// What an arm is given, as laws over any sequence of forces, motions, faults and numbers that are
/// none.
#include "simulator/device/force_output.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <vector>

namespace hallux::simulator {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const DeviceLimits small_arm{.force_newton = 3.3,
                             .continuous_force_newton = 0.88,
                             .thermal_time_s = 10.0,
                             .stiffness_newton_per_mm = 0.7,
                             .damping_newton_s_per_mm = 0.005,
                             .slew_newton_per_s = 200.0,
                             .transport_ticks = 1};
const ForceOutputSettings settings = force_output_settings(small_arm, 2.0, 1);

double length(const Vec3& vector) { return std::sqrt(glm::dot(vector, vector)); }

/// Forces up to 60 N and steps up to 0.5 mm a tick; every now and then a fault, a long tick or a
/// number that is none.
rc::Gen<ForceInput> any_input() {
  return rc::gen::exec([] {
    const auto part = [](int most, double unit) {
      return unit * *rc::gen::inRange(-most, most + 1);
    };
    ForceInput input;
    input.simulated_in_world_newton = {part(30, 1.0), part(30, 1.0), part(30, 1.0)};
    input.handle_in_world_mm = {part(5, 0.1), part(5, 0.1),
                                part(5, 0.1)};  // the way, summed up below
    input.vibration_in_world_newton = {part(5, 0.1), part(5, 0.1), part(5, 0.1)};
    input.duration_s = 0.001 * *rc::gen::inRange(1, 4);
    const int mishap = *rc::gen::inRange(0, 60);
    input.is_live = mishap != 0;
    if (mishap == 1) input.simulated_in_world_newton.y = nan;
    if (mishap == 2) input.simulated_in_world_newton *= 1.0e300;
    if (mishap == 3) input.handle_in_world_mm.z = infinity;
    if (mishap == 4) input.duration_s = nan;
    if (mishap == 5) input.vibration_in_world_newton.x = nan;
    return input;
  });
}

/// `given` is called with each input and what came of it. Each input is held for 5 ticks, going on
/// as it went.
template <typename Given>
void run(const std::vector<ForceInput>& inputs, Given&& given) {
  ForceOutputState state;
  Vec3 handle_mm(0.0, 0.0, 0.0);
  for (const ForceInput& input : inputs) {
    for (int i = 0; i < 5; ++i) {
      ForceInput at_handle = input;
      at_handle.handle_in_world_mm = handle_mm + input.handle_in_world_mm;
      if (std::isfinite(at_handle.handle_in_world_mm.z)) handle_mm = at_handle.handle_in_world_mm;
      given(at_handle, output_force(state, settings, at_handle), state);
    }
  }
}

double duration_s(const ForceInput& input) {
  return std::isfinite(input.duration_s) ? input.duration_s : 0.003;
}

TEST(ForceOutput, IsWithinForceSlewAndHeatWhateverComes) {
  EXPECT_TRUE(rc::check([] {
    const auto inputs = *rc::gen::container<std::vector<ForceInput>>(any_input());
    Vec3 before_newton(0.0, 0.0, 0.0);
    double squares = 0.0, time_s = 0.0;
    run(inputs,
        [&](const ForceInput& input, const DeviceForce& given, const ForceOutputState& state) {
          const double force_newton = length(given.force_in_world_newton);
          RC_ASSERT(force_newton <= 3.3 * (1.0 + 1.0e-12));
          RC_ASSERT(state.thermal.heat <= 1.0 + 1.0e-12);
          const double tick_s = duration_s(input);
          squares += tick_s * force_newton * force_newton;
          time_s += tick_s;
          RC_ASSERT(squares <= 0.88 * 0.88 * (time_s + 10.0) + 3.3 * 3.3 * 0.003);
          const bool is_stopped =
              has(given.limits, ForceLimit::Stopped) || has(given.limits, ForceLimit::TooFast);
          // Heat takes the force down within half a second beside the slew: F t / 2 ease a tick.
          const double change_newton = length(given.force_in_world_newton - before_newton);
          RC_ASSERT(is_stopped || change_newton <= 200.0 * tick_s + 3.3 * tick_s + 1.0e-9);
          if (is_stopped) RC_ASSERT(given.force_in_world_newton == Vec3(0.0, 0.0, 0.0));
          before_newton = given.force_in_world_newton;
        });
  }));
}

TEST(ForceOutput, AFaultOrNoNumberIsNoForceAtOnce) {
  EXPECT_TRUE(rc::check([] {
    const auto inputs = *rc::gen::container<std::vector<ForceInput>>(any_input());
    run(inputs, [&](const ForceInput& input, const DeviceForce& given, const ForceOutputState&) {
      const Vec3& force = input.simulated_in_world_newton;
      const bool is_number = std::isfinite(force.x) && std::isfinite(force.y) &&
                             std::isfinite(force.z) && std::isfinite(input.handle_in_world_mm.z) &&
                             std::isfinite(input.vibration_in_world_newton.x);
      if (input.is_live && is_number) return;
      RC_ASSERT(given.force_in_world_newton == Vec3(0.0, 0.0, 0.0));
      RC_ASSERT(has(given.limits, ForceLimit::Stopped));
    });
  }));
}

TEST(ForceOutput, GrowsFromNothingWithinHalfASecondOfEveryStop) {
  EXPECT_TRUE(rc::check([] {
    const auto inputs = *rc::gen::container<std::vector<ForceInput>>(any_input());
    double since_stop_s = 0.0;
    Vec3 handle_mm(0.0, 0.0, 0.0);
    run(inputs,
        [&](const ForceInput& input, const DeviceForce& given, const ForceOutputState& state) {
          since_stop_s =
              has(given.limits, ForceLimit::Stopped) || has(given.limits, ForceLimit::TooFast)
                  ? 0.0
                  : since_stop_s + duration_s(input);
          const double share = std::min(1.0, since_stop_s / 0.5);
          RC_ASSERT(state.started_share <= share + 1.0e-9);
          RC_ASSERT(has(given.limits, ForceLimit::SoftStart) ==
                    (since_stop_s > 0.0 && share < 1.0 - 1e-9));
          // Besides what has grown only the damper acts, at most 0.005 N s/mm at less than a metre
          // a second.
          const double most_newton =
              share * (settings.scale * 30.0 + 0.5) * std::sqrt(3.0) + 0.005 * 1000.0;
          RC_ASSERT(length(given.force_in_world_newton) <= most_newton);
        });
  }));
}

TEST(ForceOutput, AHandleAtRestFeelsTheScaledForceOnceItHasGrown) {
  ForceOutputState state;
  const ForceInput input{.simulated_in_world_newton = {3.0, -4.0, 0.0}};
  Vec3 before_newton(0.0, 0.0, 0.0);
  for (int tick = 1; tick <= 500; ++tick) {
    const DeviceForce given = output_force(state, settings, input);
    const double share = tick / 500.0;
    EXPECT_NEAR(length(given.force_in_world_newton), share * settings.scale * 5.0, 1.0e-9) << tick;
    before_newton = given.force_in_world_newton;
  }
  EXPECT_NEAR(before_newton.x, settings.scale * 3.0, 1.0e-12);
  EXPECT_NEAR(before_newton.y, settings.scale * -4.0, 1.0e-12);
  EXPECT_EQ(output_force(state, settings, input).limits, 0U) << "nothing limits it any more";
}

TEST(ForceOutput, SaysWhatLimitsIt) {
  ForceOutputState state;
  state.started_share = 1.0;
  const ForceInput strong{.simulated_in_world_newton = {60.0, 0.0, 0.0}};
  std::uint32_t limits = 0;
  for (int tick = 0; tick < 50; ++tick) limits |= output_force(state, settings, strong).limits;
  EXPECT_TRUE(has(limits, ForceLimit::Slew)) << "0 to 3.3 N takes 17 ticks";
  EXPECT_TRUE(has(limits, ForceLimit::Greatest)) << "60 N are 5.94 N of the device";
  EXPECT_FALSE(has(limits, ForceLimit::Heat));
  for (int tick = 0; tick < 2000; ++tick) limits |= output_force(state, settings, strong).limits;
  EXPECT_TRUE(has(limits, ForceLimit::Heat));
}

TEST(ForceOutput, AHandleFasterThanAHandIsLetGo) {
  ForceOutputState state;
  state.started_share = 1.0;
  ForceInput input{.simulated_in_world_newton = {5.0, 0.0, 0.0}};
  for (int tick = 0; tick < 20; ++tick) output_force(state, settings, input);
  input.handle_in_world_mm.x += 0.9;
  EXPECT_NE(output_force(state, settings, input).force_in_world_newton, Vec3(0.0, 0.0, 0.0));
  input.handle_in_world_mm.x += 1.1;
  const DeviceForce given = output_force(state, settings, input);
  EXPECT_EQ(given.force_in_world_newton, Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(given.limits, static_cast<std::uint32_t>(ForceLimit::TooFast));
  EXPECT_TRUE(has(output_force(state, settings, input).limits, ForceLimit::SoftStart));
}

TEST(ForceOutput, AFaultDoesNotCoolTheMotors) {
  ForceOutputState state;
  const ForceInput strong{.simulated_in_world_newton = {60.0, 0.0, 0.0}};
  for (int tick = 0; tick < 3000; ++tick) output_force(state, settings, strong);
  const double heat = state.thermal.heat;
  ASSERT_GT(heat, 0.5);
  output_force(state, settings, {.is_live = false});
  EXPECT_GT(state.thermal.heat, 0.99 * heat);
}

TEST(ForceOutputDeathTest, RefusesADeviceWithoutForce) {
  EXPECT_DEATH(force_output_settings(DeviceLimits{}, 2.0, 1), "is_possible");
}

}  // namespace
}  // namespace hallux::simulator
