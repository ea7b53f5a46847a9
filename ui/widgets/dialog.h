/// A form over everything: a few fields, the safe answer and the verb.
#pragma once

#include <functional>
#include <string_view>

#include "ui/widgets/menu.h"

namespace hallux::ui {

struct Dialog {
  std::string_view title = {}, sentence = {};
  std::string_view act = {};    ///< the verb: "Pin note"
  std::string_view keep = {};   ///< the way out: "Cancel"
  std::string_view error = {};  ///< why the last try failed; empty: nothing is wrong
  float form_height = 0.0F;     ///< that the fields need; where there is less room they scroll
  bool is_busy = false;         ///< the work that it began still runs
  bool is_dangerous = false;
};

/// Draws it with the fields that `draw_form` draws into the place it is given; it answers false where something is still
/// missing, so that the verb cannot be pressed. Buttons are named `id.act`, which Enter presses (Ctrl+Enter in a field of
/// several lines), and `id.keep`, which Esc presses.
Answer dialog(Ui& ui, std::string_view id, const Dialog& shown,
              const std::function<bool(const Rect& form)>& draw_form);

}  // namespace hallux::ui
