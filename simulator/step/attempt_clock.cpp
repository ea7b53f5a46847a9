#include "simulator/step/attempt_clock.h"

#include <utility>

#include "simulator/record/record.h"

namespace hallux::simulator {

namespace {

std::uint32_t bit_of(std::int32_t holder) noexcept { return holder == paused_by_loop ? 2U : 1U; }

}  // namespace

bool AttemptClock::start() noexcept {
  if (phase_ != Phase::Waiting) return false;
  phase_ = Phase::Started;
  awaits_tool_ = true;
  return true;
}

ClockChange AttemptClock::pause(std::int32_t holder) noexcept {
  const bool was_running = is_running();
  holds_ |= bit_of(holder);
  if (!was_running) return ClockChange::None;
  is_pause_told_ = true;
  return ClockChange::Paused;
}

ClockChange AttemptClock::resume(std::int32_t holder) noexcept {
  const bool was_running = is_running();
  holds_ &= ~bit_of(holder);
  const bool runs_again = !was_running && is_running();
  return runs_again && std::exchange(is_pause_told_, false) ? ClockChange::Resumed
                                                            : ClockChange::None;
}

}  // namespace hallux::simulator
