#include "tests/scenarios/hands/scripted_attempt.h"

#include <vector>

#include "scenarios/planned_bridge.h"

namespace hallux::tests {

namespace {

/// Far more than come between two reports of progress, a few hundred lines.
constexpr std::size_t ring_capacity = 32768;

template <typename Value>
void drain(simulator::Ring<Value>& ring, std::vector<Value>& values) {
  for (Value value; ring.pop(value);) values.push_back(value);
}

void drain_all(simulator::AttemptChannels& channels, simulator::Recording& recording) {
  drain(channels.tape, recording.tape);
  drain(channels.samples, recording.samples);
  drain(channels.events, recording.events);
}

}  // namespace

simulator::ContactSettings contact_of(const scenarios::Scenario& scenario) {
  simulator::ContactSettings settings;
  settings.cycles_per_minute = scenario.blade.cycles_per_minute;
  settings.sharpness = scenario.blade.sharpness;
  settings.bone_quality = scenario.patient.bone_quality;
  return settings;
}

simulator::ToolEffectSettings effects_of(const scenarios::Scenario& scenario,
                                         const scenarios::Plan& plan) {
  return {capsules_of(plan.danger_zones), scenario.blade.thickness_mm};
}

ScriptedAttempt run_hand(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                         const scenarios::Plan& plan, scenarios::FeelingHand& hand) {
  simulator::AttemptSetup setup{bone, scenario.blade.size, contact_of(scenario),
                                planned_bridge(plan)};
  setup.last_tick = scenarios::FeelingHand::last_tick;
  setup.effects = effects_of(scenario, plan);
  setup.attempt_operator = &hand;
  simulator::AttemptChannels channels(ring_capacity);
  ScriptedAttempt attempt;
  attempt.loop = run_attempt(setup, hand, channels, [&](double /*fraction*/) {
    drain_all(channels, attempt.recording);
    return true;
  });
  drain_all(channels, attempt.recording);
  return attempt;
}

ScriptedAttempt run_hand(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                         std::string_view hand, std::uint64_t seed) {
  const scenarios::Plan plan = plan_on(scenario, bone);
  scenarios::FeelingHand feeling(scenario, bone, plan, scenarios::hand_skill(hand), seed);
  return run_hand(scenario, bone, plan, feeling);
}

}  // namespace hallux::tests
