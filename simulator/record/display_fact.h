/// Display facts: what the window showed while somebody operated, as the integers that are kept.
///
/// They stand beside the record of an attempt and are no part of it: nothing is scored or replayed
/// from them, the seal is not of them, and they may be dropped. So a number that no view has is
/// possible in what is read back; who shows one asks is_view first.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "simulator/base/transform.h"

namespace hallux::simulator {

/// Values that a newer program writes are none of these.
enum class ShownStereo : std::int64_t { Mono = 0, SideBySide = 1, Anaglyph = 2 };
enum class ShownLayout : std::int64_t {
  /// One picture over the whole window.
  Whole = 0,
  /// With the section through the blade's plane as an inset.
  WithSection = 1
};

/// On the screen from its tick on, until the next fact.
struct DisplayFact {
  /// Of the newest sample that the picture was drawn from.
  std::int64_t tick = 0;
  /// What the camera looks at.
  std::array<std::int64_t, 3> target_in_world_um{};
  /// Quaternion (w, x, y, z) of the view: x right, y up, z to the viewer.
  std::array<std::int64_t, 4> world_from_view_micro{1000000, 0, 0, 0};
  /// Thousandths of a millimetre on the screen for one in the world.
  std::int64_t magnification_milli = 8000;
  /// How far behind the screen plane the target lies, in the world.
  std::int64_t target_depth_um = 6000;
  /// Of the picture.
  std::int64_t width_over_height_milli = 1600;
  ShownStereo stereo = ShownStereo::Mono;
  ShownLayout layout = ShownLayout::Whole;
  /// Facts that found no room since the one before.
  std::int64_t lost_before = 0;

  friend bool operator==(const DisplayFact&, const DisplayFact&) = default;
};

/// A view as it is drawn.
struct ShownView {
  Vec3 target_in_world_mm{0.0, 0.0, 0.0};
  /// Of unit length; view: x right, y up, z to the viewer.
  Quat world_from_view{1.0, 0.0, 0.0, 0.0};
  /// Millimetres on the screen for one in the world.
  double magnification = 8.0;
  double target_depth_mm = 6.0;
  double width_over_height = 1.6;
  ShownStereo stereo = ShownStereo::Mono;
  ShownLayout layout = ShownLayout::Whole;
};

/// The nearest fact; nothing where it is no view: a number that is none, nothing magnified.
std::optional<DisplayFact> fact_of(const ShownView& view, std::int64_t tick) noexcept;
/// The view that is meant; its quaternion is normalised again.
/// needs   is_view(fact)
ShownView shown_view_of(const DisplayFact& fact) noexcept;

/// Whether a picture can be drawn from its numbers: a rotation, a magnification above zero, all of
/// it within a room. Stereo and layout may be those of another program.
bool is_view(const DisplayFact& fact) noexcept;
/// Whether this program knows its stereo and its layout.
bool is_known(const DisplayFact& fact) noexcept;

/// The integers in the order in which they are kept.
inline constexpr std::size_t display_columns = 14;
std::array<std::int64_t, display_columns> columns_of(const DisplayFact& fact) noexcept;
DisplayFact display_fact_from(const std::array<std::int64_t, display_columns>& columns) noexcept;

}  // namespace hallux::simulator
