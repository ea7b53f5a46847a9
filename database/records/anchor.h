/// Anchor: one line about an audit that somebody keeps elsewhere. It vouches for all that was done
/// until then, also against who owns the files.
/// Inside this room only.
#pragma once

#include <cstdint>
#include <string>

#include "database/records/ids.h"
#include "simulator/base/digest.h"

namespace hallux::database {

struct Anchor {
  DirectoryId directory;
  /// How many acts the audit has, and the link of the last.
  std::int64_t acts = 0;
  Digest head;
  /// Of that act.
  std::string at_utc;
};

}  // namespace hallux::database
