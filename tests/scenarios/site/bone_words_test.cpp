#include "scenarios/site/bone_words.h"

#include <gtest/gtest.h>

namespace hallux::scenarios {
namespace {

TEST(BoneWords, NameTheNearestAxisAndASecondThatIsHalfAsLong) {
  EXPECT_EQ(direction_text(Vec3{0.0, 1.0, 0.0}), "dorsal");
  EXPECT_EQ(direction_text(Vec3{0.0, 0.1, -1.0}), "medial");
  EXPECT_EQ(direction_text(Vec3{1.0, -0.8, 0.0}), "plantar-distal");
  EXPECT_EQ(direction_text(Vec3{-1.0, 0.9, 0.8}), "dorsal-proximal");
  EXPECT_EQ(direction_text(Vec3{0.0, 0.0, 0.0}), "");
}

}  // namespace
}  // namespace hallux::scenarios
