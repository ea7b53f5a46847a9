#include "ui/widgets/input/focus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hallux::ui {
namespace {

// The stops of Tab: single controls, and one widget for each group.
std::vector<const Widget*> tab_stops(const FrameContent& content, const std::string& focus) {
  std::vector<const Widget*> stops;
  for (const Widget& widget : content.widgets) {
    if (!can_have_focus(content, widget)) continue;
    if (widget.group.empty()) {
      stops.push_back(&widget);
      continue;
    }
    const auto same = std::ranges::find_if(
        stops, [&](const Widget* stop) { return stop->group == widget.group; });
    if (same == stops.end())
      stops.push_back(&widget);
    else if (widget.id == focus || (widget.is_chosen && (*same)->id != focus))
      *same = &widget;
  }
  std::stable_partition(stops.begin(), stops.end(),
                        [](const Widget* stop) { return !stop->comes_late; });
  return stops;
}

// How far `to` lies from `from` in the arrow's direction; infinite where it lies elsewhere.
float distance_by_arrow(const Rect& from, const Rect& to, Key arrow) {
  const float dx = to.mid_x() - from.mid_x(), dy = to.mid_y() - from.mid_y();
  const bool is_across = arrow == Key::Left || arrow == Key::Right;
  const float along = arrow == Key::Left    ? -dx
                      : arrow == Key::Right ? dx
                      : arrow == Key::Up    ? -dy
                                            : dy;
  const float aside = std::abs(is_across ? dy : dx);
  if (along < 1.0F || aside > 3.0F * along) return std::numeric_limits<float>::infinity();
  return along + 2.0F * aside;
}

// The one before or behind `from` in its group.
const Widget* neighbour(const FrameContent& content, const Widget& from, Key arrow) {
  const bool is_forwards = arrow == Key::Right || arrow == Key::Down;
  const Widget* before = nullptr;
  bool was_found = false;
  for (const Widget& widget : content.widgets) {
    if (widget.group != from.group || !can_have_focus(content, widget)) continue;
    if (was_found) return &widget;
    if (widget.id == from.id) {
      if (!is_forwards) return before;
      was_found = true;
    }
    before = &widget;
  }
  return nullptr;
}

}  // namespace

bool can_have_focus(const FrameContent& content, const Widget& widget) noexcept {
  return (widget.is_enabled || !widget.why_off.empty()) && widget.is_focusable &&
         widget.layer >= reachable_layer(content);
}

bool can_be_pressed(const FrameContent& content, const Widget& widget) noexcept {
  return widget.is_enabled && can_have_focus(content, widget);
}

std::string next_in_tab_order(const FrameContent& content, const std::string& focus,
                              bool is_backwards) {
  const std::vector<const Widget*> stops = tab_stops(content, focus);
  if (stops.empty()) return {};
  const auto at =
      std::ranges::find_if(stops, [&](const Widget* stop) { return stop->id == focus; });
  if (at == stops.end()) return is_backwards ? stops.back()->id : stops.front()->id;
  const auto count = stops.size(), place = static_cast<std::size_t>(at - stops.begin());
  return stops[(place + (is_backwards ? count - 1 : 1)) % count]->id;
}

std::string next_by_arrow(const FrameContent& content, const std::string& focus, Key arrow) {
  const Widget* from = find_widget(content, focus);
  if (from == nullptr || from->group.empty()) return focus;
  if (from->is_in_sequence && arrow != Key::Home && arrow != Key::End) {
    const Widget* next = neighbour(content, *from, arrow);
    return next == nullptr ? focus : next->id;
  }
  const Widget* best = nullptr;
  float best_distance = std::numeric_limits<float>::infinity();
  for (const Widget& widget : content.widgets) {
    if (widget.group != from->group || !can_have_focus(content, widget)) continue;
    if (arrow == Key::End || (arrow == Key::Home && best == nullptr)) best = &widget;
    if (arrow == Key::Home || arrow == Key::End || widget.id == focus) continue;
    const float distance = distance_by_arrow(from->rect, widget.rect, arrow);
    if (distance < best_distance) {
      best = &widget;
      best_distance = distance;
    }
  }
  return best == nullptr ? focus : best->id;
}

}  // namespace hallux::ui
