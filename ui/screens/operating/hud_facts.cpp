#include "ui/screens/operating/hud_facts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/base/units.h"
#include "simulator/record/sample_force.h"
#include "ui/screens/operating/fixation_hints.h"
#include "ui/screens/operating/hand/tray_card.h"
#include "ui/screens/pictures/fixation_reading.h"
#include "ui/screens/pictures/way_ahead.h"

namespace hallux::ui {

namespace {

using scenarios::HeldCut;
using scenarios::StepKind;
using simulator::ToolStatus;

/// Of the button of such a step, as the id of a text.
std::string_view verb_of(StepKind kind) noexcept {
  return kind == StepKind::Remove   ? "operate.step.remove"
         : kind == StepKind::Close  ? "operate.step.close"
         : kind == StepKind::Finish ? "operate.step.finish"
                                    : "operate.step.done";
}

RigidTransform bone_from_tool(const HudSources& from) {
  return inverse(from.prepared_case.bone().world_from_bone) *
         transform_from(from.loop.sample.world_from_tool);
}

// -- why a step does nothing yet

/// The cut that still holds; of several the one that holds most. Null where all are open.
const HeldCut* most_held(const SiteFacts& site) {
  const auto most =
      std::max_element(site.cuts.begin(), site.cuts.end(),
                       [](const HeldCut& a, const HeldCut& b) { return a.share < b.share; });
  return most == site.cuts.end() || most->is_through() ? nullptr : &*most;
}

std::string why_held(const HudSources& from) {
  const Texts& texts = from.texts;
  if (!from.session.is_practice()) return std::string(texts.text("operate.why.holds_plain"));
  if (from.site == nullptr) return std::string(texts.text("operate.hint.wait"));
  const bool is_any_begun = std::any_of(from.site->cuts.begin(), from.site->cuts.end(),
                                        [](const HeldCut& cut) { return cut.is_begun(); });
  if (!is_any_begun) return std::string(texts.text("operate.why.not_sawn"));
  if (const HeldCut* held = most_held(*from.site)) return held_text(texts, *held);
  return std::string(
      texts.text(from.site->are_pieces_due ? "operate.why.draw_out" : "operate.why.not_met"));
}

/// A crumb that lies free is no reason to take anything out.
std::string why_nothing_free(const HudSources& from) {
  std::string why = why_held(from);
  if (!from.session.steps().lies_anything_free()) return why;
  return from.texts.say("operate.why.crumb", {{"why", std::move(why)}});
}

std::string why_step_off(const HudSources& from) {
  const StepProgress& steps = from.session.steps();
  if (from.session.pausing().is_paused()) return std::string(from.texts.text("operate.why.paused"));
  if (steps.is_waiting() || steps.is_ready()) return {};
  return why_nothing_free(from);
}

void add_steps(OperatingHud& hud, const HudSources& from) {
  const StepProgress& steps = from.session.steps();
  const std::vector<scenarios::OperationStep>& all = from.prepared_case.scenario.steps;
  for (std::size_t step = 0; step < all.size(); ++step)
    hud.steps.push_back(
        {all[step].title, steps.is_done(step), steps.can_reopen(step), steps.can_choose(step)});
  hud.step = steps.step();
  if (!steps.kind()) return;
  hud.step_action = from.texts.text(verb_of(*steps.kind()));
  hud.is_step_busy = steps.is_waiting();
  hud.why_step_off = why_step_off(from);
}

// -- what is told beside the teeth

/// Whether the teeth touch bone, as the hand feels it.
std::string contact_line(const HudSources& from) {
  const std::uint32_t status = from.loop.sample.status;
  const bool is_touching = has(status, ToolStatus::InContact);
  const bool is_inside = has(status, ToolStatus::InKerf) || has(status, ToolStatus::InBore);
  return std::string(from.texts.text(is_inside     ? "operate.tip.in"
                                     : is_touching ? "operate.tip.on"
                                                   : "operate.tip.clear"));
}

std::optional<double> way_to_hinge_mm(const HudSources& from) {
  if (from.cut == nullptr) return std::nullopt;
  const scenarios::PlannedHinge* const hinge =
      find_hinge(from.prepared_case.plan_in_first, from.cut->hinge);
  if (hinge == nullptr) return std::nullopt;
  return hallux::ui::way_to_hinge_mm(*hinge, bone_from_tool(from));
}

std::string plan_line(const Texts& texts, const PlanReading& reading) {
  const std::string offset = signed_text(reading.distance_mm) + " mm";
  if (!reading.end_distance_mm) return texts.say("operate.tip.plan", {{"offset", offset}});
  return texts.say("operate.tip.plan_end",
                   {{"offset", offset}, {"end", signed_text(*reading.end_distance_mm) + " mm"}});
}

/// With the place where a stroke straight on must end.
PlanReading reading_of(const HudSources& from) {
  PlanReading reading = read_against(*from.cut, blade_of(coach_view(from)), bone_from_tool(from));
  if (from.site == nullptr) return reading;
  if (const auto way_mm = stroke_end_mm(from.site->ahead, way_to_hinge_mm(from)))
    reading.end_distance_mm = distance_ahead_mm(reading, *way_mm);
  return reading;
}

bool is_saw_in_hand(const HudSources& from) {
  return from.session.tools().is_saw() && from.session.tools().forceps() != Forceps::Holding;
}

void add_plan(OperatingHud& hud, const HudSources& from) {
  if (from.cut == nullptr || !is_saw_in_hand(from)) return;
  const std::size_t index = index_of_cut(from.prepared_case.plan_in_first, from.cut->name);
  hud.plan = {reading_of(from), read_passes(*from.cut, from.passes[index], bone_from_tool(from)),
              bands_of(from.prepared_case.scenario.rubric, from.cut->name)};
}

void add_tip(OperatingHud& hud, const HudSources& from) {
  if (from.session.is_practice() && from.site != nullptr && is_saw_in_hand(from))
    hud.way = way_ahead(from.site->ahead, way_to_hinge_mm(from));
  hud.tip_lines.push_back(hud.way ? words_of(from.texts, *hud.way) : contact_line(from));
  if (hud.plan) hud.tip_lines.push_back(plan_line(from.texts, hud.plan->blade));
}

// -- tools, wires and screws, fragments

void add_held(OperatingHud& hud, const HudSources& from) {
  const ToolsInHand& tools = from.session.tools();
  if (tools.tray().size() < 2 || tools.tool() == nullptr) return;
  const std::uint32_t status = from.loop.sample.status;
  HudTool& held = hud.held.emplace();
  const ToolWords words = tool_words(from.texts, *tools.tool());
  held.title = words.title;
  held.size = words.size;
  held.is_irrigated_kind = !tools.is_implant_driver();
  held.is_implant = tools.is_implant_driver();
  held.stands_in_bone = has(status, ToolStatus::InBore);
  held.can_take = from.site != nullptr && from.site->reach.implant.has_value();
  held.is_gripping = tools.forceps() != Forceps::Open;
  held.rate_per_minute = rate_per_minute(tools.tool()->tool);
}

std::string degrees(double rad) { return decimal_text(degree_from_radian(rad)) + "°"; }

void add_aims(OperatingHud& hud, const HudSources& from) {
  const CoachView view = coach_view(from);
  if (from.site == nullptr || !from.session.is_practice() || view.tools == nullptr) return;
  if (const std::optional<ImplantTask> task = implant_at_hand(view)) {
    const ImplantReading reading = read_implant(*task->implant, bone_from_tool(from));
    hud.aims = {{"aim.entry", "operate.aim.entry", decimal_text(reading.entry_mm) + " mm"},
                {"aim.direction", "operate.aim.direction", degrees(reading.direction_rad)},
                {"aim.depth", "operate.aim.depth",
                 from.texts.say("operate.aim.depth_of",
                                {{"depth", signed_text(reading.depth_mm)},
                                 {"length", decimal_text(task->implant->length_mm)}})}};
  }
  const std::optional<std::size_t> shift = shift_at_hand(view);
  if (!shift) return;
  const ShiftReading reading = shift_reading(view, *shift);
  hud.aims = {{"aim.moved", "operate.aim.moved", decimal_text(reading.moved_mm) + " mm"},
              {"aim.off", "operate.aim.off", decimal_text(reading.off_mm) + " mm"},
              {"aim.turned", "operate.aim.turned", degrees(reading.turned_rad)}};
}

/// The next thing to do, and the push that goes with it also where the words are hidden.
void add_hint(OperatingHud& hud, const HudSources& from, bool is_hinted) {
  std::optional<Hint> hint = next_hint(coach_view(from));
  if (!hint) return;
  if (hint->place) {
    const auto place = static_cast<std::size_t>(*hint->place);
    hint->values.emplace_back("tool", tool_text(from.texts, from.session.tools().tray()[place]));
  }
  hud.push = hint->push.value_or(usual_push);
  if (is_hinted) hud.hint = hint_text(from.texts, *hint, from.session.saw().led());
}

}  // namespace

CoachView coach_view(const HudSources& from) { return coach_view(from, from.session.steps()); }

CoachView coach_view(const HudSources& from, const StepProgress& steps) {
  const PreparedCase& prepared = from.prepared_case;
  const Quat bone_from_world = glm::conjugate(prepared.bone().world_from_bone.rotation);
  const std::uint32_t status = from.loop.sample.status;
  return {.scenario = prepared.scenario,
          .plan = prepared.plan_in_first,
          .passes = from.passes,
          .steps = steps,
          .site = from.site,
          .tools = &from.session.tools(),
          .bone_from_tool = bone_from_tool(from),
          .bone_from_view = bone_from_world * from.world_from_view,
          .is_saw_on = has(status, ToolStatus::SawOn) || has(status, ToolStatus::DriveOn),
          .is_irrigated = has(status, ToolStatus::Irrigated),
          .is_in_kerf = has(status, ToolStatus::InKerf),
          .is_in_bore = has(status, ToolStatus::InBore),
          .is_paused = from.session.pausing().is_paused(),
          .is_touching = has(status, ToolStatus::InContact),
          .force_newton = simulator::force_size_newton(from.loop.sample)};
}

OperatingHud hud_of(const HudSources& from, bool is_hinted) {
  const scenarios::Scenario& scenario = from.prepared_case.scenario;
  OperatingHud hud;
  hud.is_practice = from.session.is_practice();
  hud.is_paused = from.session.pausing().is_paused();
  hud.is_reviewed = scenario.is_reviewed;
  hud.tick = from.loop.sample.tick;
  add_steps(hud, from);
  const simulator::Saw* const saw = from.session.tools().saw();
  hud.saw = saw == nullptr ? scenario.saw : *saw;
  hud.is_saw_on = has(from.loop.sample.status, ToolStatus::SawOn) ||
                  has(from.loop.sample.status, ToolStatus::DriveOn);
  add_held(hud, from);
  hud.is_irrigated = from.session.saw().is_irrigated();
  hud.force_newton = simulator::force_size_newton(from.loop.sample);
  add_plan(hud, from);
  add_aims(hud, from);
  add_tip(hud, from);
  // Like the read-outs of the plan: help while one learns, none in an assessment.
  if (hud.is_practice) hud.bone_celsius = from.loop.hottest_celsius;
  if (hud.is_practice) add_hint(hud, from, is_hinted);
  return hud;
}

std::string held_text(const Texts& texts, const HeldCut& held) {
  const std::string share = std::to_string(std::max(1L, std::lround(100.0 * held.share))) + " %";
  if (held.side.empty()) return texts.say("operate.why.holds", {{"share", share}});
  return texts.say("operate.why.holds_at", {{"share", share}, {"side", held.side}});
}

NoticeTexts notice_texts(Notice notice) noexcept {
  constexpr const char* hinge = "operate.hinge_refused";
  constexpr const char* grip = "operate.grip_refused";
  // In the order of Notice.
  constexpr std::array<NoticeTexts, 17> words{{
      {"operate.nothing_free", "operate.nothing_free.detail"},
      {hinge, "operate.hinge.broken"},
      {hinge, "operate.hinge.stiff"},
      {hinge, "operate.hinge.nothing"},
      {hinge, "operate.hinge.waiting"},
      {"operate.kerf_refused", "operate.kerf_refused.detail"},
      {"operate.hand_refused", "operate.hand.tool_in_bone"},
      {"operate.hand_refused", "operate.hand.full"},
      {grip, "operate.grip.nothing"},
      {grip, "operate.grip.bone"},
      {grip, "operate.grip.fixed"},
      {grip, "operate.grip.too_many"},
      {"operate.hand_refused", "operate.hand.nothing_to_leave"},
      {"operate.hand_refused", "operate.hand.nothing_to_take"},
      {"operate.hand_refused", "operate.hand.too_many_left"},
      {"operate.bore_refused", "operate.bore_refused.detail"},
      {"operate.metal_met", "operate.metal_met.detail"},
  }};
  return words[static_cast<std::size_t>(notice)];
}

}  // namespace hallux::ui
