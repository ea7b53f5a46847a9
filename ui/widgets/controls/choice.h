/// Choosing: segmented control, tabs, checkbox, toggle, filter pills.
#pragma once

#include <span>
#include <string_view>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

inline constexpr float segmented_height = 36.0F, tabs_height = 40.0F, tab_gap = 28.0F;

/// One of a few, side by side: a track with a thumb. True where `chosen` changed. Options are named
/// `id.0`, `id.1` ...
bool segmented(Ui& ui, std::string_view id, const Rect& rect,
               std::span<const std::string_view> labels, int& chosen);
/// The width in which every label has 16 px on both sides.
float segmented_width(const Ui& ui, std::span<const std::string_view> labels);

/// One page of a card: underlined words over a hairline. True where `chosen` changed. Tabs are
/// named `id.0`, `id.1` ...
bool tabs(Ui& ui, std::string_view id, const Rect& rect, std::span<const std::string_view> labels,
          int& chosen);

/// 18 x 18 with its words to the right, all of it to press; `why_off` as of a button. True where
/// `is_on` changed.
bool checkbox(Ui& ui, std::string_view id, const Rect& rect, std::string_view label, bool& is_on,
              bool is_label_shown = true, std::string_view why_off = {});
/// 36 x 20 with its words to the right: takes effect at once.
bool toggle(Ui& ui, std::string_view id, const Rect& rect, std::string_view label, bool& is_on,
            bool is_label_shown = true, std::string_view why_off = {});

/// A pill to press, 24 high: chosen in the accent. Returns its width in `width` where given.
bool filter_pill(Ui& ui, std::string_view id, Point left_middle, std::string_view label,
                 bool is_chosen, float* width = nullptr);

/// The boxes alone, for rows of tables and the gallery; `box` is 18 x 18, `track` 36 x 20.
void draw_checkbox(Ui& ui, const Rect& box, bool is_on, bool is_enabled, const ControlState& state);
void draw_toggle(Ui& ui, const Rect& track, bool is_on, bool is_enabled, const ControlState& state);

}  // namespace hallux::ui
