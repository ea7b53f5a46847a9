#include "simulator/cutting/field/kerf_set.h"

#include <gtest/gtest.h>

#include <vector>

namespace hallux::simulator {
namespace {

constexpr Blade blade{.width_mm = 8.0, .depth_mm = 20.0, .kerf_mm = 0.5};

RigidTransform shifted(const Vec3& by_mm) { return {Quat{1.0, 0.0, 0.0, 0.0}, by_mm}; }

CutEvent event_of(CutEventKind kind, std::int32_t subject, std::int64_t value = 0,
                  const RigidTransform& pose = {}) {
  return {0, kind, subject, value, quantise(pose)};
}

/// The saw on, its blade at a place of the world and in a kerf; -1: in none.
ToolSample sample_at(std::int32_t kerf, const Vec3& place_mm) {
  ToolSample sample;
  sample.status = bit(ToolStatus::SawOn);
  sample.kerf = kerf;
  sample.world_from_tool = quantise(shifted(place_mm));
  return sample;
}

std::vector<std::int32_t> kerfs_in(const KerfNumbers& numbers) {
  std::vector<std::int32_t> kerfs;
  for (const std::int32_t kerf : numbers) kerfs.push_back(kerf);
  return kerfs;
}

TEST(KerfNumbers, AreVisitedAscending) {
  KerfNumbers numbers;
  EXPECT_TRUE(numbers.is_empty());
  for (const std::int32_t kerf : {7, 0, 15}) numbers.add(kerf);
  EXPECT_EQ(kerfs_in(numbers), (std::vector<std::int32_t>{0, 7, 15}));
  EXPECT_EQ(numbers.count(), 3);
  EXPECT_EQ(kerfs_in(KerfNumbers::first(3)), (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_EQ(KerfNumbers::first(kerf_limit).count(), kerf_limit);
}

/// One bone of which piece 1 was parted and lies five millimetres aside.
class TwoFragments : public testing::Test {
 protected:
  TwoFragments() {
    kerfs_.apply(event_of(CutEventKind::FragmentParted, 1, 0));
    kerfs_.apply(event_of(CutEventKind::Released, 1, 0, shifted(aside_mm_)));
  }

  Vec3 aside_mm_{0.0, 0.0, 5.0};
  KerfSet kerfs_{blade, RigidTransform{}};
};

TEST_F(TwoFragments, AKerfOpensInTheFrameOfItsFragment) {
  ASSERT_TRUE(kerfs_.apply(event_of(CutEventKind::PlaneFrozen, 0, 1)));
  ASSERT_EQ(kerfs_.apply(sample_at(0, {1.0, 0.0, 5.0})).size(), 1U);
  EXPECT_TRUE(kerfs_.is_open(kerfs_.kerfs_of(1), {0.0, 0.0, 0.0}));
  EXPECT_FALSE(kerfs_.is_open(kerfs_.kerfs_of(1), {0.0, 0.0, 5.0}));
  EXPECT_TRUE(kerfs_.kerfs_of(0).is_empty());
  EXPECT_FALSE(kerfs_.is_open(kerfs_.kerfs_of(0), {0.0, 0.0, 0.0}));
}

TEST_F(TwoFragments, APlaneFrozenInTheMidstOfACutIsOneWithIt) {
  kerfs_.apply(event_of(CutEventKind::PlaneFrozen, 0, 0, shifted(aside_mm_)));
  kerfs_.apply(sample_at(0, {0.0, 0.0, 5.0}));
  ASSERT_TRUE(kerfs_.apply(event_of(CutEventKind::PlaneFrozen, 1, 1)));
  const auto risen = kerfs_.apply(sample_at(0, {2.0, 0.0, 5.0}));
  ASSERT_EQ(risen.size(), 2U);
  EXPECT_EQ(risen[0].kerf, 0) << "that of the sample first";
  EXPECT_EQ(risen[1].kerf, 1);
  EXPECT_TRUE(kerfs_.is_open(kerfs_.kerfs_of(0), {1.5, 0.0, 5.0}));
  EXPECT_TRUE(kerfs_.is_open(kerfs_.kerfs_of(1), {1.5, 0.0, 0.0}));
  kerfs_.apply(sample_at(-1, {-30.0, 0.0, 5.0}));
  EXPECT_EQ(kerfs_.apply(sample_at(1, {4.0, 0.0, 5.0})).size(), 2U) << "in whichever it stands";
}

TEST_F(TwoFragments, AFragmentThatMovesEndsWhatWasOneCut) {
  kerfs_.apply(event_of(CutEventKind::PlaneFrozen, 0, 0, shifted(aside_mm_)));
  kerfs_.apply(sample_at(0, {0.0, 0.0, 5.0}));
  kerfs_.apply(event_of(CutEventKind::PlaneFrozen, 1, 1));
  kerfs_.apply(sample_at(-1, {-30.0, 0.0, 5.0}));
  EXPECT_EQ(kerfs_in(kerfs_.one_cut_with(0)), (std::vector<std::int32_t>{0, 1}));
  kerfs_.apply(event_of(CutEventKind::Released, 1, 0, shifted({0.0, 0.0, 6.0})));
  EXPECT_EQ(kerfs_in(kerfs_.one_cut_with(0)), (std::vector<std::int32_t>{0}));
  EXPECT_EQ(kerfs_.apply(sample_at(0, {6.0, 0.0, 5.0})).size(), 1U);
}

TEST_F(TwoFragments, APlaneFrozenAfterTheBladeLeftIsACutOfItsOwn) {
  kerfs_.apply(event_of(CutEventKind::PlaneFrozen, 0, 0, shifted(aside_mm_)));
  kerfs_.apply(sample_at(0, {0.0, 0.0, 5.0}));
  kerfs_.apply(sample_at(-1, {-30.0, 0.0, 5.0}));
  kerfs_.apply(event_of(CutEventKind::PlaneFrozen, 1, 1));
  EXPECT_EQ(kerfs_.one_cut_with(1).count(), 1);
}

TEST(KerfSet, AFragmentThatPartsLeavesSolidsWithoutKerfs) {
  KerfSet kerfs(blade, RigidTransform{});
  kerfs.apply(event_of(CutEventKind::PlaneFrozen, 0, 0));
  kerfs.apply(sample_at(0, {0.0, 0.0, 0.0}));
  kerfs.apply(sample_at(-1, {-30.0, 0.0, 0.0}));
  kerfs.apply(event_of(CutEventKind::FragmentParted, 1, 0));
  EXPECT_TRUE(kerfs.kerfs_of(0).is_empty());
  kerfs.apply(event_of(CutEventKind::HingeClosed, 0, 0, shifted({0.1, 0.0, 0.0})));
  EXPECT_TRUE(kerfs.fragments()[1].is_moved);
  ASSERT_TRUE(kerfs.apply(event_of(CutEventKind::PlaneFrozen, 1, 1)));
  EXPECT_EQ(kerfs_in(kerfs.kerfs_of(1)), (std::vector<std::int32_t>{1}));
}

TEST(KerfSet, RefusesEventsThatNoAttemptGives) {
  KerfSet kerfs(blade, RigidTransform{});
  EXPECT_FALSE(kerfs.apply(event_of(CutEventKind::PlaneFrozen, 1))) << "not the next";
  EXPECT_FALSE(kerfs.apply(event_of(CutEventKind::PlaneFrozen, 0, 1))) << "no such fragment";
  EXPECT_FALSE(kerfs.apply(event_of(CutEventKind::PlaneFrozen, 0, -1)));
  for (std::int32_t kerf = 0; kerf < kerf_limit; ++kerf) {
    EXPECT_TRUE(kerfs.apply(event_of(CutEventKind::PlaneFrozen, kerf)));
  }
  EXPECT_FALSE(kerfs.apply(event_of(CutEventKind::PlaneFrozen, kerf_limit)));
  EXPECT_EQ(kerfs.count(), kerf_limit);
}

}  // namespace
}  // namespace hallux::simulator
