/// The rubric's bands of the cut at hand, as live read-outs show them: where full points end, and
/// where none are left. Inside this corner only.
#pragma once

#include <optional>
#include <string_view>

#include "scenarios/scenario.h"

namespace hallux::ui {

/// Of a size: full points up to `full`, none from `zero` on.
struct LiveBand {
  double full = 0.0, zero = 0.0;
};

enum class BandState {
  /// Full points.
  Full,
  /// Some points are lost.
  Partial,
  /// All of them are.
  None
};

/// Of a value's size.
BandState state_in(const LiveBand& band, double value) noexcept;

/// Nothing where the rubric has no such item of this cut.
struct CutBands {
  /// Of the angle between blade and planned face [deg].
  std::optional<LiveBand> angle_deg;
  /// Of the face's furthest point from the plan [mm].
  std::optional<LiveBand> location_mm;
};

CutBands bands_of(const scenarios::Rubric& rubric, std::string_view cut);

}  // namespace hallux::ui
