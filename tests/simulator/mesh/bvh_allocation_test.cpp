#include <gtest/gtest.h>

#include "simulator/base/random.h"
#include "simulator/mesh/bvh.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

TEST(BvhAllocation, QueriesTakeNothingFromTheHeap) {
  const Bvh bvh{tests::sphere(10.0, 10)};
  Random random{1};
  double sum = 0.0;
  const std::uint64_t before = tests::allocations_of_this_thread();
  for (int i = 0; i < 1000; ++i) {
    const Vec3 point{random.uniform(-12.0, 12.0), random.uniform(-12.0, 12.0), 1.0};
    sum += bvh.nearest(point)->distance_mm + bvh.signed_distance_mm(point, 1.0);
    sum += bvh.contains(point) ? 1.0 : 0.0;
    sum += bvh.first_hit(point, Vec3{0.0, 0.0, 1.0}).has_value() ? 1.0 : 0.0;
  }
  EXPECT_EQ(tests::allocations_of_this_thread(), before);
  EXPECT_NE(sum, 0.0);
}

TEST(BvhAllocation, TheCounterSeesWhatIsTaken) {
  const std::uint64_t before = tests::allocations_of_this_thread();
  const Bvh bvh{tests::sphere(10.0, 2)};
  EXPECT_GT(tests::allocations_of_this_thread(), before);
}

}  // namespace
}  // namespace hallux::simulator
