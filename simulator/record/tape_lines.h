/// The lines of an input tape in their order, wherever they are kept.
///
/// A line takes 112 bytes in memory and few as it is stored. Who looks at one line after the other,
/// as scoring does, need not have them all at the same time.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include "simulator/record/record.h"

namespace hallux::simulator {

/// Borrows the lines from whoever keeps them.
class TapeLines {
 public:
  using Visit = std::function<void(const TapeLine& line)>;
  using Walk = std::function<void(const Visit& visit)>;

  /// None.
  TapeLines() = default;
  /// needs   `walk` visits `count` lines in the order of the tape, the same each time
  TapeLines(std::size_t count, Walk walk) : count_(count), walk_(std::move(walk)) {}

  std::size_t count() const noexcept { return count_; }
  /// What `visit` throws ends it.
  /// errors  those of whoever keeps the lines
  /// thread  any, several at once
  void visit(const Visit& visit) const {
    if (count_ > 0) walk_(visit);
  }

 private:
  std::size_t count_ = 0;
  Walk walk_;
};

/// Those that a recording holds.
TapeLines tape_of(const Recording& recording);

/// A recording whose tape may be kept elsewhere; borrows both.
struct Recorded {
  /// Its outputs are looked at here, its own tape is not.
  const Recording& outputs;
  TapeLines tape;

  /// With the tape that it holds.
  Recorded(const Recording& whole) : outputs(whole), tape(tape_of(whole)) {}
  Recorded(const Recording& outputs_alone, TapeLines kept_elsewhere)
      : outputs(outputs_alone), tape(std::move(kept_elsewhere)) {}
};

}  // namespace hallux::simulator
