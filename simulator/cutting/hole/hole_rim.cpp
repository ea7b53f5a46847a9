/// Seen along the axis the cylinder is a circle, and a rim is what the circle crosses triangle by
/// triangle. Whether a corner lies in the disc is decided once; so an edge between an inner and an
/// outer corner is crossed once, any other one not at all or twice. Disc and triangle share a
/// convex part: where the triangle's border leaves the disc, the rim follows the circle to where
/// the border comes in again. That end is where the neighbour's border leaves the disc: the arcs
/// link up by (edge, crossing), never by position.
#include "simulator/cutting/hole/hole_rim.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"
#include "simulator/cutting/hole/skin_along_axis.h"

namespace hallux::simulator {

namespace {

constexpr double arc_step_rad = 2.0 * pi / 48.0;
/// A triangle with less than this as a share of its sides' product stands upright on the circle's
/// plane: its arc is as short as its ends say.
constexpr double upright = 1.0e-9;

/// Of an edge, from its corner of lower number: which crossing of the circle.
using CrossingKey = std::tuple<std::uint32_t, std::uint32_t, int>;

struct CircleCrossing {
  CrossingKey key;
  Vec3 local_mm{0.0, 0.0, 0.0};
  /// In the direction asked for.
  bool leaves_disc = false;
};

struct Arc {
  CrossingKey end;
  /// From its beginning on, without its end.
  std::vector<Vec3> local_mm;
};

struct Corner {
  std::uint32_t point = 0;
  Vec3 local_mm{0.0, 0.0, 0.0};
};

Vec2 flat(const Vec3& local_mm) noexcept { return {local_mm.x, local_mm.y}; }

bool is_in_disc(const Vec3& local_mm, double radius_mm) noexcept {
  return glm::dot(flat(local_mm), flat(local_mm)) < radius_mm * radius_mm;
}

/// The crossings of an edge, from its corner of lower number to the other; both triangles of the
/// edge get the same bits.
std::vector<CircleCrossing> crossings_of_edge(const Corner& low, const Corner& high,
                                              double radius_mm) {
  const Vec2 from = flat(low.local_mm), way = flat(high.local_mm) - from;
  const bool begins_in = is_in_disc(low.local_mm, radius_mm);
  const bool ends_in = is_in_disc(high.local_mm, radius_mm);
  const double aa = glm::dot(way, way), ab = glm::dot(way, from);
  const double root2 = ab * ab - aa * (glm::dot(from, from) - radius_mm * radius_mm);
  const double root = std::sqrt(std::max(0.0, root2));
  const auto crossing = [&](double share, int index, bool leaves) {
    const double held = std::clamp(share, 0.0, 1.0);
    return CircleCrossing{{low.point, high.point, index},
                          low.local_mm + held * (high.local_mm - low.local_mm),
                          leaves};
  };
  if (begins_in && ends_in) return {};
  if (begins_in != ends_in) {
    // One in, one out: the edge has a length, seen along the axis.
    return {crossing((begins_in ? root - ab : -root - ab) / aa, 0, begins_in)};
  }
  const double middle = aa > 0.0 ? -ab / aa : -1.0;
  if (!(root2 > 0.0) || !(middle > 0.0) || !(middle < 1.0)) return {};
  return {crossing((-root - ab) / aa, 0, false), crossing((root - ab) / aa, 1, true)};
}

class RimTracer {
 public:
  RimTracer(const IndexedMesh& skin, const AxisFrame& frame, double radius_mm)
      : skin_(skin), frame_(frame), radius_mm_(radius_mm) {}

  void add(const LocalTriangle& local) {
    std::vector<CircleCrossing> around;
    bool holds_corner = false;
    for (std::size_t i = 0; i < 3; ++i) {
      add_edge(corner(local, i), corner(local, (i + 1) % 3), around);
      holds_corner = holds_corner || is_in_disc(local.corner_mm[i], radius_mm_);
    }
    if (around.empty()) {
      if (!holds_corner && crossing_of(local, Vec2{0.0, 0.0})) add_circle(local);
      return;
    }
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (around[i].leaves_disc) add_arc(local, around[i], around[(i + 1) % around.size()]);
    }
  }

  /// All rims; whole ones within triangles first.
  std::vector<HoleRim> take() {
    while (!arcs_.empty()) {
      std::vector<Vec3> local_mm;
      for (auto next = arcs_.begin(); next != arcs_.end();) {
        local_mm.insert(local_mm.end(), next->second.local_mm.begin(), next->second.local_mm.end());
        const CrossingKey end = next->second.end;
        arcs_.erase(next);
        next = arcs_.find(end);
      }
      add_rim(local_mm);
    }
    return std::move(rims_);
  }

 private:
  Corner corner(const LocalTriangle& local, std::size_t i) const noexcept {
    return {skin_.triangles[local.triangle][i], local.corner_mm[i]};
  }

