#include "scenarios/hands/stroke_plan.h"

#include <algorithm>
#include <cmath>

namespace hallux::scenarios {

namespace {

/// Bone so near beside the tooth line counts as under it.
constexpr double beside_mm = 1.0;

/// Widens the stroke by the part of the edge that lies under the tooth line: on a coarse outline
/// the bone may reach furthest between two corners that are both beside it.
void widen(Stroke& stroke, const Vec2& from, const Vec2& to, double low_mm, double high_mm) {
  if (std::max(from.y, to.y) < low_mm || std::min(from.y, to.y) > high_mm) return;
  const auto feed_at = [&](double along_mm) {
    const double share = (along_mm - from.y) / (to.y - from.y);
    return from.x + share * (to.x - from.x);
  };
  for (const Vec2& end : {from, to}) {
    const bool is_level = from.y == to.y || (end.y >= low_mm && end.y <= high_mm);
    const double feed_mm = is_level ? end.x : feed_at(end.y < low_mm ? low_mm : high_mm);
    stroke.first_mm = std::min(stroke.first_mm, feed_mm);
    stroke.last_mm = std::max(stroke.last_mm, feed_mm);
  }
}

/// Feed range of the region under a tooth line in the middle of `along_mm`; the whole range where
/// no contour says more.
Stroke stroke_at(const simulator::SectionRegion& region, double along_mm,
                 const StrokeLayout& layout) {
  Stroke stroke{along_mm, region.max_mm.x, region.min_mm.x};
  const double half_mm = 0.5 * layout.blade_width_mm + beside_mm;
  for (const simulator::Contour& contour : region.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      widen(stroke, contour[i], contour[(i + 1) % contour.size()], along_mm - half_mm,
            along_mm + half_mm);
    }
  }
  if (stroke.first_mm > stroke.last_mm) {
    stroke.first_mm = region.min_mm.x;
    stroke.last_mm = region.max_mm.x;
  }
  stroke.end_mm = stroke.last_mm + layout.beyond_mm;
  return stroke;
}

}  // namespace

std::vector<Stroke> plan_strokes(const simulator::SectionRegion& region,
                                 const StrokeLayout& layout) {
  const double low_mm = region.min_mm.y - layout.margin_mm;
  const double high_mm = region.max_mm.y + layout.margin_mm;
  const double spare_mm = high_mm - low_mm - layout.blade_width_mm;
  const double step_mm = layout.blade_width_mm - layout.overlap_mm;
  const int count = 1 + std::max(0, static_cast<int>(std::ceil(spare_mm / step_mm)));
  const double middle_mm = 0.5 * (low_mm + high_mm);
  const double spread_mm = count > 1 ? spare_mm / (count - 1) : 0.0;
  std::vector<Stroke> strokes;
  for (int i = 0; i < count; ++i) {
    const double along_mm = middle_mm + spread_mm * (i - 0.5 * (count - 1));
    strokes.push_back(stroke_at(region, along_mm, layout));
  }
  // From the middle outwards: each stroke after the first has an open slot beside it to drop into.
  std::stable_sort(strokes.begin(), strokes.end(), [middle_mm](const Stroke& a, const Stroke& b) {
    return std::abs(a.along_mm - middle_mm) < std::abs(b.along_mm - middle_mm);
  });
  return strokes;
}

std::vector<Stroke> stopped(const std::vector<Stroke>& strokes, double stop_mm) {
  std::vector<Stroke> shorter;
  for (Stroke stroke : strokes) {
    if (stroke.first_mm >= stop_mm) continue;
    stroke.end_mm = stop_mm;
    stroke.last_mm = std::min(stroke.last_mm, stop_mm);
    stroke.stops_in_bone = true;
    shorter.push_back(stroke);
  }
  return shorter;
}

}  // namespace hallux::scenarios
