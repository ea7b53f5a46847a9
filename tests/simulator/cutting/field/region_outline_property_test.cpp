/// What must hold for the outline of any field. RapidCheck prints the seed of a failing case;
/// RC_PARAMS="seed=..." repeats it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/cutting/field/region_outline.h"
#include "tests/simulator/cutting/field/random_stamps.h"
#include "tests/support/outline_area.h"

namespace hallux::tests {
namespace {

using namespace simulator;

using Segment = std::array<Vec2, 2>;

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

std::vector<Segment> segments_of(const RegionOutline& outline) {
  std::vector<Segment> segments;
  std::size_t first = 0;
  for (const std::size_t last : outline.loop_ends) {
    for (std::size_t i = first; i < last; ++i) {
      segments.push_back(
          {outline.corners_mm[i], outline.corners_mm[i + 1 == last ? first : i + 1]});
    }
    first = last;
  }
  return segments;
}

KerfField field_of(Random& random, std::size_t stamps) {
  KerfField field(small_grid());
  FieldWindow changed;
  for (std::size_t i = 0; i < stamps; ++i) {
    const RandomStamp stamp = random_stamp(random);
    field.stamp(stamp.blade, stamp.from, stamp.to, changed);
  }
  return field;
}

/// Marching squares cell by cell: area and length of the outline at level 0, nothing straightened.
struct RawOutline {
  double area_mm2 = 0.0, length_mm = 0.0;
};

class RawCell {
 public:
  RawCell(const KerfField& field, std::int32_t u, std::int32_t v) : field_(field), u_(u), v_(v) {}

  RawOutline outline() const {
    std::array<bool, 4> open{};
    for (std::size_t k = 0; k < 4; ++k) open[k] = value(k) > 0.0;
    const bool faces = open[0] == open[2] && open[1] == open[3] && open[0] != open[1];
    if (!faces) return piece({true, true, true, true});
    RawOutline sum;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!open[k]) continue;
      std::array<bool, 4> only{};
      only[k] = true;
      const RawOutline corner = piece(only);
      sum.area_mm2 += corner.area_mm2;
      sum.length_mm += corner.length_mm;
    }
    return sum;
  }

 private:
  Vec2 step(std::size_t k) const { return {k == 1 || k == 2 ? 1.0 : 0.0, k >= 2 ? 1.0 : 0.0}; }
  double value(std::size_t k) const {
    const std::int32_t u = u_ + (k == 1 || k == 2 ? 1 : 0), v = v_ + (k >= 2 ? 1 : 0);
    const FieldGrid& grid = field_.grid();
    if (u < 0 || v < 0 || u >= grid.u_count || v >= grid.v_count) return -grid.spacing_mm;
    return static_cast<double>(field_.at(u, v));
  }
  /// The polygon around the open corners that `counts`.
  RawOutline piece(const std::array<bool, 4>& counts) const {
    std::vector<Vec2> polygon;
    RawOutline result;
    std::size_t left_at = 0;
    bool leaves = false;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t next = (k + 1) % 4;
      const bool here = counts[k] && value(k) > 0.0, there = counts[next] && value(next) > 0.0;
      if (here) polygon.push_back(step(k));
      if (here == there) continue;
      const double part = std::clamp(value(k) / (value(k) - value(next)), 0.001, 0.999);
      const double other = std::clamp(value(next) / (value(next) - value(k)), 0.001, 0.999);
      polygon.push_back(here ? step(k) + part * (step(next) - step(k))
                             : step(next) + other * (step(k) - step(next)));
      if (here) left_at = polygon.size() - 1, leaves = true;
    }
    const double spacing_mm = field_.grid().spacing_mm;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      result.area_mm2 +=
          0.5 * spacing_mm * spacing_mm * cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
    if (leaves) {
      const Vec2 way = polygon[(left_at + 1) % polygon.size()] - polygon[left_at];
      result.length_mm = spacing_mm * glm::length(way);
    }
    return result;
  }

  const KerfField& field_;
  std::int32_t u_, v_;
};

RawOutline raw_outline(const KerfField& field) {
  RawOutline sum;
  for (std::int32_t v = -1; v < field.grid().v_count; ++v) {
    for (std::int32_t u = -1; u < field.grid().u_count; ++u) {
      const RawOutline cell = RawCell(field, u, v).outline();
      sum.area_mm2 += cell.area_mm2;
      sum.length_mm += cell.length_mm;
    }
  }
  return sum;
}

