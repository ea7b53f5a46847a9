#include "simulator/record/fragment_poses.h"

#include <gtest/gtest.h>

#include <array>

#include "simulator/base/units.h"

namespace hallux::simulator {
namespace {

CutEvent event_of(CutEventKind kind, std::int32_t subject, std::int64_t value = 0,
                  const RigidTransform& pose = {}) {
  return {0, kind, subject, value, quantise(pose)};
}

RigidTransform shifted(const Vec3& by_mm) { return {Quat{1.0, 0.0, 0.0, 0.0}, by_mm}; }

TEST(FragmentPoses, ABoneIsAFragmentWhereThePatientHasIt) {
  const std::array<RigidTransform, 2> bones{shifted({1.0, 2.0, 3.0}), shifted({50.0, 0.0, 0.0})};
  const FragmentPoses poses{std::span<const RigidTransform>(bones)};
  ASSERT_EQ(poses.count(), 2);
  EXPECT_EQ(poses[1].bone, 1);
  EXPECT_EQ(poses[1].parent, -1);
  EXPECT_EQ(poses[1].world_from_fragment, bones[1]);
  EXPECT_FALSE(poses[1].is_moved);
}

TEST(FragmentPoses, APartedPieceLiesWhereItWasUntilItIsReleasedElsewhere) {
  FragmentPoses poses(shifted({10.0, 0.0, 0.0}));
  ASSERT_TRUE(poses.apply(event_of(CutEventKind::FragmentParted, 3, 0)));
  ASSERT_EQ(poses.count(), 2);
  EXPECT_EQ(poses[1].parent, 0);
  EXPECT_EQ(poses[1].world_from_fragment, poses[0].world_from_fragment);
  ASSERT_TRUE(poses.apply(event_of(CutEventKind::Gripped, 1)));
  EXPECT_FALSE(poses[1].is_moved) << "a grip moves nothing";
  ASSERT_TRUE(poses.apply(event_of(CutEventKind::Released, 1, 0, shifted({0.0, 0.0, 5.0}))));
  EXPECT_TRUE(poses[1].is_moved);
  const Vec3 place = transform_point(poses[1].world_from_fragment, Vec3(1.0, 1.0, 1.0));
  EXPECT_NEAR(place.x, 11.0, 1e-12);
  EXPECT_NEAR(place.z, 6.0, 1e-12);
  const Vec3 back = transform_point(poses[1].fragment_from_world, place);
  EXPECT_NEAR(length_of(back - Vec3(1.0, 1.0, 1.0)), 0.0, 1e-12);
}

TEST(FragmentPoses, AClosedHingePlacesTheHalfThatWasParted) {
  FragmentPoses poses(RigidTransform{});
  const RigidTransform turned{rotation_about(Vec3(0.0, 1.0, 0.0), radian_from_degree(10.0)),
                              Vec3(0.0, 0.0, 1.0)};
  ASSERT_TRUE(poses.apply(event_of(CutEventKind::HingeClosed, -1, 0, turned)));
  EXPECT_EQ(poses.count(), 1) << "up to engine 7 no half was a fragment";
  EXPECT_FALSE(poses[0].is_moved);
  ASSERT_TRUE(poses.apply(event_of(CutEventKind::FragmentParted, 1, 0)));
  ASSERT_TRUE(poses.apply(event_of(CutEventKind::HingeClosed, 0, 0, turned)));
  EXPECT_EQ(poses[1].bone_from_fragment, transform_from(quantise(turned)));
}

TEST(FragmentPoses, RefusesWhatTheAttemptCannotHave) {
  FragmentPoses poses(RigidTransform{});
  EXPECT_FALSE(poses.apply(event_of(CutEventKind::FragmentParted, 1, 1)));
  EXPECT_FALSE(poses.apply(event_of(CutEventKind::FragmentParted, 1, -1)));
  EXPECT_FALSE(poses.apply(event_of(CutEventKind::Released, 1)));
  for (std::int32_t piece = 1; piece <= moved_fragment_limit; ++piece) {
    EXPECT_TRUE(poses.apply(event_of(CutEventKind::FragmentParted, piece, 0)));
  }
  EXPECT_TRUE(poses.is_full());
  EXPECT_FALSE(poses.apply(event_of(CutEventKind::FragmentParted, 99, 0)));
  EXPECT_EQ(poses.count(), 1 + moved_fragment_limit);
}

}  // namespace
}  // namespace hallux::simulator
