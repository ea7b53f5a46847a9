#include "ui/screens/operating/operating_screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "database/assets.h"
#include "scenarios/planned_guide.h"
#include "simulator/base/units.h"
#include "simulator/record/sample_force.h"
#include "ui/render/scene_painter.h"
#include "ui/screens/operating/operation_work.h"
#include "ui/widgets/card.h"
#include "ui/widgets/menu.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

using database::AttemptKind;
using scenarios::StepKind;
using simulator::Switch;
using simulator::ToolStatus;

constexpr double reach_mm = 90.0;  ///< from the site, that the saw may be led
constexpr double soon_s = 0.05;
constexpr Vec2 plane_half_mm{16.0, 13.0};
/// Of the loop, beyond which people are told.
constexpr double late_limit_us = 2000.0;

constexpr std::array<const char*, standard_view_count> view_names{
    "operate.key.view.1", "operate.key.view.2", "operate.key.view.3", "operate.key.view.4",
    "operate.key.view.5", "operate.key.view.6", "operate.key.view.7", "operate.key.view.8"};

std::uint32_t bit(Switch value) noexcept { return static_cast<std::uint32_t>(value); }

}  // namespace

OperatingScreen::OperatingScreen(std::shared_ptr<Visit> visit, Places& places,
                                 database::ScenarioVersionId scenario, AttemptKind kind,
                                 simulator::Guidance guidance)
    : visit_(std::move(visit)),
      places_(places),
      scenario_(scenario),
      kind_(kind),
      guidance_(guidance) {}

OperatingScreen::~OperatingScreen() {
  bone_.reset();
  begun_.reset();
}

void OperatingScreen::leave(Shell& /*shell*/) {
  if (phase_ != Phase::Operating || is_paused_) return;
  set_paused(true);
  paused_by_ = "operate.paused.locked";
}

void OperatingScreen::draw(Ui& ui, const Rect& /*content*/, Shell& shell) {
  sight_.display = ui.display();
  switch (phase_) {
    case Phase::Preparing:
      prepare(ui, shell);
      break;
    case Phase::Stopped:
      draw_stopped(ui, shell);
      break;
    default:
      draw_operation(ui, shell);
  }
}

// -- before

void OperatingScreen::prepare(Ui& ui, Shell& shell) {
  ui.canvas().fill(ui.display(), ui.theme().page);
  if (prepared_.is_new()) {
    prepared_.start(ui, shell, ui.text("operate.preparing"),
                    [visit = visit_, scenario = scenario_](WorkReport& report) {
                      return prepare_operation(*visit, scenario, report);
                    });
  }
  const Rect inside =
      card(ui, centred(ui.display(), std::min(520.0F, ui.display().w - 32.0F), 300.0F),
           ui.text("operate.preparing"));
  if (!prepared_.draw_until_ready(ui, "operate.unprepared", inside, 4)) return;
  const OperatingTable& table = *prepared_.value().table;
  world_from_target_ = start_pose(table);
  sight_.camera = start_camera(table);
  phase_ = Phase::Ready;
  ui.want_frame_in_s(0.0);
}

void OperatingScreen::draw_ready(Ui& ui, Shell& shell) {
  const OperatingTable& table = *prepared_.value().table;
  const float width = std::min(520.0F, ui.display().w - 32.0F);
  const std::string_view words =
      ui.text(is_practice() ? "operate.ready.practice" : "operate.ready.assessment");
  const float words_height = ui.paragraph_height(Type::Body, words, width - 2.0F * space::card);
  // Below, where the panels will be: the bone stays in sight.
  const float height = 64.0F + words_height + 24.0F + button_height + 24.0F;
  const Rect display = ui.display();
  const float above = std::max(display.bottom() - height - hud_inset_share * display.h, 0.0F);
  const Rect rect{display.mid_x() - 0.5F * width, above, width, height};
  const Rect inside = card(ui, rect, table.scenario.title);
  ui.canvas().paragraph({inside.x, inside.y, inside.w, words_height},
                        {Type::Body, ui.theme().text_secondary}, words);
  ButtonSpec start{ui.text("operate.begin"), ButtonLook::Primary, Icon::Play};
  start.is_busy = phase_ == Phase::Beginning;
  const ButtonSpec back{ui.text("operate.back"), ButtonLook::Ghost};
  const float start_width = button_width(ui, start), back_width = button_width(ui, back);
  const float y = inside.bottom() - button_height;
  if (button(ui, "operate.begin", {inside.right() - start_width, y, start_width, button_height},
             start))
    begin(ui, shell);
  if (phase_ == Phase::Ready &&
      button(ui, "operate.back",
             {inside.right() - start_width - back_width - 12.0F, y, back_width, button_height},
             back))
    shell.pop();
}

