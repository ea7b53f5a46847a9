// Steps, pauses and the end of an operation: the half of the screen that gives commands.
#include <utility>

#include "ui/screens/operating/operating_screen.h"
#include "ui/screens/operating/operation_work.h"
#include "ui/widgets/menu.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

using scenarios::StepKind;
using simulator::CutEventKind;

constexpr double piece_wait_s = 1.0, hinge_wait_s = 20.0;
constexpr double soon_s = 0.05;

}  // namespace

void OperatingScreen::draw_paused(Ui& ui) {
  const LayerScope layer(ui.canvas(), Layer::Page);
  const Rect rect = centred(ui.display(), std::min(360.0F, ui.display().w - 32.0F), 72.0F);
  draw_hud_panel(ui.canvas(), ui.theme(), rect);
  ui.canvas().text_in({rect.x + 24.0F, rect.y + 10.0F, rect.w - 48.0F, 28.0F},
                      {Type::CardTitle, ui.theme().text, Align::Centre}, ui.text("operate.paused"));
  ui.canvas().text_in({rect.x + 24.0F, rect.y + 38.0F, rect.w - 48.0F, 22.0F},
                      {Type::Small, ui.theme().text_secondary, Align::Centre},
                      ui.text("operate.paused.sentence"));
}

void OperatingScreen::set_paused(bool is_paused) {
  if (is_paused == is_paused_) return;
  is_paused_ = is_paused;
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
      waiting_until_s_ = ui.time_s() + piece_wait_s;
      begun_->live->pick_up_freed();
      break;
    case StepKind::Close:
      waiting_ = Waiting::Hinge;
      waiting_until_s_ = ui.time_s() + hinge_wait_s;
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
  if (answer == Answer::Keep) {
    set_paused(was_paused_before_);
    return;
  }
  phase_ = Phase::Sealing;
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
  if (!end->failure.empty() || (!end->is_sealed && !is_abandoned_)) {
    why_not_leave_.clear();
    stopped_ = end->failure.empty() ? std::string(ui.text("operate.stopped.unknown"))
                                    : sentence_of(end->failure);
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
        lead_on(shell);
      });
}

void OperatingScreen::lead_on(Shell& shell) {
  why_not_leave_.clear();
  const database::AttemptId attempt = begun_->live->attempt();
  Places& places = places_;
  shell.pop();
  places.show_result(attempt);
}

}  // namespace hallux::ui
