/// The pieces that an attempt took out of the wound. Inside this room only.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "assessment/rebuild/rebuild.h"
#include "simulator/mesh/bone.h"
#include "simulator/mesh/bvh.h"
#include "simulator/record/tape_lines.h"

namespace hallux::assessment {

/// From it on events tell where a piece that was taken out lay.
inline constexpr std::int32_t first_engine_with_places = 7;

struct TakenOut {
  std::int64_t tick = 0;
  /// As the piece was when its place was worked out last before it was taken.
  std::unique_ptr<const simulator::Bvh> body;
};

/// By time. A piece is known by the point that its event carries; in recordings of engine 6 and
/// older, which carry none, by the volume with which it came free.
/// needs   rebuilt is of this recording, bone and blade
/// errors  Cancelled; those of whoever keeps the tape; a removal whose piece is nowhere gives none
/// thread  any; seconds where the blade went on in bone after a piece was taken
std::vector<TakenOut> pieces_taken_out(const RebuiltBone& rebuilt, const simulator::Bone& bone,
                                       const simulator::Recorded& recorded,
                                       const Progress& progress = {});

}  // namespace hallux::assessment
