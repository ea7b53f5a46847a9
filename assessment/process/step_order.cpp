#include "assessment/process/step_order.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "assessment/process/sample_spans.h"
#include "scenarios/steps/step_order.h"

namespace hallux::assessment {

namespace {

using scenarios::OperationStep;
using scenarios::StepKind;
using simulator::CutEvent;
using simulator::CutEventKind;

std::optional<std::int64_t> sawn_tick(const Evidence& evidence, const std::string& cut) {
  std::optional<std::int64_t> tick;
  for (const CutFace& face : evidence.faces[index_of_cut(evidence.plan, cut)]) {
    const RebuiltKerf& kerf = evidence.rebuilt.kerfs[static_cast<std::size_t>(face.kerf)];
    if (kerf.cutting_samples == 0) continue;
    tick = std::min(tick.value_or(kerf.first_cutting_tick), kerf.first_cutting_tick);
  }
  return tick;
}

/// The last piece that was taken out; where steps have their own ids, before the step was done.
std::optional<std::int64_t> removed_tick(const Evidence& evidence, std::size_t index) {
  const auto last = last_tick_of(evidence.recording, CutEventKind::PieceRemoved);
  if (evidence.scenario.format == 1) return last;
  const auto done = last_tick_of(evidence.recording, CutEventKind::StepDone, index);
  std::optional<std::int64_t> tick;
  for (const CutEvent& event : evidence.recording.events) {
    if (event.kind == CutEventKind::PieceRemoved && done && event.tick <= *done) tick = event.tick;
  }
  return tick;
}

std::optional<std::int64_t> tick_of(const Evidence& evidence, std::size_t index) {
  const OperationStep& step = evidence.scenario.steps[index];
  switch (step.kind) {
    case StepKind::Cut:
    case StepKind::Trim:
      return sawn_tick(evidence, step.cut);
    case StepKind::Remove:
      return removed_tick(evidence, index);
    case StepKind::Close: {
      const CutEvent* const closing =
          closing_of(evidence.recording, index_of_hinge(evidence.plan, step.hinge));
      return closing == nullptr ? std::nullopt : std::optional(closing->tick);
    }
    case StepKind::Finish:
      return last_tick_of(evidence.recording, CutEventKind::Finished);
    default:
      return last_tick_of(evidence.recording, CutEventKind::StepDone, index);
  }
}

using StepTicks = std::vector<std::optional<std::int64_t>>;

/// How many of the steps up to each, itself included, can be kept so that their ticks rise: what
/// the longest common subsequence is where no step stands twice.
std::vector<std::size_t> longest_up_to(const StepTicks& ticks) {
  std::vector<std::size_t> longest(ticks.size(), 0);
  for (std::size_t step = 0; step < ticks.size(); ++step) {
    if (!ticks[step]) continue;
    longest[step] = 1;
    for (std::size_t before = 0; before < step; ++before) {
      if (ticks[before] && *ticks[before] <= *ticks[step])
        longest[step] = std::max(longest[step], longest[before] + 1);
    }
  }
  return longest;
}

/// Which steps the longest part keeps, found from its end.
std::vector<bool> kept_of(const StepTicks& ticks) {
  const std::vector<std::size_t> longest = longest_up_to(ticks);
  std::size_t wanted = *std::max_element(longest.begin(), longest.end());
  std::vector<bool> is_kept(ticks.size(), false);
  std::optional<std::int64_t> later;
  for (std::size_t step = ticks.size(); step-- > 0;) {
    if (wanted == 0 || longest[step] != wanted || (later && *ticks[step] > *later)) continue;
    is_kept[step] = true;
    later = ticks[step];
    --wanted;
  }
  return is_kept;
}

/// Steps that nobody had to carry out: optional ones that were passed over, and alternatives in
/// whose place another one was carried out. Of alternatives of which none was, the first counts.
std::vector<bool> not_required(const scenarios::Scenario& scenario, const StepTicks& ticks) {
  std::vector<bool> is_not(ticks.size(), false);
  for (std::size_t step = 0; step < ticks.size(); ++step) {
    if (ticks[step]) continue;
    const std::vector<std::size_t> group = scenarios::alternatives_of(scenario, step);
    is_not[step] =
        scenario.steps[step].is_optional || group.front() != step ||
        std::ranges::any_of(group, [&](std::size_t each) { return ticks[each].has_value(); });
  }
  return is_not;
}

/// Pairs of steps that were carried out the wrong way round: the sooner one needs the later one.
/// "Sooner, and needs" is an order, so the most steps without such a pair are those that a greatest
/// matching of pairs leaves (Dilworth).
class WrongPairs {
 public:
  WrongPairs(const scenarios::Scenario& scenario, const StepTicks& ticks)
      : wrong_(ticks.size()), matched_(ticks.size()) {
    const auto needs = scenarios::needs_of_steps(scenario);
    for (std::size_t sooner = 0; sooner < ticks.size(); ++sooner) {
      for (const std::size_t later : needs[sooner]) {
        if (ticks[sooner] && ticks[later] && *ticks[sooner] < *ticks[later])
          wrong_[sooner].push_back(later);
      }
    }
  }

