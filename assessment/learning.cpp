#include "assessment/learning.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/check.h"

namespace hallux::assessment {

double gain_of_pass() noexcept {
  return std::log((1.0 - acceptable_failure_share) / (1.0 - unacceptable_failure_share));
}

double loss_of_failure() noexcept {
  return std::log(unacceptable_failure_share / acceptable_failure_share);
}

int clean_runs_needed() noexcept {
  return static_cast<int>(std::ceil(evidence_needed / gain_of_pass() - 1e-9));
}

int LearningState::clean_runs() const noexcept {
  return std::min(clean_runs_needed(),
                  static_cast<int>(std::lround(std::ceil(evidence / gain_of_pass() - 1e-9))));
}

LearningState learning_state(const std::vector<bool>& passed) {
  LearningState state;
  double slip = 0.0;
  for (const bool has_passed : passed) {
    if (state.is_competent) {
      slip = std::max(0.0, slip + (has_passed ? -gain_of_pass() : loss_of_failure()));
      if (slip >= slip_needed) {
        state.is_competent = false;
        state.has_slipped = true;
        state.evidence = 0.0;
      }
    } else {
      const double step = has_passed ? gain_of_pass() : -loss_of_failure();
      state.evidence = std::clamp(state.evidence + step, 0.0, evidence_needed);
      if (state.evidence >= evidence_needed) {
        state.is_competent = true;
        state.has_slipped = false;
        slip = 0.0;
      }
    }
    state.evidence_by_run.push_back(state.evidence);
  }
  return state;
}

std::vector<double> running_median(const std::vector<double>& values, std::size_t window) {
  CHECK(window >= 1);
  std::vector<double> medians;
  medians.reserve(values.size());
  for (std::size_t last = 0; last < values.size(); ++last) {
    const std::size_t count = std::min(window, last + 1);
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(last + 1 - count);
    std::vector<double> few(begin, begin + static_cast<std::ptrdiff_t>(count));
    std::sort(few.begin(), few.end());
    medians.push_back(count % 2 == 1 ? few[count / 2]
                                     : 0.5 * (few[count / 2 - 1] + few[count / 2]));
  }
  return medians;
}

}  // namespace hallux::assessment
