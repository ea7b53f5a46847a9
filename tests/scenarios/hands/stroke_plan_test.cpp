#include "scenarios/hands/stroke_plan.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::scenarios {
namespace {

/// Sums of a few numbers under 100.
constexpr double rounding_mm = 1.0e-12;

/// 1.5 mm beyond the sides.
constexpr StrokeLayout forefoot{12.0, 3.0, 1.5};

simulator::SectionRegion region_of(simulator::Contour contour) {
  simulator::SectionRegion region;
  region.min_mm = region.max_mm = contour.at(0);
  for (const Vec2& point : contour) {
    region.min_mm = glm::min(region.min_mm, point);
    region.max_mm = glm::max(region.max_mm, point);
  }
  region.contours = {std::move(contour)};
  return region;
}

simulator::SectionRegion rectangle(const Vec2& low_mm, const Vec2& high_mm) {
  return region_of({low_mm, {high_mm.x, low_mm.y}, high_mm, {low_mm.x, high_mm.y}});
}

/// A bone's outline has many points: here every half millimetre or closer, as on a bone of 0.3 mm
/// edges.
simulator::SectionRegion ellipse(const Vec2& half_mm, double dent) {
  constexpr int count = 720;
  simulator::Contour contour;
  for (int i = 0; i < count; ++i) {
    const double angle_rad = 2.0 * pi * i / count;
    const double share = 1.0 + dent * std::cos(3.0 * angle_rad);
    contour.emplace_back(share * half_mm.x * std::cos(angle_rad),
                         share * half_mm.y * std::sin(angle_rad));
  }
  return region_of(std::move(contour));
}

TEST(StrokePlan, OfANarrowSectionIsOneStrokeThroughItsMiddle) {
  const auto strokes = plan_strokes(rectangle({-3.0, 1.0}, {11.0, 7.0}), forefoot);
  ASSERT_EQ(strokes.size(), 1U);
  EXPECT_NEAR(strokes[0].along_mm, 4.0, rounding_mm);
  EXPECT_NEAR(strokes[0].first_mm, -3.0, rounding_mm);
  EXPECT_NEAR(strokes[0].last_mm, 11.0, rounding_mm);
}

TEST(StrokePlan, GoesFromTheMiddleOutwards) {
  // 20 mm and 1.5 mm beyond each end make 23: blades of 12 with 3 mm of overlap take three.
  const auto strokes = plan_strokes(rectangle({0.0, -12.0}, {18.0, 12.0}), forefoot);
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_NEAR(strokes[0].along_mm, 0.0, rounding_mm);
  EXPECT_NEAR(std::abs(strokes[1].along_mm), 7.5, rounding_mm);
  EXPECT_NEAR(strokes[1].along_mm, -strokes[2].along_mm, rounding_mm);
}

TEST(StrokePlan, KnowsWhereBoneBeginsAndEndsUnderEachStroke) {
  // Half as long at the far side: the strokes there are shorter.
  const simulator::SectionRegion region = ellipse({10.0, 18.0}, 0.0);
  for (const Stroke& stroke : plan_strokes(region, forefoot)) {
    // The outline is widest at the end of the tooth line that is nearer to the middle.
    const double nearest_mm = std::max(0.0, std::abs(stroke.along_mm) - 6.0 - 1.0);
    const double half_mm = 10.0 * std::sqrt(1.0 - nearest_mm * nearest_mm / (18.0 * 18.0));
    // Points lie every 0.16 mm along the outline, whose slope is below 2 there.
    EXPECT_NEAR(stroke.last_mm, half_mm, 0.35);
    EXPECT_NEAR(stroke.first_mm, -half_mm, 0.35);
  }
}

TEST(StrokePlan, FollowsAnOutlineBetweenCornersThatAreBesideTheToothLine) {
  // Both long sides rise by 0.1 mm per millimetre along the tooth line: over its 12 mm and 1 mm
  // beside it from -7 to 7.
  const auto region = region_of({{-3.0, -20.0}, {7.0, -20.0}, {11.0, 20.0}, {1.0, 20.0}});
  const auto strokes = plan_strokes(region, forefoot);
  ASSERT_EQ(strokes.size(), 5U);
  EXPECT_NEAR(strokes[0].along_mm, 0.0, rounding_mm);
  EXPECT_NEAR(strokes[0].first_mm, -1.0 - 0.7, rounding_mm);
  EXPECT_NEAR(strokes[0].last_mm, 9.0 + 0.7, rounding_mm);
}

TEST(StrokePlan, GoesOnBeyondTheLastBone) {
  const auto strokes = plan_strokes(rectangle({-3.0, 1.0}, {11.0, 7.0}), forefoot);
  EXPECT_NEAR(strokes.at(0).end_mm, 11.0 + 1.5, rounding_mm);
  EXPECT_FALSE(strokes[0].stops_in_bone);
}

TEST(StrokePlan, StopsAtALine) {
  const std::vector<Stroke> through{
      {0.0, -3.0, 11.0, 12.5}, {9.0, 2.0, 4.0, 5.5}, {-9.0, 6.5, 8.0, 9.5}};
  const std::vector<Stroke> strokes = stopped(through, 6.0);
  // The third begins beyond the line; the second's bone ends before it, and the hand goes to the
  // line all the same.
  ASSERT_EQ(strokes.size(), 2U);
  const double lasts_mm[] = {6.0, 4.0};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(strokes[i].end_mm, 6.0, rounding_mm) << i;
    EXPECT_NEAR(strokes[i].last_mm, lasts_mm[i], rounding_mm) << i;
    EXPECT_EQ(strokes[i].first_mm, through[i].first_mm) << i;
    EXPECT_EQ(strokes[i].along_mm, through[i].along_mm) << i;
    EXPECT_TRUE(strokes[i].stops_in_bone) << i;
  }
}