  void add_edge(const Corner& from, const Corner& to, std::vector<CircleCrossing>& around) const {
    const bool is_turned = to.point < from.point;
    std::vector<CircleCrossing> found = is_turned ? crossings_of_edge(to, from, radius_mm_)
                                                  : crossings_of_edge(from, to, radius_mm_);
    if (is_turned) {
      std::reverse(found.begin(), found.end());
      for (CircleCrossing& crossing : found) crossing.leaves_disc = !crossing.leaves_disc;
    }
    around.insert(around.end(), found.begin(), found.end());
  }

  /// Points of the circle on the triangle, `from_rad` itself left out, over the signed turn.
  void follow_circle(const LocalTriangle& local, double from_rad, double turn_rad,
                     std::vector<Vec3>& points) const {
    const auto& [a, b, c] = local.corner_mm;
    const Vec3 normal = glm::cross(b - a, c - a);
    const double low = std::min({a.z, b.z, c.z}), high = std::max({a.z, b.z, c.z});
    const auto steps = static_cast<int>(std::ceil(std::abs(turn_rad) / arc_step_rad));
    for (int i = 1; i < steps; ++i) {
      const double angle_rad = from_rad + turn_rad * i / steps;
      const Vec2 at = radius_mm_ * Vec2{elementary::cos(angle_rad), elementary::sin(angle_rad)};
      const double rise = (normal.x * (at.x - a.x) + normal.y * (at.y - a.y)) / normal.z;
      points.emplace_back(at.x, at.y, std::clamp(a.z - rise, low, high));
    }
  }

  /// 1: outward faces look along the axis, -1: against it, 0: upright.
  static double facing(const LocalTriangle& local) noexcept {
    const auto& [a, b, c] = local.corner_mm;
    const Vec3 normal = glm::cross(b - a, c - a);
    if (!(std::abs(normal.z) > upright * length_of(normal))) return 0.0;
    return normal.z > 0.0 ? 1.0 : -1.0;
  }

  void add_arc(const LocalTriangle& local, const CircleCrossing& from, const CircleCrossing& to) {
    Arc arc{to.key, {from.local_mm}};
    const double side = facing(local);
    const double from_rad = elementary::atan2(from.local_mm.y, from.local_mm.x);
    const double to_rad = elementary::atan2(to.local_mm.y, to.local_mm.x);
    double turn_rad = side * (to_rad - from_rad);
    if (turn_rad < 0.0) turn_rad += 2.0 * pi;
    // Ends that coincide are joined straight: rounding may turn no way into a whole turn.
    const bool is_short = length_of(flat(to.local_mm - from.local_mm)) < grazing_mm;
    if (side != 0.0 && !is_short) follow_circle(local, from_rad, side * turn_rad, arc.local_mm);
    arcs_.emplace(from.key, std::move(arc));
  }

  void add_circle(const LocalTriangle& local) {
    const double side = facing(local);
    if (side == 0.0) return;
    std::vector<Vec3> points;
    // One step more than a turn: its first point is left out.
    follow_circle(local, -side * arc_step_rad, side * (2.0 * pi + arc_step_rad), points);
    add_rim(points);
  }

  /// Fewer points are a graze of two triangles, along their edge and back.
  void add_rim(const std::vector<Vec3>& local_mm) {
    if (local_mm.size() < 3) return;
    HoleRim rim;
    for (const Vec3& local : local_mm) {
      rim.points_mm.push_back(frame_.to_body(local));
      rim.way_mm += local.z / static_cast<double>(local_mm.size());
    }
    rims_.push_back(std::move(rim));
  }

  const IndexedMesh& skin_;
  const AxisFrame& frame_;
  double radius_mm_;
  std::map<CrossingKey, Arc> arcs_;
  std::vector<HoleRim> rims_;
};

}  // namespace

std::vector<HoleRim> hole_rims(const IndexedMesh& skin, const Bvh& tree, const Capsule& hole) {
  const Segment axis = axis_of(hole);
  const AxisFrame frame = frame_along(axis.from, axis.to);
  std::vector<LocalTriangle> triangles;
  find_triangles_along(tree, frame, hole.radius_mm, triangles);
  RimTracer tracer(skin, frame, hole.radius_mm);
  for (const LocalTriangle& triangle : triangles) tracer.add(triangle);
  std::vector<HoleRim> rims = tracer.take();
  const double length_mm = length_of(axis.to - axis.from);
  std::erase_if(rims, [&](const HoleRim& rim) {
    return !(rim.way_mm >= -hole.radius_mm && rim.way_mm <= length_mm);
  });
  std::sort(rims.begin(), rims.end(),
            [](const HoleRim& a, const HoleRim& b) { return a.way_mm < b.way_mm; });
  return rims;
}

}  // namespace hallux::simulator
