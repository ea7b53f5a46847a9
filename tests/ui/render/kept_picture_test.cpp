// A picture drawn over what is kept of the one before is, to the last bit, the one that is drawn
// anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

#include "tests/ui/render/drilled_bone.h"
#include "tests/ui/render/graphics.h"
#include "tests/ui/render/operating_world.h"
#include "ui/render/renderer.h"
#include "ui/render/stereo.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr PixelSize size{640, 360};
constexpr double aspect = 640.0 / 360.0;

/// What sets two pictures of one size apart, in words; empty where nothing does.
std::string difference_of(const Pixels& one, const Pixels& other) {
  std::size_t count = 0;
  int most = 0;
  for (std::size_t i = 0; i < one.rgba.size(); ++i) {
    const int levels = std::abs(int{one.rgba[i]} - int{other.rgba[i]});
    count += levels > 0 ? 1U : 0U;
    most = std::max(most, levels);
  }
  if (count == 0) return {};
  return std::to_string(count) + " values differ, by " + std::to_string(most) + " at most";
}

class KeptPictures : public Graphics {
 protected:
  KeptPictures() { saw_to(-6.0); }

  EyeView view(Eye eye = Eye::Middle) const { return view_of(camera_, Viewer{}, eye, aspect); }
  Pixels anew(Eye eye = Eye::Middle) {
    const RenderTarget target(size_);
    renderer_.draw(scene_, view(eye), target.target());
    return target.read();
  }
  Pixels kept(Eye eye = Eye::Middle) {
    const RenderTarget target(size_);
    renderer_.draw(scene_, view(eye), target.target(), eye == Eye::Right ? right_ : left_);
    redrawn_ = renderer_.counts().redrawn_pixels;
    relit_ = renderer_.counts().relit_pixels;
    return target.read();
  }
  void expect_same(const char* what) { EXPECT_EQ(difference_of(kept(), anew()), "") << what; }
  void saw_to(double reach_mm) {
    world_.saw_to(reach_mm);
    scene_ = world_.scene();
  }

  OperatingWorld world_{0.9};
  Scene scene_ = world_.scene();
  Camera camera_ = world_.camera();
  PixelSize size_ = size;
  Renderer renderer_{RenderQuality{.supersampling = 1, .keeps_still = true}};
  KeptPicture left_, right_;
  std::size_t redrawn_ = 0, relit_ = 0;
};

TEST_F(KeptPictures, AreTheSameWhateverMovesOrChanges) {
  expect_same("nothing changed");
  scene_.saw->world_from_tool.translation_mm += Vec3(1.0, 4.0, -2.0);
  expect_same("the saw moved, its shadow and its line with it");
  for (const double reach_mm : {-5.6, -5.5, -3.0, -2.9, 1.0}) {
    saw_to(reach_mm);
    expect_same("sawn");
  }
  camera_ = orbited(camera_, 0.1, -0.05);
  expect_same("the view turned");
  scene_.ground = Ground::Light;
  expect_same("another ground");
  scene_.bones.back().world_from_bone.translation_mm += Vec3(0.0, 2.0, 0.0);
  expect_same("a bone moved");
  scene_.bones.back().presence = 0.4;
  expect_same("a bone fades");
  scene_.bones.front().cut_away = CutAway{Vec3(1.0, 0.0, 0.0), 12.0};
  expect_same("a bone cut away");
  scene_.bones.front().map = SignedMap{.kerf = -1};
  expect_same("a map on it");
  scene_.bones.front().patch = nullptr;
  expect_same("its patch gone");
  scene_.bones.pop_back();
  expect_same("a bone less");
  scene_.saw.reset();
  scene_.lines.clear();
  expect_same("no saw");
  size_ = {333, 217};
  expect_same("another size");
  renderer_.forget_bones();
  expect_same("the card forgot the bones");
  world_.take_wedge_out();
  scene_ = world_.scene();
  expect_same("another mesh");
}

// Edges are smoothed where something changed; what lies further away keeps them.
TEST_F(KeptPictures, AreTheSameWithSmoothEdges) {
  renderer_.set_quality({.supersampling = 1, .keeps_still = true, .smooths_edges = true});
  const auto expect_same_smooth = [&](const char* what) {
    KeptPicture fresh;
    const RenderTarget target(size_);
    renderer_.draw(scene_, view(), target.target(), fresh);
    const Pixels anew = target.read();
    EXPECT_EQ(difference_of(kept(), anew), "") << what;
  };
  expect_same_smooth("the first");
  for (const double reach_mm : {-5.6, -5.5, -3.0, 1.0}) {
    saw_to(reach_mm);
    expect_same_smooth("sawn");
  }
  for (int i = 0; i < 6; ++i) {
    scene_.saw->world_from_tool.translation_mm += Vec3(1.0, 2.0 * i, -2.0);
    expect_same_smooth("the saw moved");
  }
  camera_ = orbited(camera_, 0.1, -0.05);
  expect_same_smooth("the view turned");
  scene_.saw.reset();
  expect_same_smooth("no saw");
}

