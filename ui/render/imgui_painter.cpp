#include "ui/render/imgui_painter.h"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <stdexcept>

namespace hallux::ui {

namespace {

/// The letters in colours were sent; where others come, they are made again from their coverage.
void forget_colours(ImFontAtlas& fonts) {
  if (fonts.TexPixelsAlpha8 == nullptr) return;
  IM_FREE(fonts.TexPixelsRGBA32);
  fonts.TexPixelsRGBA32 = nullptr;
}

}  // namespace

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

void ImguiPainter::draw(const ImDrawData& data, int fonts_version, float columns) {
  ImDrawData shown = data;
  shown.FramebufferScale.x *= columns;
  if (fonts_version != fonts_version_) {
    // The data names the fonts' texture as it was when the frame began: none yet, or the one that
    // goes now.
    const ImTextureID before = ImGui::GetIO().Fonts->TexID;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    forget_colours(*ImGui::GetIO().Fonts);
    fonts_version_ = fonts_version;
    for (int list = 0; list < shown.CmdListsCount; ++list)
      for (ImDrawCmd& command : shown.CmdLists[list]->CmdBuffer)
        if (command.TextureId == nullptr || command.TextureId == before)
          command.TextureId = ImGui::GetIO().Fonts->TexID;
  }
  ImGui_ImplOpenGL3_RenderDrawData(&shown);
}

}  // namespace hallux::ui
