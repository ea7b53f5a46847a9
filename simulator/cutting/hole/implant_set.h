/// Wires and screws that stay in the bone, by the events of an attempt: one rule for the step and
/// for scoring.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "simulator/cutting/hole/capsule.h"
#include "simulator/record/fragment_poses.h"
#include "simulator/record/record.h"
#include "simulator/tool/tray.h"

namespace hallux::simulator {

/// As many as an attempt may leave; one that is taken and left again counts twice.
inline constexpr std::int32_t implant_limit = 24;

/// With less of its axis than this in it, an implant holds no fragment.
inline constexpr double engaged_least_mm = 1.0;
/// Wires within 5 degrees are parallel: together they do not hold.
inline constexpr double parallel_sine = 0.0872;

struct Implant {
  /// That left it: its place on the tray.
  std::int32_t tool = 0;
  ImplantSize size;
  /// That it goes along with.
  std::int32_t fragment = 0;
  /// Origin at the tip, x along the axis.
  RigidTransform fragment_from_tool;
  /// It is in the driver again.
  bool is_taken = false;
};

/// From the tip back to the head or the chuck; in the frame that the pose leads to.
Capsule capsule_of(const ImplantSize& size, const RigidTransform& frame_from_tool) noexcept;

class ImplantSet {
 public:
  /// tray  with the drivers that may leave one
  explicit ImplantSet(const Tray& tray);

  /// By their numbers.
  std::span<const Implant> all() const noexcept {
    return {implants_.data(), static_cast<std::size_t>(count_)};
  }
  std::int32_t count() const noexcept { return count_; }
  bool is_full() const noexcept { return count_ == implant_limit; }
  /// Whether it was left, and not taken again.
  bool is_there(std::int32_t implant) const noexcept {
    return implant >= 0 && implant < count_ && !(*this)[implant].is_taken;
  }
  const Implant& operator[](std::int32_t implant) const noexcept {
    return implants_[static_cast<std::size_t>(implant)];
  }

  /// Follows the events: the tool in the hand, implants that are left, carried and taken; others
  /// change nothing.
  /// fragments  after the event
  /// errors  false where it names an implant that is not the next or not there, a tool that leaves
  ///         none, or a fragment that there is not; nothing changed then
  /// thread  haptic; allocates nothing
  bool apply(const CutEvent& event, const FragmentPoses& fragments) noexcept;

 private:
  bool leave(const CutEvent& event, const FragmentPoses& fragments) noexcept;
  bool carry(const CutEvent& event, const FragmentPoses& fragments) noexcept;

  Tray tray_;
  std::array<Implant, static_cast<std::size_t>(implant_limit)> implants_{};
  std::int32_t count_ = 0;
  std::int32_t tool_ = 0;
};

}  // namespace hallux::simulator
