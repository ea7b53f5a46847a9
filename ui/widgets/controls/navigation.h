/// The way between the screens of one role: at the left, 216 wide, or a rail of icons where the
/// window is narrow.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

struct NavigationItem {
  /// Of the control, "nav.history".
  std::string_view id = {};
  std::string_view label = {};
  Icon icon = Icon::None;
  /// What waits there; 0 shows none.
  int badge = 0;
};

/// Who is signed in; always visible at the foot.
struct SignedIn {
  std::string_view name = {}, role = {}, initials = {};
  int hue = 0;
};

struct NavigationSpec {
  std::span<const NavigationItem> items = {};
  int chosen = -1;
  SignedIn who = {};
  bool is_rail = false;
};

enum class NavigationAction : std::uint8_t { None, Item, Help, Person };
struct NavigationResponse {
  NavigationAction action = NavigationAction::None;
  int item = -1;
  /// The place a menu of the person opens above.
  Rect person = {};
};

/// Draws the whole height of the display's left edge; Help is `nav.help`, the person `nav.person`.
NavigationResponse side_navigation(Ui& ui, const NavigationSpec& spec);

/// The place that is free between the places and the help at its foot, for what is told in passing;
/// empty on a rail.
Rect navigation_gap(const Ui& ui, std::size_t items, bool is_rail) noexcept;

/// Its width at this size of the window: the rail below 1180.
float navigation_width(const Ui& ui, bool is_rail) noexcept;
/// True where the window is too narrow for the words.
bool wants_rail(const Ui& ui) noexcept;

}  // namespace hallux::ui
