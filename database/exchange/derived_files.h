/// Files beside an exported record that are made from it: meshes and the like, by another room.
/// Inside this room only.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "database/content/assets.h"
#include "database/records/attempt.h"
#include "simulator/record/record.h"

namespace hallux::database {

/// A file that this room cannot make.
struct DerivedFile {
  /// See is_exchange_name.
  std::string name;
  std::string bytes;
};

struct ExportMaterial {
  const AttemptHeader& header;
  const ScenarioText& scenario;
  std::span<const std::byte> bone;
  const simulator::Recording& recording;
};

/// What lies beside the record because it can be made from it. May throw what it likes: then
/// nothing is exported.
using MakeDerived = std::function<std::vector<DerivedFile>(const ExportMaterial&)>;

}  // namespace hallux::database
