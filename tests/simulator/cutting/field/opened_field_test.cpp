#include "simulator/cutting/field/opened_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/simulator/cutting/field/random_stamps.h"

namespace hallux::simulator {
namespace {

constexpr std::int64_t tick_count = 40;

/// A field as forty random stamps leave it, with what it was after each.
struct StampedField {
  explicit StampedField(std::uint64_t seed) : field(tests::small_grid()) {
    Random random(seed, "opened field");
    OpeningNotes notes(tests::small_grid());
    for (std::int64_t tick = 0; tick < tick_count; ++tick) {
      const tests::RandomStamp stamp = tests::random_stamp(random);
      FieldWindow changed;
      field.stamp(stamp.blade, stamp.from, stamp.to, changed);
      notes.note(field, changed, tick);
      after.push_back(field);
    }
    opened = notes.finish({}, field);
  }

  KerfField field;
  std::vector<KerfField> after;
  OpenedField opened;
};

bool is_open(const KerfField& field, std::int32_t u, std::int32_t v) {
  return field.at(u, v) > 0.0F;
}

int nodes_that_differ(const KerfField& a, const KerfField& b) {
  int count = 0;
  for (std::int32_t u = 0; u < a.grid().u_count; ++u) {
    for (std::int32_t v = 0; v < a.grid().v_count; ++v) count += a.at(u, v) == b.at(u, v) ? 0 : 1;
  }
  return count;
}

TEST(OpenedField, OpensAfterEachTickTheNodesThatWereOpenThen) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const StampedField stamped(seed);
    OpenedMoment moment(stamped.opened);
    for (const std::int64_t tick : {0, 3, 17, 38, 5, 39}) {
      moment.move_to(tick);
      const KerfField& then = stamped.after[static_cast<std::size_t>(tick)];
      int wrong = 0;
      for (std::int32_t u = 0; u < then.grid().u_count; ++u) {
        for (std::int32_t v = 0; v < then.grid().v_count; ++v)
          wrong += is_open(then, u, v) == is_open(moment.field(), u, v) ? 0 : 1;
      }
      EXPECT_EQ(wrong, 0) << "seed " << seed << ", tick " << tick;
    }
  }
}

TEST(OpenedField, IsTheFieldItselfAtLast) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const StampedField stamped(seed);
    OpenedMoment moment(stamped.opened);
    moment.move_to(7);
    moment.move_to(tick_count);
    EXPECT_EQ(nodes_that_differ(moment.field(), stamped.field), 0);
    const RegionOutline outline = outline_of(stamped.field);
    EXPECT_EQ(moment.outline().corners_mm, outline.corners_mm);
    EXPECT_EQ(moment.outline().loop_ends, outline.loop_ends);
  }
}

TEST(OpenedField, LiesHalfASpacingFromTheOutlineOfThenAtMost) {
  const StampedField stamped(3);
  for (const std::int64_t tick : {4, 11, 25}) {
    const RegionOutline then = outline_of(stamped.after[static_cast<std::size_t>(tick)]);
    double length_mm = 0.0;
    std::uint32_t first = 0;
    for (const std::uint32_t end : then.loop_ends) {
      for (std::uint32_t i = first; i < end; ++i) {
        const Vec2 way = then.corners_mm[i + 1 == end ? first : i + 1] - then.corners_mm[i];
        length_mm += std::hypot(way.x, way.y);
      }
      first = end;
    }
    EXPECT_NEAR(area_mm2(outline_at(stamped.opened, tick)), area_mm2(then),
                0.5 * tests::small_grid().spacing_mm * length_mm);
  }
}

TEST(OpenedField, BeforeTheFirstTickNothingIsOpen) {
  const StampedField stamped(1);
  EXPECT_TRUE(outline_at(stamped.opened, -1).loop_ends.empty());
  const OpenedField nothing =
      OpeningNotes(tests::small_grid()).finish({}, KerfField(tests::small_grid()));
  EXPECT_TRUE(nothing.ticks().empty());
  EXPECT_TRUE(outline_at(nothing, tick_count).loop_ends.empty());
}

TEST(OpenedField, NamesItsTicksOnceAndAscending) {
  const std::vector<std::int32_t> ticks = StampedField(2).opened.ticks();
  ASSERT_GT(ticks.size(), 5U);
  for (std::size_t i = 1; i < ticks.size(); ++i) EXPECT_LT(ticks[i - 1], ticks[i]);
}

TEST(KerfFieldPut, IsStampedOnAsIfStampsHadMadeIt) {
  const StampedField stamped(5);
  KerfField put(tests::small_grid());
  // What stood there before, and what it covered, is forgotten.
  Random before(9, "before");
  for (int i = 0; i < 10; ++i) {
    const tests::RandomStamp stamp = tests::random_stamp(before);
    FieldWindow changed;
    put.stamp(stamp.blade, stamp.from, stamp.to, changed);
  }
  const FieldGrid grid = tests::small_grid();
  std::vector<float> values;
  for (std::int32_t u = 0; u < grid.u_count; ++u) {
    for (std::int32_t v = 0; v < grid.v_count; ++v) values.push_back(stamped.field.at(u, v));
  }
  put.put({0, 0, grid.u_count, grid.v_count}, values);
  KerfField further = stamped.field;
  Random after(11, "after");
  for (int i = 0; i < 20; ++i) {
    const tests::RandomStamp stamp = tests::random_stamp(after);
    FieldWindow changed;
    put.stamp(stamp.blade, stamp.from, stamp.to, changed);
    further.stamp(stamp.blade, stamp.from, stamp.to, changed);
    ASSERT_EQ(nodes_that_differ(put, further), 0);
  }
  EXPECT_EQ(outline_of(put).corners_mm, outline_of(further).corners_mm);
}

TEST(KerfFieldPut, LimitsWhatNoFieldHolds) {
  KerfField field(tests::small_grid());
  const std::vector<float> values{std::numeric_limits<float>::quiet_NaN(), 1.0e30F,
                                  -std::numeric_limits<float>::infinity(), 0.01F};
  field.put({2, 3, 4, 5}, values);
  const auto limit = static_cast<float>(tests::small_grid().spacing_mm);
  EXPECT_EQ(field.at(2, 3), -limit);
  EXPECT_EQ(field.at(2, 4), limit);
  EXPECT_EQ(field.at(3, 3), -limit);
  EXPECT_EQ(field.at(3, 4), 0.01F);
}

}  // namespace
}  // namespace hallux::simulator
