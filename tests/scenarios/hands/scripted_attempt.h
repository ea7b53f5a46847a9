/// A scripted attempt in virtual time, in one process and without a database: for tests and
/// benchmarks.
#pragma once

#include <cstdint>
#include <string_view>

#include "scenarios/hands/feeling_hand.h"
#include "scenarios/scenario.h"
#include "simulator/loop/attempt_loop.h"
#include "simulator/mesh/bone.h"
#include "simulator/record/record.h"

namespace hallux::tests {

struct ScriptedAttempt {
  simulator::Recording recording;
  simulator::LoopStatistics loop;
};

/// The hand's whole attempt, with all that came in and out.
/// thread  any; attempts share nothing but what they are given
ScriptedAttempt run_hand(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                         const scenarios::Plan& plan, scenarios::FeelingHand& hand);

/// The hand of that name and seed, carried out.
ScriptedAttempt run_hand(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                         std::string_view hand, std::uint64_t seed);

}  // namespace hallux::tests