bool meet(const Segment& a, const Segment& b) {
  const auto turns = [](const Segment& s, const Vec2& p) { return cross(s[1] - s[0], p - s[0]); };
  const auto spans_meet = [](double a0, double a1, double b0, double b1) {
    return std::max(std::min(a0, a1), std::min(b0, b1)) <=
           std::min(std::max(a0, a1), std::max(b0, b1));
  };
  return spans_meet(a[0].x, a[1].x, b[0].x, b[1].x) && spans_meet(a[0].y, a[1].y, b[0].y, b[1].y) &&
         turns(a, b[0]) * turns(a, b[1]) <= 0.0 && turns(b, a[0]) * turns(b, a[1]) <= 0.0;
}

RC_GTEST_PROP(RegionOutlineProperty, IsTheSameHoweverItWasReached, (std::uint64_t seed)) {
  Random random(seed);
  KerfField field(small_grid());
  OutlineTracker tracker(small_grid());
  FieldWindow changed;
  for (int i = 0; i < 25; ++i) {
    const RandomStamp stamp = random_stamp(random);
    field.stamp(stamp.blade, stamp.from, stamp.to, changed);
    if (random.uniform() < 0.4) continue;
    tracker.update(field);
    const RegionOutline expected = outline_of(field);
    RC_ASSERT(tracker.outline().loop_ends == expected.loop_ends);
    RC_ASSERT(tracker.outline().corners_mm == expected.corners_mm);
  }
}

RC_GTEST_PROP(RegionOutlineProperty, GoesAroundTheOpenNodesAndNoOther, (std::uint64_t seed)) {
  Random random(seed);
  const KerfField field = field_of(random, 1 + random.bits() % 12);
  const FieldGrid& grid = field.grid();
  const std::vector<Segment> segments = segments_of(outline_of(field));
  for (std::int32_t u = 0; u < grid.u_count; ++u) {
    const double u_mm = grid.origin_mm.x + grid.spacing_mm * u;
    std::vector<double> heights_mm;
    for (const auto& [a, b] : segments) {
      if ((a.x <= u_mm) == (b.x <= u_mm)) continue;
      heights_mm.push_back(a.y + (b.y - a.y) * (u_mm - a.x) / (b.x - a.x));
    }
    std::sort(heights_mm.begin(), heights_mm.end());
    for (std::int32_t v = 0; v < grid.v_count; ++v) {
      const double v_mm = grid.origin_mm.y + grid.spacing_mm * v;
      const auto below = std::lower_bound(heights_mm.begin(), heights_mm.end(), v_mm);
      RC_ASSERT(((below - heights_mm.begin()) % 2 == 1) == (field.at(u, v) > 0.0F));
    }
  }
}

RC_GTEST_PROP(RegionOutlineProperty, HasSimpleLoopsThatDoNotTouch, (std::uint64_t seed)) {
  Random random(seed);
  const RegionOutline outline = outline_of(field_of(random, 1 + random.bits() % 12));
  std::size_t first = 0;
  for (const std::size_t last : outline.loop_ends) {
    RC_ASSERT(last - first >= 3U);
    first = last;
  }
  const std::vector<Segment> segments = segments_of(outline);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t k = i + 1; k < segments.size(); ++k) {
      const bool are_neighbours =
          segments[i][1] == segments[k][0] || segments[k][1] == segments[i][0];
      RC_ASSERT(are_neighbours || !meet(segments[i], segments[k]));
    }
  }
}

RC_GTEST_PROP(RegionOutlineProperty, NeverHoldsMoreThanTheFieldAndLosesOnlyTheSlack,
              (std::uint64_t seed)) {
  Random random(seed);
  const KerfField field = field_of(random, 1 + random.bits() % 12);
  const RawOutline raw = raw_outline(field);
  const double area = area_mm2(outline_of(field));
  RC_ASSERT(area <= raw.area_mm2 + 1e-12);
  RC_ASSERT(area >= raw.area_mm2 - outline_slack_mm * raw.length_mm - 1e-12);
}

RC_GTEST_PROP(RegionOutlineProperty, GrowsWithTheFieldButForTheSlack, (std::uint64_t seed)) {
  Random random(seed);
  KerfField field(small_grid());
  FieldWindow changed;
  double before_mm2 = 0.0;
  for (int i = 0; i < 12; ++i) {
    const RandomStamp stamp = random_stamp(random);
    field.stamp(stamp.blade, stamp.from, stamp.to, changed);
    const double after_mm2 = area_mm2(outline_of(field));
    RC_ASSERT(after_mm2 >= before_mm2 - outline_slack_mm * raw_outline(field).length_mm - 1e-12);
    before_mm2 = after_mm2;
  }
}

}  // namespace
}  // namespace hallux::tests
