/// The kerfs of one attempt, opened from what is recorded: one rule for the step, for its jobs and
/// for scoring.
///
/// The rule: a PlaneFrozen event fixes a kerf's plane in a fragment; every sample in that kerf with
/// the saw on stamps the blade from the previous sample's pose (where that was in the same kerf) to
/// its own. A plane that is frozen while the blade is in a kerf of another fragment is one cut with
/// it: a sample in either opens both, until one of the fragments moves. Nothing else opens bone.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "simulator/base/transform.h"
#include "simulator/cutting/field/kerf.h"
#include "simulator/record/fragment_poses.h"
#include "simulator/record/record.h"
#include "simulator/tool/tray.h"

namespace hallux::simulator {

/// As many planes as an attempt may freeze; a touch beyond that is refused with an event.
inline constexpr std::int32_t kerf_limit = 16;

/// Some of an attempt's kerfs, ascending.
class KerfNumbers {
 public:
  class Iterator {
   public:
    explicit Iterator(std::uint32_t left) noexcept : left_(left) {}
    std::int32_t operator*() const noexcept { return std::countr_zero(left_); }
    Iterator& operator++() noexcept {
      left_ &= left_ - 1;
      return *this;
    }
    bool operator!=(const Iterator& other) const noexcept { return left_ != other.left_; }

   private:
    std::uint32_t left_;
  };

  Iterator begin() const noexcept { return Iterator(bits_); }
  static Iterator end() noexcept { return Iterator(0); }
  bool is_empty() const noexcept { return bits_ == 0; }
  bool has(std::int32_t kerf) const noexcept { return (bits_ & bit_of(kerf)) != 0; }
  std::int32_t count() const noexcept { return std::popcount(bits_); }
  void add(std::int32_t kerf) noexcept { bits_ |= bit_of(kerf); }
  void add(const KerfNumbers& kerfs) noexcept { bits_ |= kerfs.bits_; }
  /// The first `count` of all.
  static KerfNumbers first(std::int32_t count) noexcept {
    KerfNumbers kerfs;
    kerfs.bits_ = (std::uint32_t{1} << static_cast<unsigned>(count)) - 1;
    return kerfs;
  }

 private:
  static_assert(kerf_limit < 32);
  static std::uint32_t bit_of(std::int32_t kerf) noexcept {
    return std::uint32_t{1} << static_cast<unsigned>(kerf);
  }

  std::uint32_t bits_ = 0;
};

/// A kerf whose field rose, and where.
struct RisenKerf {
  std::int32_t kerf = -1;
  /// Holds every node that rose.
  FieldWindow window;
};

class KerfSet {
 public:
  /// Takes all its memory here; what no blade comes near is never touched.
  /// tray  with the blades that may be chosen
  KerfSet(const Tray& tray, const RigidTransform& world_from_bone, const FieldGrid& grid = {})
      : KerfSet(tray, FragmentPoses(world_from_bone), grid) {}
  KerfSet(const Tray& tray, const FragmentPoses& fragments, const FieldGrid& grid = {});

  std::int32_t count() const noexcept { return count_; }
  const KerfPlane& plane(std::int32_t kerf) const noexcept { return planes_[index(kerf)]; }
  const KerfField& field(std::int32_t kerf) const noexcept { return fields_[index(kerf)]; }
  const Tray& tray() const noexcept { return tray_; }
  /// In the hand: its place on the tray.
  std::int32_t tool() const noexcept { return tool_; }
  /// In the hand, or last in it.
  const Blade& blade() const noexcept { return blade_; }
  const RigidTransform& kerf_from_bone(std::int32_t kerf) const noexcept {
    return kerf_from_bone_[index(kerf)];
  }
  /// In whose frame its plane is said.
  std::int32_t fragment_of(std::int32_t kerf) const noexcept { return fragment_of_[index(kerf)]; }
  /// The kerfs that cut this fragment since it is one, or since another was parted from it.
  const KerfNumbers& kerfs_of(std::int32_t fragment) const noexcept {
    return kerfs_of_[index(fragment)];
  }
  const FragmentPoses& fragments() const noexcept { return fragments_; }

  /// Follows the events: planes, fragments and where they lie, the blade in the hand; others change
  /// nothing.
  /// errors  false where it names a kerf that is not the next, or one beyond the limit, or a
  ///         fragment or a tool that there is not; nothing changed then
  /// thread  haptic; allocates nothing
  bool apply(const CutEvent& event) noexcept;
  /// Freezes the next kerf to the recorded pose of the tool; its number, or -1 where the limit is
  /// reached.
  /// fragment  its frame is that of the pose
  /// thread    haptic; allocates nothing
  std::int32_t freeze(const QuantisedPose& fragment_from_tool, std::int32_t fragment = 0) noexcept;
  /// Stamps what this sample opened; the kerfs that rose, that of the sample first. Valid until the
  /// next call.
  /// thread  haptic; allocates nothing
  std::span<const RisenKerf> apply(const ToolSample& sample) noexcept;

