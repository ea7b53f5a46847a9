/// A recorded bone at one moment after the other: a solid that stands still, a patch on it, or the
/// two halves of a hinge.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "simulator/cutting/slice/section.h"
#include "simulator/cutting/solid/solid_patch.h"
#include "simulator/history/bone_history.h"

namespace hallux::simulator {

class BoneMoment {
 public:
  /// Borrows the history.
  explicit BoneMoment(const BoneHistory& history) : history_(history) {}

  /// Makes the bone stand as it did after this tick. Milliseconds at most; nothing where nothing
  /// changed.
  void move_to(std::int64_t tick);
  /// Another after each change.
  std::uint64_t revision() const noexcept { return revision_; }

  /// Its halves stand in place of stretch and patch.
  bool is_closed() const noexcept { return was_closed_; }
  /// The place in the history of the stretch whose solid stands still.
  std::size_t stretch() const noexcept { return stretch_.value_or(0); }
  /// On that solid; null where nothing of it changed.
  const SolidPatch* patch() const noexcept;

  /// The kerf that grew last, as far as it is open; nothing before the first.
  std::optional<KerfOpening> kerf_at_hand();

  /// Where a ray first meets what stands, in the frame of the bone before anything moved; nothing
  /// where it misses.
  /// needs   direction has length 1
  std::optional<Vec3> first_hit(const Vec3& from_in_bone_mm, const Vec3& direction) const;
  /// Where a point of the bone before anything moved is now, in the bone's frame.
  Vec3 moved_place(const Vec3& point_in_bone_mm) const;

 private:
  void build_patch();
  const RegionOutline& outline_of_growing(std::int32_t kerf);
  void leave_out_taken();
  const IndexedMesh& mesh() const noexcept { return history_.stretches[stretch()].solid.mesh; }

  const BoneHistory& history_;
  std::int64_t tick_ = -1;
  std::optional<std::size_t> stretch_;
  /// Of the kerf that grows in the stretch.
  std::size_t grown_ = 0;
  /// How many pieces are out.
  std::size_t taken_ = 0;
  bool was_closed_ = false;
  /// Of the stretch.
  std::unique_ptr<PatchBuilder> builder_;
  /// Whose moment `opened_` is.
  std::int32_t kerf_ = -1;
  std::unique_ptr<OpenedMoment> opened_;
  SolidPatch patch_;
  std::uint64_t revision_ = 0;
};

}  // namespace hallux::simulator
