#include "simulator/bone/close_wedge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/units.h"
#include "simulator/bone/blade_sweep.h"
#include "simulator/mesh/mesh_error.h"
#include "simulator/mesh/read_mesh.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

constexpr double half_degree = 5.0;
constexpr double half_kerf_mm = 0.25;
/// Corners of walls lie where shares on a lattice of 2^-20 mm put them; the walls of two kerfs
/// measure some 12 mm2.
constexpr double balance_mm3 = 2.0e-5;

/// A block of 30 x 14 x 12 mm with two kerfs whose planes meet in the line x = 0, y = 6, at 10
/// degrees.
class WedgedBlock : public testing::Test {
 protected:
  /// A blade goes straight to `tip_mm`; without it the cut goes all the way through.
  void saw(const Vec3& normal, double offset, const std::optional<SweepPose>& tip = {}) {
    const KerfPlane plane = bone_.plane_of(normal, offset, 2.0 * half_kerf_mm);
    ASSERT_TRUE(bone_.begin(plane, tip.has_value()).can_open);
    if (!tip) {
      bone_.commit(bone_.open_all());
      return;
    }
    const SweepPose start{tip->tip_in_mesh_mm - 20.0 * tip->direction, tip->direction};
    const BladePath path = path_in_plane({13.0, 40.0, {start, *tip}}, bone_.begun().plane);
    stamp_motion(bone_.field(), path.blade, path.poses[0], path.poses[1]);
    bone_.commit(outline_of(bone_.field()));
  }
  /// side -1: on the side of negative x. The teeth stop at `tip_y_mm`; without it the cut goes all
  /// the way through.
  void saw_side(int side, std::optional<double> tip_y_mm) {
    const double tilt_rad = side * radian_from_degree(half_degree);
    const Vec3 normal(std::cos(tilt_rad), std::sin(tilt_rad), 0.0);
    const Vec3 direction(-normal.y, normal.x, 0.0);
    std::optional<SweepPose> tip;
    if (tip_y_mm) {
      tip = {Vec3(0.0, 6.0, 0.0) + (*tip_y_mm - 6.0) / direction.y * direction, direction};
    }
    saw(normal, 6.0 * normal.y, tip);
  }
  WedgeClosure close(std::optional<double> tip_y_mm) {
    saw_side(-1, tip_y_mm);
    saw_side(1, tip_y_mm);
    bodies_ = split_pieces(bone_.solid());
    return close_wedge(bone_, bone_.kerf(0), bone_.kerf(1), bodies_);
  }
  double volume_mm3(std::size_t body) const { return signed_volume_mm3(bodies_[body].mesh); }

  SawnBone bone_{tests::solid_block(Vec3(30.0, 14.0, 12.0))};
  std::vector<CutSolid> bodies_;
};

/// Where the outer walls leave the block they stand 10 degrees and both half kerfs apart, seen from
/// the joint: there they touch first.
TEST_F(WedgedBlock, TurnsUntilTheOuterWallsTouch) {
  const WedgeClosure closure = close(6.0);
  ASSERT_EQ(closure.outcome, HingeOutcome::Closed);
  EXPECT_NEAR(closure.thickness_mm, 1.0, 2.0e-3);
  const double half_rad = radian_from_degree(half_degree);
  const double along_mm = (13.0 + half_kerf_mm * std::sin(half_rad)) / std::cos(half_rad);
  const double expected_rad = 2.0 * (half_rad + std::atan(half_kerf_mm / along_mm));
  EXPECT_NEAR(closure.angle_rad, expected_rad, 1.0e-4);
}

