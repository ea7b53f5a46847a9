#include "ui/screens/pictures/patient_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <map>
#include <thread>

#include "simulator/base/progress.h"
#include "tests/ui/screens/no_patient.h"
#include "tests/ui/screens/some_navigator.h"
#include "tests/ui/screens/some_published.h"
#include "tests/ui/screens/some_visitor.h"
#include "ui/render/scene_painter.h"
#include "ui/screens/sign_in/sign_in_screen.h"
#include "ui/screens/trainee/briefing_screen.h"
#include "ui/screens/trainee/operations_screen.h"

namespace hallux::ui {
namespace {

using testing::ElementsAre;

/// Notes what it was asked to draw, and keeps it as the real one does.
class NotingPainter : public ScenePainter {
 public:
  std::uint64_t draw(std::string_view name, const Scene&, const Camera& camera,
                     PixelSize size) override {
    drawn_names.emplace_back(name);
    cameras[std::string(name)] = camera;
    sizes_[std::string(name)] = size;
    return 1;
  }
  std::uint64_t drawn(std::string_view name, PixelSize size) override {
    const auto known = sizes_.find(std::string(name));
    return known != sizes_.end() && known->second == size ? 1 : 0;
  }
  std::uint64_t show(std::string_view, std::shared_ptr<const Pixels>) override { return 0; }
  void draw_behind(const Scene&, const Camera&, const StereoSetting&) override {}
  std::size_t triangles() const noexcept override { return 0; }

  std::vector<std::string> drawn_names;
  std::map<std::string, Camera> cameras;

 private:
  std::map<std::string, PixelSize> sizes_;
};

/// A screen in front of a painter; work ends when the test lets it.
class Gallery {
 public:
  explicit Gallery(std::unique_ptr<Screen> screen)
      : driver(texts_, [this](Ui& ui) { shell.draw(ui, painter); }) {
    shell.preferences().is_motion_reduced = true;
    shell.push(std::move(screen));
    driver.frame();
    driver.settle();
  }
  void finish_work() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!shell.background().is_idle() && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      driver.frame();
    }
    driver.frame();
    driver.settle();
  }

  Shell shell;
  NotingPainter painter;

 private:
  const Texts texts_ = english_texts();

 public:
  Driver driver;
};

/// Builds once it is told to.
struct HeldBuild {
  std::atomic<bool> may_end{false};

  PatientPictures::Build build() {
    return [this](const scenarios::Scenario& scenario, const Progress& progress) {
      while (!may_end) {
        if (!progress(0.5)) throw scenarios::ScenarioError("cancelled");
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      return no_patient(scenario, progress);
    };
  }
};

TEST(PatientPictures, TheFormNeverWaitsForTheBoneBesideIt) {
  database::SomeCourse course;
  HeldBuild held;
  PatientPictures pictures{held.build()};
  std::shared_ptr<SignedInSession> signed_in;
  Gallery gallery(std::make_unique<SignInScreen>(
      course.database().directory(),
      [&](Shell&, std::shared_ptr<SignedInSession> in) { signed_in = std::move(in); },
      database::cheap, &pictures));
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!gallery.driver.has("entry.login") && std::chrono::steady_clock::now() < end) {
    gallery.driver.frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  gallery.driver.wait(1.0);
  EXPECT_THAT(gallery.painter.drawn_names, ElementsAre("entry.ground.dark"));
  for (const Widget& widget : gallery.driver.content().widgets) {
    EXPECT_NE(widget.id.substr(0, 5), "work.") << "nobody waits for it, so it is not shown";
  }
  gallery.driver.type("ada");
  gallery.driver.press(Key::Tab);
  gallery.driver.type(database::good_password);
  gallery.driver.press(Key::Enter);
  while (signed_in == nullptr && std::chrono::steady_clock::now() < end) {
    gallery.driver.frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_NE(signed_in, nullptr);
  held.may_end = true;
  gallery.finish_work();
  EXPECT_THAT(gallery.painter.drawn_names, ElementsAre("entry.ground.dark", "entry.bone.dark"));
}

TEST(PatientPictures, ACardIsDrawnOnceAndAnewOnAnotherGround) {
  SomePublished published;
  SomeNavigator places;
  PatientPictures pictures{no_patient};
  Gallery gallery(
      std::make_unique<OperationsScreen>(visit_of(published.course(), "ada"), places, pictures));
  gallery.finish_work();
  gallery.driver.wait(1.0);
  EXPECT_THAT(gallery.painter.drawn_names, ElementsAre("operations.akin.dark"));
  gallery.shell.preferences().theme = ThemeName::Light;
  gallery.driver.frame();
  gallery.driver.settle();
  EXPECT_THAT(gallery.painter.drawn_names,
              ElementsAre("operations.akin.dark", "operations.akin.light"));
}

TEST(PatientPictures, OneBuildServesAllScreens) {
  SomePublished published;
  SomeNavigator places;
  int builds = 0;
  PatientPictures pictures{[&](const auto& scenario, const auto& progress) {
    ++builds;
    return no_patient(scenario, progress);
  }};
  const auto signed_in = visit_of(published.course(), "ada");
  Gallery gallery(std::make_unique<OperationsScreen>(signed_in, places, pictures));
  gallery.finish_work();
  gallery.shell.push(
      std::make_unique<BriefingScreen>(signed_in, places, pictures, published.akin()));
  gallery.driver.frame();
  gallery.finish_work();
  EXPECT_TRUE(gallery.driver.has("brief.picture"));
  EXPECT_EQ(builds, 1);
}

}  // namespace
}  // namespace hallux::ui
