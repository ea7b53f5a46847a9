/// Takes pictures of the window without one: the whole course driven as by a person, drawn with OpenGL.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "tests/ui/app/course_window.h"
#include "ui/render/headless_context.h"
#include "ui/render/imgui_painter.h"
#include "ui/render/scene_painter.h"

namespace hallux::tests {

class Photographer {
 public:
  /// 1440 x 900 pixels. `folder` takes the pictures.
  Photographer(const std::filesystem::path& data_directory, std::filesystem::path folder,
               ui::ThemeName theme);

  ui::Driver& driver() { return window_->driver(); }
  ui::CourseWindow& window() { return *window_; }
  /// Signs out whoever is there, and in.
  void sign_in(const std::string& login, const std::string& password);
  /// Presses, and waits until what it leads to was read.
  void press(std::string_view id);
  /// Writes `name`.png as the window is now, with nothing under the pointer.
  void take(const std::string& name);

 private:
  void draw(ui::Shell& shell, ui::Ui& ui);

  ui::HeadlessContext context_;
  ui::RenderTarget target_;
  std::filesystem::path folder_;
  ui::OpenGlScenePainter scenes_;
  std::unique_ptr<ui::CourseWindow> window_;
  std::unique_ptr<ui::ImguiPainter> painter_;
};

}  // namespace hallux::tests
