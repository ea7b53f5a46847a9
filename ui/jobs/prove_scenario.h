/// Whether a scenario's rubric tells a good performance from a bad one: the perfect hand, and the
/// perfect hand with each fault that the scenario lists.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {

/// What the perfect hand is to score at least, of 100 000.
inline constexpr std::int64_t perfect_milli = 97'000;

struct LostPoints {
  /// Of a rubric item, or a gate.
  std::string item;
  /// Of 100, as shown.
  std::int64_t lost_milli = 0;
  std::string text;
};

/// One performance and whether it came out as it had to.
struct ProvedPerformance {
  /// "perfect", or the fault.
  std::string name;
  std::int64_t score_milli = 0;
  std::vector<LostPoints> lost;
  /// Items that had to lose at least half, gates that had to trigger.
  std::vector<std::string> expected;
  /// What came out otherwise, a sentence each; empty where all is as expected.
  std::vector<std::string> differences;

  bool is_ok() const noexcept { return differences.empty(); }
};

struct ScenarioProof {
  ProvedPerformance perfect;
  /// One for each fault of the scenario.
  std::vector<ProvedPerformance> faults;

  bool has_passed() const noexcept;
};

/// The perfect hand scores at least 97 and has a sentence for each point that it loses. Each fault
/// costs its items at least half of their points and triggers its gates and no others; no other
/// group loses or gains more than 5 % of its weight, and the score never rises.
/// errors  ScenarioError where a fault is none, or the scenario does not fit its patient; Cancelled
/// thread  work's; some seconds for each performance
ScenarioProof prove_scenario(const scenarios::Scenario& scenario, const StageProgress& progress);

}  // namespace hallux::ui
