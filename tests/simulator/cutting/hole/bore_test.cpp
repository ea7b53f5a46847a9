#include "simulator/cutting/hole/bore.h"

#include <gtest/gtest.h>

namespace hallux::tests {
namespace {

using namespace simulator;

/// The tool bores towards -y.
RigidTransform tool_at(double y_mm) {
  return {rotation_from_axes(Vec3{0.0, -1.0, 0.0}, Vec3{0.0, 0.0, 1.0}), {1.0, y_mm, 2.0}};
}

TEST(Bore, BeginsAtTheSkinAndIsAsDeepAsTheTouch) {
  const Bore bore = begin_bore(tool_at(9.7), 0.3, 0.8);
  EXPECT_NEAR(bore.body_from_bore.translation_mm.y, 10.0, 1e-12);
  EXPECT_EQ(bore.depth_mm, 0.3);
}

TEST(Bore, GrowsWithTheTipAndNeverFalls) {
  Bore bore = begin_bore(tool_at(9.7), 0.3, 0.8);
  open_bore(bore, tool_at(4.0));
  EXPECT_NEAR(bore.depth_mm, 6.0, 1e-12);
  open_bore(bore, tool_at(8.0));
  EXPECT_NEAR(bore.depth_mm, 6.0, 1e-12);
}

TEST(Bore, IsACapsuleFromBeforeTheSkinToTheDeepestTip) {
  Bore bore = begin_bore(tool_at(9.7), 0.3, 0.8);
  open_bore(bore, tool_at(4.0));
  const Capsule hole = capsule_of(bore);
  EXPECT_TRUE(is_in_capsule({&hole, 1}, {1.0, 10.2, 2.7}));
  EXPECT_TRUE(is_in_capsule({&hole, 1}, {1.0, 4.01, 2.0}));
  EXPECT_FALSE(is_in_capsule({&hole, 1}, {1.0, 3.99, 2.0}));
  EXPECT_FALSE(is_in_capsule({&hole, 1}, {1.0, 7.0, 2.81}));
}

TEST(Bore, WidenedHasTheSameAxisAndIsClosed) {
  Bore wire = begin_bore(tool_at(9.7), 0.3, 0.55);
  open_bore(wire, tool_at(4.0));
  const Bore wide = widened(wire, 1.1);
  EXPECT_EQ(wide.body_from_bore, wire.body_from_bore);
  EXPECT_EQ(wide.radius_mm, 1.1);
  EXPECT_EQ(wide.depth_mm, 0.0);
}

}  // namespace
}  // namespace hallux::tests
