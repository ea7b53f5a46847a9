/// The attempts of the simulated course, operated and scored side by side and handed over in their
/// order. Inside this corner only.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <future>
#include <vector>

#include "assessment/assess.h"
#include "simulator/base/progress.h"
#include "simulator/loop/attempt_loop.h"
#include "ui/jobs/demo/demo_plan.h"

namespace hallux::ui {

/// One scenario, its patient and the plan on it: the same for all attempts at it.
struct DemoOperation {
  scenarios::Scenario scenario;
  std::vector<simulator::Bone> bones;
  scenarios::Plan plan;
};

struct OperatedAttempt {
  DemoAttempt planned;
  simulator::Recording recording;
  simulator::LoopStatistics loop;
  database::ScoreCard card;
  std::vector<assessment::Measurement> measurements;
};

/// The attempt in virtual time, kept in memory, and its score. Where the hand's aim misses the
/// bone, another seed is taken.
/// errors  ScenarioError where no seed aims at the bone; Cancelled, also assessment's, where
///         `progress` answered false
OperatedAttempt operate_and_score(const DemoOperation& operation, const DemoAttempt& planned,
                                  const Progress& progress);

/// Runs the attempts on as many threads as there are processors, a few ahead of whoever takes them.
class DemoAttemptLine {
 public:
  /// Borrows both.
  DemoAttemptLine(const std::vector<DemoOperation>& operations,
                  const std::vector<DemoAttempt>& planned);
  /// Stops what is running.
  ~DemoAttemptLine();
  DemoAttemptLine(const DemoAttemptLine&) = delete;
  DemoAttemptLine& operator=(const DemoAttemptLine&) = delete;

  /// Waits for the next in order; `report` is told the part of all that is done, ten times a
  /// second.
  /// errors  Cancelled where `report` answered false; as operate_and_score
  OperatedAttempt take(const Progress& report);

 private:
  void fill();

  const std::vector<DemoOperation>& operations_;
  const std::vector<DemoAttempt>& planned_;
  std::size_t started_ = 0;
  std::atomic<bool> is_stopped_{false};
  /// Thousandths of attempts.
  std::atomic<std::int64_t> done_milli_{0};
  std::deque<std::future<OperatedAttempt>> running_;
};

}  // namespace hallux::ui
