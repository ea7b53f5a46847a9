/// A recorded bone at one moment after the other: its fragments where they lie, each a solid that
/// stands still and a patch on it, and the wires, screws and holes in them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "simulator/cutting/slice/section.h"
#include "simulator/history/fragment_moment.h"

namespace hallux::simulator {

/// The rim of a hole that is open, on a fragment; borrowed.
struct RimInMoment {
  std::int32_t fragment = 0;
  const HoleRim* rim = nullptr;
  /// Out of the bone, along the hole, in the fragment's frame.
  Vec3 outward{0.0, 0.0, 1.0};
};

/// A kerf as far as it is open, in the frame of its fragment.
struct KerfAtHand {
  std::int32_t fragment = 0;
  KerfOpening opening;
};

class BoneMoment {
 public:
  /// Borrows the history.
  explicit BoneMoment(const BoneHistory& history);

  /// Makes the bone stand as it did after this tick. Milliseconds at most; nothing where nothing
  /// changed.
  void move_to(std::int64_t tick);
  /// Another after each change of a solid or a pose.
  std::uint64_t revision() const noexcept { return revision_; }

  /// Of the whole recording, those that are not there now among them.
  std::int32_t fragment_count() const noexcept {
    return static_cast<std::int32_t>(fragments_.size());
  }
  const FragmentMoment& fragment(std::int32_t number) const noexcept {
    return fragments_[static_cast<std::size_t>(number)].moment;
  }
  /// Of one fragment: another after each change of its solid; no two fragments have the same.
  std::uint64_t revision_of(std::int32_t number) const noexcept {
    return fragments_[static_cast<std::size_t>(number)].revision;
  }
  RigidTransform world_from_fragment(std::int32_t number) const noexcept {
    return history_.world_from_fragment(number, tick_);
  }

  /// That stand in a fragment that is there; borrowed from the history.
  std::vector<const ImplantStay*> implants() const;
  /// Of the holes that are open, as far as they are open.
  std::vector<RimInMoment> rims() const;

  /// The kerf that grew last, as far as it is open; nothing before the first.
  std::optional<KerfAtHand> kerf_at_hand();

  /// Where a ray first meets what stands; nothing where it misses.
  /// needs   direction has length 1
  std::optional<PlaceOnFragment> first_hit(const Vec3& from_in_world_mm,
                                           const Vec3& direction_in_world) const;
  /// Where a place is now; of what was taken out, where it was last.
  Vec3 world_place_mm(const PlaceOnFragment& place) const noexcept {
    return history_.world_place_mm(place, tick_);
  }

 private:
  struct Shown {
    FragmentMoment moment;
    std::uint64_t revision = 0;
    std::size_t path_step = 0;
  };

  const FragmentHistory& history_of(std::int32_t number) const noexcept {
    return history_.fragments[static_cast<std::size_t>(number)];
  }

  const BoneHistory& history_;
  std::int64_t tick_ = -1;
  std::vector<Shown> fragments_;
  std::uint64_t revision_ = 0;
};

}  // namespace hallux::simulator
