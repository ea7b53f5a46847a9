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
  bool is_wanted() const noexcept { return is_wanted_; }
  /// Asked for, and the result was not applied yet.
  bool is_waiting() const noexcept { return is_waiting_; }
  /// The blade opened bone whose pieces were not asked for since.
  bool has_opened() const noexcept { return !opened_.is_empty(); }

  void watch(const BladePassage& blade) noexcept {
    opened_.add(blade.opened);
    if (!blade.opened.is_empty()) last_opened_ = blade.kerf_after;
    const bool has_left = blade.kerf_before >= 0 && blade.kerf_after != blade.kerf_before;
    if (has_opened() && (has_left || blade.broke_through)) is_wanted_ = true;
  }
  /// The kerf for whose fragment a job is to be asked now; -1: none.
  std::int32_t ask(const KerfSet& kerfs) noexcept {
    if (!is_wanted_ || is_waiting_) return -1;
    const std::int32_t kerf = opened_.has(last_opened_) ? last_opened_ : *opened_.begin();
    KerfNumbers left;
    for (const std::int32_t other : opened_) {
      if (kerfs.fragment_of(other) != kerfs.fragment_of(kerf)) left.add(other);
    }
    opened_ = left;
    is_wanted_ = has_opened();
    is_waiting_ = true;
    return kerf;
  }
  void apply() noexcept { is_waiting_ = false; }

 private:
  /// Since the pieces of their fragments were asked for.
  KerfNumbers opened_;
  std::int32_t last_opened_ = 0;
  bool is_wanted_ = false, is_waiting_ = false;
};

}  // namespace hallux::simulator
