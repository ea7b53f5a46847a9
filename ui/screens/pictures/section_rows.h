/// Plane loops along one row: where it runs through them. Inside this corner only.
#pragma once

#include <span>
#include <vector>

#include "ui/render/scene/site.h"

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

}  // namespace hallux::ui
