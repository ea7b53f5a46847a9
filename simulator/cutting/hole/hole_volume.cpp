/// Each capsule is divided across its axis into rings, and the rings into sectors. In every cell
/// one line parallel to the axis, through the cell's centroid, is asked how much of it is bone.
///
///     top view            side view of a cell
///      .-+-.              |  .--cap's mean height over the ring
///     /-.+.-\         ~~~~|~~~~~ skin: within a cell it is a plane, or it counts to the bound
///     |-( )-|             |
///     \-'+'-/         ....|..... another capsule's chord, with its radius made wider and narrower
///      '-+-'              |
///
/// What is exact: areas, centroids, a ring's mean cap, and skin that is one triangle over the
/// whole cell (a linear function is its value at the centroid). What is not, counts to the bound:
///
/// - the line's part in bone changes within a cell by no more than the heights that the triangles
///   with a border there have over the cell (an end moves on a triangle, and one that comes or goes
///   does so on a triangle);
/// - a point of the cell is at most `reach` from the line at its height, so it lies in another
///   capsule for sure where the line is `reach` deep in it, and outside where it is `reach` away;
/// - where skin or another capsule meets a cap, the cap's rise over the ring counts as well.
///
/// Dropped: octrees of signed distances (the bound falls with the cell's size alone, and a hole is
/// all surface), and closed forms of triangle and disc (exact for one cylinder, of no use for caps
/// and for capsules that cross).
#include "simulator/cutting/hole/hole_volume.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"
#include "simulator/cutting/hole/skin_along_axis.h"

namespace hallux::simulator {

namespace {

/// Of a volume: above what summing can lose.
constexpr double rounding_share = 1.0e-9;
/// A face whose normal has less than this along the axis stands upright.
constexpr double upright = 1.0e-9;

struct Range {
  double from = 0.0, to = 0.0;

