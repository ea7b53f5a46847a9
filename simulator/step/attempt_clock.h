/// The clock of an attempt: before the start, running, held, over. Inside this corner only.
///
///     Waiting --start--> Started --end--> Over
///
/// The operator's pause and the loop's gap both hold it. Each ends its own: the end of a gap does
/// not end a pause.
#pragma once

#include <cstdint>

namespace hallux::simulator {

/// A change of the clock that is told as an event.
enum class ClockChange { None, Paused, Resumed };

class AttemptClock {
 public:
  bool is_over() const noexcept { return phase_ == Phase::Over; }
  /// Started, and nothing holds it.
  bool is_running() const noexcept { return phase_ == Phase::Started && holds_ == 0; }

  /// ensures true the first time; later starts change nothing
  /// needs   not is_over(), here and below
  bool start() noexcept;
  /// holder  paused_by_loop, or the operator
  ClockChange pause(std::int32_t holder) noexcept;
  /// ensures the end of a pause is told only where its beginning was: not for one from before the
  ///         start
  ClockChange resume(std::int32_t holder) noexcept;
  void end() noexcept { phase_ = Phase::Over; }

  /// Started, but the tool has not been put where the hand is. Holds beyond the attempt's end.
  bool awaits_tool() const noexcept { return awaits_tool_; }
  void note_tool_placed() noexcept { awaits_tool_ = false; }

 private:
  enum class Phase { Waiting, Started, Over };

  Phase phase_ = Phase::Waiting;
  /// One bit for each holder.
  std::uint32_t holds_ = 0;
  bool is_pause_told_ = false;
  bool awaits_tool_ = false;
};

}  // namespace hallux::simulator
