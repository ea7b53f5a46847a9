/// F1: every movement and shortcut that works on the screen, with its mouse and its keys, from what
/// the screen has bound. Inside this corner only.
#pragma once

#include <string>
#include <vector>

#include "ui/widgets/ui.h"

namespace hallux::ui {

/// The keys as they are printed: "Ctrl+Shift+Z".
std::string chord_text(const Texts& texts, Chord chord);

/// One thing that can be done, with all ways to do it.
struct HelpRow {
  std::string label;
  std::vector<std::string> keys;
  /// What the mouse does for it; "" where it does nothing.
  std::string mouse;
};

/// What the mouse does comes first, in the order in which the screen bound it; then what only keys
/// do, in theirs.
std::vector<HelpRow> help_rows(const Texts& texts, const std::vector<Shortcut>& shortcuts,
                               const std::vector<MouseGesture>& gestures);

enum class HelpAnswer { Waiting, Close, Guide };

/// A panel over the screen, closed by its button `help.close` or Esc. Where there is a guide,
/// `help.guide` or F1 leads to it.
HelpAnswer draw_shortcut_list(Ui& ui, bool has_guide);

}  // namespace hallux::ui
