// The rings of an attempt are emptied where a recorder would be: at each report of progress, twice
// a second, on the loop's own thread. They hold many times what comes in between.
#include "ui/jobs/unrecorded_attempt.h"

#include <exception>
#include <new>
#include <utility>

#include "scenarios/simulation_setup.h"

namespace hallux::ui {

namespace {

constexpr std::size_t ring_capacity = 4096;

template <typename Value>
void drop(simulator::Ring<Value>& ring) noexcept {
  for (Value value; ring.pop(value);) continue;
}

}  // namespace

UnrecordedAttempt::UnrecordedAttempt(std::shared_ptr<const PreparedCase> prepared_case,
                                     std::unique_ptr<simulator::HapticDevice> device)
    : CommandedLoop(force_scale_of(*device, *prepared_case, simulator::Guidance::None)),
      prepared_case_(std::move(prepared_case)),
      device_(std::move(device)),
      channels_(ring_capacity) {
  say({simulator::CommandKind::Start, 0, 0});
  thread_ = std::jthread([this] { run(); });
}

/// The command is heard at once, the flag at the next report.
UnrecordedAttempt::~UnrecordedAttempt() {
  abandon();
  is_stopping_.store(true, std::memory_order_relaxed);
}

void UnrecordedAttempt::run() noexcept {
  try {
    operate();
  } catch (const std::bad_alloc&) {
    end_.failure = LiveFailure::MemoryFull;
  } catch (const std::exception&) {
    end_.failure = LiveFailure::Other;
  }
  watch().closed.store(true, std::memory_order_release);
  is_over_.store(true, std::memory_order_release);
}

void UnrecordedAttempt::operate() {
  simulator::AttemptSetup setup{simulation_setup(prepared_case_->scenario, prepared_case_->bones,
                                                 prepared_case_->plan, simulator::Guidance::None)};
  setup.pacing = simulator::Pacing::RealTime;
  setup.last_tick = LiveAttempt::ticks_at_most;
  setup.watch = &watch();
  for (const auto& whole : prepared_case_->wholes) setup.wholes.push_back(whole.get());
  end_.loop = run_attempt(setup, *device_, channels_, [this](double) {
    drop_record();
    return !is_stopping_.load(std::memory_order_relaxed);
  });
  end_.end = end_.loop.end;
}

void UnrecordedAttempt::drop_record() noexcept {
  drop(channels_.tape);
  drop(channels_.samples);
  drop(channels_.events);
}

}  // namespace hallux::ui
