// Opens the gallery in a real window: gallery_window [--ui-map FILE] [--picture FILE] [--report
// FILE]. The report, written when the window closes, holds what was typed, pressed and drawn.
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

#include "tests/ui/widgets/gallery.h"
#include "ui/window/shell/shell.h"
#include "ui/window/window.h"

namespace {

using namespace hallux::ui;

class GalleryScreen : public Screen {
 public:
  GalleryScreen(GalleryState& state, Window& window) : state_(state), window_(window) {}
  GuideSection guide_section() const override { return GuideSection::Overview; }
  WindowChrome surround() const override { return WindowChrome::Nothing; }
  void draw(Ui& ui, const Rect&, Shell&) override {
    draw_components(ui, state_);
    if (ui.shortcut({Key::F2}, "Larger parts")) state_.page = 1 - state_.page;
    if (ui.shortcut({Key::F10}, "Close")) window_.close();
  }

 private:
  GalleryState& state_;
  Window& window_;
};

std::string argument(int count, char** arguments, const std::string& name) {
  for (int number = 1; number + 1 < count; ++number)
    if (arguments[number] == name) return arguments[number + 1];
  return {};
}

int run(int count, char** arguments) {
  const Texts texts = english_texts();
  WindowSetting setting{"Gallery"};
  if (const std::string map = argument(count, arguments, "--ui-map"); !map.empty())
    setting.write_ui_map = [map](const std::string& json) {
      std::ofstream(map + ".new") << json;
      std::filesystem::rename(map + ".new", map);
    };
  Window window(texts, setting);
  GalleryState state;
  Shell shell(Window::wake);
  shell.push(std::make_unique<GalleryScreen>(state, window));
  if (const std::string picture = argument(count, arguments, "--picture"); !picture.empty())
    window.keep_picture(picture);
  window.run(shell);
  if (const std::string report = argument(count, arguments, "--report"); !report.empty())
    std::ofstream(report) << "search=" << state.search << "\nsegment=" << state.segment
                          << "\npresses=" << state.presses
                          << "\nscale=" << shell.preferences().scale
                          << "\nframes=" << window.frames() << "\n";
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return run(count, arguments);
  } catch (const WindowError& fault) {
    std::fprintf(stderr, "%s\n", fault.what());
    return 7;
  }
}
