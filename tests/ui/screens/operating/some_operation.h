/// Operations of the window without a window: a course with coarse patients, a screen driven frame
/// by frame, and a painter that keeps what it was asked to draw.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "simulator/base/progress.h"
#include "tests/database/some_course.h"
#include "tests/ui/screens/some_navigator.h"
#include "tests/ui/widgets/driver.h"
#include "ui/render/scene_painter.h"
#include "ui/screens/operating/operating_screen.h"

namespace hallux::ui {

/// Keeps facts of the scene that lay behind the last frame.
class NotedScenes : public NoScenePainter {
 public:
  void draw_behind(const Scene& scene, const Camera& seen_from,
                   const StereoSetting& setting) override;
  std::size_t triangles() const noexcept override { return 1234; }

  int pictures = 0;
  std::size_t bones = 0, planes = 0, lines = 0, chips = 0;
  /// 0: no patch.
  std::size_t patch_triangles = 0;
  std::optional<SawInScene> saw;
  Camera camera;
  StereoSetting stereo;
};

/// A course in which a coarse patient of a shipped scenario is published. Ada comes through
/// SQLite's file system `vfs_name`, where it names one.
class OperableCourse {
 public:
  explicit OperableCourse(const std::string& scenario, double edge_mm = 1.5,
                          std::string vfs_name = {});

  database::SomeCourse& course() noexcept { return course_; }
  database::ScenarioVersionId version() const noexcept { return version_; }
  std::shared_ptr<SignedInSession> visit_of_ada();
  /// The one attempt there is, as it is stored now.
  database::AttemptHeader attempt();
  /// Where there are several.
  database::AttemptHeader newest_attempt();
  /// Bone and plan, laid out as for whoever operates.
  std::shared_ptr<const PreparedCase> prepared_case(SignedInSession& signed_in);

 private:
  database::SomeCourse course_;
  database::ScenarioVersionId version_;
  std::string vfs_name_;
};

/// Waits until it holds, at most a minute.
bool soon(const std::function<bool()>& holds);
/// For jobs of which nobody hears how far they are.
Progress no_progress(const std::string& stage);

/// Where operations get their device from.
LentHands some_mouse(const HandStart& start, const Progress& progress);

/// Ada before the operating screen, over a screen to come back to. Another painter may stand in for
/// the one that notes; it must have begun a frame whenever one is made.
class Operator {
 public:
  Operator(OperableCourse& course, database::AttemptKind kind, float scale = 1.0F,
           Point size = {1440.0F, 900.0F}, ScenePainter* painter = nullptr,
           LendHands lend = some_mouse);
  /// Before any screen, made with nothing to wait for.
  explicit Operator(std::unique_ptr<Screen> screen, float scale = 1.0F,
                    Point size = {1440.0F, 900.0F});
  ~Operator();

  /// Presses Begin and waits until the loop runs.
  void begin();
  /// Makes frames until it holds, at most so long on the wall's clock.
  bool until(const std::function<bool()>& holds, double seconds = 30.0);
  void make_frames(int count);
  /// Presses a key once without waiting: a running operation never settles.
  void press(Key key, Modifiers modifiers = {});
  /// Lifts the hand first where the saw has the pointer, as a person does.
  void click(std::string_view id);
  /// Leads the saw where it has the pointer, else moves that.
  void move_to(Point place);
  bool is_gone() const noexcept { return shell().depth() == 1; }
  /// Takes the screen away as the end of the window does.
  void close() { shell_.reset(); }

  Driver& driver() noexcept { return *driver_; }
  const Driver& driver() const noexcept { return *driver_; }
  const Shell& shell() const noexcept { return *shell_; }
  Shell& shell() noexcept { return *shell_; }

  SomeNavigator navigator;
  NotedScenes scenes;

 private:
  void open(std::unique_ptr<Screen> screen, float scale, Point size, ScenePainter* painter);

  std::unique_ptr<Shell> shell_ = std::make_unique<Shell>();
  const Texts texts_ = english_texts();
  std::unique_ptr<Driver> driver_;
};

}  // namespace hallux::ui
