/// Places on bone that notes, questions and ledgers name, each with the fragment that it goes along
/// with. Inside this corner only.
#pragma once

#include <utility>
#include <vector>

#include "database/records/note.h"
#include "simulator/history/bone_moment.h"

namespace hallux::ui {

class PinnedPlaces {
 public:
  /// The first time a place is asked for costs milliseconds, then nothing.
  /// needs   always the same history
  const simulator::PlaceOnFragment& of(const simulator::BoneHistory& history,
                                       const database::BonePoint& place);

 private:
  std::vector<std::pair<database::BonePoint, simulator::PlaceOnFragment>> known_;
};

/// A place as it is kept: on the bone or on a piece by its number, before anything moved.
database::BonePoint bone_point_of(const simulator::BoneHistory& history,
                                  const simulator::PlaceOnFragment& place);

}  // namespace hallux::ui
