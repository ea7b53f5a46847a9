#include "tests/scenarios/hands/scripted_attempt.h"

#include "scenarios/simulation_setup.h"
#include "simulator/record/drain.h"

namespace hallux::tests {

namespace {

/// Far more than come between two reports of progress, a few hundred lines.
constexpr std::size_t ring_capacity = 32768;

}  // namespace

ScriptedAttempt run_hand(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                         const scenarios::Plan& plan, scenarios::FeelingHand& hand) {
  simulator::AttemptSetup setup{simulation_setup(scenario, bone, plan, simulator::Guidance::None)};
  setup.last_tick = hand.end_tick();
  setup.attempt_operator = &hand;
  simulator::AttemptChannels channels(ring_capacity);
  ScriptedAttempt attempt;
  attempt.loop = run_attempt(setup, hand, channels, [&](double /*fraction*/) {
    drain(channels, attempt.recording);
    return true;
  });
  drain(channels, attempt.recording);
  return attempt;
}

ScriptedAttempt run_hand(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                         std::string_view hand, std::uint64_t seed) {
  const scenarios::Plan plan = plan_on(scenario, bone);
  scenarios::FeelingHand feeling(scenario, bone, plan, scenarios::hand_skill(hand), seed);
  return run_hand(scenario, bone, plan, feeling);
}

}  // namespace hallux::tests
