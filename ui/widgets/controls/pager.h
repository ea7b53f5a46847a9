/// Steps through what does not fit beside each other: an arrow back, "Operations 4 to 6 of 12", an
/// arrow on.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

/// A window of `shown` things, the first of them number `first` (from 0) of `count`.
struct PagerSpec {
  int first = 0, shown = 0, count = 0;
  /// What is shown: "Operations 4 to 6 of 12".
  std::string_view words = {};
  /// What the arrows do: "Earlier operations".
  std::string_view back = {}, on = {};
};

inline constexpr float pager_height = 36.0F;

/// Draws it at the right end of `line`, which should be `pager_height` high. The arrows are named
/// `id.back` and `id.on`; at an end the one that leads nowhere is disabled. Returns the first thing
/// to show from now on: the last page is full.
int pager(Ui& ui, std::string_view id, const Rect& line, const PagerSpec& spec);

}  // namespace hallux::ui
