/// Strokes that several pictures of the metrics share. Inside this corner only.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "tests/screenshots/svg_page.h"

namespace hallux::tests {

inline Vec2 unit_of(const Vec2& way) { return way / std::sqrt(glm::dot(way, way)); }

/// An arc about a middle from one direction to another, less than half a turn apart.
inline void draw_arc(SvgPage& page, const Vec2& middle, const Vec2& from, const Vec2& to,
                     double radius) {
  std::vector<Vec2> places;
  constexpr int parts = 16;
  for (int part = 0; part <= parts; ++part) {
    const double share = static_cast<double>(part) / parts;
    places.push_back(middle +
                     radius * unit_of((1.0 - share) * unit_of(from) + share * unit_of(to)));
  }
  page.polyline(places, "axis");
}

/// A closed oval of four rounded corners.
inline std::vector<Vec2> oval(const Vec2& middle, const Vec2& half) {
  std::vector<Vec2> places;
  constexpr int parts = 12;
  const Vec2 corners[] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (int part = 0; part < parts; ++part) {
      const double share = static_cast<double>(part) / parts;
      const Vec2 way =
          unit_of((1.0 - share) * corners[quarter] + share * corners[(quarter + 1) % 4]);
      places.push_back(middle + Vec2(half.x * way.x, half.y * way.y));
    }
  }
  return places;
}

/// A shaft between two ends, narrower in its middle; x to the right is distal.
inline std::vector<Vec2> shaft(const Vec2& low, const Vec2& high) {
  const Vec2 size = high - low;
  const auto at = [&](double x, double y) { return low + Vec2(x * size.x, y * size.y); };
  return {at(0.0, 0.12),  at(0.05, 0.02), at(0.15, 0.0),  at(0.35, 0.12),
          at(0.6, 0.16),  at(0.8, 0.1),   at(0.95, 0.12), at(1.0, 0.3),
          at(1.0, 0.7),   at(0.95, 0.88), at(0.8, 0.9),   at(0.6, 0.84),
          at(0.35, 0.88), at(0.15, 1.0),  at(0.05, 0.98), at(0.0, 0.88)};
}

inline void draw_bone(SvgPage& page, const std::vector<Vec2>& outline) {
  page.polygon(outline, "bonefill");
  page.polygon(outline, "bone");
}

}  // namespace hallux::tests
