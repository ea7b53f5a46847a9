#include "ui/window/lost_display.h"

#include <X11/Xlib.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace hallux::ui {

namespace {

int exit_code_then = 1;

// Nothing may be allocated or locked here: the call came from within Xlib, whatever the program was
// doing.
int end_program(Display*) {
  constexpr std::string_view said =
      "hallux: the display is gone, and the window with it. What was recorded is kept; open the "
      "course again to see it, an attempt that was running is then marked as interrupted.\n";
  // Where nobody reads it there is nobody else to tell.
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, said.data(), said.size());
  std::_Exit(exit_code_then);
}

}  // namespace

void end_where_display_is_lost(int exit_code) noexcept {
  exit_code_then = exit_code;
  XSetIOErrorHandler(end_program);
}

}  // namespace hallux::ui
