// Steps, pauses and the end of an operation: the half of the screen that gives commands.
#include <utility>

#include "simulator/base/units.h"
#include "ui/screens/operating/operating_screen.h"
#include "ui/screens/operating/operation_work.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/menu.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

using scenarios::StepKind;
using simulator::CutEventKind;

/// What was asked for waits for the pieces; they take a slow machine seconds.
constexpr double longest_wait_s = 20.0;
constexpr double soon_s = 0.05, shown_after_s = 0.3;
constexpr float sealing_height = 44.0F;
constexpr double silence_s = static_cast<double>(simulator::MouseDevice::silence_ticks) * step_s;
/// The panels at the foot and the line of trouble above them.
constexpr float room_of_panels = 92.0F + 16.0F + 44.0F;

}  // namespace

void OperatingScreen::draw_paused(Ui& ui) {
  const LayerScope layer(ui.canvas(), Layer::Page);
  const Rect display = ui.display();
  const float width = std::min(440.0F, display.w - 32.0F), inner = width - 48.0F;
  const std::string words =
      (paused_by_ == nullptr ? std::string() : std::string(ui.text(paused_by_)) + " ") +
      std::string(ui.text("operate.paused.sentence"));
  const float words_height = ui.paragraph_height(Type::Small, words, inner);
  const float height = 44.0F + words_height + 12.0F + button_height + 16.0F;
  // Below the bone where there is room: whoever pauses may want to look at it.
  const float low = 0.94F * display.h - room_of_panels - height;
  const Rect rect{display.mid_x() - 0.5F * width, std::max(display.mid_y() - 0.5F * height, low),
                  width, height};
  draw_hud_panel(ui.canvas(), ui.theme(), rect);
  ui.canvas().text_in({rect.x + 24.0F, rect.y + 12.0F, inner, 28.0F},
                      {Type::CardTitle, ui.theme().text, Align::Centre}, ui.text("operate.paused"));
  ui.canvas().paragraph({rect.x + 24.0F, rect.y + 44.0F, inner, words_height},
                        {Type::Small, ui.theme().text_secondary, Align::Centre}, words);
  const ButtonSpec go_on{ui.text("operate.resume"), ButtonLook::Secondary, Icon::Play};
  const float button_w = button_width(ui, go_on);
  if (button(ui, "operate.go_on",
             {rect.mid_x() - 0.5F * button_w, rect.bottom() - 16.0F - button_height, button_w,
              button_height},
             go_on))
    set_paused(false);
}

/// The loop ends and the record is closed: a moment, unless the disk is slow.
void OperatingScreen::draw_sealing(Ui& ui) const {
  if (ui.time_s() - sealing_since_s_ < shown_after_s) return;
  const std::string_view words = ui.text("operate.sealing");
  const float width = ui.width_of(Type::BodyMedium, words) + 48.0F;
  const Rect display = ui.display();
  const Rect rect{display.mid_x() - 0.5F * width, 0.94F * display.h - sealing_height, width,
                  sealing_height};
  draw_hud_panel(ui.canvas(), ui.theme(), rect);
  ui.canvas().text_in(rect, {Type::BodyMedium, ui.theme().text, Align::Centre}, words);
}

/// The saw runs only while somebody can hear, see and stop it.
const char* OperatingScreen::what_took_the_hands(Ui& ui) const {
  if (ui.has_lost_keys()) return "operate.paused.keys";
  if (!is_saw_on_) return nullptr;
  if (ui.has_pointer_left() && steering_.is_led_by_pointer()) return "operate.paused.pointer";
  if (reachable_layer(ui.shown()) > Layer::Page) return "operate.paused.covered";
  return ui.time_s() > steered_s_ + silence_s ? "operate.paused.still" : nullptr;
}

void OperatingScreen::set_paused(bool is_paused) {
  if (is_paused == is_paused_ || (!is_paused && is_storage_full_)) return;
  is_paused_ = is_paused;
  paused_by_ = nullptr;
  if (is_paused) {
    is_saw_on_ = false;
    begun_->mouse->aim(world_from_target_, 0);
    begun_->live->pause();
  } else {
    begun_->live->resume();
  }
}

void OperatingScreen::carry_out_step(Ui& ui) {
  const std::vector<scenarios::OperationStep>& steps = prepared_.value().table->scenario.steps;
  if (step_ >= steps.size() || waiting_ != Waiting::Nothing) return;
  switch (steps[step_].kind) {
    case StepKind::Verify:
    case StepKind::Cut:
      end_step();
      break;
    case StepKind::Remove:
      waiting_ = Waiting::Piece;
      waiting_until_s_ = ui.time_s() + longest_wait_s;
      begun_->live->pick_up_freed();
      break;
    case StepKind::Close:
      waiting_ = Waiting::Hinge;
      waiting_until_s_ = ui.time_s() + longest_wait_s;
      begun_->live->close_hinge();
      break;
    case StepKind::Finish:
      ask(Asking::Finish);
      break;
  }
}

void OperatingScreen::end_step() {
  begun_->live->declare_done(static_cast<std::int32_t>(step_));
  ++step_;
  waiting_ = Waiting::Nothing;
}

