/// A tick of a bore takes nothing from the heap and gives nothing back.
#include <gtest/gtest.h>

#include "tests/simulator/contact/bore/bore_world.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

TEST(BoreTick, TakesNoMemory) {
  BoreWorld world(cortical_bone(solid_block({40.0, 6.0, 30.0})), bore_tool(WireDriver{}));
  world.bores.reserve(8);
  world.holes.reserve(8);
  world.metal.push_back({{-30.0, -20.0, 0.0}, {30.0, -20.0, 0.0}, 0.8});
  const Vec3 down{0.0, -1.0, 0.0};
  world.state.wound_from_tool = pointing({0.0, 6.0, 0.0}, down);
  const std::uint64_t taken = allocations_of_this_thread(), given = frees_of_this_thread();
  bool broke_through = false;
  for (const double x_mm : {0.0, 4.0}) {
    world.glide(pointing({x_mm, 5.0, 0.0}, down), true, 500);
    world.glide(pointing({x_mm, 2.9, 0.0}, down), true, 100);
    for (int i = 0; i < 4500; ++i)
      broke_through = world.push(10.0, true).broke_through || broke_through;
    world.glide(pointing({x_mm, 6.0, 0.0}, down), false, 500);
  }
  EXPECT_EQ(allocations_of_this_thread(), taken);
  EXPECT_EQ(frees_of_this_thread(), given);
  EXPECT_TRUE(broke_through);
  EXPECT_EQ(world.bores.size(), 2U);
}

}  // namespace
}  // namespace hallux::tests
