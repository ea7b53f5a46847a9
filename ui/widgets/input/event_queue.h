/// Keeps every event of the window in order until a frame takes it, so that none is lost between
/// two frames.
///
/// Dear ImGui 1.86 samples keys once a frame: a key pressed and released in between is never seen.
/// Here nothing is sampled: a frame takes events one after the other and stops behind the one that
/// changes the screen, so that the next event meets the screen the person was looking at when the
/// first had worked.
#pragma once

#include <deque>
#include <optional>

#include "ui/widgets/input/input_event.h"

namespace hallux::ui {

class EventQueue {
 public:
  /// Adds an event; movements that follow one another are kept as the last one only.
  void push(const InputEvent& event);
  /// The oldest event, taken out; nothing where none waits.
  std::optional<InputEvent> take();
  /// The oldest event, left where it is; valid until the queue changes; nullptr where none waits.
  const InputEvent* oldest() const noexcept { return events_.empty() ? nullptr : &events_.front(); }
  bool is_empty() const noexcept { return events_.empty(); }
  std::size_t count() const noexcept { return events_.size(); }

 private:
  std::deque<InputEvent> events_;
};

}  // namespace hallux::ui