/// One thing after the other in the hand and in the bone.
void take_tools(Scene& scene, const OperatingWorld& world,
                const std::function<void(const char*)>& expect) {
  const DrillLine line = drill_line(world, Vec3(15.0, 0.0, 0.0), Vec3(0.55, -0.75, 0.25));
  scene.saw.reset();
  scene.driver = DriverInScene{line.world_from_tool(-3.0), simulator::Drill{}};
  expect("a drill for a saw");
  scene.driver->is_running = true;
  for (const double depth_mm : {-1.0, 2.0, 6.0}) {
    scene.driver->world_from_tool = line.world_from_tool(depth_mm);
    scene.driver->turned_rad += 1.1;
    expect("drilled");
  }
  scene.holes = {hole_at(world, line, 1.35)};
  expect("a hole");
  scene.driver = DriverInScene{line.world_from_tool(-1.0), simulator::WireDriver{}};
  scene.driver->handpiece_presence = 0.4;
  expect("a wire driver that is seen through");
  scene.driver->tool = simulator::Screwdriver{};
  scene.driver->handpiece_presence = 1.0;
  expect("a screwdriver");
  scene.forceps = ForcepsInScene{line.world_from_tool(1.0), 14.0};
  expect("forceps besides");
  scene.forceps->opening_mm = 9.0;
  scene.forceps->handle_presence = 0.5;
  expect("the forceps close");
  scene.driver.reset();
  scene.implants = {{line.world_from_tool(6.0), simulator::Screwdriver{}},
                    {line.world_from_tool(3.0), simulator::WireDriver{}, true}};
  expect("a screw and a wire that is planned");
  scene.implants.front().is_planned = true;
  scene.ground = Ground::Light;
  expect("both planned, on another ground");
  scene.bones.front().world_from_bone.translation_mm += Vec3(0.0, 0.5, 0.0);
  expect("the bone moved");
  scene.implants.clear();
  scene.holes.clear();
  scene.forceps.reset();
  expect("nothing of it");
}

TEST_F(KeptPictures, AreTheSameWithToolsAndWhatTheyLeave) {
  kept();
  take_tools(scene_, world_, [&](const char* what) { expect_same(what); });
}

TEST_F(KeptPictures, AreTheSameWithToolsAndSmoothEdges) {
  renderer_.set_quality({.supersampling = 1, .keeps_still = true, .smooths_edges = true});
  kept();
  take_tools(scene_, world_, [&](const char* what) {
    KeptPicture fresh;
    const RenderTarget target(size_);
    renderer_.draw(scene_, view(), target.target(), fresh);
    const Pixels anew = target.read();
    EXPECT_EQ(difference_of(kept(), anew), "") << what;
  });
}

TEST_F(KeptPictures, AreTheSameHoweverADriverIsHeld) {
  const RigidTransform held = scene_.saw->world_from_tool;
  scene_.saw.reset();
  scene_.driver = DriverInScene{held, simulator::Drill{.bit = {.length_mm = 30.0}}};
  for (int i = 0; i < 40; ++i) {
    const Vec3 axis = glm::normalize(Vec3(std::sin(1.0 * i), std::cos(2.0 * i), std::sin(3.0 * i)));
    scene_.driver->world_from_tool =
        held * RigidTransform{rotation_about(axis, 0.16 * i),
                              Vec3(2.0 * std::sin(0.7 * i), 0.0, 5.0 * std::cos(1.3 * i))};
    expect_same(("held in way " + std::to_string(i)).c_str());
  }
}

TEST_F(KeptPictures, AreNotDrawnAnewForWhatStandsInBoneOrIsHeld) {
  scene_.saw.reset();
  const DrillLine line = drill_line(world_, Vec3(15.0, 0.0, 0.0), Vec3(0.55, -0.75, 0.25));
  scene_.driver = DriverInScene{line.world_from_tool(-3.0), simulator::WireDriver{}};
  kept();
  scene_.implants = {{line.world_from_tool(6.0), simulator::Screwdriver{}, true}};
  scene_.holes = {hole_at(world_, line, 1.0)};
  scene_.forceps = ForcepsInScene{line.world_from_tool(0.0)};
  scene_.driver->turned_rad = 1.0;
  kept();
  EXPECT_EQ(redrawn_, 0U);
  EXPECT_EQ(relit_, 0U);
  scene_.driver->world_from_tool.translation_mm += Vec3(0.5, 0.0, 0.0);
  kept();
  EXPECT_EQ(redrawn_, 0U);
  EXPECT_GT(relit_, 0U);
  EXPECT_LT(relit_, 640U * 360U / 2U);
}

