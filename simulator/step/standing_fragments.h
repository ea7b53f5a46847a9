/// Fragments as a tool meets them: what each was cut from, what was taken out of it, where it lies,
/// and the joint that it hangs on. Inside this corner only.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "simulator/contact/gripped_body.h"
#include "simulator/contact/wound.h"
#include "simulator/mesh/bone.h"

namespace hallux::simulator {

class StandingFragments {
 public:
  /// Each bone is a fragment; the first one's frame is the wound's. Borrows tissues and kerfs for
  /// its lifetime.
  StandingFragments(std::span<const TissueMap* const> tissues, std::span<const Bone* const> bones,
                    const KerfSet& kerfs) noexcept;
  StandingFragments(const StandingFragments&) = delete;
  StandingFragments& operator=(const StandingFragments&) = delete;

  const Wound& wound() const noexcept { return wound_; }

  /// A fragment is what this surface encloses, from now on; borrowed for the lifetime of this.
  void cut_from(std::int32_t fragment, const Bvh& surface) noexcept {
    surfaces_[static_cast<std::size_t>(fragment)] = &surface;
  }
  /// A fragment hangs on the one that it was parted from.
  /// joint   in the frame of both
  void hang(std::int32_t fragment, const WoundJoint& joint) noexcept {
    joints_[static_cast<std::size_t>(fragment)] = joint;
  }
  /// Where the joint of a fragment lies now; nothing where it hangs on none.
  std::optional<WoundJoint> joint_of(std::int32_t fragment) const noexcept;
  /// Stands as the kerfs' events place it, without what was taken out of it.
  /// removed  borrowed until the next call for this fragment
  void stand(std::int32_t fragment, std::span<const Bvh* const> removed) noexcept;
  void take_out(std::int32_t fragment) noexcept { wound_.take(fragment); }

 private:
  template <typename Value>
  using OfEach = std::array<Value, static_cast<std::size_t>(fragment_limit)>;

  /// A bone's tissues, and a ball around it: so around each of its fragments in their frames.
  struct StandingBone {
    const TissueMap* tissue = nullptr;
    Vec3 centre_mm{0.0, 0.0, 0.0};
    double radius_mm = 0.0;
  };
  static StandingBone standing(const TissueMap& tissue, const Bone& bone) noexcept;

  const KerfSet& kerfs_;
  RigidTransform wound_from_world_;
  std::array<StandingBone, static_cast<std::size_t>(bone_limit)> bones_{};
  /// Null: all of the bone.
  OfEach<const Bvh*> surfaces_{};
  OfEach<std::optional<WoundJoint>> joints_{};
  Wound wound_;
};

}  // namespace hallux::simulator
