#include "simulator/contact/metal.h"

#include <gtest/gtest.h>

#include <array>

namespace hallux::simulator {
namespace {

TEST(Metal, IsMetByTheFirstPointThatLiesInIt) {
  const std::array<Capsule, 2> metal{Capsule{{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, 0.8},
                                     Capsule{{0.0, 9.0, 0.0}, {0.0, 12.0, 0.0}, 0.5}};
  const std::array<Vec3, 3> beside{Vec3{5.0, 0.81, 0.0}, Vec3{0.0, 5.0, 0.0}, Vec3{0.0, 13.0, 0.0}};
  EXPECT_FALSE(meets_metal(beside, metal));
  const std::array<Vec3, 2> in_second{Vec3{5.0, 0.81, 0.0}, Vec3{0.1, 12.3, 0.0}};
  EXPECT_TRUE(meets_metal(in_second, metal));
}

TEST(Metal, IsNotMetWhereThereIsNone) {
  const std::array<Vec3, 1> point{Vec3{0.0, 0.0, 0.0}};
  EXPECT_FALSE(meets_metal(point, {}));
  const std::array<Capsule, 1> metal{Capsule{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.8}};
  EXPECT_FALSE(meets_metal({}, metal));
}

}  // namespace
}  // namespace hallux::simulator
