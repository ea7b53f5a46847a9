/// The pieces that an attempt took out of the wound. Inside this room only.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "assessment/rebuild/rebuild.h"
#include "simulator/mesh/bones.h"
#include "simulator/mesh/bvh.h"
#include "simulator/record/tape_lines.h"

namespace hallux::assessment {

/// From it on events tell where a piece that was taken out lay.
inline constexpr std::int32_t first_engine_with_places = 7;

/// Of the patient's bones, that of the piece which an event names.
/// event      of the recording, a removal
/// fragments  as the recording leaves them
std::size_t bone_of_piece(const simulator::Recording& recording, std::size_t event,
                          const simulator::FragmentPoses& fragments) noexcept;

struct TakenOut {
  std::int64_t tick = 0;
  /// Of the patient's bones, in whose frame it is.
  std::size_t bone = 0;
  /// As the piece was when its place was worked out last before it was taken.
  std::unique_ptr<const simulator::Bvh> body;
};

/// By time. A piece is known by the point that its event carries; in recordings of engine 6 and
/// older, which carry none, by the volume with which it came free.
/// needs   rebuilt is of this recording, bones and blade
/// errors  Cancelled; those of whoever keeps the tape; a removal whose piece is nowhere gives none
/// thread  any; seconds where the blade went on in bone after a piece was taken
std::vector<TakenOut> pieces_taken_out(const RebuiltBone& rebuilt, simulator::Bones bones,
                                       const simulator::Recorded& recorded,
                                       const Progress& progress = {});

}  // namespace hallux::assessment
