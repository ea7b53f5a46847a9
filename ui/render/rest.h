/// When a picture is at rest, and what is drawn of it then. No graphics and no clock: it counts
/// pictures. Inside this corner only.
///
///     moving   moving   moving   first   sample   sample  ...  kept   kept
///     changed  same ------------------------------------------------------->  any change: moving
///              waits for the hand to be at rest   refines           drawn no more
#pragma once

#include <cstdint>

namespace hallux::ui {

/// What is to be drawn of a picture in this frame.
enum class Drawing : std::uint8_t {
  /// As while it moves.
  Moving,
  /// The same, as the first sample of what it will be at rest.
  First,
  /// One more sample.
  Sample,
  /// Nothing: what was drawn stays.
  Kept
};

struct RestPlan {
  /// Of a refined picture, its first with them; 1: there is nothing to refine.
  int samples = 1;
  /// How many pictures are the same, and untouched, before the first sample.
  int waits = 0;
};

class Rest {
 public:
  explicit Rest(const RestPlan& plan = {}) noexcept : plan_(plan) {}

  /// The next picture is asked for.
  /// is_same     nothing in it changed since the last
  /// is_touched  somebody touched mouse or keys: a frame that answers draws no sample
  Drawing next(bool is_same, bool is_touched) noexcept;
  /// Samples that the picture has; 0 while it moves.
  int samples() const noexcept { return samples_; }
  bool is_finished() const noexcept { return samples_ >= plan_.samples; }

 private:
  RestPlan plan_;
  int waited_ = 0, samples_ = 0;
};

}  // namespace hallux::ui
