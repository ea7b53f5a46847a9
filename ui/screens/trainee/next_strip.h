/// A strip with the one thing to do next, its button, and a quieter one beside it.
/// Inside this corner only.
#pragma once

#include <string>
#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

struct NextStrip {
  Icon icon = Icon::Drill;
  std::string title;
  std::string_view sentence;
  /// Ids and labels; the quieter one may be empty.
  std::string_view go_id, go_label, aside_id = {}, aside_label = {};
  /// What Enter does.
  bool is_primary = true;
};

enum class NextAnswer { Waiting, Go, Aside };
NextAnswer draw_next_strip(Ui& ui, const Rect& strip, const NextStrip& next);

}  // namespace hallux::ui
