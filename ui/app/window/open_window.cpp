#include "ui/app/window/open_window.h"

#include "ui/app/window/course.h"
#include "ui/app/window/window_preferences.h"
#include "ui/window/lost_display.h"
#include "ui/window/window.h"

namespace hallux::ui {

ExitCode open_window(const VerbContext& context,
                     const std::optional<std::filesystem::path>& ui_map) {
  const Texts texts = english_texts();
  WindowSetting setting;
  setting.ui_map = ui_map;
  try {
    Window window(texts, setting);
    end_where_display_is_lost(static_cast<int>(ExitCode::NoDisplay));
    Shell shell(Window::wake);
    const Course course(texts, context.data_directory, shell);
    const PreferenceKeeper keeper(texts, context.data_directory, shell);
    window.run(shell);
  } catch (const WindowError& error) {
    throw VerbError(ExitCode::NoDisplay, error.what());
  }
  return ExitCode::Done;
}

}  // namespace hallux::ui
