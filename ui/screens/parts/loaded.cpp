#include "ui/screens/parts/loaded.h"

namespace hallux::ui {

bool draw_unread(Ui& ui, std::string_view id, const Rect& content, const std::string& reason) {
  const std::string_view why = reason.empty() ? ui.text("reading.stopped") : reason;
  return failed_card(ui, id, content, {ui.text("reading.failed"), why, ui.text("reading.again")});
}

}  // namespace hallux::ui
