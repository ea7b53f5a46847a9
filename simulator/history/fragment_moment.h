/// A fragment of a recorded bone at one moment after the other: a solid that stands still, and a
/// patch on it. Inside this corner only.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "simulator/cutting/solid/solid_patch.h"
#include "simulator/history/bone_history.h"

namespace hallux::simulator {

class FragmentMoment {
 public:
  /// Borrows the history.
  FragmentMoment(const BoneHistory& history, std::int32_t fragment)
      : history_(&history), fragment_(fragment) {}

  /// Makes the fragment stand as it did after this tick. Milliseconds at most.
  /// ensures false where nothing of its solid changed
  bool move_to(std::int64_t tick);

  /// It is a fragment of its own, and was not taken out.
  bool is_there() const noexcept { return is_there_; }
  // Where it is there.
  /// The place in its history of the stretch whose solid stands still.
  std::size_t stretch() const noexcept { return stretch_.value_or(0); }
  /// On that solid; null where nothing of it changed.
  const SolidPatch* patch() const noexcept;
  const CutSolid& solid() const noexcept { return now().solid; }
  /// The outline of one of its kerfs as far as it is open.
  RegionOutline outline_of(std::int32_t kerf);
  /// How far along a ray it first meets what stands, all in the fragment's frame; nothing where it
  /// misses.
  /// needs   direction has length 1
  std::optional<double> first_hit_mm(const Vec3& from_mm, const Vec3& direction) const;

 private:
  const FragmentHistory& own() const noexcept {
    return history_->fragments[static_cast<std::size_t>(fragment_)];
  }
  const BoneStretch& now() const noexcept { return own().stretches[stretch()]; }
  void build_patch();
  const RegionOutline& outline_of_growing(std::int32_t kerf);
  void leave_out_taken();

  const BoneHistory* history_;
  std::int32_t fragment_;
  std::int64_t tick_ = -1;
  bool is_there_ = false;
  std::optional<std::size_t> stretch_;
  /// Of the kerf that grows in the stretch.
  std::size_t grown_ = 0;
  /// How many pieces are out.
  std::size_t taken_ = 0;
  /// Of the stretch.
  std::unique_ptr<PatchBuilder> builder_;
  /// Whose moment `opened_` is.
  std::int32_t kerf_ = -1;
  std::unique_ptr<OpenedMoment> opened_;
  SolidPatch patch_;
};

}  // namespace hallux::simulator
