#include "ui/screens/operating/hud_facts.h"

#include "simulator/record/sample_force.h"

namespace hallux::ui {

namespace {

using scenarios::StepKind;
using simulator::ToolStatus;

/// Of the button of such a step, as the id of a text.
std::string_view verb_of(StepKind kind) noexcept {
  switch (kind) {
    case StepKind::Remove:
      return "operate.step.remove";
    case StepKind::Close:
      return "operate.step.close";
    case StepKind::Finish:
      return "operate.step.finish";
    case StepKind::Verify:
    case StepKind::Cut:
      break;
  }
  return "operate.step.done";
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
                    const OperatingTable& table, const simulator::LoopView& loop,
                    const scenarios::PlannedCut* cut) {
  const scenarios::Scenario& scenario = table.scenario;
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
  hud.is_cutting = has(loop.sample.status, ToolStatus::Cutting);
  hud.force_newton = simulator::force_size_newton(loop.sample);
  if (cut != nullptr) {
    hud.reading = read_against(
        *cut, scenario.saw.blade,
        inverse(table.bone.world_from_bone) * transform_from(loop.sample.world_from_tool));
  }
  // Like the read-outs of the plan: help while one learns, none in an assessment.
  if (hud.is_practice) hud.bone_celsius = loop.hottest_celsius;
  return hud;
}

NoticeWords words_of(StepNotice notice) noexcept {
  switch (notice) {
    case StepNotice::NothingFree:
      return {"operate.nothing_free", "operate.nothing_free.detail"};
    case StepNotice::HingeBroken:
      return {"operate.hinge_refused", "operate.hinge.broken"};
    case StepNotice::HingeStiff:
      return {"operate.hinge_refused", "operate.hinge.stiff"};
    case StepNotice::HingeMissing:
      return {"operate.hinge_refused", "operate.hinge.nothing"};
    case StepNotice::HingeUnanswered:
      return {"operate.hinge_refused", "operate.hinge.waiting"};
    case StepNotice::KerfRefused:
      break;
  }
  return {"operate.kerf_refused", "operate.kerf_refused.detail"};
}

}  // namespace hallux::ui
