/// Buttons, icon buttons and links.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

enum class ButtonLook : std::uint8_t { Primary, Secondary, Ghost, Danger };

struct ButtonSpec {
  std::string_view label = {};
  ButtonLook look = ButtonLook::Secondary;
  Icon icon = Icon::None;
  /// Why it is off: not empty turns it off, is shown on hover and told.
  std::string_view why_off = {};
  /// What it started still runs: a spinner stands for the icon, pressing does nothing.
  bool is_busy = false;
};

/// Heights by place.
inline constexpr float button_height = 38.0F, header_button_height = 36.0F,
                       large_button_height = 44.0F;

/// True in the frame in which it was pressed. The first primary button of a screen is what Enter
/// does.
bool button(Ui& ui, std::string_view id, const Rect& rect, const ButtonSpec& spec);
/// The same at the left of a line, as wide as its label needs and the line allows.
bool button_in_line(Ui& ui, std::string_view id, Rect line, const ButtonSpec& spec);
/// The width its label needs: at least 88, padding 16.
float button_width(const Ui& ui, const ButtonSpec& spec);

/// How a control looks now; a gallery may draw any state without a person doing it.
struct ControlState {
  float hover = 0.0F;
  bool is_held = false, shows_ring = false;
};
void draw_button(Ui& ui, const Rect& rect, const ButtonSpec& spec, const ControlState& state);

struct IconButtonSpec {
  /// Read out and shown as a tooltip.
  std::string_view label = {};
  Icon icon = Icon::None;
  bool is_on = false;
  /// Why it is off, as of a button.
  std::string_view why_off = {};
  /// Tab comes to it last.
  bool comes_late = false;
};
/// 36 x 36.
bool icon_button(Ui& ui, std::string_view id, const Rect& rect, const IconButtonSpec& spec);

/// Words that lead somewhere, in the accent; `at` is the left (or right) end in the middle of the
/// line.
bool link(Ui& ui, std::string_view id, Point at, std::string_view label, Align align = Align::Left,
          Type type = Type::Small);

}  // namespace hallux::ui
