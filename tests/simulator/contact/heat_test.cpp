/// A saw that is led as the published temperature tests led theirs: at a given rate, push and feed
/// through hard bone.
#include "simulator/contact/heat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "simulator/base/units.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

/// Blade and rate of domain 3.3's calibration: the least rise that was published for dry bone.
struct Sawing {
  double cycles_per_minute = 10000.0;
  double push_newton = 10.0;
  double feed_mm_s = 0.5;  ///< 30 mm/min
  bool is_irrigated = false;
};
constexpr Blade test_blade{.width_mm = 10.0, .depth_mm = 25.0, .kerf_mm = 0.5};

/// A block of cortical bone with its top at y = 10, sawn from there towards -y in the plane x = 0.
class SawnBlock {
 public:
  explicit SawnBlock(const Sawing& sawing)
      : sawing_(sawing), field_({test_blade, sawing.cycles_per_minute}) {
    kerfs_.freeze(quantise(pose()));
  }

  /// One sample of the record, `ticks` long.
  void step(std::int64_t ticks, double feed_mm_s, bool saw_runs = true) {
    tick_ += ticks;
    tip_mm_ -= feed_mm_s * static_cast<double>(ticks) * step_s;
    ToolSample sample;
    sample.tick = tick_ - 1;
    sample.kerf = 0;
    sample.world_from_tool = quantise(bone_.world_from_bone * pose());
    const Vec3 back = transform_direction(bone_.world_from_bone, Vec3{0.0, 1.0, 0.0});
    sample.force_mn = {millinewton_from_newton(sawing_.push_newton * back.x),
                       millinewton_from_newton(sawing_.push_newton * back.y),
                       millinewton_from_newton(sawing_.push_newton * back.z)};
    for (const ToolStatus bit : {ToolStatus::Running, ToolStatus::InContact, ToolStatus::InKerf}) {
      sample.status |= static_cast<std::uint32_t>(bit);
    }
    if (saw_runs) sample.status |= static_cast<std::uint32_t>(ToolStatus::SawOn);
    if (sawing_.is_irrigated) sample.status |= static_cast<std::uint32_t>(ToolStatus::Irrigated);
    kerfs_.apply(sample);
    field_.apply(sample, {tissue_, kerfs_, {}});
    for (HeatMark mark; field_.take_mark(mark);) marks.push_back({sample.tick, mark});
  }
  void saw(double seconds) { run(seconds, sawing_.feed_mm_s, true); }
  void dwell(double seconds) { run(seconds, 0.0, true); }
  void rest(double seconds) { run(seconds, 0.0, false); }

  const HeatField& field() const { return field_; }
  const HeatSummary& summary() const { return field_.summary(); }
  const KerfSet& kerfs() const { return kerfs_; }

  std::int64_t ticks_per_line = 1;
  std::vector<std::pair<std::int64_t, HeatMark>> marks;

 private:
  RigidTransform pose() const { return tests::blade_down({0.0, tip_mm_, 0.0}); }
  void run(double seconds, double feed_mm_s, bool saw_runs) {
    const auto end = tick_ + static_cast<std::int64_t>(seconds * 1000.0 + 0.5);
    while (tick_ < end) step(ticks_per_line, feed_mm_s, saw_runs);
  }

  Sawing sawing_;
  Bone bone_ = tests::cortical_bone(tests::solid_block({8.0, 20.0, 30.0}));
  TissueMap tissue_{bone_};
  KerfSet kerfs_{test_blade, bone_.world_from_bone};
  HeatField field_;
  double tip_mm_ = 10.0;
  std::int64_t tick_ = 0;
};

/// Over a way of 8 mm: by then the front has its steady temperature.
double rise_celsius(const Sawing& sawing) {
  SawnBlock block(sawing);
  block.saw(8.0 / sawing.feed_mm_s);
  return block.summary().hottest_celsius - body_celsius;
}

TEST(Heat, DryBoneRisesByThePublished65Degrees) {
  // 65.45 degrees at 10,000 cycles and 30 mm/min; the share that stays in the walls was fitted to
  // it.
  EXPECT_NEAR(rise_celsius({}), 65.45, 1.5);
}

TEST(Heat, IrrigatedBoneNeverRisesAboveTheBodysTemperature) {
  SawnBlock block({.is_irrigated = true});
  block.saw(16.0);
  EXPECT_EQ(block.summary().hottest_celsius, body_celsius);
  EXPECT_EQ(block.summary().greatest_dose_min, 0.0);
  EXPECT_TRUE(block.marks.empty());
}

TEST(Heat, RisesWithTheRateOfTheSaw) {
  double last = 0.0;
  for (const double cycles_per_minute : {5000.0, 7500.0, 10000.0, 12500.0}) {
    const double rise = rise_celsius({.cycles_per_minute = cycles_per_minute});
    EXPECT_GT(rise, last + 5.0) << cycles_per_minute;
    last = rise;
  }
}

TEST(Heat, FallsWithTheFeedUnderTheSamePush) {
  double last = 1000.0;
  for (const double feed_mm_s : {0.25, 0.5, 0.75, 1.0}) {
    const double rise = rise_celsius({.feed_mm_s = feed_mm_s});
    EXPECT_LT(rise, last - 2.0) << feed_mm_s;
    last = rise;
  }
}

