// What is seen of teeth and kerf, measured where it can be computed by hand.
#include "ui/render/visibility.h"

#include <gtest/gtest.h>

#include "simulator/cutting/pieces/cut_solid.h"
#include "tests/support/worlds.h"
#include "tests/ui/render/graphics.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr double aspect = 1.6;

/// All skin.
BoneLook plain_look() {
  BoneLook look;
  look.id = 1;
  look.depth.x_count = look.depth.y_count = look.depth.z_count = 2;
  look.depth.nodes.assign(8, 32768);
  return look;
}

/// Looks along -z at the origin, 10 mm of screen for one.
class Sight : public Graphics {
 protected:
  Sight() {
    camera_.magnification = 10.0;
    camera_.target_depth_mm = 0.0;
  }
  BoneInScene block_at(const Vec3& middle_mm) {
    BoneInScene bone;
    bone.mesh = &block_;
    bone.look = &look_;
    bone.world_from_bone.translation_mm = middle_mm;
    return bone;
  }
  Visibility measure(const SightSamples& samples) {
    return meter_.measure(scene_, view_of(camera_, Viewer{}, Eye::Middle, aspect), samples);
  }
  /// A hundred places along x in the plane of the screen, from -10 to 10.
  static std::vector<SightPlace> row(double z_mm = 0.0) {
    std::vector<SightPlace> places;
    for (int i = 0; i < 100; ++i) {
      const Vec3 place_mm(-10.0 + 0.2 * (i + 0.5), 0.0, z_mm);
      places.push_back({place_mm, place_mm});
    }
    return places;
  }

  BoneLook look_ = plain_look();
  /// A cube of 6 mm.
  BoneMesh block_ = mesh_of(1, simulator::uncut_solid(solid_block({6.0, 6.0, 6.0})), look_);
  Scene scene_;
  Camera camera_;
  SightMeter meter_{{800, 500}};
};

TEST_F(Sight, OfNothingAllIsSeen) {
  const Visibility seen = measure({});
  EXPECT_EQ(seen.tooth_line_share, 1.0);
  EXPECT_EQ(seen.kerf_share, 1.0);
}

TEST_F(Sight, WhatNothingLiesBeforeIsSeen) {
  EXPECT_EQ(measure({row(), row()}).tooth_line_share, 1.0);
  scene_.bones = {block_at(Vec3(0.0, 0.0, -6.0))};
  EXPECT_EQ(measure({row(), {}}).tooth_line_share, 1.0) << "it lies before the block";
}

// A cube's shadow on the row: its front edge at 5 mm, seen from 62 mm, hides a little more than its
// own width.
TEST_F(Sight, ABlockHidesAsMuchAsItsShadowSays) {
  const double eye_mm = Viewer{}.distance_mm / camera_.magnification;
  for (const double before_mm : {3.0, 5.0, 9.0}) {
    scene_.bones = {block_at(Vec3(0.0, 0.0, before_mm + 3.0))};
    // The near face, which lies 6 mm nearer to the eye, is the wider one.
    const double near_mm = before_mm + 6.0;
    const double shadow_mm = 6.0 * eye_mm / (eye_mm - near_mm);
    const Visibility seen = measure({row(), row()});
    EXPECT_NEAR(seen.tooth_line_share, 1.0 - shadow_mm / 20.0, 0.011) << before_mm;
    EXPECT_EQ(seen.kerf_share, seen.tooth_line_share);
    EXPECT_NEAR(static_cast<double>(meter_.hiders().bone), 200.0 * shadow_mm / 20.0, 3.0);
    EXPECT_EQ(meter_.hiders().blade + meter_.hiders().handpiece, 0U);
  }
}

TEST_F(Sight, APlaceIsSeenWhereOneOfItsSidesIs) {
  scene_.bones = {block_at(Vec3(0.0, 0.0, 8.0))};
  std::vector<SightPlace> places = row();
  for (SightPlace& place : places) place[1] += Vec3(0.0, 6.0, 0.0);
  EXPECT_EQ(measure({places, {}}).tooth_line_share, 1.0);
}

