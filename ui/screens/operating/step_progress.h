/// The step of an operation that is at hand, and the answer that a pressed step waits for.
/// Inside this corner only.
///
///     at hand --pressed--> done at once
///        |   '--pressed--> waits for pieces or the hinge --events of the kernel--> done
///        |'<---refused, or 20 s without an answer----'                              |
///        '<-------------- taken up again, where no deed is undone -----------------'
///
/// In a chain the next that is not done comes after each. Where steps only say what they come
/// after, several may be done next: the first of them is at hand until another is chosen. A step
/// that takes bone out does so piece after piece, the largest first; what else lies free is left
/// there.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/site/wanted_part.h"
#include "simulator/record/record.h"
#include "ui/screens/operating/hand/notice.h"

namespace hallux::ui {

/// What the button of a step asks for.
enum class StepDeed { Nothing, EndStep, PickUp, CloseHinge, AskToFinish };

struct StepNews {
  /// The step at hand got what it waited for.
  bool is_fulfilled = false;
  std::optional<Notice> notice = {};
  /// The next to be taken out.
  std::optional<std::int32_t> piece = {};
};

class StepProgress {
 public:
  /// Pieces take a slow machine seconds.
  static constexpr double longest_wait_s = 20.0;

  StepProgress() = default;
  /// A chain.
  explicit StepProgress(std::vector<scenarios::StepKind> steps)
      : steps_(std::move(steps)), done_(steps_.size(), false) {}
  /// Of a scenario in its own order. Borrows it.
  explicit StepProgress(const scenarios::Scenario& scenario);

  /// Number of the step at hand, from 0; the count of steps after the last.
  std::size_t step() const noexcept { return step_; }
  bool is_done(std::size_t step) const noexcept { return step < done_.size() && done_[step]; }
  /// Done by a word alone, and nothing is waited for. What was taken out or closed stays so.
  bool can_reopen(std::size_t step) const noexcept;
  /// Not at hand, and may be done next; nothing is waited for.
  bool can_choose(std::size_t step) const;
  /// It is at hand instead.
  /// needs   can_choose(step)
  void choose(std::size_t step) noexcept { step_ = step; }
  /// That step is at hand again.
  /// needs   can_reopen(step)
  void reopen(std::size_t step) noexcept;
  /// Nothing after the last step.
  std::optional<scenarios::StepKind> kind() const noexcept;
  bool is_waiting() const noexcept { return waiting_ != Waiting::Nothing; }
  /// The number of the hinge that the step at hand closes.
  std::int32_t hinge() const noexcept;
  /// Whether the button does anything now: a step's part is taken out once it is off.
  bool is_ready() const noexcept;
  /// Something lies free, be it a crumb.
  bool lies_anything_free() const noexcept { return freed_ > removed_; }

  /// What the steps that remove ask for, in their order, as it lies in the wound now.
  void see(std::span<const scenarios::WantedPart> parts) {
    parts_.assign(parts.begin(), parts.end());
  }
  /// The button of the step at hand was pressed; what it asks for may be waited for from now on.
  StepDeed press(double now_s);
  /// The piece that is waited for.
  /// needs   press said PickUp, and nothing was applied since
  std::int32_t piece_to_take() const noexcept { return to_take_.front(); }
  /// Takes what happened at the bone.
  StepNews apply(const simulator::CutEvent& event);
  /// Gives up on an answer that does not come.
  std::optional<Notice> expire(double now_s) noexcept;
  /// Ends the step at hand. Returns its number.
  std::int32_t end_step();

 private:
  enum class Waiting { Nothing, Piece, Hinge };

  const scenarios::WantedPart* wanted() const noexcept;
  StepDeed take_out(double now_s);
  StepNews removed(std::int32_t piece);
  void wait_for(Waiting what, double now_s) noexcept;
  StepNews refused(Notice notice) noexcept;
  std::size_t next_after(std::size_t ended) const;

  /// Null of a chain.
  const scenarios::Scenario* ordered_ = nullptr;
  std::vector<scenarios::StepKind> steps_;
  /// Of each step that closes one, the hinge.
  std::vector<std::int32_t> hinges_;
  std::vector<bool> done_;
  std::size_t step_ = 0;
  Waiting waiting_ = Waiting::Nothing;
  double waiting_until_s_ = 0.0;
  int freed_ = 0, removed_ = 0;
  std::vector<scenarios::WantedPart> parts_;
  /// While pieces are waited for: these, in turn.
  std::vector<std::int32_t> to_take_;
};

}  // namespace hallux::ui
