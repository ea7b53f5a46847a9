// An attempt, drawn: the field hears the person and shows what is so; the screen leads it from
// preparing to its score.
#include "ui/screens/operating/operating_screen.h"

#include <algorithm>
#include <utility>

#include "ui/screens/operating/hand/tray_card.h"
#include "ui/screens/operating/hud_facts.h"
#include "ui/screens/operating/operating_cards.h"
#include "ui/widgets/controls/card.h"

namespace hallux::ui {

namespace {

constexpr double soon_s = 0.05;

std::string text_in(const Ui& ui, std::string_view id) { return std::string(ui.text(id)); }

const char* name_of(StereoMode mode) {
  return mode == StereoMode::Mono         ? "mono"
         : mode == StereoMode::SideBySide ? "side_by_side"
                                          : "anaglyph";
}

}  // namespace

OperatingScreen::OperatingScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator,
                                 const OperationChoice& choice, LendHands lend_hands)
    : signed_in_(std::move(signed_in)),
      navigator_(navigator),
      choice_(choice),
      lend_hands_(std::move(lend_hands)),
      field_(choice.way.kind, choice.way.guidance) {}

std::string_view OperatingScreen::why_not_leave() const {
  const auto staying = session().staying();
  if (texts_ == nullptr || staying == OperatingSession::Staying::No) return {};
  return texts_->text(staying == OperatingSession::Staying::WhileScored ? "operate.stay.scoring"
                                                                        : "operate.stay");
}

bool OperatingScreen::ask_before_leaving(Ui& ui) {
  if (session().phase() != Phase::Operating) return false;
  session().ask(Asked::Leave);
  ui.want_frame_in_s(0.0);
  return session().asked() != Asked::Nothing;
}

void OperatingScreen::draw(Ui& ui, const Rect& /*content*/, Shell& shell) {
  texts_ = &ui.texts();
  if (session().phase() == Phase::Preparing) return prepare(ui, shell);
  if (session().phase() == Phase::Stopped) return draw_stopped(ui, shell);
  draw_operation(ui, shell);
}

// -- before

void OperatingScreen::prepare(Ui& ui, Shell& shell) {
  ui.canvas().fill(ui.display(), ui.theme().page);
  if (prepared_.is_new()) {
    prepared_.start(ui, shell, ui.text("operate.preparing"),
                    [signed_in = signed_in_, scenario = choice_.scenario](WorkReport& report) {
                      return prepare_operation(*signed_in, scenario, report);
                    });
  }
  const Rect inside =
      card(ui, centred(ui.display(), std::min(520.0F, ui.display().w - 32.0F), 300.0F),
           ui.text("operate.preparing"));
  if (!prepared_.draw_until_ready(ui, "operate.unprepared", inside, 4)) return;
  field_.make_ready(std::move(prepared_.value()));
  ui.want_frame_in_s(0.0);
}

LiveBegin OperatingScreen::what_to_begin() const {
  return {.scenario = choice_.scenario,
          .person = signed_in_->person().id,
          .kind = choice_.way.kind,
          .guidance = choice_.way.guidance,
          .force_law = choice_.way.feels_historic_law ? simulator::ForceLaw::Thesis
                                                      : simulator::ForceLaw::Simulated,
          .stereo_mode = name_of(field_.viewport().stereo_mode())};
}

void OperatingScreen::begin(Ui& ui, Shell& shell) {
  if (!session().begin()) return;
  auto begun = std::make_shared<Begun>();
  work_.start(
      shell, text_in(ui, "operate.beginning"),
      [signed_in = signed_in_, prepared_case = field_.prepared().prepared_case,
       what = what_to_begin(), start = field_.start(), lend = lend_hands_,
       begun](WorkReport& report) {
        try {
          LentHands hands = lend(start, [&](double) { return report.reached(0.0); });
          begun->device = hands.saw.get();
          begun->second = std::move(hands.second);
          LiveBegin begin = what;
          if (begun->second) begin.second_device = begun->second->kind();
          begun->live = begin_operation(*signed_in, prepared_case, begin, std::move(hands.saw));
        } catch (const DeviceRefused& refused) {
          begun->refused = refused.what();
        }
      },
      [this, &shell, begun, title = text_in(ui, "operate.refused")](WorkEnd end,
                                                                    const std::string& reason) {
        if (end == WorkEnd::Cancelled) return session().take_back();
        if (end == WorkEnd::Failed) return session().fail_to_begin(reason);
        if (!begun->refused.empty()) {
          shell.say({Meaning::Warn, title, sentence_of(begun->refused)});
          return session().take_back();
        }
        live_ = std::move(begun->live);
        field_.run(live_->attempt().text, *live_, *begun->device, std::move(begun->second));
      });
}

// -- while it runs

void OperatingScreen::draw_operation(Ui& ui, Shell& shell) {
  field_.hear(ui, shell);
  const bool is_end_pressed = session().is_heard() &&
                              ui.shortcut({Key::End}, ui.text("operate.key.finish")) &&
                              !ui.is_key_held_on();
  if (is_end_pressed) session().ask(Asked::Finish);
  if (field_.is_running()) field_.apply_loop(ui, shell);
  field_.show(ui, shell);
  if (field_.is_running() && field_.loop().lines > 0)
    live_->note_view(shown_view(ui), field_.loop().sample.tick);
  draw_cards(ui, shell);
  if (field_.is_running()) lead_on(ui, shell);
  field_.hold_pointer(ui, shell.preferences());
}

