/// What each kerf of a recording opened, and when; and a solid after some of its kerfs as they
/// stood at one tick after the other. Inside this corner only.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "simulator/bone/cut_bone.h"
#include "simulator/cutting/field/opened_field.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

/// Later than any tick.
inline constexpr std::int64_t never_tick = std::numeric_limits<std::int64_t>::max();

struct KerfGrowth {
  OpenedField opened;
  /// Ticks at which something opened, ascending.
  std::vector<std::int32_t> ticks;
  /// That it is in, and when it was begun.
  std::int32_t fragment = 0;
  std::int64_t frozen_tick = 0;

  /// How many of the ticks are not after this one: the kerf looks the same wherever that is the
  /// same.
  std::size_t grown_at(std::int64_t tick) const noexcept;
};

/// opened  of the recording, one per kerf
std::vector<KerfGrowth> growths_of(std::vector<OpenedField> opened, const Recording& recording);

class BoneAtTick {
 public:
  /// Borrows the solid and the growths.
  /// kerfs  those that cut it, in the order of cutting
  BoneAtTick(const WholeBone& whole, NumberedPieces pieces, const std::vector<KerfGrowth>& growths,
             std::vector<std::int32_t> kerfs);

  /// The bone after this tick.
  CutBone& move_to(std::int64_t tick);
  /// The bone after this tick but for one kerf; -1: for none.
  CutSolid all_but(std::int32_t kerf, std::int64_t tick);
  CutBone& bone() noexcept { return bone_; }
  const std::vector<std::int32_t>& kerfs() const noexcept { return kerfs_; }

 private:
  void put(std::size_t place, RegionOutline region);
  const KerfGrowth& growth(std::size_t place) const noexcept {
    return (*growths_)[static_cast<std::size_t>(kerfs_[place])];
  }

  const std::vector<KerfGrowth>* growths_;
  std::vector<std::int32_t> kerfs_;
  CutBone bone_;
  /// By place in the order of cutting.
  std::vector<std::size_t> grown_;
};

}  // namespace hallux::simulator
