#include "ui/screens/pictures/section_rows.h"

#include <algorithm>

namespace hallux::ui {

std::vector<RowSpan> spans_at(std::span<const PlaneLoop> loops, double x_mm) {
  std::vector<double> crossings_mm;
  for (const PlaneLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if ((a.x > x_mm) == (b.x > x_mm)) continue;
      crossings_mm.push_back(a.y + (x_mm - a.x) / (b.x - a.x) * (b.y - a.y));
    }
  }
  std::ranges::sort(crossings_mm);
  std::vector<RowSpan> spans;
  for (std::size_t i = 0; i + 1 < crossings_mm.size(); i += 2) {
    spans.push_back({crossings_mm[i], crossings_mm[i + 1]});
  }
  return spans;
}

std::vector<RowSpan> without(std::span<const RowSpan> from, std::span<const RowSpan> taken) {
  std::vector<RowSpan> left;
  for (const RowSpan& span : from) {
    double at_mm = span.from_mm;
    for (const RowSpan& gone : taken) {
      if (gone.to_mm <= at_mm || gone.from_mm >= span.to_mm) continue;
      if (gone.from_mm > at_mm) left.push_back({at_mm, gone.from_mm});
      at_mm = gone.to_mm;
    }
    if (at_mm < span.to_mm) left.push_back({at_mm, span.to_mm});
  }
  return left;
}

}  // namespace hallux::ui
