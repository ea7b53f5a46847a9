/// The wound: the fragments that a tool may meet, each as it still stands and where it lies now.
///
///     wound frame (that of the first bone) --fragment_from_wound--> frame of a fragment
///
/// A fragment is asked in its own frame, that of its original bone before anything moved: neither
/// its kerfs nor its tissues move with it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "simulator/contact/tissue.h"

namespace hallux::simulator {

/// What is remembered of each fragment by its own.
template <typename Memory>
using OfFragments = std::array<Memory, static_cast<std::size_t>(fragment_limit)>;

struct WoundFragment {
  RemainingTissue tissue;
  RigidTransform wound_from_fragment, fragment_from_wound;
  /// Both are the identity otherwise, and are not applied.
  bool is_moved = false;
  /// A ball around it, in its frame.
  Vec3 centre_mm{0.0, 0.0, 0.0};
  double radius_mm = 0.0;

  RigidTransform fragment_from(const RigidTransform& wound_from_tool) const noexcept {
    return is_moved ? fragment_from_wound * wound_from_tool : wound_from_tool;
  }
  /// Where something of its frame lies now.
  RigidTransform wound_from(const RigidTransform& fragment_from_thing) const noexcept {
    return is_moved ? wound_from_fragment * fragment_from_thing : fragment_from_thing;
  }
  Vec3 point_from(const Vec3& point_in_wound_mm) const noexcept {
    return is_moved ? transform_point(fragment_from_wound, point_in_wound_mm) : point_in_wound_mm;
  }
};

class Wound {
 public:
  /// Without a fragment. Borrows the kerfs.
  explicit Wound(const KerfSet& kerfs) noexcept : kerfs_(&kerfs) {}
  /// A bone that is one fragment. Borrows what the tissue does.
  Wound(const RemainingTissue& only) noexcept;
  Wound(const TissueMap& original, const KerfSet& kerfs,
        std::span<const Bvh* const> removed_pieces) noexcept
      : Wound(RemainingTissue{original, kerfs, removed_pieces}) {}

  /// Puts a fragment under its number, or in place of the one that was there.
  void put(std::int32_t fragment, const WoundFragment& standing) noexcept;
  /// Nothing of it is there any more.
  void take(std::int32_t fragment) noexcept {
    fragments_[static_cast<std::size_t>(fragment)].reset();
  }

  const KerfSet& kerfs() const noexcept { return *kerfs_; }
  const Blade& blade() const noexcept { return kerfs_->blade(); }
  /// Null where there is none of that number.
  const WoundFragment* fragment(std::int32_t number) const noexcept {
    const auto& standing = fragments_[static_cast<std::size_t>(number)];
    return standing ? &*standing : nullptr;
  }
  /// That the kerf is in.
  /// needs   it is there
  const WoundFragment& fragment_of_kerf(std::int32_t kerf) const noexcept {
    return *fragments_[static_cast<std::size_t>(kerfs_->fragment_of(kerf))];
  }
  /// A kerf's plane where it lies now.
  KerfPlane plane(std::int32_t kerf) const noexcept;

  /// Calls visit(number, fragment) for those whose ball comes within `reach_mm` of a point, by
  /// their numbers; a fragment that is alone is always near.
  template <typename Visit>
  void visit_near(const Vec3& point_in_wound_mm, double reach_mm, const Visit& visit) const {
    for (std::int32_t number = 0; number < end_; ++number) {
      const WoundFragment* const standing = fragment(number);
      if (standing == nullptr) continue;
      if (end_ > 1 && !is_near(*standing, point_in_wound_mm, reach_mm)) continue;
      visit(number, *standing);
    }
  }
  /// Distance to the nearest fragment's surface as it was before its kerfs, negative inside [mm].
  double clearance_mm(const Vec3& point_in_wound_mm) const noexcept;
  double clearance_mm(const Vec3& point_in_wound_mm,
                      OfFragments<SurfaceMemory>& memory) const noexcept;

 private:
  static bool is_near(const WoundFragment& standing, const Vec3& point_in_wound_mm,
                      double reach_mm) noexcept {
    const double most_mm = standing.radius_mm + reach_mm;
    return squared_length(standing.point_from(point_in_wound_mm) - standing.centre_mm) <=
           most_mm * most_mm;
  }

  const KerfSet* kerfs_;
  std::array<std::optional<WoundFragment>, static_cast<std::size_t>(fragment_limit)> fragments_{};
  std::int32_t end_ = 0;
};

/// Further than this no point of a blade lies from the middle of its tooth line.
inline double reach_of_blade_mm(const Blade& blade) noexcept {
  return blade.depth_mm + blade.width_mm + blade.kerf_mm;
}

}  // namespace hallux::simulator
