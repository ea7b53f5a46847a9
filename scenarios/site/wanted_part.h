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

/// A fragment of an attempt as it is now, in its own frame; all borrowed.
struct FragmentInPieces {
  /// What it was cut from since it is one.
  simulator::SolidWithTree whole;
  simulator::FragmentKerfs kerfs;
  /// That lie free, largest first, each with its tree.
  std::vector<const simulator::PieceBody*> free;
  std::vector<const simulator::Bvh*> taken_out;
};

/// Steps of that kind end with bone out of the wound: what their cuts part off.
bool takes_out(StepKind kind) noexcept;

/// Nothing is of it where one of its cuts was not begun, or they lie in different fragments.
/// held       by the plan's cuts
/// fragments  by their numbers
/// thread  any; some 10 ms
WantedPart wanted_part(const OperationStep& step, const Plan& plan, std::span<const HeldCut> held,
                       std::span<const FragmentInPieces> fragments);

}  // namespace hallux::scenarios