TEST_F(KeptPictures, DrawOnlyWhatWasCutWhileTheViewStandsStill) {
  constexpr std::size_t all = 640U * 360U;
  kept();
  EXPECT_EQ(redrawn_, all);
  kept();
  EXPECT_EQ(redrawn_, 0U);
  scene_.saw->world_from_tool.translation_mm += Vec3(0.0, 3.0, 0.0);
  kept();
  EXPECT_EQ(redrawn_, 0U);
  saw_to(-5.7);
  kept();
  EXPECT_GT(redrawn_, 0U);
  EXPECT_LT(redrawn_, all / 8);
  camera_ = orbited(camera_, 0.02, 0.0);
  kept();
  EXPECT_EQ(redrawn_, all);
}

TEST_F(KeptPictures, AreLitAnewOnlyWhereTheSawsShadowWasOrIs) {
  constexpr std::size_t all = 640U * 360U;
  kept();
  EXPECT_EQ(relit_, all);
  kept();
  EXPECT_EQ(relit_, 0U);
  scene_.saw->is_running = !scene_.saw->is_running;
  kept();
  EXPECT_EQ(relit_, 0U);
  scene_.saw->world_from_tool.translation_mm += Vec3(0.0, 0.5, 0.0);
  kept();
  EXPECT_GT(relit_, 0U);
  EXPECT_LT(relit_, all / 2);
}

TEST_F(KeptPictures, AreTheSameHoweverTheSawIsHeld) {
  const RigidTransform held = scene_.saw->world_from_tool;
  for (int i = 0; i < 40; ++i) {
    const Vec3 axis = glm::normalize(Vec3(std::sin(1.0 * i), std::cos(2.0 * i), std::sin(3.0 * i)));
    scene_.saw->world_from_tool =
        held * RigidTransform{rotation_about(axis, 0.16 * i),
                              Vec3(2.0 * std::sin(0.7 * i), 0.0, 5.0 * std::cos(1.3 * i))};
    expect_same(("held in way " + std::to_string(i)).c_str());
  }
}

TEST_F(KeptPictures, EachEyeHasItsOwnAndMayMissPictures) {
  for (int i = 0; i < 24; ++i) {
    saw_to(-5.9 + 0.2 * i);
    EXPECT_EQ(difference_of(kept(Eye::Left), anew(Eye::Left)), "") << i;
    // The other eye looks now and then, at last after more changes than are remembered.
    if (i > 4 && i < 23) continue;
    EXPECT_EQ(difference_of(kept(Eye::Right), anew(Eye::Right)), "") << i;
  }
}

TEST_F(KeptPictures, ARendererThatKeepsNothingDrawsTheSame) {
  const Pixels with = kept();
  renderer_.set_quality({.supersampling = 1});
  EXPECT_EQ(difference_of(kept(), with), "");
  EXPECT_GT(redrawn_, 0U);
}

TEST_F(KeptPictures, WhatAPassingPictureWasDrawnInIsLetGoWhileOthersAreDrawn) {
  const RenderQuality keeps = renderer_.quality();
  const RenderTarget target({32, 18});
  renderer_.draw(scene_, view(), target.target(), left_);
  const ObjectCensus alone = count_objects();
  renderer_.set_quality(still_quality);
  renderer_.draw(scene_, camera_, target.target());
  renderer_.set_quality(keeps);
  ASSERT_GT(count_objects().framebuffers, alone.framebuffers);
  for (int picture = 0; picture < 9; ++picture) {
    renderer_.draw(scene_, view(), target.target(), left_);
  }
  EXPECT_GT(count_objects().framebuffers, alone.framebuffers);
  renderer_.draw(scene_, view(), target.target(), left_);
  EXPECT_EQ(count_objects().framebuffers, alone.framebuffers);
  EXPECT_EQ(count_objects().textures, alone.textures);
  renderer_.draw(scene_, camera_, target.target());
  EXPECT_EQ(take_error(), 0U) << "it is made anew where it is wanted again";
}

// As an operation takes the place of a briefing's picture.
TEST_F(KeptPictures, WhatAPassingPictureWasDrawnInIsLetGoBeforeAKeptOneNeedsRoom) {
  const RenderTarget target({32, 18});
  const ObjectCensus nothing = count_objects();
  renderer_.draw(scene_, camera_, target.target());
  const ObjectCensus passing = count_objects();
  ASSERT_GT(passing.framebuffers, nothing.framebuffers);
  renderer_.draw(scene_, view(), target.target(), left_);
  // A kept picture has its smooth edges besides.
  EXPECT_LE(count_objects().framebuffers, passing.framebuffers + 1) << "one of them, not both";
  EXPECT_LE(count_objects().textures, passing.textures + 1);
}

}  // namespace
}  // namespace hallux::tests
