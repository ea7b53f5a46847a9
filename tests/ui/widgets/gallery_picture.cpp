// Draws the gallery without a window into PNG files: gallery_picture FOLDER. To be looked at beside
// the style guide.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include "tests/ui/widgets/driver.h"
#include "tests/ui/widgets/gallery.h"
#include "ui/render/gl/headless_context.h"
#include "ui/render/imgui_painter.h"
#include "ui/render/picture.h"

namespace {

using namespace hallux::ui;

void draw_picture(const std::filesystem::path& folder, const std::string& name, ThemeName theme,
                  float scale, const Driver::Draw& draw, Point pointer,
                  float height_at_one = 900.0F) {
  const int width = static_cast<int>(std::lround(1440.0F * scale)),
            height = static_cast<int>(std::lround(height_at_one * scale));
  const HeadlessContext context;
  const RenderTarget target({width, height});
  const Texts texts = english_texts();
  DriverSetting setting{static_cast<float>(width), static_cast<float>(height), scale, theme};
  Driver driver(texts, draw, setting);
  driver.move_to(pointer);
  driver.wait(1.0);
  ImguiPainter painter;
  const BoundFramebuffer bound(target.target().framebuffer);
  painter.draw(driver.ui().draw_data(), driver.ui().fonts_version());
  const std::string file = name + (theme == ThemeName::Dark ? "-dark-" : "-light-") +
                           std::to_string(std::lround(scale * 100.0F)) + ".png";
  write_png(folder / file, target.read());
  std::printf("%s\n", (folder / file).c_str());
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: gallery_picture FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  for (const ThemeName theme : {ThemeName::Dark, ThemeName::Light})
    for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
      GalleryState components, parts, asked;
      draw_picture(folder, "components", theme, scale,
                   [&](Ui& ui) { draw_components(ui, components); }, {-9.0F, -9.0F});
      parts.people.chosen = {"person-1", "person-2"};
      parts.people.sort = {0, false};
      draw_picture(
          folder, "parts", theme, scale, [&](Ui& ui) { draw_larger_parts(ui, parts); },
          {700.0F, 780.0F}, 1434.0F);
      asked.has_question = true;
      if (scale == 1.0F)
        draw_picture(folder, "question", theme, scale, [&](Ui& ui) { draw_components(ui, asked); },
                     {-9.0F, -9.0F});
    }
  return 0;
}
