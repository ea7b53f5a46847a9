/// The part that a step takes out, among the pieces that lie free in the wound: the piece itself,
/// what broke off it, and neither splinters of the bone that stays nor crumbs.
///
/// For displays and buttons: it asks the fields and the pieces, and feeds nothing back.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scenarios/site/parted_bone.h"

namespace hallux::scenarios {

struct WantedPart {
  /// Numbers of the free pieces that are of it, largest first.
  std::vector<std::int32_t> pieces = {};
  /// They, with what was taken out before, are most of it: it is to be taken out.
  bool is_off = false;
};

/// The bone of an attempt as it is now; all borrowed.
struct BoneInPieces {
  /// The bone as it was.
  simulator::SolidWithTree whole;
  const simulator::KerfSet& kerfs;
  /// That lie free, largest first, each with its tree.
  std::span<const simulator::PieceBody* const> free;
  std::span<const simulator::Bvh* const> taken_out;
};

/// Nothing is of it where one of its cuts was not begun.
/// held    by the plan's cuts
/// thread  any; some 10 ms
WantedPart wanted_part(const OperationStep& step, const Plan& plan, std::span<const HeldCut> held,
                       const BoneInPieces& bone);

}  // namespace hallux::scenarios
