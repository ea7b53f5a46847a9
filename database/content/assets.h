/// Assets, stored under their own digest: bones, and the scenario texts attempts were made with.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "database/records/ids.h"
#include "database/store/connection.h"
#include "simulator/base/digest.h"

namespace hallux::database {

/// Stores `bytes` unless they are there already; returns their digest.
/// errors  DatabaseError
Digest put_asset(Database& database, std::string_view kind, std::span<const std::byte> bytes);

/// The bytes, checked against the digest.
/// errors  DatabaseError: NotFound, Damaged
std::vector<std::byte> get_asset(Database& database, const Digest& digest);

struct ScenarioText {
  std::string name;
  std::int32_t version = 1;
  /// Byte for byte as it was read.
  std::string json;
  /// Its text says so of itself, which nobody believes.
  bool is_reviewed = false;
};

/// The row of this very text; stored where it is new.
/// errors  DatabaseError
ScenarioVersionId put_scenario_version(Database& database, const ScenarioText& text);

/// errors  DatabaseError: NotFound; Damaged where the text is not what its digest says
ScenarioText get_scenario_version(Database& database, ScenarioVersionId id);

}  // namespace hallux::database
