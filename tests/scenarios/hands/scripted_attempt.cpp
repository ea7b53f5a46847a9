#include "tests/scenarios/hands/scripted_attempt.h"

#include <vector>

#include "scenarios/planned_bridge.h"
#include "simulator/device/scripted.h"

namespace hallux::tests {

namespace {

template <typename Value>
std::vector<Value> drained(simulator::Ring<Value>& ring) {
  std::vector<Value> values;
  values.reserve(ring.size());
  for (Value value; ring.pop(value);) values.push_back(value);
  return values;
}

}  // namespace

simulator::ContactSettings contact_of(const scenarios::Scenario& scenario) {
  simulator::ContactSettings settings;
  settings.cycles_per_minute = scenario.blade.cycles_per_minute;
  return settings;
}

simulator::WoundSettings wound_of(const scenarios::Scenario& scenario,
                                  const scenarios::Plan& plan) {
  return {capsules_of(plan.danger_zones), scenario.blade.thickness_mm};
}

ScriptedAttempt run_motion(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                           const simulator::HandMotion& motion) {
  const std::int64_t last_tick = motion.last_tick() + 1;
  const scenarios::Plan plan = plan_on(scenario, bone);
  const simulator::AttemptSetup setup{bone,
                                      scenario.blade.size,
                                      contact_of(scenario),
                                      planned_bridge(plan),
                                      simulator::Pacing::Virtual,
                                      motion.commands,
                                      last_tick,
                                      {},
                                      nullptr,
                                      wound_of(scenario, plan)};
  simulator::ScriptedDevice device(motion);
  // Room for every line, so that nobody has to drain meanwhile.
  simulator::AttemptChannels channels(static_cast<std::size_t>(last_tick) + 1);
  ScriptedAttempt attempt;
  attempt.loop = run_attempt(setup, device, channels);
  attempt.recording.tape = drained(channels.tape);
  attempt.recording.samples = drained(channels.samples);
  attempt.recording.events = drained(channels.events);
  return attempt;
}

ScriptedAttempt run_hand(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                         std::string_view hand, std::uint64_t seed) {
  const scenarios::ScriptedHand scripted =
      make_hand(scenario, bone, plan_on(scenario, bone), scenarios::hand_skill(hand), seed);
  return run_motion(scenario, bone, scripted.motion);
}

}  // namespace hallux::tests
