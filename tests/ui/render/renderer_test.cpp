#include "ui/render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <tuple>

#include "tests/ui/render/graphics.h"
#include "tests/ui/render/operating_world.h"
#include "ui/render/gl/headless_context.h"
#include "ui/render/picture.h"
#include "ui/render/scene_painter.h"
#include "ui/render/stereo.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr PixelSize size{640, 360};

class Pictures : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    world = new OperatingWorld(0.9);
    world->saw_to(-4.0);
  }
  static void TearDownTestSuite() { delete world; }

  Pixels draw(const Scene& scene, const Camera& camera) {
    const RenderTarget target(size);
    renderer_->draw(scene, camera, target.target());
    return target.read();
  }

  static OperatingWorld* world;
  HeadlessContext context_;
  std::unique_ptr<Renderer> renderer_ = std::make_unique<Renderer>(RenderQuality{});
};
OperatingWorld* Pictures::world = nullptr;

// Measured facts of the operating view, seen and found good; a change of looks changes them by
// hand.
TEST_F(Pictures, TheOperatingViewShowsBoneWhereItIsWarmAndNothingElseIs) {
  for (const Ground ground : {Ground::Dark, Ground::Light}) {
    Scene scene = world->scene();
    scene.ground = ground;
    scene.bones.pop_back();  // the phalanx alone
    scene.planes.clear();
    const Facts bone = facts_of(draw(scene, world->camera()), is_bone_coloured);
    EXPECT_NEAR(bone.share, 0.132, 0.02);
    EXPECT_NEAR(bone.x, 0.376, 0.015);
    EXPECT_NEAR(bone.y, 0.493, 0.02);
    // Warm ivory: red over green over blue, far from grey and from white.
    EXPECT_GT(bone.red, bone.green + 8.0);
    EXPECT_GT(bone.green, bone.blue + 14.0);
    EXPECT_NEAR(bone.red, 180.0, 12.0);
  }
}

TEST_F(Pictures, ACutAwayIsGoneWithTheNextPicture) {
  Scene scene = world->scene();
  const Pixels whole = draw(scene, world->camera());
  scene.bones.front().cut_away = CutAway{Vec3(1.0, 0.0, 0.0), 12.0};
  EXPECT_NE(draw(scene, world->camera()).rgba, whole.rgba);
  scene.bones.front().cut_away.reset();
  EXPECT_EQ(draw(scene, world->camera()).rgba, whole.rgba);
}

TEST_F(Pictures, TheGroundIsCoolAndBrightestWhereItIsLit) {
  Scene scene;
  const Pixels dark = draw(scene, world->camera());
  EXPECT_NEAR(pixel_at(dark, 320, 180).blue, 0x44, 2);
  EXPECT_NEAR(pixel_at(dark, 1, 1).blue, 0x18, 3);
  EXPECT_EQ(facts_of(dark, is_bone_coloured).count, 0U);
  scene.ground = Ground::Light;
  const Pixels light = draw(scene, world->camera());
  EXPECT_NEAR(pixel_at(light, 320, 180).red, 0xF2, 2);
  EXPECT_NEAR(pixel_at(light, 1, 1).red, 0xC3, 3);
}

// It is drawn once and kept: whatever it follows from makes it new.
TEST_F(Pictures, TheGroundIsTheOneOfAFreshRendererWhateverWasDrawnBefore) {
  Scene scene = world->scene();
  draw(scene, world->camera());
  const auto expect_fresh = [&](const char* what) {
    Renderer fresh(RenderQuality{});
    const RenderTarget target(size);
    fresh.draw(scene, world->camera(), target.target());
    EXPECT_EQ(draw(scene, world->camera()).rgba, target.read().rgba) << what;
  };
  scene.ground = Ground::Light;
  expect_fresh("another ground");
  scene.light_place = Vec2(0.2, 0.7);
  expect_fresh("lit elsewhere");
  scene.bones.clear();
  expect_fresh("where bones were");
}

TEST_F(Pictures, TheBladeShadowsTheBone) {
  Scene scene = world->scene();
  scene.bones.pop_back();
  scene.planes.clear();
  scene.lines.clear();
  // The operator's height, from medial.
  const Camera camera = orbited(standard_view(world->camera(), StandardView::Medial), -0.13, 0.35);
  scene.bones.front().patch = nullptr;
  const Pixels shaded = draw(scene, camera);
  // The same with the saw far away, its shadow with it.
  scene.saw->world_from_tool.translation_mm += Vec3(0.0, 0.0, -400.0);
  const Pixels lit = draw(scene, camera);
  std::size_t darker = 0, brighter = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Colour with = pixel_at(shaded, x, y), without = pixel_at(lit, x, y);
      if (!is_bone_coloured(with) || !is_bone_coloured(without)) continue;
      darker += with.red < without.red - 15 ? 1U : 0U;
      brighter += with.red > without.red + 2 ? 1U : 0U;
    }
  }
  EXPECT_GT(darker, 120U);
  EXPECT_EQ(brighter, 0U);
}

