/// The push that saws and does not force: what the hints ask for and the meter shows.
#pragma once

namespace hallux::ui {

struct PushRange {
  double least_newton = 6.0, most_newton = 14.0;
};

/// source  ours, not surgeon-reviewed; the blade does the rest
inline constexpr PushRange usual_push{6.0, 14.0};
/// Before a hinge: it stops in time.
inline constexpr PushRange gentle_push{2.5, 5.0};
/// Before the far side, where bone gives way: the blade goes on by no more than the hand was ahead.
inline constexpr PushRange easing_push{2.0, 4.0};

}  // namespace hallux::ui
