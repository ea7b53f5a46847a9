#include "simulator/cutting/kerf_contact.h"

#include <algorithm>
#include <span>

#include "simulator/base/check.h"
#include "simulator/cutting/id_table.h"
#include "simulator/cutting/slab_query.h"

namespace hallux::simulator {

namespace {

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) noexcept {
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
}

/// A mesh edge as far as it lies in the slab.
struct SlabEdge {
  std::uint32_t strip_edge = no_index;
  std::uint32_t low_end = 0,
                high_end = 0;  ///< strip points towards the mesh point of lower, higher index
};

/// The corners of a triangle that lie beyond one plane, in the order of the walk.
struct OuterRun {
  std::array<std::uint32_t, 2> corners{};
  std::uint8_t count = 0;
};

/// The ring of a touched triangle's part in the slab: each corner with the edge that leaves it.
struct StripRing {
  std::array<std::uint32_t, 6> points{};
  std::array<std::uint32_t, 6> edges{};  ///< no_index: a contour edge, still to be made
  std::array<SlabPart, 6> levels{};
  std::array<OuterRun, 6> outer{};  ///< beyond a contour edge
  std::size_t count = 0;

  void push(std::uint32_t point, std::uint32_t edge) noexcept {
    points[count] = point;
    edges[count++] = edge;
  }
};

class ContactSlicer {
 public:
  ContactSlicer(const CutSolid& solid, KerfContact& contact, std::size_t touched_count)
      : mesh_(solid.mesh),
        contact_(contact),
        half_mm_(0.5 * contact.plane.thickness_mm),
        point_ids_(touched_count),
        edge_ids_(2 * touched_count) {}

  void slice(std::uint32_t touched);

 private:
  struct Corner {
    std::uint32_t point = 0;
    double height_mm = 0.0;
    SlabPart part = SlabPart::Inside;
  };

  Corner corner_of(std::uint32_t point) const noexcept;
  std::uint32_t add_point(const Vec3& point_in_bone_mm, double height_mm, std::uint32_t base_point);
  std::uint32_t inside_point(const Corner& corner);
  std::uint32_t end_of(const Corner& from, const Corner& to);
  SlabEdge slab_edge(const Corner& a, const Corner& b);
  StripRing ring_of(const std::array<Corner, 3>& corners);
  void add_contour_edges(StripRing& ring);
  void add_fan(const StripRing& ring);
  std::uint32_t add_edge(std::uint32_t a, std::uint32_t b, SlabPart level);
  void add_triangle(const std::array<std::uint32_t, 3>& points,
                    const std::array<std::uint32_t, 3>& edges);

