#include "ui/screens/pictures/patient_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/progress.h"
#include "tests/ui/render/graphics.h"
#include "ui/render/picture.h"

namespace hallux::ui {
namespace {

constexpr PixelSize card_size{550, 376};

PatientView view_of_shipped(const char* name) {
  return make_patient_view(scenarios::load_shipped_scenario(name), {}, 1.0);
}

/// As many passes as the blade needs, and together they cover the section.
void expect_covering(const PatientView& view, std::size_t count) {
  ASSERT_EQ(view.passes.size(), view.faces.size());
  for (const PassesInView& passes : view.passes) {
    EXPECT_EQ(passes.middles_mm.size(), count);
    EXPECT_EQ(passes.is_one(), count == 1);
    EXPECT_EQ(passes.bone_width_mm + 2.0 > passes.blade_width_mm, count > 1);
    EXPECT_GE(passes.middles_mm.back() - passes.middles_mm.front() + passes.blade_width_mm,
              passes.bone_width_mm);
    EXPECT_FALSE(passes.section.section.bone_mm.empty());
  }
}

TEST(PatientView, EveryCutHasItsFaceItsPassesAndTheSawWaitsBeforeTheFirst) {
  const PatientView view = view_of_shipped("akin");
  ASSERT_EQ(view.faces.size(), 2U);
  expect_covering(view, 2);
  const Scene scene = scene_of(view, PatientPicture::Card, Ground::Dark);
  ASSERT_TRUE(scene.saw.has_value());
  // The teeth look along the blade's plane, from medial to lateral, and stand medial of the bone.
  const RigidTransform& tool = scene.saw->world_from_tool;
  EXPECT_GT(transform_direction(tool, Vec3(1.0, 0.0, 0.0)).z, 0.9);
  EXPECT_LT(tool.translation_mm.z, view.bone.world_from_bone.translation_mm.z - 8.0);
  EXPECT_FALSE(scene_of(view, PatientPicture::Whole, Ground::Dark).saw.has_value());
}

TEST(PatientView, AFaceAlongTheShaftIsShownAtTheHeadOnly) {
  const PatientView view = view_of_shipped("silver");
  ASSERT_EQ(view.faces.size(), 1U);
  expect_covering(view, 2);
  EXPECT_LT(view.faces.front().half_mm.y, 16.0) << "not along the whole bone";
  const Scene scene = scene_of(view, PatientPicture::Card, Ground::Dark);
  EXPECT_LT(transform_direction(scene.saw->world_from_tool, Vec3(1.0, 0.0, 0.0)).y, -0.6)
      << "from dorsal";
}

TEST(PatientView, OneContentHasOneName) {
  const PatientView akin = view_of_shipped("akin"), again = view_of_shipped("akin");
  EXPECT_EQ(akin.bone.mesh.id, again.bone.mesh.id);
  EXPECT_NE(akin.bone.mesh.id, akin.neighbour->mesh.id);
  EXPECT_NE(akin.bone.mesh.id, view_of_shipped("silver").neighbour->mesh.id);
}

TEST(PatientView, BuildingItCanBeStopped) {
  EXPECT_THROW(make_patient_view(
                   scenarios::load_shipped_scenario("akin"), [](double) { return false; }, 1.0),
               Cancelled);
}

using PatientPictureTest = tests::Graphics;

// The bone fills a good part of the card, stands near its middle and does not run out of it.
TEST_F(PatientPictureTest, ACardShowsItsBone) {
  Renderer renderer(still_quality);
  for (const char* name : {"akin", "silver"}) {
    const PatientView view = view_of_shipped(name);
    for (const Ground ground : {Ground::Dark, Ground::Light}) {
      const Pixels picture =
          render_picture(renderer, scene_of(view, PatientPicture::Card, ground),
                         camera_of(view, PatientPicture::Card, 550.0 / 376.0), card_size);
      const tests::Facts bone = tests::facts_of(picture, tests::is_bone_coloured);
      EXPECT_GT(bone.share, 0.10) << name;
      EXPECT_LT(bone.share, 0.60) << name;
      EXPECT_NEAR(bone.x, 0.5, 0.22) << name;
      EXPECT_NEAR(bone.y, 0.5, 0.22) << name;
    }
  }
}

}  // namespace
}  // namespace hallux::ui
