/// The fields that an attempt's blade opened, kept beside the database so that showing the attempt
/// again need not stamp them again. For showing: a score is always computed from the recording
/// itself.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "assessment/rebuild/opened_fields.h"
#include "simulator/base/progress.h"
#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {

/// What is kept of this very recording, else made from it now, and kept. Where it cannot be kept it
/// is only slower the next time.
/// errors  Cancelled
assessment::OpenedFields fields_of(const AttemptMaterial& material,
                                   const std::filesystem::path& data_directory,
                                   const Progress& progress = {});

/// What score_attempt examines, of an attempt that was measured before: for showing.
/// errors  Cancelled
assessment::Examination examine_kept(const AttemptMaterial& material,
                                     const std::filesystem::path& data_directory,
                                     std::vector<assessment::Measurement> measurements,
                                     const StageProgress& progress);

/// The name under which an attempt's fields are kept.
std::string cached_fields_name(const database::AttemptId& attempt);

/// The form in which fields are kept: of this machine's byte order, checked by who keeps it.
std::vector<std::byte> bytes_of(const assessment::OpenedFields& fields);
/// Nothing where the bytes are no fields: cut short, or with a window beyond its grid.
std::optional<assessment::OpenedFields> fields_from(std::span<const std::byte> bytes);

}  // namespace hallux::ui