void OperatingScreen::begin(Ui& ui, Shell& shell) {
  if (phase_ != Phase::Ready) return;
  phase_ = Phase::Beginning;
  why_not_leave_ = ui.text("operate.stay");
  auto begun = std::make_shared<Begun>();
  LiveBegin what;
  what.scenario = scenario_;
  what.person = visit_->person().id;
  what.kind = kind_;
  what.guidance = guidance_;
  what.stereo_mode = stereo_.mode == StereoMode::Mono         ? "mono"
                     : stereo_.mode == StereoMode::SideBySide ? "side_by_side"
                                                              : "anaglyph";
  work_.start(
      shell, std::string(ui.text("operate.beginning")),
      [visit = visit_, table = prepared_.value().table, start = world_from_target_, what,
       begun](WorkReport&) {
        auto mouse = std::make_unique<simulator::MouseDevice>(start);
        begun->mouse = mouse.get();
        begun->live = begin_operation(*visit, table, what, std::move(mouse));
      },
      [this, begun](WorkEnd end, const std::string& reason) {
        if (end != WorkEnd::Done) {
          why_not_leave_.clear();
          stopped_ = sentence_of(reason);
          phase_ = end == WorkEnd::Cancelled ? Phase::Ready : Phase::Stopped;
          return;
        }
        begun_ = begun;
        bone_ = std::make_unique<BoneBeingCut>(*begun_->live, std::move(prepared_.value().picture));
        phase_ = Phase::Operating;
      });
}

void OperatingScreen::draw_stopped(Ui& ui, Shell& shell) {
  ui.canvas().fill(ui.display(), ui.theme().page);
  const std::string why = stopped_ + (begun_ ? " " + std::string(ui.text("operate.kept")) : "");
  const float width = std::min(560.0F, ui.display().w - 32.0F);
  const float height = 250.0F + ui.paragraph_height(Type::Small, why, width - 2.0F * space::card);
  Rect inside = card(ui, centred(ui.display(), width, height), {});
  if (begun_) {
    const ButtonSpec see{ui.text("operate.see_kept"), ButtonLook::Ghost, Icon::Eye};
    const float see_width = button_width(ui, see);
    inside.h -= button_height;
    if (button(ui, "operate.see_kept",
               {inside.mid_x() - 0.5F * see_width, inside.bottom(), see_width, button_height}, see))
      return lead_on(shell, Onward::Replay);
  }
  if (failed_card(ui, "operate.stopped", inside,
                  {ui.text("operate.stopped"), why, ui.text("operate.back")}))
    shell.pop();
}

// -- while it runs

void OperatingScreen::draw_operation(Ui& ui, Shell& shell) {
  const AreaResponse area = ui.area("operate.view", ui.text("operate.view"), ui.display());
  const bool is_open = asking_ == Asking::Nothing && phase_ < Phase::Sealing;
  if (is_open) look(ui, area);
  if (is_open && phase_ == Phase::Operating && !is_paused_) {
    if (const char* why = what_took_the_hands(ui)) {
      set_paused(true);
      paused_by_ = why;
    }
  }
  if (is_open && phase_ == Phase::Operating) hear_keys(ui, shell);
  if (is_open && phase_ == Phase::Operating && !is_paused_) {
    steer(ui, area);
  } else {
    steering_.let_go();
  }
  if (phase_ == Phase::Operating || phase_ == Phase::Sealing) follow_events(ui, shell);
  follow_storage(ui);
  show_scene(ui, shell);
  if (phase_ == Phase::Ready || phase_ == Phase::Beginning) {
    draw_ready(ui, shell);
  } else if (phase_ == Phase::Operating) {
    if (is_hud_shown_) draw_hud(ui, shell);
    if (asking_ == Asking::Nothing) {
      if (is_storage_full_) {
        draw_storage_full(ui);
      } else if (is_paused_) {
        draw_paused(ui);
      }
    }
    draw_question(ui);
  } else if (phase_ == Phase::Sealing) {
    if (is_storage_full_) {
      draw_storage_full(ui);
    } else {
      draw_sealing(ui);
    }
  }
  if (begun_) follow_end(ui, shell);
}