TEST(Heat, ASawThatDwellsReachesTheBalanceOfHeatAndCooling) {
  SawnBlock block({.push_newton = 4.0});
  block.saw(4.0);
  block.dwell(60.0);
  // share x friction x push x speed x cooling / capacity of the strip that it rubs
  const double power_watt = 0.76 * 0.3 * 4.0 * mean_tooth_speed_mm_s(25.0, 10000.0) / 1000.0;
  const double capacity = bone_heat_joule_per_mm3_kelvin * 2.0 * 10.0 * 2.0 * 1.0;
  const Vec2 behind_teeth{2.0 - 0.5, 0.5};  // the tool was frozen 2 mm higher up
  // Where the teeth stand in a cell, and where they lie along it, shifts a few percent to the
  // neighbours.
  const double expected = power_watt * cooling_s / capacity;
  EXPECT_NEAR(block.field().celsius_at(0, behind_teeth) - body_celsius, expected, 0.05 * expected);
}

TEST(Heat, CoolsToBodyTemperatureWhenTheSawStops) {
  SawnBlock block({});
  block.saw(8.0);
  block.rest(60.0);
  // 65 degrees, twelve time constants of 5 s.
  EXPECT_NEAR(block.field().celsius_at(0, {2.5, 0.5}), body_celsius, 65.0 / 160000.0);
  EXPECT_GT(block.summary().hottest_celsius, 90.0);
}

TEST(Heat, CountsTheTimeInWhichAnyBoneIsHot) {
  SawnBlock block({});
  block.saw(8.0);
  const double sawing_s = block.summary().hot_s;
  EXPECT_GT(sawing_s, 5.0);
  EXPECT_LT(sawing_s, 8.0);
  block.rest(60.0);
  // 102 degrees cool to 47 in 5 ln(65 / 10) = 9.4 s.
  EXPECT_NEAR(block.summary().hot_s - sawing_s, 9.4, 0.5);
}

TEST(Heat, DrySawingKillsTheWallsOfAllThatWasSawn) {
  SawnBlock block({});
  block.saw(16.0);
  block.rest(30.0);
  // 8 mm of way and 10 mm of width, a millimetre of both walls; cells on the rim may count or not.
  EXPECT_GE(block.summary().necrotic_mm3, 2.0 * 7.0 * 9.0);
  EXPECT_LE(block.summary().necrotic_mm3, 2.0 * 10.0 * 12.0);
}

TEST(Heat, MarksEachPatchOnceAndNeverTwoWithinATenthOfASecond) {
  SawnBlock block({});
  block.saw(16.0);
  block.rest(20.0);
  ASSERT_FALSE(block.marks.empty());
  for (std::size_t i = 0; i < block.marks.size(); ++i) {
    if (i > 0) {
      EXPECT_GE(block.marks[i].first - block.marks[i - 1].first, ticks_per_heat_mark);
    }
    for (std::size_t j = 0; j < i; ++j) {
      const HeatMark& a = block.marks[i].second;
      const HeatMark& b = block.marks[j].second;
      const Vec2 apart_mm = glm::abs(a.place_mm - b.place_mm);
      const bool is_other_cell = apart_mm.x > 0.0 || apart_mm.y > 0.0;
      EXPECT_TRUE(a.kind != b.kind || is_other_cell);
    }
  }
  const auto is_hot = [](const auto& mark) { return mark.second.kind == HeatMarkKind::Hot; };
  const auto hot = std::count_if(block.marks.begin(), block.marks.end(), is_hot);
  // 10 x 12 mm in patches of 5 x 5 mm.
  EXPECT_GE(hot, 4);
  EXPECT_LE(hot, 12);
  EXPECT_EQ(static_cast<std::size_t>(hot) * 2, block.marks.size());
}

TEST(Heat, WarmsNoCellInTheAirAboveTheBone) {
  SawnBlock block({});
  block.saw(3.0);
  EXPECT_EQ(block.field().celsius_at(0, {-0.5, 0.5}), body_celsius);
  EXPECT_EQ(block.field().celsius_at(0, {-1.5, 0.5}), body_celsius);
  EXPECT_GT(block.field().celsius_at(0, {0.5, 0.5}), hot_celsius);
}

TEST(Heat, StandsStillWhileTheAttemptDoesNotRun) {
  SawnBlock block({});
  block.saw(8.0);
  HeatField field = block.field();
  const double before_celsius = field.celsius_at(0, {3.5, 0.5});
  const Bone bone = tests::cortical_bone(tests::solid_block({8.0, 20.0, 30.0}));
  const TissueMap tissue(bone);
  for (std::int64_t tick = 8000; tick < 9000; ++tick) {
    ToolSample sample;
    sample.tick = tick;
    field.apply(sample, {tissue, block.kerfs(), {}});
  }
  EXPECT_EQ(field.celsius_at(0, {3.5, 0.5}), before_celsius);
  EXPECT_EQ(field.summary().hot_s, block.summary().hot_s);
}

TEST(Heat, IsBodyTemperatureBeyondItsCells) {
  const SawnBlock block({});
  EXPECT_EQ(block.field().celsius_at(0, {1000.0, 0.0}), body_celsius);
}

TEST(Heat, MissedTicksChangeItByLittle) {
  SawnBlock punctual({}), late({});
  late.ticks_per_line = 3;
  punctual.saw(12.0);
  late.saw(12.0);
  EXPECT_NEAR(late.summary().hottest_celsius, punctual.summary().hottest_celsius, 0.5);
  EXPECT_NEAR(late.summary().hot_s, punctual.summary().hot_s, 0.1);
}

TEST(Heat, TheSameSamplesGiveTheSameBits) {
  SawnBlock one({}), other({});
  one.saw(6.0);
  other.saw(6.0);
  EXPECT_EQ(one.summary().hottest_celsius, other.summary().hottest_celsius);
  EXPECT_EQ(one.summary().greatest_dose_min, other.summary().greatest_dose_min);
}

}  // namespace
}  // namespace hallux::simulator