void OperatingScreen::follow_events(Ui& ui, Shell& shell) {
  const auto warn = [&](const char* title, const char* detail) {
    waiting_ = Waiting::Nothing;
    shell.say({Meaning::Info, std::string(ui.text(title)), std::string(ui.text(detail))});
  };
  for (const simulator::CutEvent& event : bone_->take_events()) {
    if (event.kind == CutEventKind::PieceFreed) ++freed_;
    if (event.kind == CutEventKind::PieceRemoved) {
      ++removed_;
      if (waiting_ == Waiting::Piece) end_step();
    }
    if (event.kind == CutEventKind::HingeClosed && waiting_ == Waiting::Hinge) end_step();
    if (event.kind == CutEventKind::HingeRefused) {
      warn("operate.hinge_refused", event.subject == 1   ? "operate.hinge.broken"
                                    : event.subject == 2 ? "operate.hinge.stiff"
                                                         : "operate.hinge.nothing");
    }
    if (event.kind == CutEventKind::KerfRefused) {
      warn("operate.kerf_refused", "operate.kerf_refused.detail");
    }
  }
  if (waiting_ == Waiting::Nothing || ui.time_s() < waiting_until_s_) return;
  if (waiting_ == Waiting::Piece) {
    warn("operate.nothing_free", "operate.nothing_free.detail");
  } else {
    warn("operate.hinge_refused", "operate.hinge.waiting");
  }
}

void OperatingScreen::ask(Asking what) {
  if (phase_ != Phase::Operating || asking_ != Asking::Nothing) return;
  asking_ = what;
  was_paused_before_ = is_paused_;
  set_paused(true);
}

void OperatingScreen::draw_question(Ui& ui) {
  if (asking_ == Asking::Nothing) return;
  const bool is_finish = asking_ == Asking::Finish;
  const Question words =
      is_finish ? Question{ui.text("operate.ask.finish"), ui.text("operate.ask.finish.detail"),
                           ui.text("operate.ask.finish.act"), ui.text("operate.ask.keep"), false}
                : Question{ui.text("operate.ask.abandon"), ui.text("operate.ask.abandon.detail"),
                           ui.text("operate.ask.abandon.act"), ui.text("operate.ask.keep"), true};
  const Answer answer =
      question(ui, is_finish ? "operate.ask_finish" : "operate.ask_abandon", words);
  if (answer == Answer::Waiting) return;
  asking_ = Asking::Nothing;
  ui.want_frame_in_s(0.0);
  // A disk that filled up meanwhile keeps it paused.
  if (answer == Answer::Keep) {
    set_paused(was_paused_before_);
    return;
  }
  phase_ = Phase::Sealing;
  sealing_since_s_ = ui.time_s();
  is_abandoned_ = !is_finish;
  if (is_finish) {
    begun_->live->finish();
  } else {
    begun_->live->abandon();
  }
}

void OperatingScreen::follow_end(Ui& ui, Shell& shell) {
  const LiveEnd* end = begun_->live->end();
  if (phase_ == Phase::Sealing) ui.want_frame_in_s(soon_s);
  if (end == nullptr || phase_ == Phase::Scoring || phase_ == Phase::Stopped) return;
  asking_ = Asking::Nothing;
  if (end->failure != LiveFailure::None || (!end->is_sealed && !is_abandoned_)) {
    why_not_leave_.clear();
    stopped_ = words_of_failure(ui, *end);
    is_saw_on_ = false;
    phase_ = Phase::Stopped;
    ui.want_frame_in_s(0.0);
    return;
  }
  if (is_abandoned_) {
    shell.say({Meaning::Info, std::string(ui.text("operate.abandoned")),
               std::string(ui.text("operate.abandoned.detail"))});
    why_not_leave_.clear();
    phase_ = Phase::Scoring;
    shell.pop();
    return;
  }
  score(ui, shell);
}

std::string OperatingScreen::words_of_failure(const Ui& ui, const LiveEnd& end) const {
  switch (end.failure) {
    case LiveFailure::DiskFull:
      return ui.texts().say("operate.stopped.disk", {{"file", end.file.string()}});
    case LiveFailure::MemoryFull:
      return std::string(ui.text("operate.stopped.memory"));
    case LiveFailure::Other:
      return sentence_of(end.reason);
    case LiveFailure::None:
      break;
  }
  return std::string(ui.text("operate.stopped.unknown"));
}

void OperatingScreen::score(Ui& ui, Shell& shell) {
  phase_ = Phase::Scoring;
  why_not_leave_ = ui.text("operate.stay.scoring");
  work_.start(
      shell, std::string(ui.text("operate.scoring")),
      [visit = visit_, attempt = begun_->live->attempt()](WorkReport& report) {
        score_operation(*visit, attempt, report);
      },
      [this, &shell, title = std::string(ui.text("operate.unscored"))](WorkEnd end,
                                                                       const std::string& reason) {
        if (end != WorkEnd::Done) shell.say({Meaning::Warn, title, sentence_of(reason)});
        lead_on(shell, Onward::Result);
      });
}

void OperatingScreen::lead_on(Shell& shell, Onward where) {
  why_not_leave_.clear();
  const database::AttemptId attempt = begun_->live->attempt();
  Places& places = places_;
  shell.pop();
  if (where == Onward::Result) return places.show_result(attempt);
  places.show_replay(attempt, 0.0);
}

}  // namespace hallux::ui
