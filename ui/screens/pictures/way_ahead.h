/// What lies ahead of the teeth, as one number: told beside them, drawn and told in the blade's
/// plane, and asked for the end of a stroke.
///
///     teeth |    to the bone    |######|##### hinge #####| far side
///           in air: this far     in bone: to the hinge where one is planned, else to the far side
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "scenarios/plan.h"
#include "simulator/sight/blade_ahead.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {

enum class WayEnd : std::uint8_t { Bone, Beside, FarSide, Hinge, PastHinge };

struct WayAhead {
  WayEnd to = WayEnd::Bone;
  /// At least 0.
  double way_mm = 0.0;
};

/// Nearer than this the teeth touch.
inline constexpr double touching_mm = 0.05;

/// From the teeth along the feed to the hinge's line; below 0 beyond it. Nothing where the feed
/// does not lead there.
std::optional<double> way_to_hinge_mm(const scenarios::PlannedHinge& hinge,
                                      const RigidTransform& bone_from_tool) noexcept;

/// Nothing where the teeth touch bone and none stands ahead of them.
/// to_hinge_mm  of a cut that ends at a hinge; below 0 beyond it
std::optional<WayAhead> way_ahead(const simulator::BladeAhead& ahead,
                                  std::optional<double> to_hinge_mm) noexcept;

/// Where a stroke straight on must end: at the hinge, else where no tooth has bone ahead.
std::optional<double> stroke_end_mm(const simulator::BladeAhead& ahead,
                                    std::optional<double> to_hinge_mm) noexcept;

/// "Far side 3.6 mm ahead".
std::string words_of(const Texts& texts, const WayAhead& way);

}  // namespace hallux::ui
