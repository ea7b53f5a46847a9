/// A tool with a point, as the rules of contact see it: wire, drill and screw alike.
/// Inside this room only.
///
///     shoulder                                    tip
///      |
///      |====================================>     x: along the axis, from handle to tip;
///      |                                          the tool's origin is the tip
///       <------------- shaft_mm ------------>
#pragma once

#include <optional>

#include "simulator/contact/feed.h"
#include "simulator/tool/drill.h"
#include "simulator/tool/screw.h"
#include "simulator/tool/tray.h"
#include "simulator/tool/wire.h"

namespace hallux::simulator {

struct BoreTool {
  /// Of what it bores: a wire's or drill's own, a screw's shaft.
  double radius_mm = 0.8;
  /// From the tip back to what goes into no hole: chuck or head.
  double shaft_mm = 120.0;
  double shoulder_radius_mm = 5.0;
  /// What the feed law counts as the saw's cycles: rate and sharpness of the drive in it.
  double law_cycles_per_minute = 12000.0;
  double turns_per_s = 1000.0 / 60.0;
  /// Way in a turn; 0 of what has no thread.
  double pitch_mm = 0.0;
  /// A screw that is not self-drilling goes only where a hole is.
  bool bores = true;

  bool is_screw() const noexcept { return pitch_mm > 0.0; }
};

/// The rate at which the feed law takes a drive for a saw's 12,000 cycles a minute.
/// source  ours, provisional: nothing measured stands behind it
inline constexpr double rated_revolutions_per_minute = 1000.0;
/// Of chucks.
inline constexpr double chuck_radius_mm = 5.0;

BoreTool bore_tool(const WireDriver& driver) noexcept;
BoreTool bore_tool(const Drill& drill) noexcept;
/// A screw cuts as a drill of its shaft's thickness at the rated speed: its thread, not its drive,
/// says how fast it may go.
BoreTool bore_tool(const Screwdriver& driver) noexcept;
/// Nothing of a saw.
std::optional<BoreTool> bore_tool(const Tool& tool) noexcept;

}  // namespace hallux::simulator
