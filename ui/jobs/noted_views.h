/// Views of somebody who operates, chosen to be kept: at most ten a second, and only where they
/// changed noticeably. Inside this corner only.
///
///     window, each frame --note--> [ten a second, changed] --> ring --> recorder
///
/// It never waits: what finds no room in the ring is lost, and the next that is kept counts it.
#pragma once

#include <cstdint>
#include <optional>

#include "simulator/record/channels.h"

namespace hallux::ui {

class NotedViews {
 public:
  static constexpr std::int64_t ticks_between = 100;

  /// needs   the ring outlives it, and nobody else pushes into it
  explicit NotedViews(simulator::Ring<simulator::DisplayFact>& ring) : ring_(ring) {}

  /// What is on the screen now, drawn from the sample of that tick. What is no view (not a number)
  /// is not noted.
  /// thread  window
  void note(const simulator::ShownView& view, std::int64_t tick) noexcept;

 private:
  simulator::Ring<simulator::DisplayFact>& ring_;
  /// The last that was kept.
  std::optional<simulator::ShownView> kept_;
  std::int64_t kept_tick_ = 0, lost_ = 0;
};

/// Whether a person would see that the one is not the other.
bool is_noticeably_other(const simulator::ShownView& a, const simulator::ShownView& b) noexcept;

}  // namespace hallux::ui
