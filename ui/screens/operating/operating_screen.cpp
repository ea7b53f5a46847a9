// Operating, drawn: each frame hears the person, asks the session what is so, and draws that.
//
//     keys, pointer --> session (what happens) --> viewport, panels, cards (what is seen)
//
// The order within a frame is the meaning: first what takes the hands off the saw, then keys, then
// the way of the saw, then what came back from the loop; only then the picture, so that no frame
// shows a saw that runs after it was stopped.
#include "ui/screens/operating/operating_screen.h"

#include <algorithm>
#include <array>
#include <utility>

#include "scenarios/planned_guide.h"
#include "ui/screens/operating/hand/rail_of_step.h"
#include "ui/screens/operating/hud_facts.h"
#include "ui/screens/operating/operating_cards.h"
#include "ui/widgets/controls/card.h"

namespace hallux::ui {

namespace {

using scenarios::StepKind;

constexpr const char* view_area = "operate.view";
constexpr double soon_s = 0.05;
/// How soon the screen notices that there is room on the disk again.
constexpr double look_again_s = 0.2;

std::string text_in(const Ui& ui, std::string_view id) { return std::string(ui.text(id)); }

const char* name_of(StereoMode mode) {
  return mode == StereoMode::Mono         ? "mono"
         : mode == StereoMode::SideBySide ? "side_by_side"
                                          : "anaglyph";
}

std::vector<StepKind> kinds_of(const std::vector<scenarios::OperationStep>& steps) {
  std::vector<StepKind> kinds;
  kinds.reserve(steps.size());
  for (const scenarios::OperationStep& step : steps) kinds.push_back(step.kind);
  return kinds;
}

}  // namespace

OperatingScreen::OperatingScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator,
                                 const OperationChoice& choice, LendDevice lend_device)
    : signed_in_(std::move(signed_in)),
      navigator_(navigator),
      choice_(choice),
      lend_device_(std::move(lend_device)),
      session_(choice.kind) {}

std::string_view OperatingScreen::why_not_leave() const {
  const auto staying = session_.staying();
  if (texts_ == nullptr || staying == OperatingSession::Staying::No) return {};
  return texts_->text(staying == OperatingSession::Staying::WhileScored ? "operate.stay.scoring"
                                                                        : "operate.stay");
}

bool OperatingScreen::ask_before_leaving(Ui& ui) {
  if (session_.phase() != Phase::Operating) return false;
  session_.ask(Asked::Leave);
  ui.want_frame_in_s(0.0);
  return session_.asked() != Asked::Nothing;
}

void OperatingScreen::draw(Ui& ui, const Rect& /*content*/, Shell& shell) {
  texts_ = &ui.texts();
  viewport_.set_display(ui.display());
  if (session_.phase() == Phase::Preparing) return prepare(ui, shell);
  if (session_.phase() == Phase::Stopped) return draw_stopped(ui, shell);
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
  viewport_.face(prepared_case());
  session_.make_ready(kinds_of(prepared_case().scenario.steps),
                      LedSaw(start_pose(prepared_case()), start_camera(prepared_case()).target_mm));
  ui.want_frame_in_s(0.0);
}

LiveBegin OperatingScreen::what_to_begin() const {
  return {.scenario = choice_.scenario,
          .person = signed_in_->person().id,
          .kind = choice_.kind,
          .guidance = choice_.guidance,
          .stereo_mode = name_of(viewport_.stereo_mode())};
}

void OperatingScreen::begin(Ui& ui, Shell& shell) {
  if (!session_.begin()) return;
  auto begun = std::make_shared<Running>();
  work_.start(
      shell, text_in(ui, "operate.beginning"),
      [signed_in = signed_in_, prepared_case = prepared_.value().prepared_case,
       what = what_to_begin(), start = session_.saw().world_from_target(), lend = lend_device_,
       begun](WorkReport&) {
        std::unique_ptr<simulator::SteeredDevice> device = lend(start);
        begun->device = device.get();
        begun->live = begin_operation(*signed_in, prepared_case, what, std::move(device));
      },
      [this, begun](WorkEnd end, const std::string& reason) {
        if (end == WorkEnd::Cancelled) return session_.take_back();
        if (end == WorkEnd::Failed) return session_.fail_to_begin(reason);
        running_ = std::make_unique<Running>(std::move(*begun));
        running_->bone =
            std::make_unique<BoneBeingCut>(*running_->live, std::move(prepared_.value().picture));
        session_.run(*running_->live, *running_->device);
      });
}

// -- while it runs

void OperatingScreen::draw_operation(Ui& ui, Shell& shell) {
  const AreaResponse area = ui.area(view_area, ui.text(view_area), ui.display());
  hear_hands(ui, area, shell);
  if (running_) apply_loop(ui, shell);
  show_scene(ui, shell);
  draw_cards(ui, shell);
  if (running_) lead_on(ui, shell);
}

