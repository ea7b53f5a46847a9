/// Other data directories that attempts were imported from.
#pragma once

#include <cstdint>
#include <string>

#include "database/records/ids.h"

namespace hallux::database {

struct Origin {
  DirectoryId directory;
  /// What was imported from there counts as if it had been made here.
  bool is_accepted = false;
  /// The first time.
  std::string imported_utc;
  std::int32_t attempts = 0, people = 0;
};

}  // namespace hallux::database
