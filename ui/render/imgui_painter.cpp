#include "ui/render/imgui_painter.h"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <stdexcept>

namespace hallux::ui {

ImguiPainter::ImguiPainter() {
  if (epoxy_gl_version() < 33)
    throw std::runtime_error(
        "The display offers no OpenGL 3.3; install a driver or use the software renderer "
        "(libgl1-mesa-dri)");
  if (!ImGui_ImplOpenGL3_Init("#version 330 core"))
    throw std::runtime_error("The widgets' painter does not start on this OpenGL");
  ImGui_ImplOpenGL3_NewFrame();
}

ImguiPainter::~ImguiPainter() { ImGui_ImplOpenGL3_Shutdown(); }

void ImguiPainter::draw(const ImDrawData& data, int fonts_version) {
  ImDrawData shown = data;
  if (fonts_version != fonts_version_) {
    // The data names the fonts' texture as it was when the frame began: none yet, or the one that goes now.
    const ImTextureID before = ImGui::GetIO().Fonts->TexID;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    fonts_version_ = fonts_version;
    for (int list = 0; list < shown.CmdListsCount; ++list)
      for (ImDrawCmd& command : shown.CmdLists[list]->CmdBuffer)
        if (command.TextureId == nullptr || command.TextureId == before)
          command.TextureId = ImGui::GetIO().Fonts->TexID;
  }
  ImGui_ImplOpenGL3_RenderDrawData(&shown);
}

void clear_framebuffer(int width, int height, std::uint8_t red, std::uint8_t green,
                       std::uint8_t blue) {
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(static_cast<float>(red) / 255.0F, static_cast<float>(green) / 255.0F,
               static_cast<float>(blue) / 255.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
}

std::vector<std::uint8_t> read_framebuffer(int width, int height) {
  const auto row = static_cast<std::size_t>(width) * 3U, rows = static_cast<std::size_t>(height);
  std::vector<std::uint8_t> upwards(row * rows), downwards(row * rows);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, upwards.data());
  for (std::size_t line = 0; line < rows; ++line)
    std::copy_n(upwards.begin() + static_cast<std::ptrdiff_t>((rows - 1 - line) * row), row,
                downwards.begin() + static_cast<std::ptrdiff_t>(line * row));
  return downwards;
}

}  // namespace hallux::ui