void OperatingScreen::hear_hands(Ui& ui, const AreaResponse& area, Shell& shell) {
  session_.watch({ui.has_lost_keys(), ui.has_pointer_left() && viewport_.is_led_by_pointer(),
                  reachable_layer(ui.shown()) > Layer::Page},
                 ui.time_s());
  if (session_.is_heard()) {
    hear_keys(ui);
    hear_display_keys(ui, shell.preferences());
  }
  Steered steered;
  if (session_.is_open()) {
    steered = viewport_.hear(ui, area, prepared_case(), session_.is_led(),
                             session_.saw().world_from_target().translation_mm);
  }
  lead(ui, area, steered, shell.preferences().captures_pointer);
}

void OperatingScreen::hear_keys(Ui& ui) {
  // All of it turns on and off: once, however long the key is held.
  const auto pressed = [&](Chord chord, const char* id) {
    return ui.shortcut(chord, ui.text(id)) && !ui.is_key_held_on();
  };
  const auto heard = [&](Key key, const char* id) { return pressed({key}, id); };
  // The saw also answers while Shift slows the hand down.
  if (heard(Key::Space, "operate.key.saw") || pressed(with_shift(Key::Space), "operate.key.saw"))
    session_.set_saw_on(!session_.saw().is_on());
  if (heard(Key::I, "operate.key.irrigation"))
    session_.set_irrigated(!session_.saw().is_irrigated());
  if (heard(Key::Backspace, "operate.key.take_up")) take_up_last_step();
  if (heard(Key::P, "operate.key.pause")) session_.toggle_pause();
  if (heard(Key::Escape, "operate.key.escape")) session_.pause(PausedBy::Person);
  if (heard(Key::End, "operate.key.finish")) session_.ask(Asked::Finish);
}

void OperatingScreen::hear_display_keys(Ui& ui, Preferences& preferences) {
  const auto turn = [&](Key key, const char* id, bool& is_on) {
    if (ui.shortcut({key}, ui.text(id)) && !ui.is_key_held_on()) is_on = !is_on;
  };
  if (session_.is_practice()) {
    turn(Key::G, "operate.key.plane", panels_.help.is_plane_shown);
    turn(Key::T, "operate.key.hints", panels_.help.is_hinted);
    turn(Key::V, "operate.key.inset", panels_.help.is_inset_shown);
  }
  turn(Key::N, "operate.key.neighbour", panels_.is_neighbour_shown);
  turn(Key::H, "operate.key.hud", panels_.are_shown);
  turn(Key::M, "operate.key.sound", preferences.is_saw_heard);
  turn(Key::C, "operate.key.capture", preferences.captures_pointer);
  turn(Key::K, "operate.key.hand", preferences.is_left_handed);
}

void OperatingScreen::take_up_last_step() {
  for (std::size_t step = session_.steps().step(); step-- > 0;) {
    if (session_.steps().can_reopen(step)) return session_.reopen_step(step);
  }
}

void OperatingScreen::lead(Ui& ui, const AreaResponse& area, const Steered& steered,
                           bool may_capture) {
  if (!session_.is_led()) return viewport_.release_pointer();
  if (steered.switches_saw) session_.set_saw_on(!session_.saw().is_on());
  session_.lift(viewport_.lift().is_lifted());
  if (choice_.guidance == simulator::Guidance::Slot) {
    session_.set_rail(rail_of_step(prepared_case(), session_.steps().step(),
                                   running_->site == nullptr ? nullptr : &running_->site->cuts,
                                   running_->loop.sample.kerf));
  }
  session_.lead(std::array{steered.by_mouse, steered.by_keys}, viewport_.world_from_view(),
                ui.time_s());
  if (viewport_.lift().stays_lifted()) return;
  if (may_capture) ui.capture_pointer(view_area);
  if (area.is_hovered) ui.hide_pointer();
}

/// What came back from the loop and its recorder since the last frame.
void OperatingScreen::apply_loop(Ui& ui, Shell& shell) {
  running_->loop = running_->live->view();
  running_->site = running_->bone->site();
  if (session_.phase() != Phase::Operating && session_.phase() != Phase::Sealing) return;
  tell(ui, shell, session_.apply(running_->bone->take_events(), ui.time_s()));
  if (session_.update_storage()) ui.want_frame_in_s(0.0);
  if (session_.pausing().is_storage_full()) ui.want_frame_in_s(look_again_s);
}

void OperatingScreen::tell(const Ui& ui, Shell& shell, std::span<const StepNotice> notices) const {
  for (const StepNotice notice : notices) {
    const auto [title, detail] = notice_texts(notice);
    shell.say({Meaning::Info, text_in(ui, title), text_in(ui, detail)});
  }
}