  double length() const noexcept { return std::max(0.0, to - from); }
  bool meets(const Range& other) const noexcept { return from <= other.to && other.from <= to; }
};

Range common(const Range& a, const Range& b) noexcept {
  return {std::max(a.from, b.from), std::min(a.to, b.to)};
}

/// The part of a line parallel to z that lies in a capsule, both in the axis frame.
Range chord(const Capsule& capsule, const Vec2& place_mm) noexcept {
  if (!(capsule.radius_mm > 0.0)) return {0.0, -1.0};
  const double radius2 = capsule.radius_mm * capsule.radius_mm;
  const Segment axis = axis_of(capsule);
  Range all{1.0, -1.0};
  const auto add = [&](const Range& part) {
    if (!(part.from <= part.to)) return;
    all =
        all.from > all.to ? part : Range{std::min(all.from, part.from), std::max(all.to, part.to)};
  };
  for (const Vec3& end : {axis.from, axis.to}) {
    const Vec2 aside = place_mm - Vec2{end.x, end.y};
    const double half2 = radius2 - glm::dot(aside, aside);
    if (half2 >= 0.0) add({end.z - std::sqrt(half2), end.z + std::sqrt(half2)});
  }
  const double length_mm = length_of(axis.to - axis.from);
  if (!(squared_length(axis.to - axis.from) > point_segment_mm2)) return all;
  // Of the cylinder between the ends: |m + z n| <= radius, and the way along it within its length.
  const Vec3 along = (axis.to - axis.from) / length_mm;
  const Vec3 arm = Vec3{place_mm.x, place_mm.y, 0.0} - axis.from;
  const Vec3 m = arm - glm::dot(arm, along) * along;
  const Vec3 n = Vec3{0.0, 0.0, 1.0} - along.z * along;
  const double nn = squared_length(n), mn = glm::dot(m, n), mm = squared_length(m);
  Range tube{-1.0e9, 1.0e9};
  if (nn > upright * upright) {
    const double root2 = mn * mn - nn * (mm - radius2);
    if (root2 < 0.0) return all;
    tube = {(-mn - std::sqrt(root2)) / nn, (-mn + std::sqrt(root2)) / nn};
  } else if (mm > radius2) {
    return all;
  }
  const double start_mm = glm::dot(arm, along);
  if (std::abs(along.z) > upright) {
    const double first = -start_mm / along.z, second = (length_mm - start_mm) / along.z;
    tube = common(tube, {std::min(first, second), std::max(first, second)});
  } else if (start_mm < 0.0 || start_mm > length_mm) {
    return all;
  }
  add(tube);
  return all;
}

/// A cell of a ring: where its line stands, and how far its points are from it at most.
struct Cell {
  Vec2 centre_mm{0.0, 0.0};
  double area_mm2 = 0.0;
  double reach_mm = 0.0;
};

/// A ring of cells, alike but for their direction.
struct Ring {
  double inner_mm = 0.0, outer_mm = 0.0;
  int sectors = 1;
  double centroid_mm = 0.0, area_mm2 = 0.0, reach_mm = 0.0;
  /// Of the cap over the ring: mean, lowest and highest.
  double mean_mm = 0.0, low_mm = 0.0, high_mm = 0.0;
};

Ring ring_of(int index, int rings, double radius_mm) noexcept {
  Ring ring;
  ring.inner_mm = radius_mm * index / rings;
  ring.outer_mm = radius_mm * (index + 1) / rings;
  ring.sectors = 3 + 6 * index;
  const double half_rad = pi / ring.sectors;
  const double in2 = ring.inner_mm * ring.inner_mm, out2 = ring.outer_mm * ring.outer_mm;
  ring.area_mm2 = half_rad * (out2 - in2);
  ring.centroid_mm = (2.0 / 3.0) * (out2 * ring.outer_mm - in2 * ring.inner_mm) / (out2 - in2) *
                     elementary::sin(half_rad) / half_rad;
  const double cosine = elementary::cos(half_rad), sine = elementary::sin(half_rad);
  const auto away_mm = [&](double at_mm) {
    return length_of(Vec2{at_mm * cosine - ring.centroid_mm, at_mm * sine});
  };
  ring.reach_mm =
      std::max({away_mm(ring.outer_mm), away_mm(ring.inner_mm), ring.centroid_mm - ring.inner_mm});
  const double radius2 = radius_mm * radius_mm;
  ring.high_mm = std::sqrt(std::max(0.0, radius2 - in2));
  ring.low_mm = std::sqrt(std::max(0.0, radius2 - out2));
  const auto cubed = [](double value) { return value * value * value; };
  ring.mean_mm = (2.0 / 3.0) * (cubed(ring.high_mm) - cubed(ring.low_mm)) / (out2 - in2);
  return ring;
}

/// A skin triangle as a cell asks it.
struct Face {
  LocalTriangle local;
  Range height_mm;
  /// Of the plane, along x and y; not used where the face is upright.
  Vec2 slope{0.0, 0.0};
  bool is_upright = false;
  /// Of its points from the axis: nearest and furthest.
  Range away_mm;
};

double distance_to_edge_mm(const Vec2& a, const Vec2& b, const Vec2& place_mm) noexcept {
  const Vec2 way = b - a;
  const double length2 = glm::dot(way, way);
  if (!(length2 > 0.0)) return length_of(place_mm - a);
  const double share = std::clamp(glm::dot(place_mm - a, way) / length2, 0.0, 1.0);
  return length_of(place_mm - (a + share * way));
}

double distance_to_border_mm(const LocalTriangle& triangle, const Vec2& place_mm) noexcept {
  double least_mm = 1.0e9;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = triangle.corner_mm[i];
    const Vec3& b = triangle.corner_mm[(i + 1) % 3];
    least_mm = std::min(least_mm, distance_to_edge_mm({a.x, a.y}, {b.x, b.y}, place_mm));
  }
  return least_mm;
}

Face face_of(const LocalTriangle& local) noexcept {
  Face face{local, {}, {}, false, {}};
  const auto& [a, b, c] = local.corner_mm;
  face.height_mm = {std::min({a.z, b.z, c.z}), std::max({a.z, b.z, c.z})};
  const Vec3 normal = glm::cross(b - a, c - a);
  face.is_upright = !(std::abs(normal.z) > upright * length_of(normal));
  if (!face.is_upright) face.slope = Vec2{-normal.x / normal.z, -normal.y / normal.z};
  const Vec2 axis{0.0, 0.0};
  const bool holds_axis = crossing_of(local, axis).has_value();
  face.away_mm = {
      holds_axis ? 0.0 : distance_to_border_mm(local, axis),
      std::max({length_of(Vec2{a.x, a.y}), length_of(Vec2{b.x, b.y}), length_of(Vec2{c.x, c.y})})};
  return face;
}

/// The heights that a face has, at most, within `reach_mm` of the place.
Range heights_near(const Face& face, const Vec2& place_mm, double reach_mm) noexcept {
  if (face.is_upright) return face.height_mm;
  const Vec3& corner = face.local.corner_mm[0];
  const double middle_mm = corner.z + glm::dot(face.slope, place_mm - Vec2{corner.x, corner.y});
  const double rise_mm = length_of(face.slope) * reach_mm;
  return common(face.height_mm, {middle_mm - rise_mm, middle_mm + rise_mm});
}

/// The sum over the cells of one capsule.
class CapsuleVolume {
 public:
  /// `earlier`: capsules that are counted already, in the axis frame.
  CapsuleVolume(double length_mm, double radius_mm, std::vector<Face> faces,
                std::span<const Capsule> earlier)
      : length_mm_(length_mm), radius_mm_(radius_mm), faces_(std::move(faces)), earlier_(earlier) {}

