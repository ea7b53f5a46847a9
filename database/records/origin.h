/// Other data directories that attempts were imported from.
#pragma once

#include <cstdint>
#include <string>

#include "database/records/ids.h"

namespace hallux::database {

struct Origin {
  DirectoryId directory;
  bool is_accepted = false;  ///< what was imported from there counts as if it had been made here
  std::string imported_utc;  ///< the first time
  std::int32_t attempts = 0, people = 0;
};

}  // namespace hallux::database
