/// Requests for the pieces: due when the blade has left a kerf in which it cut, and when it has
/// left the bone behind it. Inside this corner only.
#pragma once

#include <cstdint>

namespace hallux::simulator {

/// The blade's way through one step.
struct BladePassage {
  /// The kerf that held the blade before the step and after it; -1: none.
  std::int32_t kerf_before = -1, kerf_after = -1;
  /// The field of kerf_after rose.
  bool has_opened = false;
  /// The teeth left the bone at the far side.
  bool broke_through = false;
};

class PieceRequests {
 public:
  bool is_wanted() const noexcept { return is_wanted_; }
  /// Asked for, and the result was not applied yet.
  bool is_waiting() const noexcept { return is_waiting_; }
  /// The blade opened bone since the pieces were last asked for.
  bool has_opened() const noexcept { return has_opened_; }
  /// The kerf that opened last; -1: none did.
  std::int32_t last_opened() const noexcept { return last_opened_; }

  void watch(const BladePassage& blade) noexcept {
    if (blade.has_opened) {
      has_opened_ = true;
      last_opened_ = blade.kerf_after;
    }
    const bool has_left = blade.kerf_before >= 0 && blade.kerf_after != blade.kerf_before;
    if (has_opened_ && (has_left || blade.broke_through)) is_wanted_ = true;
  }
  /// True where a job is to be asked now; one at a time.
  bool ask() noexcept {
    if (!is_wanted_ || is_waiting_) return false;
    is_wanted_ = has_opened_ = false;
    is_waiting_ = true;
    return true;
  }
  void apply() noexcept { is_waiting_ = false; }

 private:
  bool has_opened_ = false;
  bool is_wanted_ = false;
  bool is_waiting_ = false;
  std::int32_t last_opened_ = -1;
};

}  // namespace hallux::simulator