  BoundedVolume sum(int rings) {
    BoundedVolume total;
    for (int index = 0; index < rings; ++index) {
      ring_ = ring_of(index, rings, radius_mm_);
      near_.clear();
      for (const Face& face : faces_) {
        if (face.away_mm.meets({ring_.inner_mm, ring_.outer_mm})) near_.push_back(&face);
      }
      for (int sector = 0; sector < ring_.sectors; ++sector) {
        const double angle_rad = 2.0 * pi * (sector + 0.5) / ring_.sectors;
        add_cell({ring_.centroid_mm * Vec2{elementary::cos(angle_rad), elementary::sin(angle_rad)},
                  ring_.area_mm2, ring_.reach_mm},
                 total);
      }
    }
    total.bound_mm3 += rounding_share * pi * radius_mm_ * radius_mm_ * (length_mm_ + radius_mm_);
    return total;
  }

 private:
  Range lower_cap() const noexcept { return {-ring_.high_mm, -ring_.low_mm}; }
  Range upper_cap() const noexcept {
    return {length_mm_ + ring_.low_mm, length_mm_ + ring_.high_mm};
  }

  void add_cell(const Cell& cell, BoundedVolume& total) {
    find_chords(cell);
    double unsure_mm = 0.0;
    crossings_.clear();
    for (const Face* face : near_) {
      unsure_mm += unsure_at(*face, cell);
      const auto crossing = crossing_of(face->local, cell.centre_mm);
      if (crossing) crossings_.push_back(*crossing);
    }
    find_inside(crossings_, inside_);
    const Range body{-ring_.mean_mm, length_mm_ + ring_.mean_mm};
    double bone_mm = 0.0;
    for (const InsideInterval& part : inside_) {
      const Range bone = common(body, {part.from_mm, part.to_mm});
      bone_mm += bone.length() - taken_mm(bone);
      unsure_mm += unsure_chords_mm(bone);
    }
    for (const Range& cap : {lower_cap(), upper_cap()}) {
      if (meets_chord(cap)) unsure_mm += cap.length();
    }
    total.volume_mm3 += cell.area_mm2 * bone_mm;
    total.bound_mm3 += cell.area_mm2 * unsure_mm;
  }

