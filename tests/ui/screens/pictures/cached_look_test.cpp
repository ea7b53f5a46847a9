#include "ui/screens/pictures/cached_look.h"

#include <gtest/gtest.h>

#include <fstream>

#include "simulator/base/progress.h"
#include "tests/database/some_database.h"
#include "tests/ui/screens/some_operation.h"
#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {
namespace {

namespace fs = std::filesystem;

struct World {
  BoneLook look() const { return cached_look_of(temporary.data(), bone); }
  fs::path kept() const { return temporary.data() / "cache" / cached_look_name(bone); }

  database::TemporaryDirectory temporary;
  simulator::Bone bone = some_operation().bone;
};

void expect_same(const BoneLook& a, const BoneLook& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.depth.origin_in_bone_mm, b.depth.origin_in_bone_mm);
  EXPECT_EQ(a.depth.spacing_mm, b.depth.spacing_mm);
  EXPECT_EQ(a.depth.x_count, b.depth.x_count);
  EXPECT_EQ(a.depth.y_count, b.depth.y_count);
  EXPECT_EQ(a.depth.z_count, b.depth.z_count);
  EXPECT_EQ(a.depth.nodes, b.depth.nodes);
  EXPECT_EQ(a.cortex.has_value(), b.cortex.has_value());
}

TEST(CachedLook, IsComputedOnceAndReadAgainBitForBit) {
  const World world;
  const BoneLook computed = world.look();
  ASSERT_TRUE(fs::exists(world.kept()));
  const auto written = fs::last_write_time(world.kept());
  double reached = 0.0;
  expect_same(cached_look_of(world.temporary.data(), world.bone,
                             [&](double fraction) {
                               reached = fraction;
                               return true;
                             }),
              computed);
  EXPECT_EQ(reached, 1.0);
  EXPECT_EQ(fs::last_write_time(world.kept()), written);
  expect_same(look_of(computed.id, world.bone), computed);
}

TEST(CachedLook, AnotherBoneHasAnother) {
  World world;
  const BoneLook before = world.look();
  for (Vec3& point_mm : world.bone.outer.points_mm) point_mm.x += 1.0;
  const BoneLook moved = world.look();
  EXPECT_NE(moved.id, before.id);
  EXPECT_NE(moved.depth.origin_in_bone_mm, before.depth.origin_in_bone_mm);
}

TEST(CachedLook, ADeletedOrDamagedFileIsMadeAgain) {
  const World world;
  const BoneLook computed = world.look();
  fs::resize_file(world.kept(), fs::file_size(world.kept()) / 2);
  expect_same(world.look(), computed);
  fs::remove_all(world.temporary.data() / "cache");
  expect_same(world.look(), computed);
  EXPECT_TRUE(fs::exists(world.kept()));
}

TEST(CachedLook, WhereItCannotBeKeptTheBoneIsShownAllTheSame) {
  const World world;
  fs::create_directories(world.temporary.data());
  std::ofstream(world.temporary.data() / "cache") << "a file";
  EXPECT_FALSE(world.look().depth.nodes.empty());
}

TEST(CachedLook, NothingIsKeptOfOneThatWasStopped) {
  const World world;
  EXPECT_THROW(cached_look_of(world.temporary.data(), world.bone,
                              [](double fraction) { return fraction <= 0.2; }),
               Cancelled);
  EXPECT_FALSE(fs::exists(world.kept()));
}

}  // namespace
}  // namespace hallux::ui
