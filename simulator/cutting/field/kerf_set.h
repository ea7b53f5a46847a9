/// The kerfs of one attempt, opened from what is recorded: one rule for the step, for its jobs and
/// for scoring.
///
/// The rule: a PlaneFrozen event fixes a kerf's plane; every sample in that kerf with the saw on
/// stamps the blade from the previous sample's pose (where that was in the same kerf) to its own.
/// Nothing else opens bone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "simulator/base/transform.h"
#include "simulator/cutting/field/kerf.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

/// As many planes as an attempt may freeze; a touch beyond that is refused with an event.
inline constexpr std::int32_t kerf_limit = 16;

class KerfSet {
 public:
  /// Takes all its memory here; what no blade comes near is never touched.
  KerfSet(const Blade& blade, const RigidTransform& world_from_bone, const FieldGrid& grid = {});

  std::int32_t count() const noexcept { return count_; }
  const KerfPlane& plane(std::int32_t kerf) const noexcept { return planes_[index(kerf)]; }
  const KerfField& field(std::int32_t kerf) const noexcept { return fields_[index(kerf)]; }
  const Blade& blade() const noexcept { return blade_; }
  const RigidTransform& kerf_from_bone(std::int32_t kerf) const noexcept {
    return kerf_from_bone_[index(kerf)];
  }

  /// Freezes the next kerf to the recorded pose of the tool; its number, or -1 where the limit is
  /// reached.
  /// thread  haptic; allocates nothing
  std::int32_t freeze(const QuantisedPose& bone_from_tool) noexcept;
  /// Stamps what this sample opened; the window of nodes that rose (empty where nothing did).
  /// thread  haptic; allocates nothing
  FieldWindow apply(const ToolSample& sample) noexcept;

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

  /// Whether some kerf's slab is open at this point.
  bool is_open(const Vec3& point_in_bone_mm) const noexcept;

 private:
  static std::size_t index(std::int32_t kerf) noexcept { return static_cast<std::size_t>(kerf); }

  Blade blade_;
  RigidTransform bone_from_world_;
  std::vector<KerfPlane> planes_;
  std::vector<RigidTransform> kerf_from_bone_;
  /// Of all fields.
  std::unique_ptr<TilePool> pool_;
  std::vector<KerfField> fields_;
  std::int32_t count_ = 0;
  std::int32_t last_kerf_ = -1;
  PlanarPose last_pose_;
};

}  // namespace hallux::simulator