TEST_F(Sight, WhatLiesOutsideThePictureIsNotSeen) {
  camera_.magnification = 60.0;
  const Visibility seen = measure({row(), {}});
  EXPECT_NEAR(seen.tooth_line_share, Viewer{}.screen_width_mm / 60.0 / 20.0, 0.011);
  EXPECT_GT(meter_.hiders().outside_picture, 50U);
}

// The blade alone, square to the sight and half way before the row: as wide as it is.
TEST_F(Sight, ABladeHidesWhatLiesBehindItAndNotItsOwnTeeth) {
  SawInScene saw;
  saw.blade = {.width_mm = 10.0, .depth_mm = 30.0};
  // x down the picture, the handle above; the teeth a little below the row.
  saw.world_from_tool = {rotation_from_axes(Vec3(0.0, -1.0, 0.0), Vec3(1.0, 0.0, 0.0)),
                         Vec3(0.0, -4.0, 6.0)};
  scene_.saw = saw;
  const double eye_mm = Viewer{}.distance_mm / camera_.magnification;
  const double shadow_mm = 10.0 * eye_mm / (eye_mm - 6.2);
  EXPECT_NEAR(measure({row(), {}}).tooth_line_share, 1.0 - shadow_mm / 20.0, 0.012);
  EXPECT_GT(meter_.hiders().blade, 50U);
  std::vector<SightPlace> teeth;
  for (int i = 0; i < 10; ++i) {
    const Vec3 tooth_mm = transform_point(saw.world_from_tool, Vec3(0.0, -4.5 + i, 0.0));
    teeth.push_back({tooth_mm, tooth_mm});
  }
  EXPECT_EQ(measure({teeth, {}}).tooth_line_share, 1.0);
}

// Straight over the handle the handpiece would hide the teeth: there it gives way.
TEST_F(Sight, AHandpieceThatIsSeenThroughHidesNothing) {
  SawInScene saw;
  saw.blade = {.width_mm = 10.0, .depth_mm = 30.0};
  saw.world_from_tool.rotation = rotation_from_axes(Vec3(0.0, 0.0, -1.0), Vec3(1.0, 0.0, 0.0));
  scene_.saw = saw;
  std::vector<SightPlace> teeth;
  for (int i = 0; i < 10; ++i) {
    const Vec3 tooth_mm = transform_point(saw.world_from_tool, Vec3(0.2, -4.5 + i, 0.0));
    teeth.push_back({tooth_mm, tooth_mm});
  }
  camera_.magnification = 2.0;
  EXPECT_GE(measure({teeth, {}}).tooth_line_share, 0.8);
  EXPECT_EQ(meter_.hiders().handpiece, 0U);
  // Beside the line to the teeth it hides what lies behind it.
  const Vec3 behind_mm(0.0, 0.0, -40.0);
  saw.world_from_tool.translation_mm = Vec3(22.0, 0.0, 0.0);
  scene_.saw = saw;
  const Vec3 aside_mm = behind_mm + Vec3(30.0, 0.0, 0.0);
  measure({{{aside_mm, aside_mm}}, {}});
  EXPECT_LE(meter_.hiders().handpiece, 1U);
}

TEST_F(Sight, MeasuringTwiceSaysTheSame) {
  scene_.bones = {block_at(Vec3(2.0, 0.0, 8.0))};
  const Visibility first = measure({row(), row(1.0)}), again = measure({row(), row(1.0)});
  EXPECT_EQ(first.tooth_line_share, again.tooth_line_share);
  EXPECT_EQ(first.kerf_share, again.kerf_share);
  EXPECT_EQ(take_error(), 0U);
}

}  // namespace
}  // namespace hallux::tests
