#include "ui/screens/operating/step_progress.h"

#include <algorithm>

#include "scenarios/steps/step_order.h"

namespace hallux::ui {

using scenarios::StepKind;
using simulator::CutEventKind;

namespace {

/// The kernel takes no more out in an attempt.
constexpr int most_removed = 8;

/// By the number that the kernel gives a hinge that it does not close.
Notice notice_of_hinge(std::int32_t refusal) noexcept {
  return refusal == 1   ? Notice::HingeBroken
         : refusal == 2 ? Notice::HingeStiff
                        : Notice::HingeMissing;
}

}  // namespace

StepProgress::StepProgress(const scenarios::Scenario& scenario)
    : ordered_(scenario.format == 1 ? nullptr : &scenario), done_(scenario.steps.size(), false) {
  for (const scenarios::OperationStep& step : scenario.steps) {
    steps_.push_back(step.kind);
    const auto hinge =
        std::ranges::find(scenario.hinges, step.hinge, &scenarios::ReferenceHinge::name);
    hinges_.push_back(static_cast<std::int32_t>(hinge - scenario.hinges.begin()));
  }
}

std::optional<StepKind> StepProgress::kind() const noexcept {
  return step_ < steps_.size() ? std::optional(steps_[step_]) : std::nullopt;
}

/// A chain without a scenario has one at most.
std::int32_t StepProgress::hinge() const noexcept {
  return step_ < hinges_.size() ? hinges_[step_] : 0;
}

bool StepProgress::is_ready() const noexcept {
  if (is_waiting() || !kind()) return false;
  return *kind() != StepKind::Remove || (wanted() != nullptr && wanted()->is_off);
}

/// Of the step at hand; null where it takes nothing out, or nothing is known yet.
const scenarios::WantedPart* StepProgress::wanted() const noexcept {
  if (!kind() || !scenarios::takes_out(*kind())) return nullptr;
  const auto part = static_cast<std::size_t>(std::count_if(
      steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(step_), scenarios::takes_out));
  return part < parts_.size() ? &parts_[part] : nullptr;
}

StepDeed StepProgress::press(double now_s) {
  if (!kind() || is_waiting()) return StepDeed::Nothing;
  switch (*kind()) {
    case StepKind::Remove:
    case StepKind::Trim:
      return take_out(now_s);
    case StepKind::Close:
      wait_for(Waiting::Hinge, now_s);
      return StepDeed::CloseHinge;
    case StepKind::Finish:
      return StepDeed::AskToFinish;
    default:
      return StepDeed::EndStep;
  }
}

/// Where nothing of it lies there any more, that was all; what is trimmed may end unfinished.
StepDeed StepProgress::take_out(double now_s) {
  if (!is_ready()) return StepDeed::Nothing;
  to_take_.clear();
  if (wanted() != nullptr && wanted()->is_off) to_take_ = wanted()->pieces;
  const auto room = static_cast<std::size_t>(std::max(0, most_removed - removed_));
  if (to_take_.size() > room) to_take_.resize(room);
  if (to_take_.empty()) return StepDeed::EndStep;
  wait_for(Waiting::Piece, now_s);
  return StepDeed::PickUp;
}

StepNews StepProgress::apply(const simulator::CutEvent& event) {
  switch (event.kind) {
    case CutEventKind::PieceFreed:
      ++freed_;
      return {};
    case CutEventKind::PieceRemoved:
      ++removed_;
      return removed(event.subject);
    case CutEventKind::HingeClosed:
      return {waiting_ == Waiting::Hinge};
    case CutEventKind::HingeRefused:
      return refused(notice_of_hinge(event.subject));
    case CutEventKind::KerfRefused:
      return refused(Notice::KerfRefused);
    default:
      return {};
  }
}

StepNews StepProgress::removed(std::int32_t piece) {
  if (waiting_ != Waiting::Piece || to_take_.front() != piece) return {};
  to_take_.erase(to_take_.begin());
  if (to_take_.empty()) return {true};
  return {false, {}, to_take_.front()};
}

std::optional<Notice> StepProgress::expire(double now_s) noexcept {
  if (!is_waiting() || now_s < waiting_until_s_) return std::nullopt;
  return refused(waiting_ == Waiting::Piece ? Notice::NothingFree : Notice::HingeUnanswered).notice;
}

std::int32_t StepProgress::end_step() {
  waiting_ = Waiting::Nothing;
  const std::size_t ended = step_;
  done_[ended] = true;
  step_ = next_after(ended);
  return static_cast<std::int32_t>(ended);
}

/// Of several that may be done next the first after the one that ended, else the first of all.
std::size_t StepProgress::next_after(std::size_t ended) const {
  if (ordered_ == nullptr) {
    std::size_t next = ended;
    while (next < steps_.size() && done_[next]) ++next;
    return next;
  }
  const std::vector<std::size_t> at_hand = steps_at_hand(*ordered_, done_);
  const auto later = std::ranges::upper_bound(at_hand, ended);
  if (later != at_hand.end()) return *later;
  return at_hand.empty() ? steps_.size() : at_hand.front();
}

bool StepProgress::can_choose(std::size_t step) const {
  if (ordered_ == nullptr || is_waiting() || step == step_) return false;
  const std::vector<std::size_t> at_hand = steps_at_hand(*ordered_, done_);
  return std::ranges::binary_search(at_hand, step);
}

bool StepProgress::can_reopen(std::size_t step) const noexcept {
  if (!is_done(step) || is_waiting()) return false;
  const StepKind kind = steps_[step];
  return kind != StepKind::Remove && kind != StepKind::Close && kind != StepKind::Finish;
}

void StepProgress::reopen(std::size_t step) noexcept {
  done_[step] = false;
  step_ = step;
}

void StepProgress::wait_for(Waiting what, double now_s) noexcept {
  waiting_ = what;
  waiting_until_s_ = now_s + longest_wait_s;
}

StepNews StepProgress::refused(Notice notice) noexcept {
  waiting_ = Waiting::Nothing;
  return {false, notice};
}

}  // namespace hallux::ui
