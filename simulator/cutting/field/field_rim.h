/// The rim of what a kerf's field has opened, segment by segment, around a point: what
/// region_outline.h joins to loops. Inside this room only.
#pragma once

#include <type_traits>

#include "simulator/cutting/field/kerf.h"

namespace hallux::simulator {

/// The part of the rim within one cell of four nodes, open on its left; between the linear zeros on
/// two of the cell's sides, never nearer to a node than a thousandth of the spacing.
struct RimSegment {
  Vec2 start_mm{0.0, 0.0}, end_mm{0.0, 0.0};
};

/// Part of visit_rim.
void visit_rim(const KerfField& field, const Vec2& point_mm, double within_mm,
               double (*visit)(void* context, const RimSegment& segment), void* context) noexcept;

/// Calls visit(RimSegment) for each segment that may lie nearer than `within_mm`; the answer is the
/// distance within which to go on [mm]. The rim where a region meets the grid's own edge is not
/// seen.
/// ensures lines of nodes without a rim cost 1/64 step a node; nothing is allocated
/// thread  any
template <typename Visit>
void visit_rim(const KerfField& field, const Vec2& point_mm, double within_mm,
               Visit&& visit) noexcept {
  visit_rim(
      field, point_mm, within_mm,
      [](void* context, const RimSegment& segment) -> double {
        return (*static_cast<std::remove_reference_t<Visit>*>(context))(segment);
      },
      &visit);
}

}  // namespace hallux::simulator
