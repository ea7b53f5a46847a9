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

const Widget* scrolled_at(const FrameContent& content, Point point) noexcept {
  return topmost(content, point, [](const Widget& widget) {
    return widget.role == Role::Scroll || (widget.role == Role::Area && widget.takes_wheel);
  });
}

}  // namespace hallux::ui
