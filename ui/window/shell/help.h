/// F1: every shortcut that works on the screen, with its key. Inside this corner only.
#pragma once

#include <string>

#include "ui/widgets/ui.h"

namespace hallux::ui {

/// The keys as they are printed: "Ctrl+Shift+Z".
std::string chord_text(const Texts& texts, Chord chord);

/// A panel over the screen. True where it was closed, by its button `help.close` or Esc.
bool draw_shortcut_list(Ui& ui);

}  // namespace hallux::ui
