/// An OpenGL context and a framebuffer without window or display, to look at what the widgets draw.
#pragma once

#include <cstdint>
#include <vector>

namespace hallux::ui {

class Offscreen {
 public:
  /// errors  std::runtime_error where EGL offers no surfaceless OpenGL 3.3
  Offscreen(int width, int height);
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;
  ~Offscreen();

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace hallux::ui