void OperatingScreen::look(Ui& ui, const AreaResponse& area) {
  sight_.camera = steering_.looked(area, ui.modifiers(), sight_);
  hear_views(ui);
  if (ui.shortcut({Key::F9}, ui.text("operate.key.stereo"))) {
    stereo_.mode = static_cast<StereoMode>((static_cast<int>(stereo_.mode) + 1) % 3);
  }
  if (ui.shortcut(with_shift(Key::F9), ui.text("operate.key.swap"))) {
    stereo_.is_swapped = !stereo_.is_swapped;
  }
}

void OperatingScreen::hear_views(Ui& ui) {
  for (int view = 0; view < standard_view_count; ++view) {
    const Key key = static_cast<Key>(static_cast<int>(Key::Digit1) + view);
    if (ui.shortcut({key}, ui.text(view_names[static_cast<std::size_t>(view)]))) {
      sight_.camera = standard_view(sight_.camera, static_cast<StandardView>(view));
    }
  }
  if (ui.shortcut({Key::R}, ui.text("operate.key.reset"))) {
    sight_.camera = start_camera(*prepared_.value().table);
  }
}

void OperatingScreen::hear_keys(Ui& ui, Shell& shell) {
  // All of it turns on and off: once, however long the key is held.
  const auto pressed = [&](Chord chord, const char* id) {
    return ui.shortcut(chord, ui.text(id)) && !ui.is_key_held_on();
  };
  const auto heard = [&](Key key, const char* id) { return pressed({key}, id); };
  // The saw also answers while Shift slows the hand down.
  if (heard(Key::Space, "operate.key.saw") || pressed(with_shift(Key::Space), "operate.key.saw"))
    is_saw_on_ = !is_saw_on_ && !is_paused_;
  if (heard(Key::I, "operate.key.irrigation")) is_irrigated_ = !is_irrigated_;
  if (is_practice() && heard(Key::G, "operate.key.plane")) is_plane_shown_ = !is_plane_shown_;
  if (heard(Key::H, "operate.key.hud")) is_hud_shown_ = !is_hud_shown_;
  bool& is_saw_heard = shell.preferences().is_saw_heard;
  if (heard(Key::M, "operate.key.sound")) is_saw_heard = !is_saw_heard;
  if (heard(Key::P, "operate.key.pause")) set_paused(!is_paused_);
  if (heard(Key::End, "operate.key.finish")) ask(Asking::Finish);
}

void OperatingScreen::steer(Ui& ui, const AreaResponse& area) {
  const OperatingTable& table = *prepared_.value().table;
  for (const simulator::PointerMotion& motion :
       {steering_.motion(area, ui.modifiers(), sight_, world_from_target_.translation_mm),
        steering_.motion_by_keys(ui)}) {
    world_from_target_ = steered(world_from_target_, sight_.camera.world_from_view, motion);
  }
  world_from_target_ =
      simulator::kept_within(world_from_target_, start_camera(table).target_mm, reach_mm);
  const std::uint32_t switches =
      (is_saw_on_ ? bit(Switch::SawRuns) : 0U) | (is_irrigated_ ? bit(Switch::Irrigates) : 0U);
  begun_->mouse->aim(world_from_target_, switches);
  steered_s_ = ui.time_s();
  if (area.is_hovered) ui.hide_pointer();
}

// -- the picture

