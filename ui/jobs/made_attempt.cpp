// The rings of an attempt are emptied where a recorder would be: between two reports of progress,
// on the same thread. They are far larger than what comes in between, a few hundred lines.
#include "ui/jobs/made_attempt.h"

#include <utility>

#include "simulator/base/check.h"
#include "simulator/base/progress.h"
#include "simulator/record/drain.h"

namespace hallux::ui {

namespace {

constexpr std::size_t ring_capacity = 32768;

simulator::Recording carried_out(const ScriptedAttempt& attempt, const simulator::Bones& bones,
                                 const Progress& progress) {
  const scenarios::Plan plan = plan_on(attempt.scenario, bones);
  const SetUpHand set_up = set_up_hand(attempt, bones, plan);
  simulator::AttemptChannels channels(ring_capacity);
  simulator::Recording recording;
  const simulator::LoopStatistics loop =
      run_attempt(set_up.setup, *set_up.hand, channels, [&](double fraction) {
        drain(channels, recording);
        return !progress || progress(fraction);
      });
  drain(channels, recording);
  if (loop.end == simulator::AttemptEnd::Cancelled)
    throw Cancelled("stopped while the hand was operating; nothing was kept");
  return recording;
}

}  // namespace

MadeAttempt make_attempt(const ScriptedAttempt& attempt, const StageProgress& progress) {
  CHECK(attempt.pacing == simulator::Pacing::Virtual);
  MadeAttempt made;
  made.material.scenario = attempt.scenario;
  made.material.bones = patient_of(attempt.scenario, progress);
  made.material.recording = carried_out(attempt, made.material.bones, progress("Operating"));
  database::AttemptHeader& header = made.material.header;
  header.scenario_name = attempt.scenario.name;
  header.scenario_version = attempt.scenario.version;
  header.begun.hand = scenarios::hand_with_faults(attempt.hand, attempt.faults);
  header.begun.seed = attempt.seed;
  header.begun.guidance = attempt.guidance;
  header.state = database::AttemptState::Closed;
  header.is_simulated = true;
  made.card = score_attempt(made.material, progress).card;
  return made;
}

}  // namespace hallux::ui
