#include "scenarios/hands/stroke_plan.h"

#include <algorithm>
#include <cmath>

namespace hallux::scenarios {

namespace {

/// Feed range of the region under a tooth line in the middle of `along_mm`; the whole range where no contour says more.
Stroke stroke_at(const simulator::SectionRegion& region, double along_mm, double width_mm) {
  Stroke stroke{along_mm, region.max_mm.x, region.min_mm.x};
  for (const simulator::Contour& contour : region.contours) {
    for (const Vec2& point : contour) {
      if (std::abs(point.y - along_mm) > 0.5 * width_mm + 1.0) continue;
      stroke.first_mm = std::min(stroke.first_mm, point.x);
      stroke.last_mm = std::max(stroke.last_mm, point.x);
    }
  }
  if (stroke.first_mm > stroke.last_mm) {
    stroke.first_mm = region.min_mm.x;
    stroke.last_mm = region.max_mm.x;
  }
  return stroke;
}

}  // namespace

std::vector<Stroke> plan_strokes(const simulator::SectionRegion& region, double blade_width_mm,
                                 double overlap_mm) {
  constexpr double margin_mm = 1.5;
  const double low_mm = region.min_mm.y - margin_mm;
  const double high_mm = region.max_mm.y + margin_mm;
  const double span_mm = high_mm - low_mm;
  const double step_mm = blade_width_mm - overlap_mm;
  const int count =
      1 + std::max(0, static_cast<int>(std::ceil((span_mm - blade_width_mm) / step_mm)));
  const double middle_mm = 0.5 * (low_mm + high_mm);
  const double spread_mm = count > 1 ? (span_mm - blade_width_mm) / (count - 1) : 0.0;
  std::vector<Stroke> strokes;
  for (int i = 0; i < count; ++i) {
    const double along_mm = middle_mm + spread_mm * (i - 0.5 * (count - 1));
    strokes.push_back(stroke_at(region, along_mm, blade_width_mm));
  }
  // From the middle outwards: each stroke after the first has an open slot beside it to drop into.
  std::stable_sort(strokes.begin(), strokes.end(), [middle_mm](const Stroke& a, const Stroke& b) {
    return std::abs(a.along_mm - middle_mm) < std::abs(b.along_mm - middle_mm);
  });
  return strokes;
}

}  // namespace hallux::scenarios
