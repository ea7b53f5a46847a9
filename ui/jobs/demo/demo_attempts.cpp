#include "ui/jobs/demo/demo_attempts.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "scenarios/hands/feeling_hand.h"
#include "scenarios/scenario_error.h"
#include "scenarios/simulation_setup.h"
#include "simulator/base/progress.h"
#include "simulator/record/drain.h"
#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {

namespace {

constexpr int other_seeds_max = 20;
constexpr std::uint64_t seed_stride = 10'000;
/// Of an attempt's time, about so much goes into operating; the rest is scoring.
constexpr double operating_part = 0.8;
/// Far more than come between two reports of progress, a few hundred lines.
constexpr std::size_t ring_capacity = 32768;

scenarios::FeelingHand aimed_hand(const DemoOperation& operation, DemoAttempt& planned) {
  for (int i = 0;; ++i) {
    try {
      return {operation.scenario, operation.bones, operation.plan, skill_between(planned.skill),
              planned.seed};
    } catch (const scenarios::ScenarioError&) {
      if (i == other_seeds_max) throw;
      planned.seed += seed_stride;
    }
  }
}

}  // namespace

OperatedAttempt operate_and_score(const DemoOperation& operation, const DemoAttempt& planned,
                                  const Progress& progress) {
  OperatedAttempt operated;
  operated.planned = planned;
  scenarios::FeelingHand hand = aimed_hand(operation, operated.planned);
  simulator::AttemptSetup setup{simulation_setup(operation.scenario, operation.bones,
                                                 operation.plan, simulator::Guidance::None)};
  setup.last_tick = scenarios::FeelingHand::last_tick;
  setup.attempt_operator = &hand;
  simulator::AttemptChannels channels{ring_capacity};
  operated.loop = run_attempt(setup, hand, channels, [&](double part) {
    drain(channels, operated.recording);
    return progress(operating_part * part);
  });
  if (operated.loop.end == simulator::AttemptEnd::Cancelled) {
    throw Cancelled("stopped while operating; nothing was stored");
  }
  drain(channels, operated.recording);
  assessment::Examination examination =
      assessment::assess_fully(operation.scenario, operation.bones, operated.recording, "scripted",
                               part_of(progress, operating_part, 1.0));
  operated.card = std::move(examination.card);
  operated.measurements = std::move(examination.measurements);
  return operated;
}

DemoAttemptLine::DemoAttemptLine(const std::vector<DemoOperation>& operations,
                                 const std::vector<DemoAttempt>& planned)
    : operations_(operations), planned_(planned) {
  fill();
}

DemoAttemptLine::~DemoAttemptLine() {
  is_stopped_ = true;
  for (std::future<OperatedAttempt>& running : running_) running.wait();
}

void DemoAttemptLine::fill() {
  const std::size_t ahead = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 8);
  while (running_.size() < ahead && started_ < planned_.size()) {
    const DemoAttempt& planned = planned_[started_++];
    running_.push_back(std::async(std::launch::async, [this, &planned] {
      std::int64_t told_milli = 0;
      const auto tell = [this, &told_milli](double part) {
        const auto milli = static_cast<std::int64_t>(1000.0 * std::clamp(part, 0.0, 1.0));
        done_milli_ += milli - told_milli;
        told_milli = milli;
        return !is_stopped_.load();
      };
      OperatedAttempt operated = operate_and_score(operations_[planned.scenario], planned, tell);
      tell(1.0);
      return operated;
    }));
  }
}

OperatedAttempt DemoAttemptLine::take(const Progress& report) {
  constexpr std::chrono::milliseconds between_reports{100};
  std::future<OperatedAttempt>& next = running_.front();
  while (next.wait_for(between_reports) != std::future_status::ready) {
    const double done = 0.001 * static_cast<double>(done_milli_.load());
    if (report(done / static_cast<double>(planned_.size()))) continue;
    is_stopped_ = true;
    throw Cancelled("stopped while the simulated course was operated; nothing of it was kept");
  }
  OperatedAttempt operated = next.get();
  running_.pop_front();
  fill();
  return operated;
}

}  // namespace hallux::ui