  const IndexedMesh& mesh_;
  KerfContact& contact_;
  double half_mm_;
  IdTable point_ids_, edge_ids_;
  std::vector<std::uint32_t> inside_points_;  // by id of the mesh point
  std::vector<SlabEdge> slab_edges_;          // by id of the mesh edge
  std::uint32_t touched_ = 0;
};

ContactSlicer::Corner ContactSlicer::corner_of(std::uint32_t point) const noexcept {
  const double corner_mm = height_mm(contact_.axes, mesh_.points_mm[point]);
  return {point, corner_mm, slab_part(corner_mm, half_mm_)};
}

std::uint32_t ContactSlicer::add_point(const Vec3& point_in_bone_mm, double height_in_kerf_mm,
                                       std::uint32_t base_point) {
  contact_.points.push_back({contact_.lattice.snap(place_mm(contact_.axes, point_in_bone_mm)),
                             contact_.lattice.snap_height(height_in_kerf_mm), point_in_bone_mm,
                             base_point, touched_});
  return static_cast<std::uint32_t>(contact_.points.size() - 1);
}

std::uint32_t ContactSlicer::inside_point(const Corner& corner) {
  bool is_new = false;
  const std::uint32_t id = point_ids_.id_of(corner.point, is_new);
  if (is_new) {
    inside_points_.push_back(
        add_point(mesh_.points_mm[corner.point], corner.height_mm, corner.point));
  }
  return inside_points_[id];
}

/// The strip point at the end of the edge's inside part that lies towards `from`.
std::uint32_t ContactSlicer::end_of(const Corner& from, const Corner& to) {
  if (from.part == SlabPart::Inside) return inside_point(from);
  const double level_mm = from.part == SlabPart::Above ? half_mm_ : -half_mm_;
  // From the lower index, so that both triangles of the edge get the same bits.
  const Corner& low = from.point < to.point ? from : to;
  const Corner& high = from.point < to.point ? to : from;
  const double share = (level_mm - low.height_mm) / (high.height_mm - low.height_mm);
  const Vec3& low_mm = mesh_.points_mm[low.point];
  const Vec3& high_mm = mesh_.points_mm[high.point];
  return add_point(low_mm + std::clamp(share, 0.0, 1.0) * (high_mm - low_mm), level_mm, no_index);
}

SlabEdge ContactSlicer::slab_edge(const Corner& a, const Corner& b) {
  bool is_new = false;
  const std::uint32_t id = edge_ids_.id_of(key_of(a.point, b.point), is_new);
  if (!is_new) return slab_edges_[id];
  const Corner& low = a.point < b.point ? a : b;
  const Corner& high = a.point < b.point ? b : a;
  SlabEdge edge;
  edge.low_end = end_of(low, high);
  edge.high_end = end_of(high, low);
  edge.strip_edge = add_edge(edge.low_end, edge.high_end, SlabPart::Inside);
  slab_edges_.push_back(edge);
  return edge;
}

std::uint32_t ContactSlicer::add_edge(std::uint32_t a, std::uint32_t b, SlabPart level) {
  contact_.edges.push_back({a, b, static_cast<std::int8_t>(level), touched_});
  return static_cast<std::uint32_t>(contact_.edges.size() - 1);
}

/// Walks around the triangle. Where the walk leaves the slab it comes back through the same plane; the corners met
/// between are the outer part's. The walk does not begin between two corners on one side, but may begin beyond a plane:
/// then the last contour edge closes what the first corners began.
StripRing ContactSlicer::ring_of(const std::array<Corner, 3>& corners) {
  StripRing ring;
  OuterRun run, first_run;
  std::size_t start = 0;
  while (corners[start].part != SlabPart::Inside &&
         corners[start].part == corners[(start + 2) % 3].part) {
    ++start;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner& from = corners[(start + i) % 3];
    const Corner& to = corners[(start + i + 1) % 3];
    const bool is_outside = from.part != SlabPart::Inside;
    if (is_outside) run.corners[run.count++] = from.point;
    if (is_outside && from.part == to.part) continue;
    if (is_outside) {
      (ring.count > 0 ? ring.outer[ring.count - 1] : first_run) = run;
      run = {};
    }
    const SlabEdge edge = slab_edge(from, to);
    const bool runs_up = from.point < to.point;
    ring.push(runs_up ? edge.low_end : edge.high_end, edge.strip_edge);
    if (to.part == SlabPart::Inside) continue;
    ring.push(runs_up ? edge.high_end : edge.low_end, no_index);
    ring.levels[ring.count - 1] = to.part;
  }
  if (first_run.count > 0) ring.outer[ring.count - 1] = first_run;
  return ring;
}

void ContactSlicer::add_contour_edges(StripRing& ring) {
  for (std::size_t i = 0; i < ring.count; ++i) {
    if (ring.edges[i] != no_index) continue;
    ring.edges[i] = add_edge(ring.points[i], ring.points[(i + 1) % ring.count], ring.levels[i]);
    contact_.outer_parts.push_back(
        {ring.edges[i], touched_, ring.outer[i].corners, ring.outer[i].count});
  }
}

void ContactSlicer::add_triangle(const std::array<std::uint32_t, 3>& points,
                                 const std::array<std::uint32_t, 3>& edges) {
  StripTriangle triangle;
  triangle.points = points;
  triangle.edges = edges;
  triangle.touched = touched_;
  for (std::size_t k = 0; k < 3; ++k) {
    triangle.runs_along[k] = contact_.edges[edges[k]].a == points[k];
  }
  const auto place = [&](std::size_t k) { return contact_.points[points[k]].place; };
  triangle.facing = static_cast<std::int8_t>(sign_of(turn(place(0), place(1), place(2))));
  contact_.triangles.push_back(triangle);
}

void ContactSlicer::add_fan(const StripRing& ring) {
  std::uint32_t diagonal = ring.edges[0];
  for (std::size_t i = 1; i + 1 < ring.count; ++i) {
    const bool is_last = i + 2 == ring.count;
    const std::uint32_t closing =
        is_last ? ring.edges[i + 1]
                : add_edge(ring.points[0], ring.points[i + 1], SlabPart::Inside);
    add_triangle({ring.points[0], ring.points[i], ring.points[i + 1]},
                 {diagonal, ring.edges[i], closing});
    diagonal = closing;
  }
}

void ContactSlicer::slice(std::uint32_t touched) {
  touched_ = touched;
  TouchedTriangle& triangle = contact_.touched[touched];
  triangle.first_strip = static_cast<std::uint32_t>(contact_.triangles.size());
  triangle.first_outer = static_cast<std::uint32_t>(contact_.outer_parts.size());
  std::array<Corner, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = corner_of(mesh_.triangles[triangle.base_triangle][k]);
  }
  StripRing ring = ring_of(corners);
  CHECK(ring.count >= 3);
  add_contour_edges(ring);
  add_fan(ring);
}