void OperatingScreen::show_scene(Ui& ui, Shell& shell) {
  const double now_s = ui.time_s();
  const double step_ms = 1000.0 * (now_s - std::exchange(last_s_, now_s));
  frame_ms_ = std::max(step_ms, 0.9 * frame_ms_);
  if (begun_ && begun_->live->view().lines > 0) {
    last_sample_ = begun_->live->view().sample;
    has_sample_ = true;
  }
  if (!is_paused_) let_chips_fly(step_ms / 1000.0);
  sound_the_saw(shell);
  shell.scenes().draw_behind(scene(ui), sight_.camera, stereo_);
  if (stereo_.mode == StereoMode::SideBySide) ui.carry_pointer();
  triangles_ = shell.scenes().triangles();
  ++pictures_;
  const bool is_running = phase_ == Phase::Operating && asking_ == Asking::Nothing && !is_paused_;
  if (is_running || shell.scenes().is_coarse()) {
    ui.want_frame_in_s(0.0);
  } else if (phase_ != Phase::Ready && (!bone_ || !bone_->is_up_to_date() || !is_paused_)) {
    ui.want_frame_in_s(soon_s);
  }
}

void OperatingScreen::let_chips_fly(double step_s) {
  if (!begun_) return;
  const simulator::LoopView& view = begun_->live->view();
  std::optional<SwarfSource> source;
  if (has(view.sample.status, ToolStatus::Cutting)) {
    const scenarios::Scenario& scenario = prepared_.value().table->scenario;
    source.emplace();
    source->world_from_tool = transform_from(view.sample.world_from_tool);
    source->width_mm = scenario.saw.blade.width_mm;
    const double rate_mm_s =
        simulator::feed_rate_mm_s(view.engaged, simulator::force_size_newton(view.sample),
                                  scenario.saw, scenario.patient.bone_quality);
    source->removed_mm3_s = rate_mm_s * view.engaged.width_mm() * scenario.saw.blade.kerf_mm;
    source->is_irrigated = is_irrigated_;
  }
  swarf_.advance(step_s, source);
}

/// Off by its key, while paused, and after the operation: then the player is told silence.
void OperatingScreen::sound_the_saw(Shell& shell) {
  if (!begun_) return;
  const bool is_heard = shell.preferences().is_saw_heard && phase_ == Phase::Operating;
  if (is_heard && player_ == nullptr) player_ = std::make_unique<SawPlayer>();
  if (player_ == nullptr) return;
  const simulator::LoopView& view = begun_->live->view();
  SawTone tone = saw_tone(view.sample, view.engaged, prepared_.value().table->scenario.saw);
  tone.runs = tone.runs && is_heard && !is_paused_;
  player_->play(tone);
}

Scene OperatingScreen::scene(Ui& ui) {
  const OperatingTable& table = *prepared_.value().table;
  Scene scene;
  scene.ground = ui.theme().is_dark() ? Ground::Dark : Ground::Light;
  if (bone_) {
    bone_->add_to(scene);
  } else {
    BoneInScene whole;
    whole.mesh = prepared_.value().picture.mesh.get();
    whole.look = &prepared_.value().picture.look;
    whole.world_from_bone = table.bone.world_from_bone;
    scene.bones.push_back(whole);
  }
  const simulator::Blade& blade = table.scenario.saw.blade;
  SawInScene saw;
  saw.world_from_tool =
      has_sample_ ? transform_from(last_sample_.world_from_tool) : world_from_target_;
  saw.blade = blade;
  saw.is_running = has(last_sample_.status, ToolStatus::SawOn) && !is_paused_;
  // Faster than pictures follow each other: each shows the blade somewhere else in its swing.
  saw.swing = std::sin(2.4 * static_cast<double>(pictures_));
  scene.saw = saw;
  scene.lines.push_back({saw.world_from_tool, 0.5 * blade.width_mm + 1.0});
  scene.chips = swarf_.chips();
  const scenarios::PlannedCut* cut = planned_cut();
  if (cut != nullptr && is_plane_shown_) {
    scene.planes.push_back(
        {table.bone.world_from_bone * bone_from_face(*cut), plane_half_mm, Ink::Reference});
  }
  return scene;
}