void OperatingScreen::show_scene(Ui& ui, Shell& shell) {
  sound_the_saw(shell);
  const bool is_paused = session_.pausing().is_paused();
  const bool has_stepped = running_ && running_->loop.lines > 0;
  BoneBeingCut* bone = running_ ? running_->bone.get() : nullptr;
  viewport_.draw(ui, shell.scenes(),
                 {.prepared_case = prepared_case(),
                  .whole = prepared_.value().picture,
                  .bone = bone,
                  .loop = has_stepped ? &running_->loop : nullptr,
                  .world_from_target = session_.saw().world_from_target(),
                  .cut = shown_cut(),
                  .is_paused = is_paused,
                  .is_irrigated = session_.saw().is_irrigated(),
                  .site = prepared_.value().site.get(),
                  .is_neighbour_shown = panels_.is_neighbour_shown,
                  .facts = running_ && session_.is_practice() ? running_->site.get() : nullptr,
                  .is_guided = session_.is_practice()});
  if (has_stepped) running_->live->note_view(viewport_.shown_view(), running_->loop.sample.tick);
  if (session_.is_led() || shell.scenes().is_unfinished()) {
    ui.want_frame_in_s(0.0);
  } else if (session_.phase() != Phase::Ready &&
             (bone == nullptr || !bone->is_up_to_date() || !is_paused)) {
    ui.want_frame_in_s(soon_s);
  }
}

/// Off by its key, while paused, and after the operation: then the player is told silence.
void OperatingScreen::sound_the_saw(Shell& shell) {
  if (!running_) return;
  const bool is_heard = shell.preferences().is_saw_heard && session_.phase() == Phase::Operating;
  if (is_heard && running_->player == nullptr) running_->player = std::make_unique<SawPlayer>();
  if (running_->player == nullptr) return;
  SawTone tone =
      saw_tone(running_->loop.sample, running_->loop.engaged, prepared_case().scenario.saw);
  tone.runs = tone.runs && is_heard && !session_.pausing().is_paused();
  running_->player->play(tone);
}

const scenarios::PlannedCut* OperatingScreen::shown_cut() const {
  if (!session_.is_practice() || !panels_.help.is_plane_shown) return nullptr;
  const scenarios::Plan& plan = prepared_case().plan;
  const std::int32_t kerf = running_ ? running_->loop.sample.kerf : -1;
  if (kerf >= 0 && running_->site != nullptr) {
    const auto& cuts = running_->site->cuts;
    for (std::size_t cut = 0; cut < cuts.size(); ++cut)
      if (cuts[cut].kerf == kerf) return &plan.cuts[cut];
  }
  return cut_at_step(prepared_case().scenario, plan, session_.steps().step());
}

const scenarios::HeldCut* OperatingScreen::held_at_step() const {
  const scenarios::PlannedCut* const cut =
      cut_at_step(prepared_case().scenario, prepared_case().plan, session_.steps().step());
  if (cut == nullptr || running_->site == nullptr) return nullptr;
  const std::size_t index = index_of_cut(prepared_case().plan, cut->name);
  return index < running_->site->cuts.size() ? &running_->site->cuts[index] : nullptr;
}

// -- the panels

void OperatingScreen::draw_cards(Ui& ui, Shell& shell) {
  const Phase phase = session_.phase();
  const bool is_storage_full = session_.pausing().is_storage_full();
  if (phase == Phase::Ready || phase == Phase::Beginning) return draw_ready(ui, shell);
  if (phase != Phase::Operating && phase != Phase::Sealing) return;
  if (phase == Phase::Operating && panels_.are_shown) draw_hud(ui, shell);
  if (session_.asked() != Asked::Nothing) return ask(ui);
  if (is_storage_full) {
    if (draw_storage_full_card(ui, running_->live->directory()))
      session_.abandon_unstored(ui.time_s());
  } else if (phase == Phase::Sealing) {
    draw_sealing(ui, session_.ended_s());
  } else if (session_.pausing().is_paused()) {
    if (draw_paused_card(ui, session_.pausing().by())) session_.go_on();
  }
}

void OperatingScreen::draw_ready(Ui& ui, Shell& shell) {
  const ReadyAnswer answer =
      draw_ready_card(ui, prepared_case().scenario.title, session_.is_practice(),
                      session_.phase() == Phase::Beginning);
  if (answer == ReadyAnswer::Begin) begin(ui, shell);
  if (answer == ReadyAnswer::Back) shell.pop();
}

