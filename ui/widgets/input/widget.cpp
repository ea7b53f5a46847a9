#include "ui/widgets/input/widget.h"

#include <algorithm>
#include <ranges>

namespace hallux::ui {
namespace {

template <typename Accepts>
const Widget* topmost(const FrameContent& content, Point point, Accepts accepts) noexcept {
  const Layer lowest = reachable_layer(content);
  const Widget* found = nullptr;
  for (const Widget& widget : content.widgets)
    if (widget.layer >= lowest && widget.visible.contains(point) && accepts(widget) &&
        (found == nullptr || widget.layer >= found->layer))
      found = &widget;
  return found;
}

}  // namespace

const Widget* find_widget(const FrameContent& content, std::string_view id) noexcept {
  const auto found = std::ranges::find(content.widgets, id, &Widget::id);
  return found == content.widgets.end() ? nullptr : &*found;
}

Layer reachable_layer(const FrameContent& content) noexcept {
  Layer lowest = Layer::Page;
  for (const Widget& widget : content.widgets)
    if (widget.layer == Layer::Popup || widget.layer == Layer::Modal)
      lowest = std::max(lowest, widget.layer);
  return lowest;
}

const Widget* widget_at(const FrameContent& content, Point point) noexcept {
  return topmost(content, point, [](const Widget& widget) { return widget.role != Role::Scroll; });
}

const Widget* turned_at(const FrameContent& content, Point point, float notches) noexcept {
  const Widget* innermost = topmost(content, point, [](const Widget& widget) {
    return widget.role == Role::Scroll || widget.takes_wheel;
  });
  const auto is_at_end = [&](const Widget& region) {
    constexpr float least = 0.5F;
    return region.role == Role::Scroll &&
           (notches > 0.0F ? region.room_above : region.room_below) < least;
  };
  const Widget* turned = innermost;
  while (turned != nullptr && is_at_end(*turned))
    turned =
        turned->scroll < 0 ? nullptr : &content.widgets[static_cast<std::size_t>(turned->scroll)];
  return turned != nullptr ? turned : innermost;
}

}  // namespace hallux::ui
