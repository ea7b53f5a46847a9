/// Reader of the manifest of an exported attempt, from JSON text that nobody vouches for.
/// Inside this corner only.
#pragma once

#include <string_view>

#include "database/exchange/manifest.h"

namespace hallux::database {

/// errors  DatabaseError: BadInput where the text is no manifest or contradicts itself; Newer for a
///         later format
Manifest manifest_from_json(std::string_view json);

}  // namespace hallux::database
