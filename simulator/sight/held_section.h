/// The part of a kerf's section that still stands: how much holds, where, and where it is deepest.
///
///     section of the bone          opened by the blade        stands: share 0.4, its middle o,
///     in the kerf's plane                                     its deepest place x
///        .--------.                   .----####.                 .----.
///       (          )                 (    #####)                (  x o |
///        '--------'                   '---#####'                 '-----'
///
/// For displays: on a grid, never fed back. What other kerfs of the fragment have
/// opened does not hold either.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "simulator/cutting/field/kerf_set.h"
#include "simulator/cutting/slice/section.h"

namespace hallux::simulator {

struct HeldSection {
  /// Of the section's area that was asked about [0, 1]; 0: nothing holds.
  double share = 0.0;
  /// In the kerf's plane; of the whole section, and of what stands of it.
  Vec2 section_middle_mm{0.0, 0.0}, middle_mm{0.0, 0.0};
  /// The place that stands furthest from air and kerf, and how far that is.
  Vec2 deepest_mm{0.0, 0.0};
  double depth_mm = 0.0;
  /// Of the section: those that were asked about.
  std::vector<std::size_t> regions;
};

/// Points of a kerf's plane with outward . p <= limit: a cut that is to stop at a hinge holds
/// beyond it by intent.
struct PlaneLimit {
  Vec2 outward{1.0, 0.0};
  double limit_mm = 0.0;
};

/// Between the places that are asked, where nothing finer is wanted.
inline constexpr double held_spacing_mm = 0.2;

/// Of the regions of the section that the blade has touched; of the largest where it touched none.
/// Where no place of the grid stands, the rim is asked more closely: what stands there is a sliver.
/// needs   the section is of this kerf's plane, of what the fragment was cut from
/// errors  none: a plane that misses the bone holds nothing
/// thread  any; about a millisecond, at a finer spacing as the square of it
HeldSection held_section(const Section& section, const FragmentKerfs& kerfs, std::int32_t kerf,
                         const std::optional<PlaneLimit>& limit = {},
                         double spacing_mm = held_spacing_mm);

}  // namespace hallux::simulator
