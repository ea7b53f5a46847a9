/// What is to be seen of a saw at work: places of its tooth line, and of the mouth of its kerf.
/// Inside this corner only.
#pragma once

#include "simulator/cutting/slice/section.h"
#include "simulator/tool/saw.h"
#include "ui/render/visibility.h"

namespace hallux::ui {

/// The bone as it was before anything was cut; borrowed.
struct WholeBone {
  const simulator::CutSolid& solid;
  const simulator::Bvh& tree;
  RigidTransform world_from_bone;
};

/// Places each millimetre along the teeth. Of a tooth in bone, or beyond it, the place counts where
/// the blade goes in behind it, as far as the blade reaches back.
std::vector<SightPlace> tooth_places(const WholeBone& bone, const RigidTransform& world_from_tool,
                                     const simulator::Blade& blade);

/// Places each half millimetre along the mouth of what is open, on the side of the bone that looks
/// against the feed; its two rims.
std::vector<SightPlace> mouth_places(const WholeBone& bone, const simulator::KerfOpening& kerf);

}  // namespace hallux::ui