  bool is_any_of(std::size_t step) const { return !wrong_[step].empty(); }
  std::size_t matching() {
    std::size_t count = 0;
    for (std::size_t step = 0; step < wrong_.size(); ++step) {
      std::vector<bool> is_tried(wrong_.size(), false);
      if (match(step, is_tried)) ++count;
    }
    return count;
  }

 private:
  bool match(std::size_t sooner, std::vector<bool>& is_tried) {
    for (const std::size_t later : wrong_[sooner]) {
      if (is_tried[later]) continue;
      is_tried[later] = true;
      if (matched_[later] && !match(*matched_[later], is_tried)) continue;
      matched_[later] = sooner;
      return true;
    }
    return false;
  }

  /// Of each step those later ones that it needs.
  std::vector<std::vector<std::size_t>> wrong_;
  std::vector<std::optional<std::size_t>> matched_;
};

/// Where steps say what they come after: the most that were carried out without one before what it
/// needs, as a share of the required ones.
Finding order_of_ordered_steps(const scenarios::Scenario& scenario, const StepTicks& ticks,
                               std::int64_t end_tick) {
  const std::vector<bool> is_not_required = not_required(scenario, ticks);
  WrongPairs wrong(scenario, ticks);
  std::size_t required = 0, done = 0;
  std::optional<std::int64_t> first_tick;
  for (std::size_t step = 0; step < ticks.size(); ++step) {
    if (is_not_required[step]) continue;
    ++required;
    if (ticks[step]) ++done;
    const bool is_amiss = !ticks[step] || wrong.is_any_of(step);
    if (is_amiss && !first_tick) first_tick = ticks[step].value_or(end_tick);
  }
  const std::size_t kept = done - wrong.matching();
  const std::int64_t tick = first_tick.value_or(end_tick);
  return {static_cast<double>(kept) / static_cast<double>(required), tick, tick};
}

}  // namespace

Finding measure_step_order(const Evidence& evidence) {
  StepTicks ticks;
  for (std::size_t index = 0; index < evidence.scenario.steps.size(); ++index)
    ticks.push_back(tick_of(evidence, index));
  if (ticks.empty()) return {1.0, 0, 0};
  const std::int64_t end_tick = last_tick_of(evidence.recording);
  if (evidence.scenario.format != 1)
    return order_of_ordered_steps(evidence.scenario, ticks, end_tick);
  const std::vector<bool> is_kept = kept_of(ticks);
  const auto kept = std::count(is_kept.begin(), is_kept.end(), true);
  const auto left_out = static_cast<std::size_t>(
      std::distance(is_kept.begin(), std::find(is_kept.begin(), is_kept.end(), false)));
  const std::int64_t tick = left_out < ticks.size() ? ticks[left_out].value_or(end_tick) : end_tick;
  return {static_cast<double>(kept) / static_cast<double>(ticks.size()), tick, tick};
}

}  // namespace hallux::assessment
