/// Messages of what happened, and work that runs with its Cancel. Both come in two widths: beside
/// the words of a page, and narrow under the places of the navigation.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

/// What happened, its detail, an action (either may be empty) and a close.
struct Toast {
  Meaning meaning = Meaning::Good;
  std::string_view title = {}, detail = {}, action = {};
};
enum class ToastAnswer : std::uint8_t { Waiting, Action, Closed };
inline constexpr float toast_width = 400.0F, toast_height = 64.0F;
/// Below this width the words stand under each other.
inline constexpr float narrow_toast_below = 320.0F;

/// The height in which title and detail have room for all their lines; at least 64.
float toast_height_for(const Ui& ui, const Toast& toast, float width);
/// Controls are `id`, `id.action` and `id.close`.
ToastAnswer toast(Ui& ui, std::string_view id, const Rect& rect, const Toast& toast);

/// Work that runs: its name, a thin bar and Cancel. `time_left` is empty below ten seconds.
struct RunningWork {
  std::string_view label = {}, time_left = {};
  float share = 0.0F;
};
float progress_height_for(const Ui& ui, const RunningWork& work, float width);
/// True where Cancel was pressed, named `id.cancel`.
bool progress(Ui& ui, std::string_view id, const Rect& rect, const RunningWork& work);

}  // namespace hallux::ui
