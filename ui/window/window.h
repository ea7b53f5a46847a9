/// The real window: GLFW, an OpenGL 3.3 core context, and frames only when something is to be
/// shown.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "ui/widgets/look/theme.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {

class Shell;

/// There is no display, or none with OpenGL 3.3; says what to do.
class WindowError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct WindowSetting {
  std::string title = "Hallux";
  /// Logical pixels.
  int width = 1440, height = 900;
  /// Keeps what the window shows, while it is open; see ui_map.h.
  std::function<void(const std::string& json)> write_ui_map = {};
  /// Whether the system asked for the end; the window is woken where that changes.
  bool (*is_asked_to_end)() noexcept = []() noexcept { return false; };
};

class Window {
 public:
  /// Opens the window and makes its context current.
  /// errors  WindowError
  Window(const Texts& texts, const WindowSetting& setting);
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window();

  /// Shows the shell until the window is closed or close() is called, and a screen that may not be
  /// left now says why instead; or until the system asks for the end, at once. An idle window waits
  /// and costs next to nothing.
  /// needs   the shell and what its screens keep on the graphics card end before the window
  /// thread  the one that opened the window
  /// errors  std::runtime_error where the map of the window cannot be written
  void run(Shell& shell);

  /// Asks for the end of run() after the frame, as the desktop does.
  void close() noexcept;
  /// Keeps the next frame as a PNG file.
  void keep_picture(std::filesystem::path file);
  /// Brings the window to draw a frame.
  /// thread  any
  static void wake() noexcept;
  /// Frames drawn so far.
  long frames() const noexcept;

 private:
  void wait_for_frame();
  void draw_frame(Shell& shell);
  void settle_pointer(Shell& shell);
  void update_map();
  bool is_closing(Shell& shell);

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hallux::ui