/// How much bone is seen within a share of the picture's height around a place of the world.
std::size_t bone_around(const Pixels& picture, const Camera& camera, const Vec3& place_mm) {
  const double aspect = static_cast<double>(size.width) / size.height;
  const Vec3 place = place_in_picture(view_of(camera, Viewer{}, Eye::Middle, aspect), place_mm);
  constexpr int reach = 28;
  const int x0 = static_cast<int>(place.x * size.width),
            y0 = static_cast<int>(place.y * size.height);
  std::size_t count = 0;
  for (int y = y0 - reach; y <= y0 + reach; ++y) {
    for (int x = x0 - reach; x <= x0 + reach; ++x) {
      const Colour colour = pixel_at(picture, x, y);
      count += colour.red > colour.blue + 12 && colour.red > 60 ? 1U : 0U;
    }
  }
  return count;
}

TEST_F(Pictures, AHandpieceBeforeTheTeethIsSeenThrough) {
  Scene scene = world->scene();
  scene.planes.clear();
  scene.lines.clear();
  // Straight along the saw: without that the grip covers what it cuts.
  Camera camera = world->camera();
  const RigidTransform tool = scene.saw->world_from_tool;
  camera.target_mm = tool.translation_mm;
  camera.world_from_view =
      tool.rotation * rotation_from_axes(Vec3(0.0, -1.0, 0.0), Vec3(0.0, 0.0, 1.0));
  const Pixels with = draw(scene, camera);
  Scene without = scene;
  without.saw.reset();
  const std::size_t all = bone_around(draw(without, camera), camera, tool.translation_mm);
  ASSERT_GT(all, 1500U);
  EXPECT_GT(bone_around(with, camera, tool.translation_mm), all / 2);
  // It is there all the same.
  EXPECT_NE(with.rgba, draw(without, camera).rgba);
}

TEST_F(Pictures, ALineOfTheBladesPlaneRunsOverTheBone) {
  Scene scene = world->scene();
  scene.planes.clear();
  scene.saw.reset();
  const auto is_accent = [](const Colour& colour) { return colour.blue > 180 && colour.red < 110; };
  const Pixels with = draw(scene, world->camera());
  EXPECT_GT(facts_of(with, is_accent).count, 200U);
  scene.lines.clear();
  EXPECT_EQ(facts_of(draw(scene, world->camera()), is_accent).count, 0U);
}

TEST_F(Pictures, CutFacesAreReddishSpongeWithinAPaleRim) {
  OperatingWorld opened(0.9);
  opened.take_wedge_out();
  Scene scene = opened.scene();
  scene.bones.pop_back();
  scene.bones.front().cut_away =
      CutAway{opened.cut().face.normal, opened.cut().face.offset_mm + 0.25};
  Camera camera = opened.camera();
  camera.magnification = 14.0;
  camera = standard_view(camera, StandardView::Distal);
  const Pixels picture = draw(scene, camera);
  const Facts red = facts_of(picture, [](const Colour& colour) {
    return colour.red > 50 && colour.red > 1.35 * colour.green && colour.red > 1.6 * colour.blue;
  });
  EXPECT_GT(red.share, 0.05);
  // Nothing of the closed skin is that red.
  scene.bones.front().cut_away.reset();
  const Facts skin =
      facts_of(draw(scene, standard_view(camera, StandardView::Dorsal)), [](const Colour& colour) {
        return colour.red > 50 && colour.red > 1.35 * colour.green &&
               colour.red > 1.6 * colour.blue;
      });
  EXPECT_LT(skin.share, 0.02);
}

