/// Digest of all that measurements depend on beside the recording: the bone, and what a scenario
/// asks for. How it is scored is no part of it, so that scenarios that differ in knots, weights and
/// gates have the same.
#pragma once

#include "scenarios/scenario.h"
#include "simulator/base/digest.h"

namespace hallux::scenarios {

/// BLAKE2b-256(text, digest of the bone): the text is the scenario's JSON without `version`,
/// `reviewed`, `reviewed_by`, `title`, `summary`, `indication`, `sources`, `rubric` and `proof`,
/// its keys in alphabetical order, without blanks.
/// needs   the scenario was read from its text
Digest plan_digest(const Scenario& scenario, const Digest& bone);

}  // namespace hallux::scenarios
