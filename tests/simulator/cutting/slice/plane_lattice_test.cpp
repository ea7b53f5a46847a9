#include "simulator/cutting/slice/plane_lattice.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "simulator/base/random.h"

namespace hallux::tests {
namespace {

using namespace simulator;

using Corners = std::vector<LatticePoint>;

/// Few places, so that nearly everything coincides.
Corners random_loop(Random& random, std::size_t count) {
  Corners corners;
  for (std::size_t i = 0; i < count; ++i) {
    const auto ordinate = [&] { return static_cast<std::int64_t>(random.bits() % 5) - 2; };
    const LatticePoint corner{ordinate(), ordinate()};
    if (corners.empty() || !(corners.back() == corner)) corners.push_back(corner);
  }
  while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
  return corners;
}

int winding_of_region(const Corners& region, const LatticePoint& bone) {
  int winding = 0;
  for (std::size_t i = 0; i < region.size(); ++i) {
    winding += winding_of_region_edge(region[i], region[(i + 1) % region.size()], bone);
  }
  return winding;
}

int winding_of_bone(const Corners& bone, const LatticePoint& corner) {
  int winding = 0;
  for (std::size_t i = 0; i < bone.size(); ++i) {
    winding += winding_of_bone_edge(bone[i], bone[(i + 1) % bone.size()], corner);
  }
  return winding;
}

/// +1: the bone's edge from a to b goes to the left of the region's edge from r to s; -1: to its
/// right; 0: no crossing.
int crossing(const LatticePoint& a, const LatticePoint& b, const LatticePoint& r,
             const LatticePoint& s) {
  if (side_of_corner(a, b, r) == side_of_corner(a, b, s)) return 0;
  const int side_of_a = side_of_bone(r, s, a);
  return side_of_a == side_of_bone(r, s, b) ? 0 : -side_of_a;
}

TEST(PlaneLattice, StepsAre2ToTheMinus20WithinReachAndDoubleBeyond) {
  const PlaneLattice fine(Vec2(-63.0), Vec2(63.0));
  EXPECT_EQ(fine.snap(Vec2(1.0, -0.5)), (LatticePoint{1 << 20, -(1 << 19)}));
  EXPECT_EQ(fine.snap_height(0.25), 1 << 18);
  const PlaneLattice coarse(Vec2(-100.0), Vec2(100.0));
  EXPECT_EQ(coarse.snap(Vec2(1.0, -0.5)), (LatticePoint{1 << 19, -(1 << 18)}));
  for (const double reach_mm : {1.0, 63.0, 65.0, 1000.0, 3e4}) {
    const LatticePoint corner =
        PlaneLattice(Vec2(-reach_mm), Vec2(reach_mm)).snap(Vec2(reach_mm, -reach_mm));
    EXPECT_LE(corner.u, 1 << 26);
    EXPECT_GE(corner.v, -(1 << 26));
  }
}

TEST(PlaneLattice, SnapsToTheNearestStepAndUpwardFromTheMiddleBetweenTwo) {
  const PlaneLattice lattice(Vec2(-63.0), Vec2(63.0));
  const double step_mm = 1.0 / (1 << 20);
  const std::vector<std::pair<double, std::int64_t>> steps{{-1.6, -2}, {-1.5, -1}, {-1.4, -1},
                                                           {-0.6, -1}, {-0.5, 0},  {0.0, 0},
                                                           {0.4, 0},   {0.5, 1},   {1.5, 2}};
  for (const auto& [asked, expected] : steps) {
    EXPECT_EQ(lattice.snap_height(asked * step_mm), expected) << asked;
  }
}

TEST(PlaneLattice, TellsTheSideAtTheEndsOfItsReachByOneStep) {
  const std::int64_t far = 1 << 26;
  const LatticePoint a{-far, -far}, b{far, far};
  EXPECT_EQ(turn(a, b, {0, 0}), 0);
  EXPECT_EQ(turn(a, b, {far - 1, far}), 2 * far);
  EXPECT_EQ(turn(a, b, {far, far - 1}), -2 * far);
  EXPECT_EQ(turn({-far, far}, {far, -far}, {far, far}), 4 * far * far);
}

// The shift made real: coordinates ten thousandfold, the region moved by (100, 1) of those steps.
TEST(PlaneLattice, AnswersAreThoseOfARegionShiftedByALittle) {
  const auto scaled = [](const LatticePoint& point, std::int64_t du, std::int64_t dv) {
    return LatticePoint{10'000 * point.u + du, 10'000 * point.v + dv};
  };
  Random random(3);
  for (int i = 0; i < 20'000; ++i) {
    const Corners at = random_loop(random, 5);
    if (at.size() < 3) continue;
    const auto bone = [&](std::size_t k) { return scaled(at[k], 0, 0); };
    const auto region = [&](std::size_t k) { return scaled(at[k], 100, 1); };
    ASSERT_EQ(side_of_corner(at[0], at[1], at[2]), sign_of(turn(bone(0), bone(1), region(2))));
    ASSERT_EQ(side_of_bone(at[0], at[1], at[2]), sign_of(turn(region(0), region(1), bone(2))));
    ASSERT_NE(side_of_corner(at[0], at[1], at[0]), 0);
    // Far from every tie the shifted windings can be asked with the unshifted predicates.
    ASSERT_EQ(winding_of_region_edge(at[0], at[1], at[2]),
              winding_of_region_edge(region(0), region(1), bone(2)));
    ASSERT_EQ(winding_of_bone_edge(at[0], at[1], at[2]),
              winding_of_bone_edge(bone(0), bone(1), region(2)));
  }
}

TEST(PlaneLattice, CrossingsAlwaysMakeUpForTheDifferenceOfWindings) {
  Random random(5);
  for (int i = 0; i < 4'000; ++i) {
    const Corners bone = random_loop(random, 3 + random.bits() % 4);
    const Corners region = random_loop(random, 3 + random.bits() % 6);
    if (bone.size() < 2 || region.size() < 2) continue;
    for (std::size_t k = 0; k < bone.size(); ++k) {
      const LatticePoint &a = bone[k], &b = bone[(k + 1) % bone.size()];
      int entered = 0;
      for (std::size_t m = 0; m < region.size(); ++m) {
        entered += crossing(a, b, region[m], region[(m + 1) % region.size()]);
      }
      ASSERT_EQ(winding_of_region(region, b) - winding_of_region(region, a), entered);
    }
    for (std::size_t m = 0; m < region.size(); ++m) {
      const LatticePoint &r = region[m], &s = region[(m + 1) % region.size()];
      int entered = 0;
      for (std::size_t k = 0; k < bone.size(); ++k) {
        entered -= crossing(bone[k], bone[(k + 1) % bone.size()], r, s);
      }
      ASSERT_EQ(winding_of_bone(bone, s) - winding_of_bone(bone, r), entered);
    }
  }
}

}  // namespace
}  // namespace hallux::tests
