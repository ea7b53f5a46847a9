/// The order of an operation's steps: a chain in format 1, in format 2 whatever each says that it
/// comes after, with alternatives of which one suffices and steps that may be left out.
#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "scenarios/scenario.h"

namespace hallux::scenarios {

/// The step and the others of its group, of which one suffices, ascending.
std::vector<std::size_t> alternatives_of(const Scenario& scenario, std::size_t step);

/// Which steps may be done next, ascending, when those are done. A step is at hand when all that it
/// comes after is done, or was optional and is passed over; no longer when another alternative of
/// its group is done, or a step that comes after it.
/// is_done  of each step of the scenario
std::vector<std::size_t> steps_at_hand(const Scenario& scenario, const std::vector<bool>& is_done);

/// Whether each step that is not optional is done, or another alternative of its group.
bool is_all_done(const Scenario& scenario, const std::vector<bool>& is_done);

/// All steps, each behind those that lead to it, by whichever alternative.
/// needs   no step comes after itself
std::vector<std::size_t> steps_in_order(const Scenario& scenario);

/// Refuses steps of format 2 that nobody can carry out in an order: unknown or doubled ids, cycles,
/// a step that comes after two alternatives of one group or after another of its own, a mixture of
/// optional and required alternatives, no one verify before all and no one finish after all.
/// errors  ScenarioError with path and mend
void check_step_order(const Scenario& scenario, std::string_view file);

/// Of each step those that it cannot be done without, optional ones taken as done.
/// needs   the order was checked
std::vector<std::set<std::size_t>> needs_of_steps(const Scenario& scenario);

}  // namespace hallux::scenarios