TEST_F(Pictures, TheSignedMapIsBlueWhereTooMuchWasTakenAndOrangeWhereBoneWasLeft) {
  OperatingWorld opened(0.9);
  opened.take_wedge_out();
  Scene scene = opened.scene();
  scene.bones.pop_back();
  const Vec3 normal = opened.cut().face.normal;
  scene.bones.front().cut_away = CutAway{normal, opened.cut().face.offset_mm + 0.25};
  Camera camera = opened.camera();
  camera.magnification = 14.0;
  camera = standard_view(camera, StandardView::Distal);
  const auto blue = [](const Colour& colour) { return colour.blue > colour.red + 60; };
  const auto orange = [](const Colour& colour) { return colour.red > colour.blue + 120; };
  SignedMap map{.kerf = 0, .side = 0, .normal_in_bone = normal, .range_mm = 2.0};
  // The plan lies 1.5 mm further into the waste: the face that was cut lies below it.
  map.offset_mm = opened.cut().face.offset_mm + 1.5;
  scene.bones.front().map = map;
  const Pixels too_much = draw(scene, camera);
  EXPECT_GT(facts_of(too_much, blue).share, 0.02);
  map.offset_mm = opened.cut().face.offset_mm - 1.5;
  scene.bones.front().map = map;
  const Pixels left = draw(scene, camera);
  EXPECT_GT(facts_of(left, orange).count, facts_of(too_much, orange).count + 2000);
}

TEST_F(Pictures, TheSameSceneIsTheSameToTheLastBitAndSawingShows) {
  OperatingWorld sawn(0.9);
  sawn.saw_to(-5.0);
  const Pixels first = draw(sawn.scene(), sawn.camera());
  EXPECT_EQ(first.rgba, draw(sawn.scene(), sawn.camera()).rgba);
  sawn.saw_to(-3.0);
  EXPECT_NE(first.rgba, draw(sawn.scene(), sawn.camera()).rgba);
}

TEST_F(Pictures, OnlyThePatchIsSentWhileSawing) {
  const RenderTarget target(size);
  renderer_->draw(world->scene(), world->camera(), target.target());
  const std::uint64_t first = renderer_->counts().uploaded_bytes;
  renderer_->draw(world->scene(), world->camera(), target.target());
  EXPECT_EQ(renderer_->counts().uploaded_bytes, 0U);
  world->saw_to(-3.8);
  renderer_->draw(world->scene(), world->camera(), target.target());
  const std::uint64_t sawn = renderer_->counts().uploaded_bytes;
  EXPECT_GT(sawn, 0U);
  EXPECT_LT(sawn, first / 4);
}

TEST_F(Pictures, NothingOfGraphicsIsLeftBehindOrGrows) {
  renderer_.reset();
  const ObjectCensus before = count_objects();
  {
    Renderer renderer(RenderQuality{});
    StereoStage stage;
    const RenderTarget window(size);
    const auto draw_all = [&](int round) {
      Scene scene = world->scene();
      scene.saw->is_running = true;
      scene.chips.resize(static_cast<std::size_t>(50 * (round % 5) + 1));
      scene.marks = {{Vec3(200.0, 15.0, -27.0)}};
      scene.blade_ghosts = {{world->world_from_tool(), {}, Ink::Reference}};
      for (const StereoMode mode :
           {StereoMode::Mono, StereoMode::SideBySide, StereoMode::Anaglyph}) {
        stage.draw(renderer, scene, world->camera(), {.mode = mode}, window.target());
      }
    };
    draw_all(4);
    const ObjectCensus once = count_objects();
    for (int round = 0; round < 10; ++round) draw_all(round);
    EXPECT_EQ(count_objects(), once);
    EXPECT_EQ(take_error(), 0U);
  }
  EXPECT_EQ(count_objects(), before);
}

TEST_F(Pictures, BonesThatAreNoLongerSeenAreLetGo) {
  const RenderTarget target({32, 18});
  draw(Scene{}, world->camera());
  const ObjectCensus empty = count_objects();
  renderer_->draw(world->scene(), world->camera(), target.target());
  EXPECT_GT(count_objects().buffers, empty.buffers);
  renderer_->forget_bones();
  // The saw stays: the next operation has one, too. Its blade and handpiece are four buffers.
  EXPECT_LE(count_objects().buffers, empty.buffers + 4);
}

TEST_F(Pictures, AScreenWithoutBonesKeepsNoneOfTheScreenBefore) {
  const RenderTarget window({32, 18});
  OpenGlScenePainter painter;
  painter.begin_frame(window.target());
  painter.draw("nothing", Scene{}, world->camera(), {32, 18});
  const ObjectCensus empty = count_objects();
  painter.draw("bones", world->scene(), world->camera(), {32, 18});
  ASSERT_GT(count_objects().buffers, empty.buffers + 4);
  for (int frame = 0; frame < 301; ++frame) painter.begin_frame(window.target());
  EXPECT_LE(count_objects().buffers, empty.buffers + 4);
}

