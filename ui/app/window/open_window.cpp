#include "ui/app/window/open_window.h"

#include "ui/app/terminal/freed_memory.h"
#include "ui/app/terminal/interrupt.h"
#include "ui/app/window/course.h"
#include "ui/app/window/window_preferences.h"
#include "ui/jobs/files/output_file.h"
#include "ui/window/lost_display.h"
#include "ui/window/window.h"

namespace hallux::ui {

namespace {

WindowSetting setting_of(const VerbContext& context,
                         const std::optional<std::filesystem::path>& ui_map) {
  WindowSetting setting;
  setting.is_asked_to_end = is_interrupted;
  if (!ui_map) return setting;
  check_output(*ui_map, ui_map_page, context.data_directory);
  setting.write_ui_map = [file = *ui_map, data = context.data_directory](const std::string& json) {
    write_output(file, json, ui_map_page, data);
  };
  return setting;
}

}  // namespace

ExitCode open_window(const VerbContext& context,
                     const std::optional<std::filesystem::path>& ui_map) {
  give_freed_memory_back();
  const Texts texts = english_texts();
  try {
    Window window(texts, setting_of(context, ui_map));
    end_where_display_is_lost(static_cast<int>(ExitCode::NoDisplay));
    Shell shell(Window::wake);
    const Course course(texts, context.data_directory, shell);
    const PreferenceKeeper keeper(texts, context.data_directory, shell);
    const InterruptAlarm alarm(Window::wake);
    window.run(shell);
  } catch (const WindowError& error) {
    throw VerbError(ExitCode::NoDisplay, error.what());
  }
  if (!is_interrupted()) return ExitCode::Done;
  throw VerbError(ExitCode::Interrupted,
                  "the window was closed by the system; what was recorded is kept, an attempt that "
                  "was running is interrupted");
}

}  // namespace hallux::ui
