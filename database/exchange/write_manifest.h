/// Writer of the manifest of an exported attempt, as JSON text. Inside this corner only.
#pragma once

#include <string>

#include "database/exchange/manifest.h"

namespace hallux::database {

/// The same manifest gives the same bytes.
/// errors  DatabaseError Damaged where a text in it is not UTF-8
std::string json_from_manifest(const Manifest& manifest);

}  // namespace hallux::database
