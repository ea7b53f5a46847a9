/// Words beside a thing: what an icon means, what a point of a chart is worth.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

/// A small panel with a value first and its context below (may be empty), beside `point` and inside
/// the display, never over the point itself.
void tooltip(Ui& ui, Point point, std::string_view value, std::string_view context);

/// The label of an icon, under the control, once the pointer has rested on it for half a second.
void tooltip_when_resting(Ui& ui, std::string_view id, const Rect& rect, std::string_view label);

/// Why a control is off: likewise, and at once where the focus ring is on it.
void tell_why_off(Ui& ui, std::string_view id, const Rect& rect, std::string_view why);

}  // namespace hallux::ui