TEST_F(WedgedBlock, IsDividedIntoTwoHalvesThatTouchAndLoseNothing) {
  const double uncut_mm3 = signed_volume_mm3(bone_.whole().mesh);
  const WedgeClosure closure = close(6.0);
  ASSERT_EQ(bodies_.size(), 3U);
  double sum_mm3 = bone_.removed_mm3();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    EXPECT_NO_THROW(check_closed_solid(bodies_[i].mesh, "a body"));
    sum_mm3 += volume_mm3(i);
  }
  EXPECT_NEAR(sum_mm3, uncut_mm3, balance_mm3);
  EXPECT_NE(closure.fixed, closure.moved);
  // The half on the side of positive x has turned towards the other.
  double moved_max_x_mm = 0.0, fixed_min_x_mm = 0.0, moved_max_y_mm = 0.0;
  for (const Vec3& point_mm : bodies_[closure.moved].mesh.points_mm) {
    moved_max_x_mm = std::max(moved_max_x_mm, point_mm.x);
    moved_max_y_mm = std::max(moved_max_y_mm, point_mm.y);
  }
  for (const Vec3& point_mm : bodies_[closure.fixed].mesh.points_mm) {
    fixed_min_x_mm = std::min(fixed_min_x_mm, point_mm.x);
  }
  EXPECT_NEAR(fixed_min_x_mm, -15.0, 1.0e-12);
  const double angle_rad = closure.angle_rad;
  const Vec2 far_corner(15.0, 1.0), near_corner(15.0, -13.0);  // from the joint
  EXPECT_NEAR(moved_max_x_mm,
              far_corner.x * std::cos(angle_rad) + far_corner.y * std::sin(angle_rad), 1.0e-3);
  EXPECT_LT(moved_max_y_mm, 7.0 + 1.0e-3);
  EXPECT_LT(near_corner.x * std::cos(angle_rad) + near_corner.y * std::sin(angle_rad),
            moved_max_x_mm);
}

TEST_F(WedgedBlock, DoesNotBendOverAThickBridge) {
  const WedgeClosure closure = close(4.2);
  EXPECT_EQ(closure.outcome, HingeOutcome::Stiff);
  EXPECT_NEAR(closure.thickness_mm, 2.8, 2.0e-3);
  EXPECT_EQ(bodies_.size(), 2U);
  EXPECT_EQ(closure.fixed, closure.moved);
}

TEST_F(WedgedBlock, BreaksOverAThinBridgeIntoTwoBodiesThatStay) {
  const WedgeClosure closure = close(6.85);
  EXPECT_EQ(closure.outcome, HingeOutcome::Broken);
  EXPECT_NEAR(closure.thickness_mm, 0.15, 2.0e-3);
  EXPECT_NE(closure.fixed, closure.moved);
  double sum_mm3 = bone_.removed_mm3();
  for (std::size_t i = 0; i < bodies_.size(); ++i) sum_mm3 += volume_mm3(i);
  EXPECT_NEAR(sum_mm3, 5040.0, balance_mm3);
}

TEST_F(WedgedBlock, IsBrokenWhereTheCutsGoAllTheWayThrough) {
  const WedgeClosure closure = close(std::nullopt);
  EXPECT_EQ(closure.outcome, HingeOutcome::Broken);
  EXPECT_EQ(closure.thickness_mm, 0.0);
  EXPECT_NE(closure.fixed, closure.moved);
  EXPECT_NE(closure.wedge, closure.fixed);
  EXPECT_NE(closure.wedge, closure.moved);
}

TEST_F(WedgedBlock, HasNothingToCloseWhereTheKerfsDoNotMeet) {
  try {
    close(-2.0);
    FAIL() << "a wedge was found";
  } catch (const MeshError& error) {
    EXPECT_EQ(std::string(error.what()).find("the kerfs leave no wedge"), 0U) << error.what();
  }
}

TEST_F(WedgedBlock, HasNoHingeBetweenParallelPlanes) {
  saw(Vec3(1.0, 0.0, 0.0), 0.0);
  saw(Vec3(1.0, 0.0, 0.0), 3.0);
  bodies_ = split_pieces(bone_.solid());
  EXPECT_THROW(close_wedge(bone_, bone_.kerf(0), bone_.kerf(1), bodies_), MeshError);
}

}  // namespace
}  // namespace hallux::simulator
