/// OpenGL without a window or a display: for pictures in files and reports, and for tests.
#pragma once

#include <string>

namespace hallux::ui {

class HeadlessContext {
 public:
  /// Makes an OpenGL 3.3 core context without a surface and makes it the calling thread's current
  /// one. There is no framebuffer 0 to draw into: draw into a RenderTarget.
  /// errors  GraphicsError where EGL, its surfaceless platform or OpenGL 3.3 is missing
  HeadlessContext();
  /// Every object made in it must be gone by then.
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

/// What draws: "llvmpipe (LLVM 15.0.6, 256 bits)", "NVIDIA ...".
/// needs   a current context
std::string renderer_name();
/// Whether the processor draws: then the picture must be made with less (see RenderQuality).
/// needs   a current context
bool is_software_renderer();

}  // namespace hallux::ui
