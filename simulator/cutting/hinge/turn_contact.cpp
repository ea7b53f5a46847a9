/// Contact under a turn, in coordinates of the axis.
///
///          n (above)           A point is (c, n, h): c towards the gap, n above it, h along the
///          |    moved          axis. A turn keeps h and the radius r, and lowers the polar angle.
///          |  ____---          So two points meet exactly where h and r are equal, and the turn is
///     axis +------- c  gap     the difference of their angles: surfaces of triangles first meet at
///          |  ----____         a corner of one on a face of the other, or where two edges cross.
///          |    fixed
#include "simulator/cutting/hinge/turn_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// Corners that lie on an edge in truth may miss it by rounding; this much further out they still
/// count.
constexpr double tolerance_mm = 1.0e-7;

struct AxisPoint {
  double c_mm = 0.0, n_mm = 0.0, h_mm = 0.0;
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) noexcept {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool meets(const Range& other) const noexcept {
    return low <= other.high + tolerance_mm && other.low <= high + tolerance_mm;
  }
};

struct Facet {
  std::array<AxisPoint, 3> corners;
  Range radius_mm, h_mm, angle_rad;
};

double squared_radius(const AxisPoint& point) noexcept {
  return point.c_mm * point.c_mm + point.n_mm * point.n_mm;
}

double dot_of(const AxisPoint& a, const AxisPoint& b) noexcept {
  return a.c_mm * b.c_mm + a.n_mm * b.n_mm;
}

AxisPoint between(const AxisPoint& a, const AxisPoint& b, double part) noexcept {
  return {a.c_mm + part * (b.c_mm - a.c_mm), a.n_mm + part * (b.n_mm - a.n_mm),
          a.h_mm + part * (b.h_mm - a.h_mm)};
}

/// The least distance of a segment, seen along the axis, from the axis.
double least_radius(const AxisPoint& a, const AxisPoint& b) noexcept {
  const AxisPoint along{b.c_mm - a.c_mm, b.n_mm - a.n_mm, 0.0};
  const double length_mm2 = squared_radius(along);
  const double part = length_mm2 > 0.0 ? std::clamp(-dot_of(a, along) / length_mm2, 0.0, 1.0) : 0.0;
  return std::sqrt(squared_radius(between(a, b, part)));
}

bool surrounds_axis(const std::array<AxisPoint, 3>& corners) noexcept {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const AxisPoint &a = corners[i], &b = corners[(i + 1) % 3];
    const double turn = a.c_mm * b.n_mm - a.n_mm * b.c_mm;
    left += turn >= 0.0 ? 1 : 0;
    right += turn <= 0.0 ? 1 : 0;
  }
  return left == 3 || right == 3;
}

Facet facet_from(const std::array<AxisPoint, 3>& corners) noexcept {
  Facet facet{corners, {}, {}, {}};
  bool is_ahead = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const AxisPoint& corner = corners[i];
    facet.h_mm.add(corner.h_mm);
    facet.radius_mm.add(std::sqrt(squared_radius(corner)));
    facet.radius_mm.add(least_radius(corner, corners[(i + 1) % 3]));
    facet.angle_rad.add(elementary::atan2(corner.n_mm, corner.c_mm));
    is_ahead = is_ahead && corner.c_mm > 0.0;
  }
  if (surrounds_axis(corners)) facet.radius_mm.add(0.0);
  if (!is_ahead) facet.angle_rad = {-pi, pi};
  return facet;
}

/// The triangles that a turn within `most_rad` may bring into contact: not those wholly outside the
/// sector that the gap's plane sweeps, on the body's own side (+1 above, -1 below).
std::vector<Facet> facets_of(const IndexedMesh& mesh, const TurnAxis& axis, double side,
                             double skip_radius_mm, double most_rad) {
  const Vec3 above = glm::cross(axis.toward_gap, axis.axis);
  const double sine = elementary::sin(most_rad), cosine = elementary::cos(most_rad);
  std::vector<Facet> facets;
  for (const Triangle& triangle : mesh.triangles) {
    std::array<AxisPoint, 3> corners;
    bool is_in_sector = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 arm_mm = mesh.points_mm[triangle[i]] - axis.point_mm;
      corners[i] = {glm::dot(arm_mm, axis.toward_gap), glm::dot(arm_mm, above),
                    glm::dot(arm_mm, axis.axis)};
      is_in_sector =
          is_in_sector || side * corners[i].n_mm * cosine - corners[i].c_mm * sine <= 0.0;
    }
    if (!is_in_sector) continue;
    const Facet facet = facet_from(corners);
    if (facet.radius_mm.high >= skip_radius_mm) facets.push_back(facet);
  }
  return facets;
}

