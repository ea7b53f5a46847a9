#include "simulator/contact/danger_zone.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/simulator/step/simulation_run.h"

namespace hallux::simulator {
namespace {

/// Teeth at x = 0, collar at x = -20, edges at y = -5 and 5, half a kerf of 0.25 to both sides of z
/// = 0.
constexpr Blade blade{.width_mm = 10.0, .depth_mm = 20.0, .kerf_mm = 0.5};
constexpr double half_kerf_mm = 0.25;

double distance_mm(const Vec3& from, const Vec3& to, double radius_mm = 1.0) {
  return distance_to_capsule_mm({}, blade, {from, to, radius_mm});
}

TEST(DangerZone, InFrontOfTheTeethIsAsFarAsTheTeeth) {
  EXPECT_NEAR(distance_mm({3.0, -9.0, 0.0}, {3.0, 9.0, 0.0}), 3.0 - 1.0 - half_kerf_mm, 1e-12);
}

TEST(DangerZone, AboveTheFaceIsAsFarAsTheFace) {
  EXPECT_NEAR(distance_mm({-8.0, 1.0, 4.0}, {-12.0, 2.0, 6.0}), 4.0 - 1.0 - half_kerf_mm, 1e-12);
}

TEST(DangerZone, BesideACornerIsAsFarAsTheCorner) {
  // A line along z past the corner (0, 5): 3 in x and 4 in y.
  EXPECT_NEAR(distance_mm({3.0, 9.0, -7.0}, {3.0, 9.0, 7.0}), 5.0 - 1.0 - half_kerf_mm, 1e-12);
}

TEST(DangerZone, BehindTheCollarIsAsFarAsTheCollar) {
  EXPECT_NEAR(distance_mm({-26.0, 0.0, -1.0}, {-26.0, 0.0, 2.0}), 6.0 - 1.0 - half_kerf_mm, 1e-12);
}

TEST(DangerZone, ThatTheBladeRunsThroughIsDeepByItsRadius) {
  EXPECT_NEAR(distance_mm({-5.0, 0.0, -3.0}, {-6.0, 1.0, 3.0}), -1.0 - half_kerf_mm, 1e-12);
}

TEST(DangerZone, OfNoLengthIsASphere) {
  EXPECT_NEAR(distance_mm({4.0, 0.0, 3.0}, {4.0, 0.0, 3.0}), 5.0 - 1.0 - half_kerf_mm, 1e-12);
}

Vec3 any_point() {
  const auto along = [] { return *rc::gen::inRange(-30000, 30000) * 0.001; };
  const double x = along(), y = along();
  return {x, y, along()};
}

/// The least distance between points sown over both, and how much too large it can be: half a step
/// of each.
RC_GTEST_PROP(DangerZone, IsNoFartherThanAnyPointAndAsNearAsTheNearest, ()) {
  const Vec3 from = any_point(), to = any_point();
  const RigidTransform pose{rotation_about(Vec3{0.6, 0.0, 0.8}, *rc::gen::inRange(0, 6283) * 0.001),
                            any_point()};
  constexpr int steps = 80;
  double least_mm = 1.0e9;
  for (int i = 0; i <= steps; ++i) {
    const Vec3 on_line =
        transform_point(inverse(pose), from + (static_cast<double>(i) / steps) * (to - from));
    const Vec3 nearest{std::clamp(on_line.x, -20.0, 0.0), std::clamp(on_line.y, -5.0, 5.0), 0.0};
    least_mm = std::min(least_mm, glm::length(on_line - nearest));
  }
  const double exact_mm = distance_to_capsule_mm(pose, blade, {from, to, 1.0}) + 1.0 + half_kerf_mm;
  RC_ASSERT(exact_mm <= least_mm + 1e-9);
  RC_ASSERT(exact_mm >= least_mm - 0.5 * glm::length(to - from) / steps - 1e-9);
}

/// A blade over a capsule across its way, so that the distance is a matter of height alone.
class Approach {
 public:
  /// The teeth stand `distance_mm` above the capsule for so many samples.
  void hold(double distance_mm, std::int64_t ticks, bool saw_runs = true, bool is_running = true) {
    for (std::int64_t i = 0; i < ticks; ++i) {
      ToolSample sample;
      sample.tick = tick_++;
      sample.world_from_tool =
          quantise(place_ * tests::blade_down({0.0, distance_mm + 1.0 + half_kerf_mm, 0.0}));
      if (saw_runs) sample.status |= static_cast<std::uint32_t>(ToolStatus::SawOn);
      if (is_running) sample.status |= static_cast<std::uint32_t>(ToolStatus::Running);
      watch_.apply(sample);
      for (DangerNews news; watch_.take_news(news);) heard.push_back(news);
    }
  }
  const DangerTrack& track() const { return watch_.tracks()[0]; }