RC_GTEST_PROP(StrokePlan, CoversTheSectionWithTheOverlapThatWasAsked, ()) {
  const auto between = [](int low, int high) {
    return static_cast<double>(*rc::gen::inRange(low * 1000, high * 1000)) / 1000.0;
  };
  const double width_mm = between(5, 14);
  const double overlap_mm = between(1, 4);
  const simulator::SectionRegion region =
      ellipse({between(4, 15), between(4, 30)}, between(0, 1) * 0.2);
  const double margin_mm = between(0, 3);
  std::vector<Stroke> strokes = plan_strokes(region, {width_mm, overlap_mm, margin_mm});
  for (const Vec2& point : region.contours[0]) {
    RC_ASSERT(std::any_of(strokes.begin(), strokes.end(), [&](const Stroke& stroke) {
      return std::abs(point.y - stroke.along_mm) <= 0.5 * width_mm + rounding_mm &&
             point.x >= stroke.first_mm && point.x <= stroke.last_mm;
    }));
  }
  std::sort(strokes.begin(), strokes.end(),
            [](const Stroke& a, const Stroke& b) { return a.along_mm < b.along_mm; });
  for (std::size_t i = 1; i < strokes.size(); ++i) {
    const double step_mm = strokes[i].along_mm - strokes[i - 1].along_mm;
    RC_ASSERT(step_mm <= width_mm - overlap_mm + rounding_mm);
    RC_ASSERT(step_mm > 0.0);
  }
  // A blade more than needed would be wasted: one fewer does not reach.
  if (strokes.size() > 1) {
    const double span_mm = region.max_mm.y - region.min_mm.y + 2.0 * margin_mm;
    const double without_one_mm =
        width_mm + static_cast<double>(strokes.size() - 2) * (width_mm - overlap_mm);
    RC_ASSERT(without_one_mm < span_mm + rounding_mm);
  }
}

}  // namespace
}  // namespace hallux::scenarios
