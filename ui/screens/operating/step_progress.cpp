#include "ui/screens/operating/step_progress.h"

#include <algorithm>

namespace hallux::ui {

using scenarios::StepKind;
using simulator::CutEventKind;

namespace {

/// The kernel takes no more out in an attempt.
constexpr int most_removed = 8;

/// By the number that the kernel gives a hinge that it does not close.
StepNotice notice_of_hinge(std::int32_t refusal) noexcept {
  return refusal == 1   ? StepNotice::HingeBroken
         : refusal == 2 ? StepNotice::HingeStiff
                        : StepNotice::HingeMissing;
}

}  // namespace

std::optional<StepKind> StepProgress::kind() const noexcept {
  return step_ < steps_.size() ? std::optional(steps_[step_]) : std::nullopt;
}

bool StepProgress::is_ready() const noexcept {
  if (is_waiting() || !kind()) return false;
  return *kind() != StepKind::Remove || (wanted() != nullptr && wanted()->is_off);
}

/// Of the step at hand; null where it takes nothing out, or nothing is known yet.
const scenarios::WantedPart* StepProgress::wanted() const noexcept {
  if (kind() != StepKind::Remove) return nullptr;
  const auto part = static_cast<std::size_t>(std::count(
      steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(step_), StepKind::Remove));
  return part < parts_.size() ? &parts_[part] : nullptr;
}

StepDeed StepProgress::press(double now_s) {
  if (!kind() || is_waiting()) return StepDeed::Nothing;
  switch (*kind()) {
    case StepKind::Remove:
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

/// Where nothing of it lies there any more, that was all.
StepDeed StepProgress::take_out(double now_s) {
  if (!is_ready()) return StepDeed::Nothing;
  to_take_ = wanted()->pieces;
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
      return refused(StepNotice::KerfRefused);
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

std::optional<StepNotice> StepProgress::expire(double now_s) noexcept {
  if (!is_waiting() || now_s < waiting_until_s_) return std::nullopt;
  return refused(waiting_ == Waiting::Piece ? StepNotice::NothingFree : StepNotice::HingeUnanswered)
      .notice;
}

std::int32_t StepProgress::end_step() noexcept {
  waiting_ = Waiting::Nothing;
  const std::size_t ended = step_;
  done_[ended] = true;
  while (step_ < steps_.size() && done_[step_]) ++step_;
  return static_cast<std::int32_t>(ended);
}

bool StepProgress::can_reopen(std::size_t step) const noexcept {
  return is_done(step) && !is_waiting() &&
         (steps_[step] == StepKind::Verify || steps_[step] == StepKind::Cut);
}

void StepProgress::reopen(std::size_t step) noexcept {
  done_[step] = false;
  step_ = step;
}

void StepProgress::wait_for(Waiting what, double now_s) noexcept {
  waiting_ = what;
  waiting_until_s_ = now_s + longest_wait_s;
}

StepNews StepProgress::refused(StepNotice notice) noexcept {
  waiting_ = Waiting::Nothing;
  return {false, notice};
}

}  // namespace hallux::ui
