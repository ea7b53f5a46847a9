// Pictures of operating to look at: show_operating_pictures FOLDER
//
// Each mode of stereo, light and dark, what a pause and a refusal say, and what is left where the
// disk is full.
#include <sqlite3.h>

#include <cstdio>

#include "tests/support/faulty_vfs.h"
#include "tests/ui/screens/operating/drawn_operation.h"

namespace {

using namespace hallux;
using namespace hallux::ui;

InputEvent event_of(EventKind kind) {
  InputEvent event;
  event.kind = kind;
  return event;
}

void begin_sawing(DrawnOperation& operation) {
  operation.press(Key::Enter);
  operation.until([&] { return operation.person().driver().has("operate.pause"); });
  operation.press(Key::Digit3);
  operation.press(Key::PageUp, 5);
  operation.press(Key::Space);
  operation.press(Key::Down, 40);
  operation.press(Key::Digit1);
  for (int i = 0; i < 60; ++i) operation.frame();
}

void show_stereo(DrawnOperation& operation, const std::filesystem::path& folder,
                 const std::string& theme) {
  const auto mode = [&](const std::string& name) {
    operation.take(folder, theme + "-" + name);
    operation.press(Key::F9);
  };
  mode("mono");
  operation.move_to({1000.0F, 640.0F});
  mode("side-by-side");
  mode("anaglyph");
}

}  // namespace

int main(int count, char** arguments) {
  testing::InitGoogleTest(&count, arguments);
  if (count < 2) {
    std::fprintf(stderr, "usage: show_operating_pictures FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  tests::FaultyVfs vfs{"pictures"};
  DrawnOperation operation("silver", 0.6, {1440, 900}, vfs.name());
  Preferences& preferences = operation.person().shell().preferences();
  operation.take(folder, "dark-ready");
  begin_sawing(operation);
  show_stereo(operation, folder, "dark");
  preferences.theme = ThemeName::Light;
  operation.frame();
  show_stereo(operation, folder, "light");
  operation.person().driver().send({event_of(EventKind::FocusLost)});
  operation.frame();
  operation.take(folder, "light-paused");
  preferences.theme = ThemeName::Dark;
  operation.frame();
  operation.person().shell().may_leave(operation.person().driver().ui());
  operation.press(Key::F9);
  operation.take(folder, "dark-side-by-side-refused");
  operation.press(Key::F9, 2);
  operation.take(folder, "dark-refused");
  operation.press(Key::P);
  operation.press(Key::End);
  operation.take(folder, "dark-question");
  operation.press(Key::Escape);
  vfs.fail_after(0, SQLITE_FULL);
  operation.until([&] { return operation.person().driver().has("operate.full.stop"); });
  operation.take(folder, "dark-full");
  preferences.theme = ThemeName::Light;
  operation.frame();
  operation.take(folder, "light-full");
  return 0;
}
