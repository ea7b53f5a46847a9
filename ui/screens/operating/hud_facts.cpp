#include "ui/screens/operating/hud_facts.h"

#include <array>

#include "simulator/record/sample_force.h"

namespace hallux::ui {

namespace {

using scenarios::StepKind;
using simulator::ToolStatus;

/// Of the button of such a step, as the id of a text.
std::string_view verb_of(StepKind kind) noexcept {
  return kind == StepKind::Remove   ? "operate.step.remove"
         : kind == StepKind::Close  ? "operate.step.close"
         : kind == StepKind::Finish ? "operate.step.finish"
                                    : "operate.step.done";
}

void add_steps(OperatingHud& hud, const Texts& texts, const OperatingSession& session) {
  const StepProgress& steps = session.steps();
  hud.step = steps.step();
  if (!steps.kind()) return;
  hud.step_action = texts.text(verb_of(*steps.kind()));
  hud.is_step_busy = steps.is_waiting();
  hud.is_step_ready = !session.pausing().is_paused() && steps.is_ready();
}

}  // namespace

OperatingHud hud_of(const Texts& texts, const OperatingSession& session,
                    const PreparedCase& prepared_case, const simulator::LoopView& loop,
                    const scenarios::PlannedCut* cut) {
  const scenarios::Scenario& scenario = prepared_case.scenario;
  OperatingHud hud;
  hud.is_practice = session.is_practice();
  hud.is_paused = session.pausing().is_paused();
  hud.is_reviewed = scenario.is_reviewed;
  hud.tick = loop.sample.tick;
  for (const scenarios::OperationStep& step : scenario.steps) hud.steps.push_back(step.title);
  add_steps(hud, texts, session);
  hud.saw = scenario.saw;
  hud.is_saw_on = has(loop.sample.status, ToolStatus::SawOn);
  hud.is_irrigated = session.saw().is_irrigated();
  hud.force_newton = simulator::force_size_newton(loop.sample);
  if (cut != nullptr) {
    hud.reading = read_against(
        *cut, scenario.saw.blade,
        inverse(prepared_case.bone.world_from_bone) * transform_from(loop.sample.world_from_tool));
  }
  // Like the read-outs of the plan: help while one learns, none in an assessment.
  if (hud.is_practice) hud.bone_celsius = loop.hottest_celsius;
  return hud;
}

NoticeTexts notice_texts(StepNotice notice) noexcept {
  constexpr const char* hinge = "operate.hinge_refused";
  // In the order of StepNotice.
  constexpr std::array<NoticeTexts, 6> words{{
      {"operate.nothing_free", "operate.nothing_free.detail"},
      {hinge, "operate.hinge.broken"},
      {hinge, "operate.hinge.stiff"},
      {hinge, "operate.hinge.nothing"},
      {hinge, "operate.hinge.waiting"},
      {"operate.kerf_refused", "operate.kerf_refused.detail"},
  }};
  return words[static_cast<std::size_t>(notice)];
}

}  // namespace hallux::ui
