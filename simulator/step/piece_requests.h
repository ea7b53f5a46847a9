/// Requests for the pieces: due when the blade has left a kerf in which it cut, and when it has
/// left the bone behind it; one for each fragment that was cut, one at a time.
/// Inside this corner only.
#pragma once

#include <cstdint>

#include "simulator/cutting/field/kerf_set.h"

namespace hallux::simulator {

/// The blade's way through one step.
struct BladePassage {
  /// The kerf that held the blade before the step and after it; -1: none.
  std::int32_t kerf_before = -1, kerf_after = -1;
  /// Whose fields rose: kerf_after, and those that are one cut with it.
  KerfNumbers opened = {};
  /// The teeth left the bone at the far side.
  bool broke_through = false;
};

class PieceRequests {
 public:
  bool is_wanted() const noexcept { return !wanted_.is_empty(); }
  /// Asked for, and the result was not applied yet.
  bool is_waiting() const noexcept { return is_waiting_; }
  /// The blade opened bone whose pieces were not asked for since.
  bool has_opened() const noexcept { return !opened_.is_empty(); }

  void watch(const BladePassage& blade) noexcept {
    opened_.add(blade.opened);
    if (!blade.opened.is_empty()) last_opened_ = blade.kerf_after;
    const bool has_left = blade.kerf_before >= 0 && blade.kerf_after != blade.kerf_before;
    if (has_left || blade.broke_through) wanted_.add(opened_);
  }
  /// The kerf for whose fragment a job is to be asked now; -1: none.
  std::int32_t ask(const KerfSet& kerfs) noexcept {
    if (!is_wanted() || is_waiting_) return -1;
    const std::int32_t kerf = wanted_.has(last_opened_) ? last_opened_ : *wanted_.begin();
    const std::int32_t fragment = kerfs.fragment_of(kerf);
    opened_ = outside(fragment, opened_, kerfs);
    wanted_ = outside(fragment, wanted_, kerfs);
    is_waiting_ = true;
    return kerf;
  }
  void apply() noexcept { is_waiting_ = false; }

 private:
  /// Those that are not in that fragment.
  static KerfNumbers outside(std::int32_t fragment, const KerfNumbers& all,
                             const KerfSet& kerfs) noexcept {
    KerfNumbers left;
    for (const std::int32_t kerf : all) {
      if (kerfs.fragment_of(kerf) != fragment) left.add(kerf);
    }
    return left;
  }

  /// Since the pieces of their fragments were asked for.
  KerfNumbers opened_;
  /// Of those: what the blade has left behind. What it opens meanwhile waits for its own time, else
  /// a blade in two fragments would ask in each tick.
  KerfNumbers wanted_;
  std::int32_t last_opened_ = 0;
  bool is_waiting_ = false;
};

}  // namespace hallux::simulator
