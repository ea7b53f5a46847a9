/// The picture of a blade's plane: for an inset beside the main picture.
#pragma once

#include <span>
#include <vector>

#include "ui/screens/pictures/blade_section.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// What lies in an odd number of loops, along one row of a picture.
struct RowSpan {
  double from_mm = 0.0, to_mm = 0.0;

  friend bool operator==(const RowSpan&, const RowSpan&) = default;
};
/// Where the row at this x passes through the loops, along y, ascending.
std::vector<RowSpan> spans_at(std::span<const PlaneLoop> loops, double x_mm);
/// What of the first lies in none of the second; both ascending.
std::vector<RowSpan> without(std::span<const RowSpan> from, std::span<const RowSpan> taken);

/// Draws it: bone, canal, what is open, the blade, the way on to the far edge with its length, the
/// plan's limits, danger zones. The saw goes downwards.
void draw_blade_section(Ui& ui, const Rect& rect, const BladeSection& section);

/// The same before anything is sawn: a numbered blade before the bone for each pass, and where its
/// edges run through the section.
/// middles_mm  of the passes, along y
void draw_section_with_passes(Ui& ui, const Rect& rect, const BladeSection& section,
                              std::span<const double> middles_mm, double blade_width_mm);

}  // namespace hallux::ui