TEST_F(Pictures, AnySizeAndAStormOfSizesIsDrawn) {
  for (const PixelSize storm :
       {PixelSize{1, 1}, {1, 900}, {1300, 2}, {333, 217}, {0, 0}, {64, 64}}) {
    const RenderTarget target(storm);
    renderer_->draw(world->scene(), world->camera(), target.target());
    StereoStage stage;
    stage.draw(*renderer_, world->scene(), world->camera(), {.mode = StereoMode::SideBySide},
               target.target());
    EXPECT_EQ(take_error(), 0U);
  }
}

TEST_F(Pictures, APointOfTheScreenPlaneIsOnTheSamePixelForBothEyes) {
  // Marks in the screen plane, before it and behind it, as drawn.
  const Camera camera = world->camera();
  StereoStage stage;
  stage.begin({.mode = StereoMode::Anaglyph}, size);
  const auto mark_places = [&](double towards_viewer_mm) {
    Scene scene;
    const Vec3 from_target(4.0, 2.0, camera.target_depth_mm + towards_viewer_mm);
    scene.marks = {{camera.target_mm + camera.world_from_view * from_target, 5.0, Ink::Harm}};
    std::array<double, 2> x{};
    for (const Eye eye : {Eye::Left, Eye::Right}) {
      renderer_->draw(scene, stage.view(eye, camera), stage.eye(eye).target());
      const Facts mark = facts_of(stage.eye(eye).read(), [](const Colour& colour) {
        return colour.red > 200 && colour.blue < 120;
      });
      EXPECT_GT(mark.count, 20U);
      x[eye == Eye::Left ? 0 : 1] = mark.x * size.width;
    }
    return x;
  };
  const auto in_plane = mark_places(0.0);
  EXPECT_EQ(in_plane[0], in_plane[1]);
  const auto behind = mark_places(-12.0);
  EXPECT_GT(behind[1], behind[0] + 2.0);
  const auto before = mark_places(8.0);
  EXPECT_LT(before[1], before[0] - 2.0);
}

// A line of one pixel stays one, though the eyes' pictures have half of the columns.
TEST_F(Pictures, PanelsOfAnAnaglyphLieSharpOverBothEyes) {
  const RenderTarget window(size);
  StereoStage stage;
  constexpr int line = 21;
  const auto picture = [&](bool has_line) {
    stage.begin({.mode = StereoMode::Anaglyph, .eye_columns = 0.5}, size);
    for (const Eye eye : {Eye::Left, Eye::Right})
      renderer_->draw(world->scene(), stage.view(eye, world->camera()), stage.eye(eye).target());
    if (has_line) whiten_column(stage.pictures_for_panels(window.target()).front(), line);
    stage.compose(window.target());
    return window.read();
  };
  const Pixels without = picture(false), with = picture(true);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Colour colour = pixel_at(with, x, y), before = pixel_at(without, x, y);
      if (x == line) {
        ASSERT_GT(std::min({colour.red, colour.green, colour.blue}), 250) << x << " " << y;
      } else {
        ASSERT_EQ(std::tie(colour.red, colour.green, colour.blue),
                  std::tie(before.red, before.green, before.blue))
            << x << " " << y;
      }
    }
  }
  stage.begin({.mode = StereoMode::SideBySide}, size);
  EXPECT_EQ(stage.pictures_for_panels(window.target()).size(), 2U)
      << "there panels belong into each eye's half";
}

/// Mean difference of green, between two pictures of one size.
double difference_of(const Pixels& one, const Pixels& other) {
  double sum = 0.0;
  for (std::size_t i = 1; i < one.rgba.size(); i += 4)
    sum += std::abs(int{one.rgba[i]} - int{other.rgba[i]});
  return 4.0 * sum / static_cast<double>(one.rgba.size());
}

class MovingViews : public Pictures {
 protected:
  Pixels frame(OpenGlScenePainter& with, const Camera& camera, int line = -1) {
    with.begin_frame(window_.target());
    with.draw_behind(scene_, camera, {.mode = mode_});
    with.finish_frame({0, 0, 0}, [&](float columns) {
      EXPECT_EQ(columns, mode_ == StereoMode::SideBySide ? 0.5F : 1.0F);
      const PixelSize picture{static_cast<int>(size.width * columns), size.height};
      if (line >= 0) whiten_column(bound_target(picture), line);
    });
    return window_.read();
  }

  const RenderTarget window_{size};
  Scene scene_ = world->scene();
  StereoMode mode_ = StereoMode::Mono;
  const Camera turned_ = orbited(world->camera(), 0.3, -0.1);
};

