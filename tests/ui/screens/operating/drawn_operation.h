/// An operation drawn with OpenGL as its window draws it, panels included, without a window.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "tests/ui/screens/operating/some_operation.h"
#include "ui/render/gl/headless_context.h"
#include "ui/render/imgui_painter.h"
#include "ui/render/picture.h"
#include "ui/render/scene_painter.h"

namespace hallux::ui {

class DrawnOperation {
 public:
  /// Before Begin was pressed; see OperableCourse.
  explicit DrawnOperation(const std::string& scenario, double edge_mm = 1.5,
                          PixelSize size = {1280, 720}, const std::string& vfs_name = {},
                          LendHands lend = some_mouse);

  Operator& person() noexcept { return person_; }
  OperableCourse& course() noexcept { return course_; }
  OpenGlScenePainter& scenes() noexcept { return scenes_; }
  std::size_t triangles() const noexcept { return scenes_.triangles(); }

  /// One frame at the clock's time, shown. Returns its milliseconds, to the last pixel.
  double frame();
  /// Makes frames until it holds, at most so long on the wall's clock.
  bool until(const std::function<bool()>& holds, double seconds = 60.0);
  void press(Key key, int times = 1, Modifiers modifiers = {});
  void click(std::string_view id);
  void move_to(Point place);
  /// What the last frame looks like.
  Pixels picture() const { return target_.read(); }
  /// Writes the next frame as `name`.png; nothing where the folder's name is empty.
  void take(const std::filesystem::path& folder, const std::string& name);

 private:
  HeadlessContext context_;
  RenderTarget target_;
  OpenGlScenePainter scenes_;
  OperableCourse course_;
  Operator person_;
  /// Once there is something of Dear ImGui.
  ImguiPainter painter_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace hallux::ui