  std::vector<DangerNews> heard;

 private:
  RigidTransform place_ = tests::slanted_place();
  std::array<DangerCapsule, 1> zones_{{{{0.0, 0.0, -10.0}, {0.0, 0.0, 10.0}, 1.0}}};
  DangerWatch watch_{place_, blade, zones_};
  std::int64_t tick_ = 0;
};
/// A quantised pose.
constexpr double quantum_mm = 0.003;

TEST(DangerWatch, TellsOfAContactOnceWhenItBeginsAndOnceWhenItIsOver) {
  Approach approach;
  approach.hold(5.0, 10);
  EXPECT_EQ(approach.track().state, DangerState::Far);
  approach.hold(2.0, 10);
  EXPECT_EQ(approach.track().state, DangerState::Near);
  EXPECT_TRUE(approach.heard.empty());
  approach.hold(-0.2, 30);
  approach.hold(-0.7, 20);
  EXPECT_EQ(approach.track().state, DangerState::Contact);
  ASSERT_EQ(approach.heard.size(), 1U);
  EXPECT_TRUE(approach.heard[0].has_begun);
  EXPECT_NEAR(approach.heard[0].distance_mm, -0.2, quantum_mm);
  approach.hold(2.0, danger_leave_ticks);
  ASSERT_EQ(approach.heard.size(), 2U);
  EXPECT_FALSE(approach.heard[1].has_begun);
  EXPECT_NEAR(approach.heard[1].distance_mm, -0.7, quantum_mm);
  EXPECT_EQ(approach.track().contacts, 1);
  EXPECT_NEAR(approach.track().contact_s, 0.05, 1e-9);
  EXPECT_NEAR(approach.track().least_mm, -0.7, quantum_mm);
}

TEST(DangerWatch, ATremblingHandIsInOneContact) {
  Approach approach;
  for (int i = 0; i < 20; ++i) {
    approach.hold(-0.1, 30);
    approach.hold(0.3, 30);
    approach.hold(0.8, 30);
  }
  EXPECT_EQ(approach.heard.size(), 1U);
  EXPECT_EQ(approach.track().contacts, 1);
  EXPECT_NEAR(approach.track().contact_s, 0.6, 1e-9);
}

TEST(DangerWatch, ABladeAtRestTouchesNothing) {
  Approach approach;
  approach.hold(-0.5, 500, false);
  approach.hold(-0.5, 500, true, false);
  EXPECT_TRUE(approach.heard.empty());
  EXPECT_EQ(approach.track().state, DangerState::Far);
  EXPECT_TRUE(std::isinf(approach.track().least_mm));
}

TEST(DangerWatch, AContactIsOverWhenTheSawStops) {
  Approach approach;
  approach.hold(-0.5, 10);
  approach.hold(-0.5, danger_leave_ticks, false);
  ASSERT_EQ(approach.heard.size(), 2U);
  EXPECT_FALSE(approach.heard[1].has_begun);
}

TEST(DangerWatch, EveryFloodOfSwitchesEndsInFewEvents) {
  Approach approach;
  for (int i = 0; i < 5000; ++i) approach.hold(i % 7 < 4 ? -0.5 : 4.0, 1, i % 3 != 0);
  EXPECT_LE(approach.heard.size(), 2U * 5000U / danger_leave_ticks + 1U);
}

}  // namespace
}  // namespace hallux::simulator