/// With the section beside it where the last frame had it: a small window has no room for it.
simulator::ShownView OperatingScreen::shown_view(const Ui& ui) const {
  simulator::ShownView view = field_.viewport().shown_view();
  if (find_widget(ui.shown(), "operate.panel.inset") != nullptr)
    view.layout = simulator::ShownLayout::WithSection;
  return view;
}

// -- the panels

void OperatingScreen::draw_cards(Ui& ui, Shell& shell) {
  const Phase phase = session().phase();
  const bool is_storage_full = session().pausing().is_storage_full();
  if (phase == Phase::Ready || phase == Phase::Beginning) return draw_ready(ui, shell);
  if (phase != Phase::Operating && phase != Phase::Sealing) return;
  if (phase == Phase::Operating && field_.are_panels_shown()) draw_hud(ui, shell);
  if (session().asked() != Asked::Nothing) return ask(ui);
  if (is_storage_full) {
    if (draw_storage_full_card(ui, live_->directory())) session().abandon_unstored(ui.time_s());
  } else if (phase == Phase::Sealing) {
    draw_sealing(ui, session().ended_s());
  } else if (session().is_device_lost()) {
    draw_device_lost(ui);
  } else if (session().pausing().is_paused()) {
    if (draw_paused_card(ui, session().pausing().by())) session().go_on();
  }
}

void OperatingScreen::draw_ready(Ui& ui, Shell& shell) {
  const bool is_beginning = session().phase() == Phase::Beginning;
  const ReadyAnswer answer = draw_ready_card(
      ui, field_.prepared_case().scenario.title,
      ready_text(ui, session().is_practice(), is_beginning, shell.preferences().device),
      is_beginning);
  if (answer == ReadyAnswer::Begin) begin(ui, shell);
  if (answer == ReadyAnswer::Back) shell.pop();
}

void OperatingScreen::draw_device_lost(Ui& ui) {
  switch (draw_device_lost_card(ui, session().is_practice(), field_.device_trouble())) {
    case LostAnswer::Waiting:
      break;
    case LostAnswer::TakeMouse:
      session().take_over_from_device();
      break;
    case LostAnswer::Abandon:
      session().ask(Asked::Abandon);
      break;
  }
}

void OperatingScreen::draw_hud(Ui& ui, Shell& shell) {
  OperatingHud hud = field_.hud(ui, shell);
  hud.is_simulated = signed_in_->is_simulated();
  if (hud.is_health_open) hud.health.log_bytes = live_->log_bytes();
  const HudAnswer answer = draw_operating_hud(ui, hud);
  field_.answer(answer, ui.texts());
  if (answer.finish) session().ask(Asked::Finish);
  if (answer.abandon) session().ask(Asked::Abandon);
  if (answer.step) {
    const scenarios::HeldCut* const held = field_.held_at_step();
    session().press_step(held != nullptr && held->is_through(), ui.time_s());
  }
}

void OperatingScreen::ask(Ui& ui) {
  if (session().asked() == Asked::Tool) {
    const TrayAnswer taken = draw_tray_card(ui, session().tools());
    if (taken.is_closed) session().close_tray(taken.place);
    return;
  }
  const scenarios::HeldCut* const held = field_.held_at_step();
  const bool is_told = session().is_practice() && held != nullptr && held->is_begun();
  const EndWords words{
      is_told ? held_text(ui.texts(), *held) : std::string(),
      left_steps_text(ui.texts(), field_.prepared_case().scenario, session().steps())};
  const Answer answer = draw_end_question(ui, session().asked(), words);
  if (answer == Answer::Waiting) return;
  session().answer(answer == Answer::Act     ? Decided::Act
                   : answer == Answer::Other ? Decided::Finish
                                             : Decided::GoOn,
                   ui.time_s());
  ui.want_frame_in_s(0.0);
}

// -- the end

void OperatingScreen::lead_on(Ui& ui, Shell& shell) {
  if (session().phase() == Phase::Sealing) ui.want_frame_in_s(soon_s);
  switch (session().take_end()) {
    case OperatingSession::Onward::Nowhere:
      break;
    case OperatingSession::Onward::Stopped:
      ui.want_frame_in_s(0.0);
      break;
    case OperatingSession::Onward::Abandoned:
      shell.say({Meaning::Info, text_in(ui, "operate.abandoned"),
                 text_in(ui, "operate.abandoned.detail")});
      shell.pop();
      break;
    case OperatingSession::Onward::Score:
      score(ui, shell);
      break;
  }
}

void OperatingScreen::score(const Ui& ui, Shell& shell) {
  work_.start(
      shell, text_in(ui, "operate.scoring"),
      [signed_in = signed_in_, attempt = live_->attempt()](WorkReport& report) {
        score_operation(*signed_in, attempt, report);
      },
      [this, &shell, title = text_in(ui, "operate.unscored")](WorkEnd end,
                                                              const std::string& reason) {
        if (end != WorkEnd::Done) shell.say({Meaning::Warn, title, sentence_of(reason)});
        show_result(shell);
      });
}

void OperatingScreen::show_result(Shell& shell) {
  session().close();
  shell.pop();
  navigator_.show_result(live_->attempt());
}

void OperatingScreen::draw_stopped(Ui& ui, Shell& shell) {
  const StoppedAnswer answer = draw_stopped_card(ui, session().stop(), live_ != nullptr);
  if (answer != StoppedAnswer::Waiting) shell.pop();
  if (answer == StoppedAnswer::SeeKept) navigator_.show_replay(live_->attempt(), 0.0);
}

}  // namespace hallux::ui