struct Segment {
  AxisPoint a, b;
  bool is_empty = true;
};

/// Where the facet has the height h along the axis; a corner just beyond its end counts as at the
/// end.
Segment slice_at(const Facet& facet, double h_mm) noexcept {
  if (h_mm < facet.h_mm.low - tolerance_mm || h_mm > facet.h_mm.high + tolerance_mm) return {};
  const double at_mm = std::clamp(h_mm, facet.h_mm.low, facet.h_mm.high);
  std::array<AxisPoint, 3> found;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const AxisPoint &a = facet.corners[i], &b = facet.corners[(i + 1) % 3];
    if (a.h_mm == at_mm) found[count++] = a;
    if ((a.h_mm < at_mm && b.h_mm > at_mm) || (a.h_mm > at_mm && b.h_mm < at_mm)) {
      found[count++] = between(a, b, (at_mm - a.h_mm) / (b.h_mm - a.h_mm));
    }
  }
  if (count == 0) return {};
  return {found[0], found[count > 1 ? 1 : 0], false};
}

/// The turn that carries the moved point onto the fixed one, which has the same radius.
double turn_between(const AxisPoint& fixed, const AxisPoint& moved) noexcept {
  return elementary::atan2(fixed.c_mm * moved.n_mm - fixed.n_mm * moved.c_mm, dot_of(fixed, moved));
}

/// Parts of [0, 1] at which a + 2 b t + c t^2 vanishes.
struct Roots {
  std::array<double, 2> part{};
  std::size_t count = 0;

  void add(double root) noexcept {
    if (root >= 0.0 && root <= 1.0) part[count++] = root;
  }
};

Roots roots_of(double a, double b, double c) noexcept {
  Roots roots;
  const double square = b * b - a * c;
  if (!(square >= 0.0)) return roots;
  // The sum without cancellation gives one root directly and the other through their product.
  const double sum = b >= 0.0 ? -b - std::sqrt(square) : -b + std::sqrt(square);
  if (c != 0.0) roots.add(sum / c);
  if (sum != 0.0) roots.add(a / sum);
  return roots;
}

/// Looks for the smallest turn over pairs of facets.
class ContactSearch {
 public:
  ContactSearch(double skip_radius_mm, double most_rad) noexcept
      : skip_mm2_(skip_radius_mm * skip_radius_mm), best_rad_(most_rad) {}

  double best_rad() const noexcept { return best_rad_; }
  bool has_contact() const noexcept { return has_contact_; }
  const AxisPoint& contact() const noexcept { return contact_; }

