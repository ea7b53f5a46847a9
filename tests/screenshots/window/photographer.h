/// Takes pictures of the window without one: the whole course driven as by a person, drawn with
/// OpenGL.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "tests/ui/app/window/course_window.h"
#include "ui/render/gl/headless_context.h"
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
  /// A key in a frame of its own, where the screen never comes to rest: while somebody operates.
  void key(ui::Key key, ui::Modifiers modifiers = {});
  /// Makes frames in real time until `is_so`.
  /// errors  std::runtime_error, with `what`, where it is not so within two minutes
  void wait_until(const std::string& what, const std::function<bool()>& is_so);
  /// Lets real time pass, in which what runs beside the window goes on.
  void work_for(double seconds);
  /// The id of the first widget whose id begins with `beginning`.
  /// errors  std::runtime_error where there is none
  std::string first(std::string_view beginning);
  /// Writes `name`.png as the window is now, with nothing under the pointer, once whatever fades in
  /// has done so.
  void take(const std::string& name);
  /// The same at once: while somebody operates.
  void take_now(const std::string& name);

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
