// What happens between the person and an attempt, apart from any picture. Functions ask for the
// phase first: keys and answers may come a frame late, after a pause or the end. The saw stops
// before the attempt is told of a pause, and a question pauses too, so that nothing is cut while
// somebody reads. The end is taken from the attempt, never assumed.
#include "ui/screens/operating/operating_session.h"

#include <utility>

namespace hallux::ui {

OperatingSession::Staying OperatingSession::staying() const noexcept {
  if (phase_ == Phase::Scoring) return Staying::WhileScored;
  const bool is_recorded = phase_ >= Phase::Beginning && phase_ <= Phase::Sealing;
  return is_recorded ? Staying::WhileRecorded : Staying::No;
}

// -- before

void OperatingSession::make_ready(StepProgress steps, const LedSaw& saw, ToolsInHand tools) {
  steps_ = std::move(steps);
  saw_ = saw;
  tools_ = std::move(tools);
  phase_ = Phase::Ready;
}

bool OperatingSession::begin() noexcept {
  if (phase_ != Phase::Ready) return false;
  phase_ = Phase::Beginning;
  return true;
}

void OperatingSession::run(AttemptControls& attempt, simulator::SteeredDevice& device) noexcept {
  attempt_ = &attempt;
  saw_.take(device);
  phase_ = Phase::Operating;
}

void OperatingSession::fail_to_begin(const std::string& reason) {
  stop_ = {LiveFailure::Other, reason, {}};
  phase_ = Phase::Stopped;
}

// -- the hands

void OperatingSession::lift(bool is_lifted) noexcept {
  if (is_lifted == saw_.is_lifted()) return;
  if (is_lifted) {
    saw_.lift();
  } else {
    saw_.set_down();
  }
}

void OperatingSession::watch(const HandsSeen& hands, double now_s) {
  if (!is_led()) return;
  if (hands.have_lost_keys) return pause(PausedBy::KeysLost);
  if (!saw_.is_on()) return;
  if (hands.has_pointer_left) return pause(PausedBy::PointerLeft);
  if (hands.is_covered) return pause(PausedBy::Covered);
  if (saw_.is_silent(now_s)) pause(PausedBy::Stillness);
}

void OperatingSession::pause(PausedBy by) {
  if (phase_ != Phase::Operating || !pausing_.pause(by)) return;
  saw_.release();
  attempt_->pause();
}

void OperatingSession::go_on() {
  if (is_device_lost_ || phase_ != Phase::Operating) return;
  if (pausing_.go_on()) attempt_->resume();
}

void OperatingSession::see_device(bool is_lost) {
  if (phase_ != Phase::Operating || is_lost == is_device_lost_) return;
  is_device_lost_ = is_lost;
  if (is_lost) return pause(PausedBy::DeviceLost);
  if (asked() == Asked::Nothing && pausing_.by() == PausedBy::DeviceLost) go_on();
}

void OperatingSession::take_over_from_device() {
  if (is_device_lost_ && is_practice()) saw_.take_over();
}

void OperatingSession::toggle_pause() {
  if (pausing_.is_paused()) return go_on();
  pause(PausedBy::Person);
}

// -- the tools

void OperatingSession::open_tray() {
  if (!is_led() || tools_.tray().size() < 2) return;
  saw_.set_on(false);
  saw_.release();
  asking_ = {Asked::Tool, false};
}

void OperatingSession::close_tray(std::optional<std::int32_t> place) {
  if (asked() != Asked::Tool) return;
  asking_ = {};
  if (is_led() && place && *place != tools_.place()) attempt_->choose_tool(*place);
}

void OperatingSession::work_forceps(std::optional<std::int32_t> piece) {
  if (!is_led()) return;
  if (tools_.forceps() != Forceps::Open) {
    if (tools_.forceps() == Forceps::Closing) tools_.open_forceps();
    return attempt_->release();
  }
  if (!piece) return;
  saw_.set_on(false);
  tools_.close_forceps();
  attempt_->grip(*piece);
}

void OperatingSession::drive_home() {
  if (!is_led() || tools_.forceps() != Forceps::Holding) return;
  tools_.drive_home();
  attempt_->impact();
}

void OperatingSession::leave_or_take(bool stands_in_bone, std::optional<std::int32_t> implant) {
  if (!is_led() || !tools_.is_implant_driver()) return;
  if (stands_in_bone || !implant) return attempt_->leave_implant();
  attempt_->take_implant(*implant);
}

// -- steps

void OperatingSession::press_step(bool is_cut_through, double now_s) {
  const std::optional<scenarios::StepKind> kind = steps_.kind();
  const bool is_sawn = kind == scenarios::StepKind::Cut || kind == scenarios::StepKind::Trim;
  const bool is_unfinished = is_sawn && !is_cut_through;
  if (is_unfinished && asked_of_step_ != steps_.step()) {
    if (!is_heard()) return;
    asked_of_step_ = steps_.step();
    return ask(Asked::EndUnfinished);
  }
  switch (steps_.press(now_s)) {
    case StepDeed::Nothing:
      break;
    case StepDeed::EndStep:
      end_step();
      break;
    case StepDeed::PickUp:
      attempt_->pick_up(steps_.piece_to_take());
      break;
    case StepDeed::CloseHinge:
      attempt_->close_hinge(steps_.hinge());
      break;
    case StepDeed::AskToFinish:
      ask(Asked::Finish);
      break;
  }
}

std::vector<Notice> OperatingSession::apply(std::span<const simulator::CutEvent> events,
                                            double now_s) {
  std::vector<Notice> notices;
  for (const simulator::CutEvent& event : events) {
    if (const std::optional<Notice> notice = tools_.apply(event)) notices.push_back(*notice);
    const StepNews news = steps_.apply(event);
    if (news.is_fulfilled) end_step();
    if (news.piece) attempt_->pick_up(*news.piece);
    if (news.notice) notices.push_back(*news.notice);
  }
  if (const std::optional<Notice> notice = steps_.expire(now_s)) notices.push_back(*notice);
  return notices;
}

void OperatingSession::take_up_step(std::size_t step) {
  if (!is_heard()) return;
  if (steps_.can_choose(step)) return steps_.choose(step);
  if (!steps_.can_reopen(step)) return;
  steps_.reopen(step);
  asked_of_step_.reset();
  attempt_->reopen(static_cast<std::int32_t>(step));
}

void OperatingSession::end_step() { attempt_->declare_done(steps_.end_step()); }

// -- the end

void OperatingSession::ask(Asked what) {
  if (!is_heard()) return;
  asking_ = {what, pausing_.is_paused()};
  pause(PausedBy::Person);
}

void OperatingSession::answer(Decided decided, double now_s) {
  if (asked() == Asked::Tool) return close_tray({});
  const auto [asked, was_paused] = std::exchange(asking_, {});
  if (decided != Decided::GoOn && asked != Asked::EndUnfinished) {
    const bool is_finished = decided == Decided::Finish || asked == Asked::Finish;
    return end_attempt(!is_finished, now_s);
  }
  if (decided == Decided::Act) end_step();
  // A device may have come back meanwhile.
  if (!was_paused || pausing_.by() == PausedBy::DeviceLost) go_on();
}

void OperatingSession::end_attempt(bool is_abandoned, double now_s) {
  seal(now_s);
  ending_.is_abandoned = is_abandoned;
  if (is_abandoned) {
    attempt_->abandon();
  } else {
    attempt_->finish();
  }
}

bool OperatingSession::update_storage() {
  if (phase_ != Phase::Operating && phase_ != Phase::Sealing) return false;
  const bool is_full = attempt_->is_storage_full();
  if (is_full == pausing_.is_storage_full()) return false;
  if (is_full) {
    pause(PausedBy::Person);
    pausing_.wait_for_room();
  } else {
    pausing_.have_room();
  }
  return true;
}

void OperatingSession::abandon_unstored(double now_s) {
  seal(now_s);
  attempt_->abandon();
}

void OperatingSession::seal(double now_s) noexcept {
  phase_ = Phase::Sealing;
  ending_.since_s = now_s;
}

OperatingSession::Onward OperatingSession::take_end() {
  if (phase_ != Phase::Operating && phase_ != Phase::Sealing) return Onward::Nowhere;
  const LiveEnd* end = attempt_->end();
  if (end == nullptr) return Onward::Nowhere;
  asking_ = {};
  if (end->failure != LiveFailure::None || (!end->is_sealed && !ending_.is_abandoned)) {
    stop_ = {end->failure, end->reason, end->file};
    saw_.set_on(false);
    phase_ = Phase::Stopped;
    return Onward::Stopped;
  }
  phase_ = ending_.is_abandoned ? Phase::Over : Phase::Scoring;
  return ending_.is_abandoned ? Onward::Abandoned : Onward::Score;
}

}  // namespace hallux::ui