  void try_pair(const Facet& fixed, const Facet& moved) noexcept {
    for (const AxisPoint& corner : moved.corners) try_corner(corner, fixed, true);
    for (const AxisPoint& corner : fixed.corners) try_corner(corner, moved, false);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        try_edges({fixed.corners[i], fixed.corners[(i + 1) % 3], false},
                  {moved.corners[j], moved.corners[(j + 1) % 3], false});
      }
    }
  }

 private:
  void note(const AxisPoint& fixed, const AxisPoint& moved) noexcept {
    if (squared_radius(fixed) < skip_mm2_) return;
    const double turn_rad = turn_between(fixed, moved);
    // Bodies that touch already may overlap by rounding.
    if (turn_rad < -tolerance_mm || (has_contact_ && turn_rad >= best_rad_)) return;
    if (turn_rad > best_rad_) return;
    best_rad_ = std::max(turn_rad, 0.0);
    contact_ = fixed;
    has_contact_ = true;
  }

  void try_corner(const AxisPoint& corner, const Facet& facet, bool is_corner_moved) noexcept {
    const double radius_mm2 = squared_radius(corner);
    if (radius_mm2 < skip_mm2_) return;
    const Segment segment = slice_at(facet, corner.h_mm);
    if (segment.is_empty) return;
    const auto note_at = [&](const AxisPoint& on_facet) {
      is_corner_moved ? note(on_facet, corner) : note(corner, on_facet);
    };
    const AxisPoint along{segment.b.c_mm - segment.a.c_mm, segment.b.n_mm - segment.a.n_mm, 0.0};
    const Roots roots = roots_of(squared_radius(segment.a) - radius_mm2, dot_of(segment.a, along),
                                 squared_radius(along));
    for (std::size_t i = 0; i < roots.count; ++i) {
      note_at(between(segment.a, segment.b, roots.part[i]));
    }
    const double radius_mm = std::sqrt(radius_mm2);
    for (const AxisPoint& end : {segment.a, segment.b}) {
      if (std::abs(std::sqrt(squared_radius(end)) - radius_mm) <= tolerance_mm) note_at(end);
    }
  }

  /// The points of equal h on both edges have equal radii where a quadratic vanishes. Its variable
  /// runs along the edge that climbs less; edges that do not climb at all meet others at their
  /// corners.
  void try_edges(const Segment& fixed, const Segment& moved) noexcept {
    const double fixed_climb_mm = fixed.b.h_mm - fixed.a.h_mm;
    const double moved_climb_mm = moved.b.h_mm - moved.a.h_mm;
    const bool is_fixed_steeper = std::abs(fixed_climb_mm) > std::abs(moved_climb_mm);
    const Segment& steep = is_fixed_steeper ? fixed : moved;
    const Segment& flat = is_fixed_steeper ? moved : fixed;
    const double climb_mm = is_fixed_steeper ? fixed_climb_mm : moved_climb_mm;
    if (std::abs(climb_mm) <= tolerance_mm) return;
    const auto on_steep = [&](double h_mm) {
      return between(steep.a, steep.b, (h_mm - steep.a.h_mm) / climb_mm);
    };
    const AxisPoint from = on_steep(flat.a.h_mm), to = on_steep(flat.b.h_mm);
    const AxisPoint steep_along{to.c_mm - from.c_mm, to.n_mm - from.n_mm, 0.0};
    const AxisPoint flat_along{flat.b.c_mm - flat.a.c_mm, flat.b.n_mm - flat.a.n_mm, 0.0};
    const Roots roots = roots_of(squared_radius(flat.a) - squared_radius(from),
                                 dot_of(flat.a, flat_along) - dot_of(from, steep_along),
                                 squared_radius(flat_along) - squared_radius(steep_along));
    for (std::size_t i = 0; i < roots.count; ++i) {
      const AxisPoint on_flat = between(flat.a, flat.b, roots.part[i]);
      const double share = (on_flat.h_mm - steep.a.h_mm) / climb_mm;
      if (share < 0.0 || share > 1.0) continue;
      const AxisPoint meeting = on_steep(on_flat.h_mm);
      is_fixed_steeper ? note(meeting, on_flat) : note(on_flat, meeting);
    }
  }

  double skip_mm2_;
  double best_rad_;
  AxisPoint contact_;
  bool has_contact_ = false;
};

}  // namespace

std::optional<TurnContact> first_turn_contact(const IndexedMesh& fixed, const IndexedMesh& moved,
                                              const TurnAxis& axis, double skip_radius_mm,
                                              double most_rad) {
  std::vector<Facet> below = facets_of(fixed, axis, -1.0, skip_radius_mm, most_rad);
  std::vector<Facet> above = facets_of(moved, axis, 1.0, skip_radius_mm, most_rad);
  // The nearest to the gap come first, so that a contact found early rules out most other pairs.
  std::stable_sort(below.begin(), below.end(), [](const Facet& a, const Facet& b) {
    return a.angle_rad.high > b.angle_rad.high;
  });
  std::stable_sort(above.begin(), above.end(), [](const Facet& a, const Facet& b) {
    return a.angle_rad.low < b.angle_rad.low;
  });
  ContactSearch search(skip_radius_mm, most_rad);
  for (const Facet& upper : above) {
    for (const Facet& lower : below) {
      if (upper.angle_rad.low - lower.angle_rad.high > search.best_rad()) break;
      if (!upper.h_mm.meets(lower.h_mm) || !upper.radius_mm.meets(lower.radius_mm)) continue;
      search.try_pair(lower, upper);
    }
  }
  if (!search.has_contact()) return std::nullopt;
  const AxisPoint& met = search.contact();
  return TurnContact{search.best_rad(), axis.point_mm + met.c_mm * axis.toward_gap +
                                            met.n_mm * glm::cross(axis.toward_gap, axis.axis) +
                                            met.h_mm * axis.axis};
}

}  // namespace hallux::simulator
