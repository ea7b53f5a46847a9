/// The tool in the hand: a saw, or one that bores; or none yet, where the one that was taken up
/// would stand in bone. Inside this corner only.
///
///     taken up --- clear of bone ---> held --- put down, or left in the bone ---> taken up
#pragma once

#include <cstdint>

#include "simulator/step/boring.h"
#include "simulator/step/sawing.h"

namespace hallux::simulator {

class ToolInHand {
 public:
  /// Its place on the tray.
  std::int32_t place() const noexcept { return place_; }
  /// What was taken up is not held yet.
  bool is_empty() const noexcept { return is_empty_; }
  Sawing& sawing() noexcept { return sawing_; }
  Boring& boring() noexcept { return boring_; }

  const RigidTransform& bone_from_tool(const Tray& tray) const noexcept {
    return tray.saw(place_) != nullptr ? sawing_.tool().bone_from_tool
                                       : boring_.tool().wound_from_tool;
  }
  /// It touches nothing.
  bool is_free(const Tray& tray) const noexcept {
    return tray.saw(place_) != nullptr ? sawing_.tool().stage == ToolStage::Free
                                       : boring_.tool().stage == BoreStage::Free;
  }
  /// Any of it lies within a fragment's outer surface as it was before its kerfs.
  bool is_in_bone(const Tray& tray, const Wound& wound) const noexcept;

  /// The tool of that place is taken up from now on: held as soon as it is clear of bone.
  void choose(std::int32_t place) noexcept {
    place_ = place;
    is_empty_ = true;
  }
  /// What the hand held is there no more: the same is taken up anew.
  void put_down() noexcept { is_empty_ = true; }
  /// Holds what it took out of the bone.
  void hold() noexcept { is_empty_ = false; }
  /// Holds what was taken up, where it is clear of bone.
  void take_up(const RigidTransform& bone_from_handle, const Tray& tray,
               const Wound& wound) noexcept;
  void place_at(const RigidTransform& bone_from_handle) noexcept {
    sawing_.place(bone_from_handle);
  }

 private:
  Sawing sawing_;
  Boring boring_;
  std::int32_t place_ = 0;
  bool is_empty_ = false;
};

}  // namespace hallux::simulator
