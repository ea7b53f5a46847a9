/// JSON text of a quality certificate, as it is sealed with its attempt.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "database/records/certificate.h"

namespace hallux::database {

/// With the verdict of today's limits: `valid`, and `not_valid_because`, a list of names. That
/// stays as it was sealed when limits change later.
std::string json_from_certificate(const RecordingCertificate& certificate);

/// What json_from_certificate wrote, whatever else stands beside it. What an older program did not
/// write yet is 0; the verdict is not read back. Nothing where the text is no such object.
std::optional<RecordingCertificate> certificate_from_json(std::string_view json);

/// What `attempt.is_valid` is of an attempt that was sealed with this quality: `valid`, or where an
/// older program wrote none `complete`; false where the text has neither.
bool is_valid_by(std::string_view quality_json);

}  // namespace hallux::database
