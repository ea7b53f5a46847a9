/// Draws what the widgets made, into the current OpenGL framebuffer.
#pragma once

struct ImDrawData;

namespace hallux::ui {

/// One for each OpenGL context; it keeps the fonts' picture and the shaders there.
class ImguiPainter {
 public:
  /// needs   a current OpenGL 3.3 core context and a current ImGui context, both until it is
  ///         destroyed
  /// errors  std::runtime_error where the context is too old
  ImguiPainter();
  ImguiPainter(const ImguiPainter&) = delete;
  ImguiPainter& operator=(const ImguiPainter&) = delete;
  ~ImguiPainter();

  /// Draws over what the framebuffer holds. `fonts_version` is that of the fonts the data was made
  /// with; where it changed, their picture is uploaded anew. `columns` is the share of the window's
  /// columns that the framebuffer has: an eye's picture may be narrower.
  void draw(const ImDrawData& data, int fonts_version, float columns = 1.0F);

 private:
  int fonts_version_ = 0;
};

}  // namespace hallux::ui
