/// Every control in every state on one screen, drawn by the same code as the screens: to look at
/// and to test.
#pragma once

#include <string>

#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/table.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

struct GalleryState {
  std::string search, login = "trainee", wrong = "trainee 66", disabled = "trainee-12",
                      secret = "geheim", note;
  int segment = 0, tab = 0, page = 0;
  bool is_checked = true, is_unchecked = false, is_on = true, is_off = false;
  TableState people;
  bool has_menu = false, has_question = false;
  int presses = 0;
};

/// The components of look.md's picture, laid out for 1440 x 900; scrolls where the display is
/// smaller.
void draw_components(Ui& ui, GalleryState& state);
/// Navigation, lists, picture cards, score and charts.
void draw_larger_parts(Ui& ui, GalleryState& state);

}  // namespace hallux::ui
