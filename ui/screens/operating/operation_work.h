/// Work of an operation beside the window, before and after it: preparing, beginning, scoring.
#pragma once

#include <memory>
#include <vector>

#include "scenarios/site/planned_passes.h"
#include "ui/jobs/live_attempt.h"
#include "ui/screens/operating/site/bone_being_cut.h"
#include "ui/screens/operating/site/site_picture.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/window/shell/background.h"

namespace hallux::ui {

/// What an operation needs before it can begin.
struct PreparedOperation {
  std::shared_ptr<const PreparedCase> prepared_case;
  BonePictures pictures;
  std::shared_ptr<const SitePicture> site;
  /// By the plan's cuts.
  std::vector<scenarios::PlannedPasses> passes;
};

/// Reads the version, makes the patient, its plan and its picture.
/// errors  DatabaseError, ScenarioError, MeshError; Cancelled
/// thread  any but the window's; also of the others
PreparedOperation prepare_operation(SignedInSession& signed_in,
                                    database::ScenarioVersionId scenario, WorkReport& report);

/// Of each of the plan's cuts, in the frame of the first bone.
std::vector<scenarios::PlannedPasses> passes_of(const PreparedCase& prepared_case);
/// Likewise.
std::vector<PlannedFace> faces_of(const PreparedCase& prepared_case);

/// Begins the attempt at the desk of who is signed in, and starts it. Its device class is what the
/// device says.
/// errors  DatabaseError
std::unique_ptr<LiveAttempt> begin_operation(SignedInSession& signed_in,
                                             std::shared_ptr<const PreparedCase> prepared_case,
                                             LiveBegin what,
                                             std::unique_ptr<simulator::HapticDevice> device);

/// Scores what was recorded and stores the score.
/// errors  DatabaseError, ScenarioError; Cancelled
void score_operation(SignedInSession& signed_in, const database::AttemptId& attempt,
                     WorkReport& report);

}  // namespace hallux::ui
