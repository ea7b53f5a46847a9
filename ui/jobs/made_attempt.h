/// An attempt that is nobody's: carried out to be watched, in memory alone.
#pragma once

#include <memory>

#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {

/// Runs the hand in virtual time and scores what it did. Nothing is stored: the header names the
/// hand, and has no id, person or number.
/// needs   the attempt is in virtual time
/// ensures the same attempt makes the same material, to the bit
/// errors  ScenarioError, MeshError; Cancelled
/// thread  work's; tens of seconds
struct MadeAttempt {
  AttemptMaterial material;
  database::ScoreCard card;
};
MadeAttempt make_attempt(const ScriptedAttempt& attempt, const StageProgress& progress);

}  // namespace hallux::ui
