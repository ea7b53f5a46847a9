// What rests is refined: measured on silhouettes, without a window.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/ui/render/graphics.h"
#include "tests/ui/render/operating_world.h"
#include "ui/render/refined_picture.h"
#include "ui/render/scene_painter.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr PixelSize size{480, 270};
constexpr RenderQuality no_pass{.supersampling = 1, .keeps_still = true},
    with_pass{.supersampling = 1, .keeps_still = true, .smooths_edges = true};
/// More than the pictures that rest before the first sample, and the samples.
constexpr int frames_at_rest = 40;

/// The channel that tells them best apart, in steps of 8 bits.
int step_between(const Colour& one, const Colour& other) {
  return std::max({std::abs(one.red - other.red), std::abs(one.green - other.green),
                   std::abs(one.blue - other.blue)});
}

/// Each pixel the mean of four.
Pixels halved(const Pixels& picture) {
  Pixels half{{picture.size.width / 2, picture.size.height / 2}, {}};
  const std::size_t row = std::size_t{4} * static_cast<std::size_t>(picture.size.width);
  for (int y = 0; y < half.size.height; ++y) {
    for (int x = 0; x < half.size.width; ++x) {
      for (std::size_t part = 0; part < 4; ++part) {
        const std::size_t at =
            2 * static_cast<std::size_t>(y) * row + 8 * static_cast<std::size_t>(x) + part;
        const int sum = picture.rgba[at] + picture.rgba[at + 4] + picture.rgba[at + row] +
                        picture.rgba[at + row + 4];
        half.rgba.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
    }
  }
  return half;
}

double mean_of(const Pixels& picture, std::size_t channel) {
  double sum = 0.0;
  for (std::size_t i = channel; i < picture.rgba.size(); i += 4) sum += picture.rgba[i];
  return 4.0 * sum / static_cast<double>(picture.rgba.size());
}

class Refined : public Graphics {
 protected:
  Refined() {
    world_.saw_to(-6.0);
    scene_ = world_.scene();
  }
  Pixels frame(const Camera& camera, bool is_touched = false) {
    painter_.begin_frame(window_.target(), is_touched);
    painter_.draw_behind(scene_, camera, {.mode = mode_});
    painter_.finish_frame({0, 0, 0}, [](float) {});
    return window_.read();
  }
  Pixels frame() { return frame(world_.camera()); }
  Pixels at_rest() {
    for (int i = 0; i < frames_at_rest; ++i) frame();
    EXPECT_FALSE(painter_.is_unfinished());
    return frame();
  }
  Pixels drawn_with(const RenderQuality& quality, const Scene& scene) {
    Renderer renderer(quality);
    KeptPicture kept;
    const RenderTarget target(size);
    const double aspect = static_cast<double>(size.width) / size.height;
    renderer.draw(scene, view_of(world_.camera(), Viewer{}, Eye::Middle, aspect), target.target(),
                  kept);
    return target.read();
  }
  /// With 64 samples a pixel.
  Pixels reference(const Scene& scene) {
    Renderer renderer(still_quality);
    const RenderTarget target({2 * size.width, 2 * size.height});
    renderer.draw(scene, world_.camera(), target.target());
    return halved(target.read());
  }

  OperatingWorld world_{0.9};
  Scene scene_ = world_.scene();
  const RenderTarget window_{size};
  StereoMode mode_ = StereoMode::Mono;
  OpenGlScenePainter painter_;
};

/// Pixels on both sides of an outline, of bone or saw, against the ground.
std::vector<std::pair<int, int>> outline_of(const Pixels& picture, const Pixels& ground) {
  const auto is_ground = [&](int x, int y) {
    return step_between(pixel_at(picture, x, y), pixel_at(ground, x, y)) == 0;
  };
  std::vector<std::pair<int, int>> outline;
  for (int y = 1; y < size.height - 1; ++y) {
    for (int x = 1; x < size.width - 1; ++x) {
      const bool is_here = is_ground(x, y);
      if (is_here != is_ground(x + 1, y) || is_here != is_ground(x - 1, y) ||
          is_here != is_ground(x, y + 1) || is_here != is_ground(x, y - 1))
        outline.emplace_back(x, y);
    }
  }
  return outline;
}

double error_along(const std::vector<std::pair<int, int>>& outline, const Pixels& picture,
                   const Pixels& reference) {
  double sum = 0.0;
  for (const auto& [x, y] : outline)
    sum += step_between(pixel_at(picture, x, y), pixel_at(reference, x, y));
  return sum / static_cast<double>(outline.size());
}

// The silhouettes of bones, and of the saw, on both grounds.
TEST_F(Refined, SilhouettesAreSmoothInMotionAndSmootherAtRest) {
  for (const bool has_saw : {false, true}) {
    for (const Ground ground : {Ground::Dark, Ground::Light}) {
      scene_ = world_.scene();
      scene_.planes.clear();
      scene_.lines.clear();
      scene_.ground = ground;
      if (has_saw) {
        scene_.bones.clear();
      } else {
        scene_.saw.reset();
      }
      Scene empty;
      empty.ground = ground;
      empty.light_place = scene_.light_place;
      const Pixels stairs = drawn_with(no_pass, scene_), smooth = drawn_with(with_pass, scene_);
      const auto outline = outline_of(stairs, drawn_with(no_pass, empty));
      ASSERT_GT(outline.size(), 200U);
      const Pixels wanted = reference(scene_);
      const double without = error_along(outline, stairs, wanted),
                   moving = error_along(outline, smooth, wanted),
                   resting = error_along(outline, at_rest(), wanted);
      const std::string of = std::string(has_saw ? "saw" : "bone") +
                             (ground == Ground::Dark ? " on dark" : " on light");
      RecordProperty(of + ", stairs", std::to_string(without));
      RecordProperty(of + ", in motion", std::to_string(moving));
      RecordProperty(of + ", at rest", std::to_string(resting));
      EXPECT_LT(moving, 0.75 * without);
      EXPECT_LT(resting, 0.5 * moving);
    }
  }
}

TEST_F(Refined, BrightnessAndPlaceStayAsTheyWereInMotion) {
  for (const StereoMode mode : {StereoMode::Mono, StereoMode::SideBySide, StereoMode::Anaglyph}) {
    mode_ = mode;
    frame();
    const Pixels moving = frame();
    Pixels before = moving;
    for (int i = 0; i < frames_at_rest; ++i) {
      const Pixels now = frame();
      for (std::size_t channel = 0; channel < 3; ++channel)
        ASSERT_NEAR(mean_of(now, channel), mean_of(moving, channel), 0.35) << i;
      before = now;
    }
    const auto picked = [](const Colour& colour) { return is_bone_coloured(colour); };
    const Facts then = facts_of(moving, picked), at_rest = facts_of(before, picked);
    if (mode == StereoMode::Anaglyph) continue;
    EXPECT_NEAR(then.x * size.width, at_rest.x * size.width, 0.3);
    EXPECT_NEAR(then.y * size.height, at_rest.y * size.height, 0.3);
  }
}

TEST_F(Refined, WhateverChangesIsShownInTheSameFrameAsIfNothingHadRested) {
  const std::vector<std::function<void()>> changes{
      [&] { scene_.saw->world_from_tool.translation_mm.y += 0.2; },
      [&] { scene_.bones.front().presence = 0.9; },
      [&] { scene_.ground = Ground::Light; },
      [&] { scene_.lines.clear(); },
      [&] { scene_.halo.emplace().world_from_tool = world_.world_from_tool(); },
      [&] { scene_.held = {world_.held()}; },
      [&] {
        scene_.chips.push_back({world_.camera().target_mm, 1.0F});
      },
      [&] { mode_ = StereoMode::SideBySide; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    for (const int frames : {2, 26}) {
      scene_ = world_.scene();
      mode_ = StereoMode::Mono;
      for (int k = 0; k < frames; ++k) frame();
      changes[i]();
      const Pixels shown = frame();
      EXPECT_TRUE(painter_.is_unfinished());
      OpenGlScenePainter other;
      other.begin_frame(window_.target());
      other.draw_behind(scene_, world_.camera(), {.mode = mode_});
      other.finish_frame({0, 0, 0}, [](float) {});
      EXPECT_EQ(window_.read().rgba, shown.rgba) << "change " << i << " after " << frames;
    }
  }
}

TEST_F(Refined, AViewThatTurnsLeavesRestAtOnce) {
  const Pixels resting = at_rest();
  frame(orbited(world_.camera(), 0.1, 0.0));
  EXPECT_TRUE(painter_.is_coarse());
  EXPECT_TRUE(painter_.is_unfinished());
  EXPECT_EQ(at_rest().rgba, resting.rgba) << "the same rest again";
}

TEST_F(Refined, AFrameThatAnswersKeepsWhatIsShownAndDrawsNoSample) {
  for (int i = 0; i < 26; ++i) frame();
  ASSERT_TRUE(painter_.is_unfinished());
  const Pixels before = frame();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(frame(world_.camera(), true).rgba, before.rgba);
}

TEST_F(Refined, AtRestNothingIsLeftButTheMean) {
  at_rest();
  const auto move = [&] {
    scene_.saw->world_from_tool.translation_mm.y += 0.2;
    frame();
  };
  move();
  const ObjectCensus moving = count_objects();
  at_rest();
  const ObjectCensus resting = count_objects();
  EXPECT_EQ(resting.framebuffers, moving.framebuffers + 1);
  EXPECT_EQ(resting.textures, moving.textures + 1);
  move();
  EXPECT_EQ(count_objects(), moving);
  EXPECT_EQ(take_error(), 0U);
}

// Each picture has four samples a pixel there, so that four pictures are enough.
TEST_F(Refined, WithMoreSamplesInEachPictureItTakesFewerPictures) {
  scene_.planes.clear();
  scene_.lines.clear();
  Scene empty;
  empty.light_place = scene_.light_place;
  const auto outline = outline_of(drawn_with(no_pass, scene_), drawn_with(no_pass, empty));
  const Pixels wanted = reference(scene_);
  painter_.set_quality({.supersampling = 2, .smooths_edges = true});
  const Pixels moving = frame();
  int samples = 0;
  Pixels before = moving, shown = moving;
  for (int i = 0; i < frames_at_rest; ++i) {
    shown = frame();
    samples += shown.rgba == before.rgba ? 0 : 1;
    before = shown;
  }
  EXPECT_EQ(samples, 3) << "after the first";
  EXPECT_FALSE(painter_.is_unfinished());
  EXPECT_LT(error_along(outline, shown, wanted), 0.7 * error_along(outline, moving, wanted));
}

TEST_F(Refined, APictureOfACardIsRefinedFromFrameToFrame) {
  const auto draw = [&](bool is_same) {
    painter_.begin_frame(window_.target());
    return is_same ? painter_.refine("bone", scene_, world_.camera(), size)
                   : painter_.draw("bone", scene_, world_.camera(), size);
  };
  EXPECT_EQ(draw(true), 0U) << "nothing is there";
  const std::uint64_t texture = draw(false);
  int frames = 0;
  while (!painter_.is_refined("bone") && frames < 100) {
    EXPECT_EQ(draw(true), texture);
    ++frames;
  }
  EXPECT_GE(frames, 16);
  EXPECT_LE(frames, frames_at_rest);
  EXPECT_TRUE(painter_.is_refined("unknown"));
  draw(false);
  EXPECT_FALSE(painter_.is_refined("bone"));
}

TEST(SamplePlaces, LieInThePixelAndAroundItsMiddle) {
  Vec2 sum(0.0, 0.0);
  for (int i = 0; i < samples_at_rest; ++i) {
    const Vec2 place = sample_place(i);
    EXPECT_LE(std::max(std::abs(place.x), std::abs(place.y)), 0.5);
    sum += place;
    if (i % 3 == 0) {
      EXPECT_LT(glm::length(sum), 0.01) << i;
    }
  }
}

}  // namespace
}  // namespace hallux::tests
