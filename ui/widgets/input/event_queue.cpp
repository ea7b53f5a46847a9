#include "ui/widgets/input/event_queue.h"

namespace hallux::ui {

void EventQueue::push(const InputEvent& event) {
  if (event.kind == EventKind::PointerMoved && !events_.empty() &&
      events_.back().kind == EventKind::PointerMoved) {
    events_.back() = event;
    return;
  }
  events_.push_back(event);
}

std::optional<InputEvent> EventQueue::take() {
  if (events_.empty()) return std::nullopt;
  const InputEvent event = events_.front();
  events_.pop_front();
  return event;
}

}  // namespace hallux::ui