  /// Touches memory for what is opened next, for whoever must not wait for it while a blade cuts:
  /// at most `at_once` tiles, until `ahead` of them wait. A blade's first stamp opens some 250.
  /// ensures the fields stay as they are
  /// thread  haptic; allocates nothing
  void make_tiles_ready(std::size_t ahead, std::size_t at_once) noexcept {
    pool_->make_ready(ahead, at_once);
  }
  const TilePool& tiles() const noexcept { return *pool_; }

  /// Opens a frozen kerf as its field was kept: instead of its samples.
  void put(std::int32_t kerf, const FieldWindow& window,
           std::span<const float> inside_mm) noexcept {
    fields_[index(kerf)].put(window, inside_mm);
  }

  /// Whether the slab of one of these kerfs is open at this point of their fragment.
  bool is_open(const KerfNumbers& kerfs, const Vec3& point_mm) const noexcept;
  /// The same of all kerfs.
  bool is_open(const Vec3& point_in_bone_mm) const noexcept {
    return is_open(KerfNumbers::first(count_), point_in_bone_mm);
  }

  /// The kerfs that are one cut with this one, itself among them.
  KerfNumbers one_cut_with(std::int32_t kerf) const noexcept;

 private:
  static std::size_t index(std::int32_t number) noexcept {
    return static_cast<std::size_t>(number);
  }
  bool choose(std::int32_t tool) noexcept;
  void part_cuts(std::int32_t fragment) noexcept;
  void stamp(std::int32_t kerf, const RigidTransform& world_from_tool, bool goes_on) noexcept;

  Tray tray_;
  Blade blade_;
  FragmentPoses fragments_;
  std::vector<KerfPlane> planes_;
  std::vector<RigidTransform> kerf_from_bone_;
  std::array<std::int32_t, static_cast<std::size_t>(kerf_limit)> fragment_of_{};
  std::array<KerfNumbers, static_cast<std::size_t>(fragment_limit)> kerfs_of_{};
  /// Of each kerf, the first that is one cut with it.
  std::array<std::int32_t, static_cast<std::size_t>(kerf_limit)> cut_of_{};
  /// Of all fields.
  std::unique_ptr<TilePool> pool_;
  std::vector<KerfField> fields_;
  std::int32_t count_ = 0;
  std::int32_t tool_ = 0;
  std::int32_t last_kerf_ = -1;
  std::array<PlanarPose, static_cast<std::size_t>(kerf_limit)> last_poses_{};
  /// That last_poses_ are of the sample before.
  KerfNumbers stamped_;
  std::array<RisenKerf, static_cast<std::size_t>(kerf_limit)> risen_{};
  std::size_t risen_count_ = 0;
};

/// The kerfs of one fragment, those that are still to come among them. Borrows the set.
class FragmentKerfs {
 public:
  /// All kerfs, of a bone that is one fragment.
  FragmentKerfs(const KerfSet& kerfs) noexcept : set_(&kerfs) {}
  FragmentKerfs(const KerfSet& kerfs, std::int32_t fragment) noexcept
      : set_(&kerfs), fragment_(fragment) {}

  KerfNumbers numbers() const noexcept {
    return fragment_ < 0 ? KerfNumbers::first(set_->count()) : set_->kerfs_of(fragment_);
  }
  KerfNumbers::Iterator begin() const noexcept { return numbers().begin(); }
  static KerfNumbers::Iterator end() noexcept { return KerfNumbers::end(); }

  const KerfSet& all() const noexcept { return *set_; }
  const Blade& blade() const noexcept { return set_->blade(); }
  const KerfPlane& plane(std::int32_t kerf) const noexcept { return set_->plane(kerf); }
  const KerfField& field(std::int32_t kerf) const noexcept { return set_->field(kerf); }
  /// The frame is the fragment's.
  const RigidTransform& kerf_from_bone(std::int32_t kerf) const noexcept {
    return set_->kerf_from_bone(kerf);
  }
  bool is_open(const Vec3& point_mm) const noexcept { return set_->is_open(numbers(), point_mm); }

 private:
  const KerfSet* set_;
  /// -1: all.
  std::int32_t fragment_ = -1;
};

}  // namespace hallux::simulator
