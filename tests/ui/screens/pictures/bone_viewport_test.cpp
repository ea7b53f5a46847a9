#include "ui/screens/pictures/bone_viewport.h"

#include <gtest/gtest.h>

#include "tests/ui/widgets/driver.h"

namespace hallux::ui {
namespace {

/// Counts what it is asked for; a picture is refined with its third sample.
class CountingPainter final : public NoScenePainter {
 public:
  std::uint64_t draw(std::string_view, const Scene&, const Camera&, PixelSize) override {
    ++pictures;
    samples = 0;
    return 1;
  }
  std::uint64_t refine(std::string_view, const Scene&, const Camera&, PixelSize) override {
    ++refined;
    ++samples;
    return 1;
  }
  bool is_refined(std::string_view) const noexcept override { return samples >= 3; }

  int pictures = 0, refined = 0, samples = 0;
};

/// A view of nothing, over all of the window.
class ViewScreen final : public Screen {
 public:
  ViewScreen() { view.look_at(Vec3(0.0, 0.0, 0.0), 20.0, StandardView::Medial); }
  GuideSection guide_section() const override { return GuideSection::Overview; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override {
    view.draw(ui, shell, content, scene, {"view", "View", revision});
  }

  BoneViewport view;
  Scene scene;
  std::uint64_t revision = 1;
};

class Viewport : public testing::Test {
 protected:
  Viewport() {
    auto screen = std::make_unique<ViewScreen>();
    screen_ = screen.get();
    shell_.preferences().is_motion_reduced = true;
    shell_.push(std::move(screen));
    driver_.frame();
    driver_.settle();
  }

  const Texts texts_ = english_texts();
  CountingPainter painter_;
  Shell shell_;
  ViewScreen* screen_ = nullptr;
  Driver driver_{texts_, [this](Ui& ui) { shell_.draw(ui, painter_); }};
};

TEST_F(Viewport, IsRefinedFrameByFrameUntilNothingIsDueAnyMore) {
  EXPECT_EQ(painter_.pictures, 1);
  EXPECT_EQ(painter_.samples, 3);
  EXPECT_GT(driver_.ui().next_frame_in_s(), 1.0);
}

TEST_F(Viewport, WhatChangesIsDrawnInThatFrame) {
  screen_->revision = 2;
  driver_.frame();
  EXPECT_EQ(painter_.pictures, 2);
  EXPECT_EQ(painter_.samples, 0);
  driver_.press(Key::Digit4);
  EXPECT_EQ(painter_.pictures, 3);
  EXPECT_EQ(painter_.samples, 3) << "and refined again";
}

}  // namespace
}  // namespace hallux::ui
