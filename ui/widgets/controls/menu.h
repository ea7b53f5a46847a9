/// Menus, and the question before what cannot be undone.
#pragma once

#include <span>
#include <string_view>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

struct MenuItem {
  std::string_view label = {};
  Icon icon = Icon::None;
  /// A key that does the same; empty: none.
  std::string_view key = {};
  /// Last, behind a hairline.
  bool is_dangerous = false;
  /// Why it is off, as of a button.
  std::string_view why_off = {};
};

/// -1 while it is open, `menu_closed` where it was closed by Esc or a press beside it, else the
/// item pressed. Items are named `id.0`, `id.1` ...; the owner stops calling it once it answered.
inline constexpr int menu_open = -1, menu_closed = -2;
int menu(Ui& ui, std::string_view id, Point corner, std::span<const MenuItem> items,
         float width = 250.0F);
/// How high a menu with these items is.
float menu_height(std::span<const MenuItem> items) noexcept;
/// The panel alone, one row raised; for the gallery.
void draw_menu(Ui& ui, const Rect& rect, std::span<const MenuItem> items, int raised);

/// A question with a scrim over everything, only where there is no way back. The safe answer has
/// the focus, Esc is it.
struct Question {
  std::string_view title = {};
  /// What will be gone.
  std::string_view consequence = {};
  /// The verb: "Erase 3 people".
  std::string_view act = {};
  /// The safe one: "Keep them".
  std::string_view keep = {};
  bool is_dangerous = true;
  /// A third way, between the two; empty: none.
  std::string_view other = {};
};
enum class Answer : std::uint8_t { Waiting, Keep, Act, Other };
/// Buttons are named `id.act`, `id.keep` and `id.other`.
Answer question(Ui& ui, std::string_view id, const Question& question);

}  // namespace hallux::ui
