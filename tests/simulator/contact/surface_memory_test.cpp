#include "simulator/contact/surface_memory.h"

#include <gtest/gtest.h>

#include <limits>

#include "simulator/base/random.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

constexpr double any_mm = std::numeric_limits<double>::infinity();

void expect_same(const std::optional<NearestPoint>& found,
                 const std::optional<NearestPoint>& fresh) {
  ASSERT_EQ(found.has_value(), fresh.has_value());
  if (!found) return;
  EXPECT_EQ(found->distance_mm, fresh->distance_mm);
  EXPECT_EQ(found->triangle, fresh->triangle);
  EXPECT_EQ(found->point_mm, fresh->point_mm);
  EXPECT_EQ(found->is_inside, fresh->is_inside);
}

class AWalk : public testing::Test {
 protected:
  Vec3 step_mm(double most_mm) {
    return {random_.uniform(-most_mm, most_mm), random_.uniform(-most_mm, most_mm),
            random_.uniform(-most_mm, most_mm)};
  }

  Bvh surface_{tests::hollow_tube({.segments = 24, .rings = 6})};
  Random random_{5};
};

TEST_F(AWalk, FindsWhatAFreshSearchFinds) {
  SurfaceMemory memory;
  Vec3 point_mm{1.0, 2.0, 3.0};
  for (int i = 0; i < 2000; ++i) {
    // Now and then far away, beyond what was remembered.
    point_mm = i % 50 == 0 ? step_mm(30.0) : point_mm + step_mm(0.4);
    const auto fresh = surface_.nearest(point_mm);
    expect_same(nearest_by_memory(surface_, point_mm, any_mm, memory), fresh);
    expect_same(nearest_by_memory(surface_, point_mm, 0.7, memory),
                surface_.nearest(point_mm, 0.7));
    ASSERT_TRUE(fresh);
    memory = {point_mm, clearance_by_memory(surface_, point_mm, memory), true};
    ASSERT_EQ(memory.clearance_mm, surface_.signed_distance_mm(point_mm));
  }
}

TEST_F(AWalk, FindsItAlsoWhereLessThanTheDistanceIsRemembered) {
  const Vec3 asked_mm{0.0, 0.0, 60.0};
  const double distance_mm = surface_.signed_distance_mm(asked_mm);
  for (const double share : {0.0, 0.3, 0.9}) {
    const SurfaceMemory memory{asked_mm, share * distance_mm, true};
    EXPECT_EQ(clearance_by_memory(surface_, asked_mm, memory), distance_mm) << share;
  }
}

TEST_F(AWalk, OfAnEmptySurfaceFindsNothing) {
  const Bvh nothing{IndexedMesh{}};
  const SurfaceMemory memory{Vec3{0.0, 0.0, 0.0}, 1.0, true};
  EXPECT_FALSE(nearest_by_memory(nothing, Vec3{0.0, 0.0, 0.0}, any_mm, memory));
  EXPECT_EQ(clearance_by_memory(nothing, Vec3{0.0, 0.0, 0.0}, memory), any_mm);
}

}  // namespace
}  // namespace hallux::simulator