void OperatingScreen::draw_hud(Ui& ui, Shell& shell) {
  const HudAnswer answer = draw_operating_hud(ui, hud(ui, shell));
  if (answer.health) panels_.is_health_open = !panels_.is_health_open;
  if (answer.pause) session_.toggle_pause();
  if (answer.finish) session_.ask(Asked::Finish);
  if (answer.abandon) session_.ask(Asked::Abandon);
  if (answer.saw) session_.set_saw_on(!session_.saw().is_on());
  if (answer.irrigation) session_.set_irrigated(!session_.saw().is_irrigated());
  if (answer.reopen) session_.reopen_step(*answer.reopen);
  if (answer.step) {
    const scenarios::HeldCut* const held = held_at_step();
    session_.press_step(held != nullptr && held->is_through(), ui.time_s());
  }
}

OperatingHud OperatingScreen::hud(const Ui& ui, Shell& shell) {
  const simulator::LoopView& loop = running_->loop;
  OperatingHud hud = hud_of({.texts = ui.texts(),
                             .session = session_,
                             .prepared_case = prepared_case(),
                             .passes = prepared_.value().passes,
                             .loop = loop,
                             .site = running_->site.get(),
                             .cut = shown_cut(),
                             .world_from_view = viewport_.world_from_view()},
                            panels_.help.is_hinted);
  hud.is_simulated = signed_in_->is_simulated();
  hud.is_left_handed = shell.preferences().is_left_handed;
  hud.tip = viewport_.place_of(transform_from(loop.sample.world_from_tool).translation_mm);
  hud.tool = viewport_.tool_places();
  hud.inset = inset();
  hud.hand = hand(ui);
  hud.health = health(ui, shell);
  hud.is_health_open = panels_.is_health_open;
  return hud;
}

HandState OperatingScreen::hand(const Ui& ui) const {
  if (!session_.is_led()) return HandState::Off;
  if (session_.saw().is_lifted()) return HandState::Lifted;
  return ui.captured_by() == view_area ? HandState::Led : HandState::LedFree;
}

const BladeSection* OperatingScreen::inset() {
  panels_.inset.reset();
  if (!session_.is_practice() || !panels_.help.is_inset_shown) return nullptr;
  const std::shared_ptr<const KerfSection> section = running_->bone->section();
  if (section == nullptr) return nullptr;
  const RigidTransform bone_from_tool = inverse(prepared_case().bone.world_from_bone) *
                                        transform_from(running_->loop.sample.world_from_tool);
  panels_.inset = blade_section(*section, bone_from_tool, prepared_case().scenario.saw.blade,
                                &prepared_case().plan);
  return &*panels_.inset;
}

OperatingHealth OperatingScreen::health(const Ui& ui, Shell& shell) {
  const simulator::LoopView& loop = running_->loop;
  panels_.limits.observe(loop.force_limits, ui.time_s());
  OperatingHealth health = health_of(loop, running_->live->force_scale(), panels_.limits.bits());
  health.frame_ms = viewport_.frame_ms();
  if (panels_.is_health_open) health.log_bytes = running_->live->log_bytes();
  health.triangles = static_cast<long>(shell.scenes().triangles());
  const std::string_view trouble = trouble_of(loop, running_->bone->has_failed());
  if (!trouble.empty()) health.trouble = ui.text(trouble);
  return health;
}

void OperatingScreen::ask(Ui& ui) {
  const scenarios::HeldCut* const held = held_at_step();
  const bool is_told = session_.is_practice() && held != nullptr && held->is_begun();
  const Answer answer = draw_end_question(ui, session_.asked(),
                                          is_told ? held_text(ui.texts(), *held) : std::string());
  if (answer == Answer::Waiting) return;
  session_.answer(answer == Answer::Act     ? Decided::Act
                  : answer == Answer::Other ? Decided::Finish
                                            : Decided::GoOn,
                  ui.time_s());
  ui.want_frame_in_s(0.0);
}

// -- the end

void OperatingScreen::lead_on(Ui& ui, Shell& shell) {
  if (session_.phase() == Phase::Sealing) ui.want_frame_in_s(soon_s);
  switch (session_.take_end()) {
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
      [signed_in = signed_in_, attempt = running_->live->attempt()](WorkReport& report) {
        score_operation(*signed_in, attempt, report);
      },
      [this, &shell, title = text_in(ui, "operate.unscored")](WorkEnd end,
                                                              const std::string& reason) {
        if (end != WorkEnd::Done) shell.say({Meaning::Warn, title, sentence_of(reason)});
        show_result(shell);
      });
}

void OperatingScreen::show_result(Shell& shell) {
  session_.close();
  shell.pop();
  navigator_.show_result(running_->live->attempt());
}

void OperatingScreen::draw_stopped(Ui& ui, Shell& shell) {
  const StoppedAnswer answer = draw_stopped_card(ui, session_.stop(), running_ != nullptr);
  if (answer != StoppedAnswer::Waiting) shell.pop();
  if (answer == StoppedAnswer::SeeKept) navigator_.show_replay(running_->live->attempt(), 0.0);
}

}  // namespace hallux::ui
