/// From a recording to the bones as they were left: the kerfs from the recorded poses, the solids
/// from the kerfs.
#pragma once

#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

#include "assessment/rebuild/opened_fields.h"
#include "simulator/base/progress.h"
#include "simulator/bone/close_bridge.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/cutting/slice/section.h"
#include "simulator/mesh/bones.h"
#include "simulator/record/record.h"
#include "simulator/tool/tray.h"

namespace hallux::assessment {

/// One kerf of the attempt. `is_touched`, `is_removed` and `opened_fraction` have one entry per
/// region of the section.
struct RebuiltKerf {
  /// Of the solid as it was when this kerf's turn came.
  simulator::Section section;
  /// Of what the blade opened.
  simulator::RegionOutline outline;
  /// The blade opened something of the region.
  std::vector<std::uint8_t> is_touched;
  /// Nothing of the region within the slab is left.
  std::vector<std::uint8_t> is_removed;
  /// [0, 1], of the region's volume within the slab.
  std::vector<double> opened_fraction;
  double removed_mm3 = 0.0;
  std::int64_t frozen_tick = 0;
  /// frozen_tick where it never cut.
  std::int64_t first_cutting_tick = 0, last_cutting_tick = 0;
  std::int64_t cutting_samples = 0;

  /// The blade was taken through all that it began: the largest region that it touched is covered.
  bool is_finished() const noexcept;
  /// How much of that region the blade opened: 1 where it is finished.
  double done_fraction() const noexcept;
};

/// A fragment as it was left: the bone, or a piece of it that was moved.
struct RebuiltFragment {
  /// The number that it has as a piece.
  std::int32_t piece = 0;
  /// Of RebuiltBone::pieces, its own.
  std::size_t first_piece = 0, piece_count = 0;
  /// Taken out of the wound.
  bool is_out = false;
};

/// ensures input = sum of pieces + debris + removed, as far as sections integrate exactly
struct RebuiltBone {
  /// Planes and fields, one per entry of `kerfs`; and where the fragments lie at last.
  simulator::KerfSet fields;
  std::vector<RebuiltKerf> kerfs = {};
  /// Of each fragment largest first, debris left out; in its frame, that of its bone before
  /// anything moved.
  std::vector<simulator::CutSolid> pieces = {};
  std::vector<double> piece_volumes_mm3 = {};
  /// Of each piece: the patient's bone that it is of.
  std::vector<std::size_t> piece_bones = {};
  /// Of each piece: it was taken out of the wound.
  std::vector<bool> is_piece_out = {};
  /// As in `fields`; the bones are the first.
  std::vector<RebuiltFragment> fragments = {};
  /// By bone, as they were.
  std::vector<double> inputs_mm3 = {};
  /// By the blade, integrated from sections.
  double removed_mm3 = 0.0;
  double debris_mm3 = 0.0;
  std::int32_t debris_count = 0;

  /// Of all bones.
  double input_mm3() const noexcept {
    return std::accumulate(inputs_mm3.begin(), inputs_mm3.end(), 0.0);
  }
};

/// Of the patient's bones, in which that kerf is.
std::size_t bone_of(const RebuiltBone& rebuilt, std::int32_t kerf) noexcept;
/// All that are in that bone.
simulator::KerfNumbers kerfs_of_bone(const RebuiltBone& rebuilt, std::size_t bone) noexcept;

/// The hinges of an operation that may have closed.
struct ClosedHinges {
  /// In the operation's order.
  simulator::PlannedBridges bridges = {};
  /// The halves are bodies of their own also where nothing was sawn, gripped or bored afterwards:
  /// how they lie is asked, not what was cut.
  bool are_always_divided = false;
};

/// Called after each sample, in their order, with the kerfs as they stand then.
using SampleFollower =
    std::function<void(const simulator::ToolSample& sample, const simulator::KerfSet& kerfs)>;

/// hinges  that the operation planned, for a recording that went on after one has closed
/// needs   recording's samples and events are in the order of their ticks
/// ensures an event of tick t acts before the sample of tick t; kerfs act on the solid in the order
///         they were frozen; `opened` saves the stamping and changes no bit
/// needs   where `opened` is given, fields of this recording (see are_of), and no follower: kept
///         fields know no time between
/// errors  Cancelled
/// thread  any
RebuiltBone rebuild(simulator::Bones bones, const simulator::Tray& tray,
                    const simulator::Recording& recording, const Progress& progress = {},
                    const OpenedFields* opened = nullptr, const SampleFollower& follow = {},
                    const ClosedHinges& hinges = {});

}  // namespace hallux::assessment
