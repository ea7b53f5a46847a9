/// Draws what the widgets made, into the current OpenGL framebuffer, and reads pictures back.
#pragma once

#include <cstdint>
#include <vector>

struct ImDrawData;

namespace hallux::ui {

/// One for each OpenGL context; it keeps the fonts' picture and the shaders there.
class ImguiPainter {
 public:
  /// needs   a current OpenGL 3.3 core context and a current ImGui context, both until it is destroyed
  /// errors  std::runtime_error where the context is too old
  ImguiPainter();
  ImguiPainter(const ImguiPainter&) = delete;
  ImguiPainter& operator=(const ImguiPainter&) = delete;
  ~ImguiPainter();

  /// Draws over what the framebuffer holds. `fonts_version` is that of the fonts the data was made with; where it
  /// changed, their picture is uploaded anew.
  void draw(const ImDrawData& data, int fonts_version);

 private:
  int fonts_version_ = 0;
};

/// Fills the current framebuffer of `width` x `height` device pixels with one opaque colour, 0-255 each.
void clear_framebuffer(int width, int height, std::uint8_t red, std::uint8_t green,
                       std::uint8_t blue);

/// The current framebuffer as rows of RGB from the top, 3 * width * height bytes.
std::vector<std::uint8_t> read_framebuffer(int width, int height);

}  // namespace hallux::ui
