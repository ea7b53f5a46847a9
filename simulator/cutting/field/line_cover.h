/// A line of a field's nodes, all at one u: spans of it, and what is known about it.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <limits>

namespace hallux::simulator {

/// Nodes [first, last) of a line.
struct NodeSpan {
  std::int32_t first = 0, last = 0;

  bool is_empty() const noexcept { return first >= last; }
};

/// What earlier stamps did to a line, as far as it shows that a later one cannot raise it: on each
/// side the bounds of one stamp, as numbers of nodes. Along a line a stamp's value is concave; so
/// it is at least the straight line from -limit at `near` to the limit at `deep`, and at the limit
/// from there to where `deep` ends on the other side.
struct LineCover {
  static constexpr double far = std::numeric_limits<double>::infinity();

  double low_near = far, low_deep = far, low_end = -far;
  double high_near = -far, high_deep = -far, high_end = far;
};

/// The cover of a line; all its bits are zero before anything is known.
struct KeptCover {
  LineCover cover;
  bool is_known;

  LineCover& known() noexcept {
    if (!is_known) *this = {LineCover{}, true};
    return cover;
  }
};

}  // namespace hallux::simulator
