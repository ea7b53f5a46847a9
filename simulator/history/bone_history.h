/// The bone at every moment of a recorded attempt, so that any of them can be shown at once: its
/// fragments, the wires, screws and bores in them, and what was in the hand.
/// Inside this corner only.
///
///     events, samples --> paths of fragments, metal, hand
///     fields, jobs    --> spans between partings --> stretches in which one kerf grows
///
/// A closed hinge is two fragments, one of which was turned; so it is in recordings of engine 7 and
/// older, which had no fragments.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/bone/close_bridge.h"
#include "simulator/history/fragment_history.h"
#include "simulator/history/hand_history.h"
#include "simulator/history/metal_history.h"
#include "simulator/mesh/bones.h"
#include "simulator/record/record.h"
#include "simulator/tool/tray.h"

namespace hallux::simulator {

/// What an attempt was made on and with.
struct HistoryRequest {
  Bones bones;
  const Recording& recording;
  /// Of the recording, one per kerf.
  std::vector<OpenedField> opened;
  /// As the operation planned it.
  PlannedBridges bridges;
  /// With the tools that left wires, screws and bores.
  Tray tray = {};
};

/// A place on bone, in the frame of its fragment.
struct PlaceOnFragment {
  std::int32_t fragment = 0;
  Vec3 point_mm{0.0, 0.0, 0.0};
};

/// Never changes once it was built.
struct BoneHistory {
  std::vector<KerfGrowth> kerfs;
  /// As FragmentPoses numbers them: the bones are the first.
  std::vector<FragmentHistory> fragments;
  MetalHistory metal;
  HandHistory hand;
  /// By bone.
  std::vector<RigidTransform> world_from_bones;

  RigidTransform world_from_fragment(std::int32_t fragment, std::int64_t tick) const noexcept;
  /// The same place in the fragment that it belongs to at last: of the one that is said and those
  /// that were parted from it, the one whose solid holds it, else the nearest.
  PlaceOnFragment place_at_last(const PlaceOnFragment& place) const;
  /// Likewise of a place that is said in the frame of the first bone, whichever bone it is on.
  PlaceOnFragment place_at_last(const Vec3& point_in_first_mm) const;
  /// In the frame of the first bone, before anything was moved.
  Vec3 point_in_first_mm(const PlaceOnFragment& place) const noexcept;
  /// Where it is in the world after that tick; while its fragment is a part of another one, where
  /// that lies.
  Vec3 world_place_mm(const PlaceOnFragment& place, std::int64_t tick) const noexcept;
};

/// `progress` is told the fraction done and may throw to stop it.
/// errors  Cancelled
/// thread  work's; seconds
std::shared_ptr<const BoneHistory> build_history(HistoryRequest request,
                                                 const Progress& progress = {});

}  // namespace hallux::simulator