// A processor draws a view that moves with fewer pixels: for that one frame, and never the panels.
TEST_F(MovingViews, AreCoarseUntilTheyRest) {
  ASSERT_TRUE(is_software_renderer());
  constexpr int line = 21;
  for (const StereoMode mode : {StereoMode::Mono, StereoMode::SideBySide, StereoMode::Anaglyph}) {
    mode_ = mode;
    OpenGlScenePainter painter;
    frame(painter, world->camera());
    EXPECT_FALSE(painter.is_coarse()) << "nothing moved before the first frame";
    const Pixels moving = frame(painter, turned_, line);
    EXPECT_TRUE(painter.is_coarse());
    const Pixels at_rest = frame(painter, turned_, line);
    EXPECT_FALSE(painter.is_coarse());
    for (int y = 0; y < size.height; ++y) {
      for (const int x : {line - 1, line, line + 1}) {
        const Colour colour = pixel_at(moving, x, y);
        ASSERT_EQ(std::min({colour.red, colour.green, colour.blue}) > 250, x == line) << x << y;
      }
    }
    EXPECT_GT(difference_of(moving, at_rest), 0.05) << "as fine as at rest";
    EXPECT_LT(difference_of(moving, at_rest), 4.0) << "another picture";
    OpenGlScenePainter never_turned;
    EXPECT_EQ(frame(never_turned, turned_, line).rgba, at_rest.rgba);
  }
}

TEST_F(MovingViews, ShowMarksAsLargeAsAtRest) {
  scene_ = {};
  const Camera camera = turned_;
  scene_.marks = {{camera.target_mm, 30.0, Ink::Harm}};
  const auto mark = [](const Pixels& picture) {
    return facts_of(picture,
                    [](const Colour& colour) { return colour.red > 140 && colour.blue < 120; });
  };
  OpenGlScenePainter painter;
  frame(painter, world->camera());
  const Facts moving = mark(frame(painter, turned_));
  ASSERT_TRUE(painter.is_coarse());
  const Facts at_rest = mark(frame(painter, turned_));
  ASSERT_GT(at_rest.count, 100U);
  EXPECT_NEAR(static_cast<double>(moving.count) / static_cast<double>(at_rest.count), 1.0, 0.2);
  EXPECT_NEAR(moving.x, at_rest.x, 1.0 / size.width);
  EXPECT_NEAR(moving.y, at_rest.y, 1.0 / size.height);
}

TEST_F(Pictures, SideBySideShowsTheLeftEyeOnTheLeftUnlessSwapped) {
  const RenderTarget window(size);
  StereoStage stage;
  const Camera camera = world->camera();
  const auto halves = [&](bool is_swapped) {
    const StereoSetting setting{.mode = StereoMode::SideBySide, .is_swapped = is_swapped};
    Scene scene;
    const Vec3 behind(0.0, 0.0, camera.target_depth_mm - 15.0);
    scene.marks = {{camera.target_mm + camera.world_from_view * behind, 6.0, Ink::Harm}};
    stage.draw(*renderer_, scene, camera, setting, window.target());
    const Pixels picture = window.read();
    double left = 0.0, right = 0.0, left_count = 0.0, right_count = 0.0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const Colour colour = pixel_at(picture, x, y);
        if (colour.red < 200 || colour.blue > 120) continue;
        (x < size.width / 2 ? left : right) += x % (size.width / 2);
        (x < size.width / 2 ? left_count : right_count) += 1.0;
      }
    }
    return right / right_count - left / left_count;
  };
  EXPECT_GT(halves(false), 1.0);  // behind the screen: the right eye sees it further to the right
  EXPECT_LT(halves(true), -1.0);
}

TEST_F(Pictures, StillPicturesHaveSmoothEdgesAndTheLivePictureComesBack) {
  const Pixels still = render_picture(*renderer_, world->scene(), world->camera(), size);
  EXPECT_EQ(renderer_->quality().supersampling, 1);
  const Pixels live = draw(world->scene(), world->camera());
  // The same picture but for its edges.
  double difference = 0.0;
  for (std::size_t i = 0; i < live.rgba.size(); ++i)
    difference += std::abs(still.rgba[i] - live.rgba[i]);
  difference /= static_cast<double>(live.rgba.size());
  EXPECT_GT(difference, 0.02);
  EXPECT_LT(difference, 4.0);
}

TEST_F(Pictures, PngFilesAreTheSameForTheSamePicture) {
  const Pixels picture = draw(world->scene(), world->camera());
  const std::vector<std::byte> bytes = encode_png(picture);
  ASSERT_GT(bytes.size(), 1000U);
  EXPECT_EQ(bytes[1], std::byte{'P'});
  EXPECT_EQ(bytes, encode_png(picture));
  EXPECT_THROW(write_png("no_such_folder/picture.png", picture), PictureError);
}

}  // namespace
}  // namespace hallux::tests