/// The cut that the step at hand asks for, in practice only.
const scenarios::PlannedCut* OperatingScreen::planned_cut() const {
  const OperatingTable& table = *prepared_.value().table;
  return is_practice() ? cut_at_step(table.scenario, table.plan, step_) : nullptr;
}

std::optional<PlanReading> OperatingScreen::plan_reading() const {
  const scenarios::PlannedCut* cut = planned_cut();
  if (cut == nullptr || !is_plane_shown_) return std::nullopt;
  const OperatingTable& table = *prepared_.value().table;
  return read_against(
      *cut, table.scenario.saw.blade,
      inverse(table.bone.world_from_bone) * transform_from(last_sample_.world_from_tool));
}

// -- the panels

OperatingHealth OperatingScreen::health(Ui& ui, Shell& /*shell*/) {
  const simulator::LoopView& view = begun_->live->view();
  limits_.see(view.force_limits, ui.time_s());
  OperatingHealth health = health_of(view, begun_->live->force_scale(), limits_.bits());
  health.frame_ms = frame_ms_;
  if (is_health_open_) health.log_bytes = begun_->live->log_bytes();
  health.triangles = static_cast<long>(triangles_);
  const char* trouble = nullptr;
  if (has(view.sample.status, ToolStatus::Faulted)) {
    trouble = "operate.trouble.device";
  } else if (bone_->has_failed()) {
    trouble = "operate.trouble.picture";
  } else if (view.ring_share > 0.5) {
    trouble = "operate.trouble.disk";
  } else if (view.late_us > late_limit_us) {
    trouble = view.has_priority ? "operate.trouble.busy" : "operate.trouble.priority";
  }
  if (trouble != nullptr) health.trouble = ui.text(trouble);
  return health;
}

OperatingHud OperatingScreen::hud(Ui& ui, Shell& shell) {
  const OperatingTable& table = *prepared_.value().table;
  const std::vector<scenarios::OperationStep>& steps = table.scenario.steps;
  OperatingHud hud;
  hud.is_practice = is_practice();
  hud.is_paused = is_paused_;
  hud.is_reviewed = table.scenario.is_reviewed;
  hud.is_simulated = visit_->is_simulated();
  hud.tick = last_sample_.tick;
  for (const scenarios::OperationStep& step : steps) hud.steps.push_back(step.title);
  hud.step = step_;
  if (step_ < steps.size()) {
    const StepKind kind = steps[step_].kind;
    const char* verb = kind == StepKind::Remove   ? "operate.step.remove"
                       : kind == StepKind::Close  ? "operate.step.close"
                       : kind == StepKind::Finish ? "operate.step.finish"
                                                  : "operate.step.done";
    hud.step_action = ui.text(verb);
    hud.is_step_busy = waiting_ != Waiting::Nothing;
    hud.is_step_ready = !is_paused_ && waiting_ == Waiting::Nothing &&
                        (kind != StepKind::Remove || freed_ > removed_);
  }
  hud.saw = table.scenario.saw;
  hud.is_saw_on = has(last_sample_.status, ToolStatus::SawOn);
  hud.is_irrigated = is_irrigated_;
  hud.is_cutting = has(last_sample_.status, ToolStatus::Cutting);
  hud.force_newton = simulator::force_size_newton(last_sample_);
  hud.tip = place_on(sight_, transform_from(last_sample_.world_from_tool).translation_mm);
  hud.reading = plan_reading();
  // Like the read-outs of the plan: help while one learns, none in an assessment.
  if (is_practice()) hud.bone_celsius = begun_->live->view().hottest_celsius;
  hud.health = health(ui, shell);
  hud.is_health_open = is_health_open_;
  return hud;
}

void OperatingScreen::draw_hud(Ui& ui, Shell& shell) {
  const HudAnswer answer = draw_operating_hud(ui, hud(ui, shell));
  if (answer.health) is_health_open_ = !is_health_open_;
  if (answer.pause) set_paused(!is_paused_);
  if (answer.finish) ask(Asking::Finish);
  if (answer.abandon) ask(Asking::Abandon);
  if (answer.step) carry_out_step(ui);
}

}  // namespace hallux::ui