/// Each point's edges, as runs of one list.
struct PointEdges {
  std::vector<std::uint32_t> first, edges;
};

PointEdges edges_of_points(const KerfContact& contact) {
  PointEdges lists;
  lists.first.assign(contact.points.size() + 1, 0);
  for (const StripEdge& edge : contact.edges) {
    ++lists.first[edge.a];
    ++lists.first[edge.b];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& first : lists.first) {
    sum += first;
    first = sum;
  }
  lists.edges.resize(sum);
  for (std::size_t i = contact.edges.size(); i-- > 0;) {
    lists.edges[--lists.first[contact.edges[i].a]] = static_cast<std::uint32_t>(i);
    lists.edges[--lists.first[contact.edges[i].b]] = static_cast<std::uint32_t>(i);
  }
  return lists;
}

/// Breadth first from the lowest point of each skin.
void grow_tree(KerfContact& contact) {
  const PointEdges lists = edges_of_points(contact);
  std::vector<std::uint32_t> skin_of_point(contact.points.size(), no_index);
  contact.tree.reserve(contact.points.size());
  for (std::uint32_t start = 0; start < contact.points.size(); ++start) {
    if (skin_of_point[start] != no_index) continue;
    const std::uint32_t skin = contact.skin_count++;
    std::size_t next = contact.tree.size();
    skin_of_point[start] = skin;
    contact.tree.push_back({start, no_index, no_index, skin});
    for (; next < contact.tree.size(); ++next) {
      const std::uint32_t point = contact.tree[next].point;
      for (std::uint32_t i = lists.first[point]; i < lists.first[point + 1]; ++i) {
        const StripEdge& edge = contact.edges[lists.edges[i]];
        const std::uint32_t other = edge.a == point ? edge.b : edge.a;
        if (skin_of_point[other] != no_index) continue;
        skin_of_point[other] = skin;
        contact.tree.push_back({other, point, lists.edges[i], skin});
      }
    }
  }
  for (TouchedTriangle& touched : contact.touched) {
    touched.skin = skin_of_point[contact.triangles[touched.first_strip].points[0]];
  }
}

void measure_box(KerfContact& contact) {
  if (contact.points.empty()) return;
  contact.min = contact.max = contact.points.front().place;
  for (const StripPoint& point : contact.points) {
    contact.min = {std::min(contact.min.u, point.place.u), std::min(contact.min.v, point.place.v)};
    contact.max = {std::max(contact.max.u, point.place.u), std::max(contact.max.v, point.place.v)};
  }
}

/// The lattice must reach over the region's box and over all the corners of the touched triangles' parts in the slab.
PlaneLattice lattice_over(const IndexedMesh& mesh, const KerfAxes& axes,
                          std::span<const std::uint32_t> triangles, Vec2 min_mm, Vec2 max_mm) {
  for (const std::uint32_t triangle : triangles) {
    for (const std::uint32_t corner : mesh.triangles[triangle]) {
      const Vec2 corner_mm = place_mm(axes, mesh.points_mm[corner]);
      min_mm = glm::min(min_mm, corner_mm);
      max_mm = glm::max(max_mm, corner_mm);
    }
  }
  return {min_mm, max_mm};
}

}  // namespace

KerfContact slice_contact(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane,
                          std::int32_t kerf, const Vec2& min_mm, const Vec2& max_mm) {
  KerfContact contact;
  contact.plane = plane;
  contact.axes = axes_of(plane);
  contact.kerf = kerf;
  contact.base_point_count = static_cast<std::uint32_t>(solid.mesh.points_mm.size());
  const std::vector<std::uint32_t> triangles =
      triangles_reaching_slab(solid.mesh, bvh, contact.axes, 0.5 * plane.thickness_mm);
  contact.lattice = lattice_over(solid.mesh, contact.axes, triangles, min_mm, max_mm);
  contact.points.reserve(2 * triangles.size());
  contact.edges.reserve(4 * triangles.size());
  contact.triangles.reserve(2 * triangles.size());
  contact.outer_parts.reserve(2 * triangles.size());
  ContactSlicer slicer(solid, contact, triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    contact.touched.push_back({triangles[i]});
    contact.origins.push_back(solid.origins[triangles[i]]);
    slicer.slice(i);
  }
  grow_tree(contact);
  measure_box(contact);
  return contact;
}

KerfContact slice_contact(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane,
                          std::int32_t kerf, const FieldGrid& grid) {
  const Vec2 size_mm(grid.spacing_mm * (grid.u_count - 1), grid.spacing_mm * (grid.v_count - 1));
  return slice_contact(solid, bvh, plane, kerf, grid.origin_mm, grid.origin_mm + size_mm);
}

}  // namespace hallux::simulator
