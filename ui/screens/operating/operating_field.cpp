// The order within a frame is the meaning: first what takes the hands off the saw, then keys, then
// the way of the saw, then what came back from the loop; only then the picture, so that no frame
// shows a saw that runs after it was stopped.
#include "ui/screens/operating/operating_field.h"

#include <algorithm>
#include <array>
#include <utility>

#include "scenarios/planned_guide.h"
#include "scenarios/tray/laid_out_tools.h"
#include "ui/jobs/devices/device_sentences.h"
#include "ui/screens/operating/fixation_hints.h"
#include "ui/screens/operating/hand/rail_of_step.h"

namespace hallux::ui {

namespace {

constexpr const char* view_area = "operate.view";
constexpr double soon_s = 0.05;
/// A frame that took longer turns no further.
constexpr double longest_frame_s = 0.1;
/// How soon the screen notices that there is room on the disk again.
constexpr double look_again_s = 0.2;

std::string text_in(const Ui& ui, std::string_view id) { return std::string(ui.text(id)); }

}  // namespace

// -- before

void OperatingField::make_ready(PreparedOperation prepared) {
  StepProgress steps(prepared.prepared_case->scenario);
  make_ready(std::move(prepared), std::move(steps));
}

void OperatingField::make_ready(PreparedOperation prepared, StepProgress steps) {
  prepared_ = std::move(prepared);
  viewport_.face(prepared_case());
  session_.make_ready(std::move(steps),
                      LedSaw(start_pose(prepared_case()), start_camera(prepared_case()).target_mm),
                      ToolsInHand(laid_out_tools(prepared_case().scenario)));
}

void OperatingField::run(const std::string& name, CommandedLoop& loop,
                         simulator::SteeredDevice& device,
                         std::unique_ptr<simulator::SecondHand> second) {
  running_.reset(new Running{loop,
                             device,
                             std::move(second),
                             {name, prepared_case(), loop.watch(), std::move(prepared_.pictures)}});
  session_.run(loop, device);
}

// -- while it runs

void OperatingField::hear(Ui& ui, Shell& shell) {
  viewport_.set_display(ui.display());
  const AreaResponse area = ui.area(view_area, ui.text(view_area), ui.display());
  const bool is_by_pointer = session_.saw().is_led_by_window() && viewport_.is_led_by_pointer();
  session_.watch({ui.has_lost_keys(), ui.has_pointer_left() && is_by_pointer,
                  reachable_layer(ui.shown()) > Layer::Page},
                 ui.time_s());
  if (session_.is_heard()) {
    hear_keys(ui);
    if (session_.tools().tray().size() > 1) hear_tool_keys(ui);
    hear_display_keys(ui, shell);
  }
  Steered steered;
  if (session_.is_open()) {
    steered = viewport_.hear(ui, area, prepared_case(), session_.is_led(),
                             session_.saw().world_from_target().translation_mm);
  }
  lead(ui, area, steered);
}

void OperatingField::hear_keys(Ui& ui) {
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
  if (heard(Key::Backspace, "operate.key.take_up")) take_up_step(ui.texts());
  if (heard(Key::P, "operate.key.pause")) session_.toggle_pause();
  if (heard(Key::Escape, "operate.key.escape")) session_.pause(PausedBy::Person);
}

void OperatingField::hear_tool_keys(Ui& ui) {
  const auto heard = [&](Key key, const char* id) {
    return ui.shortcut({key}, ui.text(id)) && !ui.is_key_held_on();
  };
  if (heard(Key::B, "operate.key.tray")) session_.open_tray();
  if (heard(Key::F, "operate.key.forceps")) work_forceps(ui.texts());
  if (heard(Key::J, "operate.key.drive_home")) session_.drive_home();
  if (heard(Key::X, "operate.key.leave")) leave_or_take();
}

/// In a step that shifts a fragment it is that one, wherever the hand is; else what is nearest.
void OperatingField::work_forceps(const Texts& texts) {
  if (running_ == nullptr || running_->site == nullptr) return;
  const CoachView view = coach_view(sources(texts));
  std::optional<std::int32_t> piece;
  if (const std::optional<std::size_t> shift = shift_at_hand(view))
    piece = piece_of_shift(view, *shift);
  session_.work_forceps(piece ? piece : running_->site->reach.piece);
}

void OperatingField::leave_or_take() {
  if (running_ == nullptr || running_->site == nullptr) return;
  session_.leave_or_take(has(running_->view.sample.status, simulator::ToolStatus::InBore),
                         running_->site->reach.implant);
}

void OperatingField::hear_display_keys(Ui& ui, Shell& shell) {
  Preferences& preferences = shell.preferences();
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
  turn(Key::K, "operate.key.hand", shell.hand().is_left_handed);
}

/// Which cut holds is told in practice alone.
void OperatingField::take_up_step(const Texts& texts) {
  HudSources known = sources(texts);
  if (!session_.is_practice()) known.site = nullptr;
  if (const std::optional<std::size_t> step = step_to_take_up(coach_view(known)))
    session_.take_up_step(*step);
}

void OperatingField::lead(Ui& ui, const AreaResponse& area, const Steered& steered) {
  if (!session_.is_led()) return viewport_.release_pointer();
  if (steered.switches_saw) session_.set_saw_on(!session_.saw().is_on());
  // A hand that was lifted off an arm comes back elsewhere: not while the bone holds the blade.
  const std::uint32_t status = running_->view.sample.status;
  const bool is_held_by_bone =
      has(status, simulator::ToolStatus::InKerf) || has(status, simulator::ToolStatus::InBore);
  const bool may_lift = session_.saw().is_led_by_window() || !is_held_by_bone;
  session_.lift(may_lift && viewport_.lift().is_lifted());
  if (guidance_ == simulator::Guidance::Slot && !session_.tools().is_saw()) {
    session_.set_rail({});
  } else if (guidance_ == simulator::Guidance::Slot) {
    session_.set_rail(rail_of_step(prepared_case(), session_.steps().step(),
                                   running_->site == nullptr ? nullptr : &running_->site->cuts,
                                   running_->view.sample.kerf));
  }
  session_.lead(std::array{steered.by_mouse, steered.by_keys, hear_second(ui.time_s())},
                viewport_.world_from_view(), ui.time_s());
  if (session_.saw().is_led_by_window() && area.is_hovered && !viewport_.lift().stays_lifted())
    ui.hide_pointer();
}

simulator::PointerMotion OperatingField::hear_second(double now_s) {
  const double since_s = now_s - std::exchange(running_->asked_s, now_s);
  if (running_->second == nullptr) return {};
  const simulator::PointerMotion motion =
      running_->second->motion(std::clamp(since_s, 0.0, longest_frame_s));
  if (session_.saw().led() == simulator::SteeredDevice::Led::Rotation) return motion;
  viewport_.turn(motion);
  return {};
}

void OperatingField::hold_pointer(Ui& ui, const Preferences& preferences) const {
  if (!session_.saw().is_led_by_window()) return;
  if (preferences.captures_pointer && session_.is_led() && !viewport_.lift().stays_lifted())
    ui.capture_pointer(view_area);
}

/// What came back from the loop since the last frame.
void OperatingField::apply_loop(Ui& ui, Shell& shell) {
  running_->view = running_->loop.view();
  running_->site = running_->bone.site();
  see_saw();
  if (session_.phase() != OperatingSession::Phase::Operating &&
      session_.phase() != OperatingSession::Phase::Sealing)
    return;
  session_.see(running_->site == nullptr ? std::span<const scenarios::WantedPart>()
                                         : std::span(running_->site->parts));
  tell(ui, shell, session_.apply(running_->bone.take_events(), ui.time_s()));
  if (session_.update_storage()) ui.want_frame_in_s(0.0);
  if (session_.pausing().is_storage_full()) ui.want_frame_in_s(look_again_s);
}

void OperatingField::see_saw() {
  const simulator::LoopView& view = running_->view;
  if (view.lines == 0) return;
  const auto bit_where = [&](simulator::ToolStatus status, simulator::Switch which) {
    return has(view.sample.status, status) ? bit(which) : 0U;
  };
  // While a piece is held, the sample tells where that is, and the hand is where it was led.
  const bool is_gripping = session_.tools().forceps() == Forceps::Holding;
  session_.see_saw(is_gripping ? session_.saw().world_from_target()
                               : transform_from(view.sample.world_from_tool),
                   bit_where(simulator::ToolStatus::SawOn, simulator::Switch::SawRuns) |
                       bit_where(simulator::ToolStatus::DriveOn, simulator::Switch::SawRuns) |
                       bit_where(simulator::ToolStatus::Irrigated, simulator::Switch::Irrigates));
  session_.see_device(view.is_device_lost);
}

bool OperatingField::is_waiting() const {
  if (session_.phase() == OperatingSession::Phase::Ready) return false;
  if (running_ == nullptr || session_.is_device_lost()) return true;
  return !session_.pausing().is_paused() || !running_->bone.is_up_to_date();
}

std::string OperatingField::device_trouble() const {
  const simulator::TroubleReport trouble = running_->device.trouble();
  if (!trouble) return {};
  const std::optional<simulator::DeviceFacts> facts = running_->device.facts();
  const simulator::KindFacts* const kind = facts ? simulator::kind_named(facts->kind) : nullptr;
  return kind == nullptr ? std::string() : trouble_words(trouble, *kind, facts->kind) + ".";
}

void OperatingField::tell(const Ui& ui, Shell& shell, std::span<const Notice> notices) const {
  for (const Notice notice : notices) {
    const auto [title, detail] = notice_texts(notice);
    shell.say({Meaning::Info, text_in(ui, title), text_in(ui, detail)});
  }
}

void OperatingField::show(Ui& ui, Shell& shell, std::span<const Mark> goals) {
  sound_the_saw(shell);
  const bool is_paused = session_.pausing().is_paused();
  const bool has_stepped = running_ && running_->view.lines > 0;
  BoneBeingCut* bone = running_ ? &running_->bone : nullptr;
  OperationInSight shown{
      .prepared_case = prepared_case(),
      .wholes = prepared_.pictures,
      .bone = bone,
      .loop = has_stepped ? &running_->view : nullptr,
      .world_from_target = session_.saw().world_from_target(),
      .tools = &session_.tools(),
      .cut = panels_.help.is_plane_shown ? known_cut() : nullptr,
      .is_paused = is_paused,
      .is_irrigated = session_.saw().is_irrigated(),
      .site = prepared_.site.get(),
      .is_neighbour_shown = panels_.is_neighbour_shown,
      .facts = running_ && session_.is_practice() ? running_->site.get() : nullptr,
      .is_guided = session_.is_practice(),
      .goals = goals};
  show_fixation(shown, ui.texts());
  viewport_.draw(ui, shell.scenes(), shown);
  if (session_.is_led() || shell.scenes().is_unfinished()) {
    ui.want_frame_in_s(0.0);
  } else if (is_waiting()) {
    ui.want_frame_in_s(soon_s);
  }
}

void OperatingField::show_fixation(OperationInSight& shown, const Texts& texts) const {
  const bool is_known = running_ && running_->site != nullptr && session_.is_practice();
  if (!is_known || !panels_.help.is_plane_shown) return;
  const CoachView view = coach_view(sources(texts));
  if (const std::optional<ImplantTask> task = implant_at_hand(view)) shown.implant = task->implant;
  shown.shift = shift_at_hand(view);
}

/// Off by its key, while paused, and after the operation: then the player is told silence.
void OperatingField::sound_the_saw(Shell& shell) {
  if (!running_) return;
  const bool is_heard =
      shell.preferences().is_saw_heard && session_.phase() == OperatingSession::Phase::Operating;
  if (is_heard && running_->player == nullptr) running_->player = std::make_unique<SawPlayer>();
  if (running_->player == nullptr) return;
  SawTone tone = saw_tone(running_->view.sample, running_->view.engaged, driven_saw());
  tone.runs = tone.runs && is_heard && !session_.pausing().is_paused();
  running_->player->play(tone);
}

/// A drive of another tool sounds as fast as it turns.
simulator::Saw OperatingField::driven_saw() const {
  const ToolsInHand& tools = session_.tools();
  if (const simulator::Saw* const saw = tools.saw()) return *saw;
  simulator::Saw saw = prepared_case().scenario.saw;
  if (tools.tool() != nullptr) saw.cycles_per_minute = rate_per_minute(tools.tool()->tool);
  return saw;
}

const scenarios::PlannedCut* OperatingField::known_cut() const {
  if (!session_.is_practice()) return nullptr;
  const scenarios::Plan& plan = prepared_case().plan_in_first;
  const std::int32_t kerf = running_ ? running_->view.sample.kerf : -1;
  if (kerf >= 0 && running_->site != nullptr) {
    const auto& cuts = running_->site->cuts;
    for (std::size_t cut = 0; cut < cuts.size(); ++cut)
      if (cuts[cut].kerf == kerf) return &plan.cuts[cut];
  }
  return cut_at_step(prepared_case().scenario, plan, session_.steps().step());
}

const scenarios::HeldCut* OperatingField::held_at_step() const {
  const scenarios::PlannedCut* const cut =
      cut_at_step(prepared_case().scenario, prepared_case().plan_in_first, session_.steps().step());
  if (cut == nullptr || running_->site == nullptr) return nullptr;
  const std::size_t index = index_of_cut(prepared_case().plan_in_first, cut->name);
  return index < running_->site->cuts.size() ? &running_->site->cuts[index] : nullptr;
}

// -- the panels

HudSources OperatingField::sources(const Texts& texts) const {
  return {.texts = texts,
          .session = session_,
          .prepared_case = prepared_case(),
          .passes = prepared_.passes,
          .loop = running_->view,
          .site = running_->site.get(),
          .cut = known_cut(),
          .world_from_view = viewport_.world_from_view()};
}

OperatingHud OperatingField::hud(const Ui& ui, Shell& shell) {
  const simulator::ToolSample& sample = running_->view.sample;
  OperatingHud hud = hud_of(sources(ui.texts()), panels_.help.is_hinted);
  hud.is_left_handed = shell.hand().is_left_handed;
  hud.badge = shell.badge_place(ui);
  hud.tip = viewport_.place_of(transform_from(sample.world_from_tool).translation_mm);
  hud.tool = viewport_.tool_places();
  hud.inset = inset(hud.way);
  hud.hand = hand(ui);
  hud.health = health(ui, shell);
  hud.is_health_open = panels_.is_health_open;
  hud.are_hints_low = panels_.are_hints_low;
  return hud;
}

void OperatingField::answer(const HudAnswer& answer, const Texts& texts) {
  panels_.are_hints_low = answer.are_hints_low;
  if (answer.health) panels_.is_health_open = !panels_.is_health_open;
  if (answer.pause) session_.toggle_pause();
  if (answer.saw) session_.set_saw_on(!session_.saw().is_on());
  if (answer.irrigation) session_.set_irrigated(!session_.saw().is_irrigated());
  if (answer.take_up) session_.take_up_step(*answer.take_up);
  if (answer.tray) session_.open_tray();
  if (answer.forceps) work_forceps(texts);
  if (answer.drive_home) session_.drive_home();
  if (answer.leave_or_take) leave_or_take();
}

HandState OperatingField::hand(const Ui& ui) const {
  if (!session_.is_led()) return HandState::Off;
  if (session_.saw().is_lifted()) return HandState::Lifted;
  if (!session_.saw().is_led_by_window()) return HandState::OnDevice;
  return ui.captured_by() == view_area ? HandState::Led : HandState::LedFree;
}

const BladeSection* OperatingField::inset(const std::optional<WayAhead>& way) {
  panels_.inset.reset();
  if (!session_.is_practice() || !panels_.help.is_inset_shown || !session_.tools().is_saw())
    return nullptr;
  const std::shared_ptr<const KerfSection> section = running_->bone.section();
  if (section == nullptr) return nullptr;
  const RigidTransform bone_from_tool = inverse(prepared_case().bone().world_from_bone) *
                                        transform_from(running_->view.sample.world_from_tool);
  panels_.inset =
      blade_section(*section, bone_from_tool, driven_saw().blade, &prepared_case().plan_in_first);
  panels_.inset->way = way;
  return &*panels_.inset;
}

OperatingHealth OperatingField::health(const Ui& ui, Shell& shell) {
  const simulator::LoopView& loop = running_->view;
  panels_.limits.observe(loop.force_limits, ui.time_s());
  // Whoever took over from an arm is pushed by nothing.
  const bool pushes = running_->device.led() != simulator::SteeredDevice::Led::Pose;
  OperatingHealth health =
      health_of(loop, pushes ? running_->loop.force_scale() : std::nullopt, panels_.limits.bits());
  health.frame_ms = viewport_.frame_ms();
  health.triangles = static_cast<long>(shell.scenes().triangles());
  const std::string_view trouble = trouble_of(loop, running_->bone.has_failed());
  if (!trouble.empty()) health.trouble = ui.text(trouble);
  if (health.trouble.empty()) health.trouble = device_trouble();
  return health;
}

}  // namespace hallux::ui
