/// The one move that leaves least of several errors: matching pursuit among the moves of the hand.
/// Inside this corner only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "simulator/device/mouse.h"
#include "ui/screens/operating/hint.h"

namespace hallux::ui {

/// Of a key's step: below, Shift is held. At 0.6 whoever goes a fifth too far with the mouse would
/// be sent back by as much, and to and fro.
inline constexpr double fine_below = 0.75;

/// One move, and what a step of it does to the errors.
template <std::size_t count>
struct Lever {
  HandMove more, less;
  std::array<double, count> change;
};

/// The move that leaves least of the errors, how much of it, and what share of them it mends.
struct Chosen {
  HandMove move = HandMove::Wait;
  double amount = 0.0, mended_share = 0.0;
};

template <std::size_t count>
Chosen best_move(const std::array<double, count>& errors, std::span<const Lever<count>> levers) {
  Chosen chosen;
  double most = 0.0, all = 0.0;
  for (const double error : errors) all += error * error;
  for (const Lever<count>& lever : levers) {
    double along = 0.0, size = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      along += errors[i] * lever.change[i];
      size += lever.change[i] * lever.change[i];
    }
    if (!(size > 1.0e-6) || along * along / size <= most) continue;
    most = along * along / size;
    const double amount = -along / size;
    chosen = {amount > 0.0 ? lever.more : lever.less, std::abs(amount), most / all};
  }
  return chosen;
}

/// Those that turn about the axes of the person's view.
/// change_of(axis_in_bone)  what a turn about that axis, by the right hand, does to the errors
template <std::size_t count, typename Change>
std::array<Lever<count>, 3> turning_levers(const Quat& bone_from_view, const Change& change_of) {
  const auto about = [&](const Vec3& axis) { return change_of(bone_from_view * axis); };
  return {{{HandMove::TurnRight, HandMove::TurnLeft, about(Vec3(0.0, 1.0, 0.0))},
           {HandMove::TurnDown, HandMove::TurnUp, about(Vec3(1.0, 0.0, 0.0))},
           {HandMove::RollLeft, HandMove::RollRight, about(Vec3(0.0, 0.0, 1.0))}}};
}

/// Those that lead across the view.
/// change_of(way_in_bone)  what a way of 1 mm does to the errors
template <std::size_t count, typename Change>
std::array<Lever<count>, 2> levers_across(const Quat& bone_from_view, const Change& change_of) {
  return {{{HandMove::Right, HandMove::Left, change_of(bone_from_view * Vec3(1.0, 0.0, 0.0))},
           {HandMove::Up, HandMove::Down, change_of(bone_from_view * Vec3(0.0, 1.0, 0.0))}}};
}

/// As key presses: fine ones where little is left.
inline void set_amount(Hint& hint, const Chosen& chosen, double key_step) {
  hint.move = chosen.move;
  hint.is_fine = chosen.amount < fine_below * key_step;
  const double step = hint.is_fine ? simulator::fine_share * key_step : key_step;
  hint.times = std::max(1, static_cast<int>(std::lround(chosen.amount / step)));
}

}  // namespace hallux::ui
