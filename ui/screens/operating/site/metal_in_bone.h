/// Wires, screws and holes of a running attempt, as the picture shows them.
/// Inside this corner only.
///
///     bores, skins of the fragments --> rims, made anew where a hole went deeper or its skin
///                                       changed --> scene, each where its fragment lies
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "simulator/jobs/live_cut.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// A fragment as it is shown; borrowed. Without a tree it is out of the wound.
struct FragmentSkin {
  const simulator::IndexedMesh* mesh = nullptr;
  const simulator::Bvh* tree = nullptr;
  /// Another mesh has another.
  std::uint64_t id = 0;
};

/// The metal at one moment, each thing in the frame of its fragment.
struct MetalShown {
  struct Standing {
    std::int32_t fragment = 0;
    ImplantInScene implant;
  };
  struct Hole {
    std::int32_t fragment = 0;
    HoleInScene hole;
  };
  std::vector<Standing> implants;
  std::vector<Hole> holes;
};

class MetalInBone {
 public:
  /// skins   by fragment
  /// thread  the one that follows the cut; a millisecond for each hole that changed
  MetalShown renew(const simulator::LiveCut& cut, const std::vector<FragmentSkin>& skins);

 private:
  /// What the rims of a bore's place were made of, and the rims.
  struct KnownHole {
    std::uint64_t skin = 0;
    double depth_mm = -1.0;
    std::vector<HoleInScene> rims;
  };

  const std::vector<HoleInScene>& rims_of(std::size_t place, const simulator::Bore& bore,
                                          const FragmentSkin& skin);

  std::vector<KnownHole> known_;
};

/// Adds it to the scene, each thing where its fragment lies.
void add_metal(Scene& scene, const MetalShown& metal,
               const std::function<RigidTransform(std::int32_t)>& world_from_fragment);

}  // namespace hallux::ui