  /// By how much the line's part in bone may change over the cell because of this face.
  double unsure_at(const Face& face, const Cell& cell) const noexcept {
    const Range whole{-ring_.high_mm, length_mm_ + ring_.high_mm};
    const Range heights = common(heights_near(face, cell.centre_mm, cell.reach_mm), whole);
    if (!(heights.length() > 0.0)) return 0.0;
    const bool has_border = distance_to_border_mm(face.local, cell.centre_mm) < cell.reach_mm;
    if (!has_border && !crossing_of(face.local, cell.centre_mm)) return 0.0;
    const bool meets_lower = heights.meets(lower_cap()), meets_upper = heights.meets(upper_cap());
    const bool is_plain = !has_border && !meets_lower && !meets_upper && !meets_chord(heights);
    if (is_plain) return 0.0;
    const double rise_mm = ring_.high_mm - ring_.low_mm;
    return heights.length() + (meets_lower ? rise_mm : 0.0) + (meets_upper ? rise_mm : 0.0);
  }

  bool meets_chord(const Range& heights) const noexcept {
    return std::any_of(wide_.begin(), wide_.end(),
                       [&](const Range& wide) { return wide.meets(heights); });
  }

  void find_chords(const Cell& cell) {
    chords_.clear();
    wide_.clear();
    narrow_.clear();
    for (Capsule capsule : earlier_) {
      const double radius_mm = capsule.radius_mm;
      capsule.radius_mm = radius_mm + cell.reach_mm;
      const Range wide = chord(capsule, cell.centre_mm);
      if (!(wide.from <= wide.to)) continue;
      wide_.push_back(wide);
      capsule.radius_mm = radius_mm - cell.reach_mm;
      narrow_.push_back(chord(capsule, cell.centre_mm));
      capsule.radius_mm = radius_mm;
      const Range middle = chord(capsule, cell.centre_mm);
      if (middle.from <= middle.to) chords_.push_back(middle);
    }
    std::sort(chords_.begin(), chords_.end(),
              [](const Range& a, const Range& b) { return a.from < b.from; });
  }

  /// Of a part of the line, what earlier capsules hold together.
  double taken_mm(const Range& bone) const noexcept {
    double taken = 0.0, from_mm = bone.from;
    for (const Range& held : chords_) {
      const Range part = common({from_mm, bone.to}, held);
      taken += part.length();
      from_mm = std::max(from_mm, held.to);
    }
    return taken;
  }

  double unsure_chords_mm(const Range& bone) const noexcept {
    double unsure = 0.0;
    for (std::size_t i = 0; i < wide_.size(); ++i)
      unsure += common(bone, wide_[i]).length() - common(bone, narrow_[i]).length();
    return unsure;
  }

  double length_mm_, radius_mm_;
  std::vector<Face> faces_;
  std::span<const Capsule> earlier_;
  Ring ring_;
  std::vector<const Face*> near_;
  std::vector<LineCrossing> crossings_;
  std::vector<InsideInterval> inside_;
  std::vector<Range> chords_, wide_, narrow_;
};

}  // namespace

BoundedVolume drilled_volume(const Bvh& solid, std::span<const Capsule> capsules, int rings) {
  BoundedVolume total;
  std::vector<LocalTriangle> triangles;
  for (std::size_t i = 0; i < capsules.size(); ++i) {
    const Segment axis = axis_of(capsules[i]);
    const AxisFrame frame = frame_along(axis.from, axis.to);
    find_triangles_along(solid, frame, capsules[i].radius_mm, triangles);
    std::vector<Face> faces;
    faces.reserve(triangles.size());
    for (const LocalTriangle& triangle : triangles) faces.push_back(face_of(triangle));
    std::vector<Capsule> earlier;
    for (const Capsule& other : capsules.first(i)) {
      if (distance_mm(other, capsules[i]) > 0.0) continue;
      earlier.push_back({frame.to_local(other.from_in_body_mm), frame.to_local(other.to_in_body_mm),
                         other.radius_mm});
    }
    CapsuleVolume sum(length_of(axis.to - axis.from), capsules[i].radius_mm, std::move(faces),
                      earlier);
    const BoundedVolume part = sum.sum(rings);
    total.volume_mm3 += part.volume_mm3;
    total.bound_mm3 += part.bound_mm3;
  }
  return total;
}

}  // namespace hallux::simulator
