/// What an operation does beside the window, before and after it: preparing, beginning, scoring.
#pragma once

#include <memory>

#include "ui/screens/operating/operating_screen.h"

namespace hallux::ui {

/// Reads the version, makes the patient, its plan and its picture.
/// errors  DatabaseError, ScenarioError, MeshError; Cancelled
/// thread  any but the window's; also of the others
PreparedOperation prepare_operation(Visit& visit, database::ScenarioVersionId scenario,
                                    WorkReport& report);

/// Begins the attempt at the desk of who is signed in, and starts it.
/// errors  DatabaseError
std::unique_ptr<LiveAttempt> begin_operation(Visit& visit,
                                             std::shared_ptr<const OperatingTable> table,
                                             const LiveBegin& what,
                                             std::unique_ptr<simulator::HapticDevice> device);

/// Scores what was recorded and stores the score.
/// errors  DatabaseError, ScenarioError; Cancelled
void score_operation(Visit& visit, const database::AttemptId& attempt, WorkReport& report);

}  // namespace hallux::ui
