/// How far a person is with an operation: whether enough of their attempts passed (see
/// pass_mark.h).
///
/// A learning curve as a sequential test (LC-CUSUM): each run that passes adds to the evidence that
/// the person is competent, each that does not takes more away, never below 0. From the declaration
/// on the ordinary test watches for the opposite.
///
///     evidence 3.0 - - - - - - - - - - - - - -.- declared competent
///                              .-'  `.   .-'
///              0  ____.-' `__.-'      `-'          runs
#pragma once

#include <cstddef>
#include <vector>

namespace hallux::assessment {

/// Who fails three times in ten is not competent, who fails once is.
/// source  docs/metrics.md, Passing and learning
inline constexpr double unacceptable_failure_share = 0.30, acceptable_failure_share = 0.10;
/// With these, an incompetent person is declared competent within 30 runs with probability 0.11, a
/// competent one 0.85.
inline constexpr double evidence_needed = 3.0, slip_needed = 2.5;

/// What a run that passes adds to the evidence, and what one that does not takes away [both above
/// 0].
double gain_of_pass() noexcept;
double loss_of_failure() noexcept;
/// Runs in a row, from nothing, until the declaration.
int clean_runs_needed() noexcept;

struct LearningState {
  /// 0 to evidence_needed.
  double evidence = 0.0;
  /// After each run.
  std::vector<double> evidence_by_run;
  bool is_competent = false;
  /// Was competent, and failed too often since.
  bool has_slipped = false;

  /// The evidence as runs in a row that would make it.
  int clean_runs() const noexcept;
};

/// `passed` in the order of the runs; those that helped the person, were set aside or were not
/// wholly measured are not among them.
LearningState learning_state(const std::vector<bool>& passed);

/// The median of the last `window` values, one for each value.
/// needs   window >= 1
std::vector<double> running_median(const std::vector<double>& values, std::size_t window);

}  // namespace hallux::assessment
