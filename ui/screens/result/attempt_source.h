/// The recorded attempt that a result is computed again from. Inside this corner only.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "ui/jobs/attempt_jobs.h"
#include "ui/screens/parts/signed_in_session.h"

namespace hallux::ui {

struct AttemptSource {
  AttemptMaterial attempt;
  /// Where what was cached beside the recording is kept.
  std::filesystem::path directory;
  /// Before, if it was; then the recording's outputs alone are there.
  std::optional<std::vector<assessment::Measurement>> measurements;
};

/// errors  DatabaseError: NotFound, Refused
/// thread  work's
AttemptSource attempt_source(SignedInSession& signed_in, const database::AttemptId& id);

/// From what was measured and kept where it is, else from the recording.
/// errors  Cancelled
/// thread  work's
assessment::Examination examination_of(const AttemptSource& source, const StageProgress& progress);

/// The same with the kerfs stamped from the recording: what is measured on it is of nothing that
/// only lay beside.
/// errors  Cancelled
/// thread  work's
assessment::Examination stamped_examination_of(const AttemptSource& source,
                                               const StageProgress& progress);

}  // namespace hallux::ui
