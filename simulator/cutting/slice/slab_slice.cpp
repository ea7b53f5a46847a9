/// Each touched triangle is cut by both planes as one walk around its corners, which yields its
/// ring inside the slab and the corners beyond a plane. Crossings are computed from the edge's
/// lower mesh point and found again by the edge, never by position: the neighbour gets the same
/// bits, and the strip is closed. Then the strip's points are put into a tree by its edges, so that
/// a region asks one point of each skin and follows crossings for the rest.
#include "simulator/cutting/slice/slab_slice.h"

#include <algorithm>

#include "simulator/base/check.h"
#include "simulator/cutting/slice/id_table.h"
#include "simulator/cutting/slice/slab_query.h"

namespace hallux::simulator {

namespace {

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
  ContactSlicer(const SlabSkin& skin, SlabSlice& contact)
      : skin_(skin),
        contact_(contact),
        half_mm_(0.5 * contact.plane.thickness_mm),
        inside_points_(skin.points.size(), no_index),
        edge_ids_(2 * skin.triangles.size()) {
    slab_edges_.reserve(2 * skin.triangles.size());
  }

  void slice(std::uint32_t touched);

 private:
  std::uint32_t add_point(const Vec3& point_in_bone_mm, double height_mm, std::uint32_t base_point);
  std::uint32_t inside_point(std::uint32_t corner);
  std::uint32_t end_of(std::uint32_t from, const SlabCorner& low, const SlabCorner& high);
  SlabEdge slab_edge(std::uint32_t low, std::uint32_t high);
  StripRing ring_of(const Triangle& corners);
  void add_contour_edges(StripRing& ring);
  void add_fan(const StripRing& ring);
  std::uint32_t add_edge(std::uint32_t a, std::uint32_t b, SlabPart level);
  void add_triangle(const std::array<std::uint32_t, 3>& points,
                    const std::array<std::uint32_t, 3>& edges);

  const SlabSkin& skin_;
  SlabSlice& contact_;
  double half_mm_;
  std::vector<std::uint32_t> inside_points_;  // per point of the skin
  IdTable edge_ids_;
  std::vector<SlabEdge> slab_edges_;  // by id of the edge
  std::uint32_t touched_ = 0;
};

std::uint32_t ContactSlicer::add_point(const Vec3& point_in_bone_mm, double height_in_kerf_mm,
                                       std::uint32_t base_point) {
  contact_.points.push_back({contact_.lattice.snap(place_mm(contact_.axes, point_in_bone_mm)),
                             contact_.lattice.snap_height(height_in_kerf_mm), point_in_bone_mm,
                             base_point, touched_});
  return static_cast<std::uint32_t>(contact_.points.size() - 1);
}

std::uint32_t ContactSlicer::inside_point(std::uint32_t corner) {
  std::uint32_t& point = inside_points_[corner];
  if (point == no_index) {
    const SlabCorner& inside = skin_.points[corner];
    point = add_point(inside.point_in_bone_mm, inside.height_mm, inside.base_point);
  }
  return point;
}

/// The strip point at the end of the edge's inside part that lies towards `from`, one of its two
/// corners. The crossing is found from the edge's lower mesh point, so that both triangles of the
/// edge would get the same bits.
std::uint32_t ContactSlicer::end_of(std::uint32_t from, const SlabCorner& low,
                                    const SlabCorner& high) {
  const SlabPart part = skin_.points[from].part;
  if (part == SlabPart::Inside) return inside_point(from);
  const double level_mm = part == SlabPart::Above ? half_mm_ : -half_mm_;
  const double share = (level_mm - low.height_mm) / (high.height_mm - low.height_mm);
  const Vec3 along_mm = high.point_in_bone_mm - low.point_in_bone_mm;
  return add_point(low.point_in_bone_mm + std::clamp(share, 0.0, 1.0) * along_mm, level_mm,
                   no_index);
}

/// The edge from the corner of lower mesh point to that of higher.
SlabEdge ContactSlicer::slab_edge(std::uint32_t low, std::uint32_t high) {
  bool is_new = false;
  const std::uint32_t id = edge_ids_.id_of((static_cast<std::uint64_t>(low) << 32U) | high, is_new);
  if (!is_new) return slab_edges_[id];
  const SlabCorner& low_corner = skin_.points[low];
  const SlabCorner& high_corner = skin_.points[high];
  SlabEdge edge;
  edge.low_end = end_of(low, low_corner, high_corner);
  edge.high_end = end_of(high, low_corner, high_corner);
  edge.strip_edge = add_edge(edge.low_end, edge.high_end, SlabPart::Inside);
  slab_edges_.push_back(edge);
  return edge;
}

std::uint32_t ContactSlicer::add_edge(std::uint32_t a, std::uint32_t b, SlabPart level) {
  contact_.edges.push_back({a, b, static_cast<std::int8_t>(level), touched_});
  return static_cast<std::uint32_t>(contact_.edges.size() - 1);
}

/// Walks around the triangle. Where the walk leaves the slab it comes back through the same plane;
/// the corners met between are the outer part's. The walk does not begin between two corners on one
/// side, but may begin beyond a plane: then the last contour edge closes what the first corners
/// began.
StripRing ContactSlicer::ring_of(const Triangle& corners) {
  StripRing ring;
  OuterRun run, first_run;
  std::size_t start = 0;
  const auto part = [&](std::size_t i) { return skin_.points[corners[i % 3]].part; };
  while (part(start) != SlabPart::Inside && part(start) == part(start + 2)) ++start;
  for (std::size_t i = start; i < start + 3; ++i) {
    const SlabCorner& from = skin_.points[corners[i % 3]];
    const SlabCorner& to = skin_.points[corners[(i + 1) % 3]];
    const bool is_outside = from.part != SlabPart::Inside;
    if (is_outside) run.corners[run.count++] = from.base_point;
    if (is_outside && from.part == to.part) continue;
    if (is_outside) {
      (ring.count > 0 ? ring.outer[ring.count - 1] : first_run) = run;
      run = {};
    }
    const bool runs_up = from.base_point < to.base_point;
    const SlabEdge edge = runs_up ? slab_edge(corners[i % 3], corners[(i + 1) % 3])
                                  : slab_edge(corners[(i + 1) % 3], corners[i % 3]);
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
  StripRing ring = ring_of(skin_.corners[touched]);
  CHECK(ring.count >= 3);
  add_contour_edges(ring);
  add_fan(ring);
}

/// An edge as one of its ends sees it.
struct Spoke {
  std::uint32_t edge = 0, other_end = 0;
};

/// Each point's edges in ascending order, as runs of one list.
struct PointEdges {
  std::vector<std::uint32_t> first;
  std::vector<Spoke> spokes;
};

PointEdges edges_of_points(const SlabSlice& contact) {
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
  lists.spokes.resize(sum);
  for (auto i = static_cast<std::uint32_t>(contact.edges.size()); i-- > 0;) {
    const StripEdge& edge = contact.edges[i];
    lists.spokes[--lists.first[edge.a]] = {i, edge.b};
    lists.spokes[--lists.first[edge.b]] = {i, edge.a};
  }
  return lists;
}

/// Breadth first from the lowest point of each skin.
void grow_tree(SlabSlice& contact) {
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
        const Spoke& spoke = lists.spokes[i];
        if (skin_of_point[spoke.other_end] != no_index) continue;
        skin_of_point[spoke.other_end] = skin;
        contact.tree.push_back({spoke.other_end, point, spoke.edge, skin});
      }
    }
  }
  for (TouchedTriangle& touched : contact.touched) {
    touched.skin = skin_of_point[contact.triangles[touched.first_strip].points[0]];
  }
}

void measure_box(SlabSlice& contact) {
  if (contact.points.empty()) return;
  contact.min = contact.max = contact.points.front().place;
  for (const StripPoint& point : contact.points) {
    contact.min = {std::min(contact.min.u, point.place.u), std::min(contact.min.v, point.place.v)};
    contact.max = {std::max(contact.max.u, point.place.u), std::max(contact.max.v, point.place.v)};
  }
}

/// The lattice must reach over the region's box and over all the corners of the touched triangles'
/// parts in the slab.
PlaneLattice lattice_over(const SlabSkin& skin, const KerfAxes& axes, Vec2 min_mm, Vec2 max_mm) {
  for (const SlabCorner& corner : skin.points) {
    const Vec2 corner_mm = place_mm(axes, corner.point_in_bone_mm);
    min_mm = glm::min(min_mm, corner_mm);
    max_mm = glm::max(max_mm, corner_mm);
  }
  return {min_mm, max_mm};
}

void reserve_for(SlabSlice& contact, std::size_t touched_count) {
  contact.touched.reserve(touched_count);
  contact.sources.reserve(touched_count);
  contact.points.reserve(2 * touched_count);
  contact.edges.reserve(4 * touched_count);
  contact.triangles.reserve(2 * touched_count);
  contact.outer_parts.reserve(2 * touched_count);
}

}  // namespace

SlabSlice slice_slab(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane,
                     std::int32_t kerf, const Vec2& min_mm, const Vec2& max_mm) {
  SlabSlice contact;
  contact.plane = plane;
  contact.axes = axes_of(plane);
  contact.kerf = kerf;
  contact.base_point_count = static_cast<std::uint32_t>(solid.mesh.points_mm.size());
  const SlabSkin skin = gather_slab_skin(solid.mesh, bvh, contact.axes, 0.5 * plane.thickness_mm);
  contact.lattice = lattice_over(skin, contact.axes, min_mm, max_mm);
  reserve_for(contact, skin.triangles.size());
  // In a loop of their own these scattered reads overlap.
  for (const std::uint32_t triangle : skin.triangles) {
    contact.touched.push_back({triangle});
    contact.sources.push_back(solid.sources[triangle]);
  }
  ContactSlicer slicer(skin, contact);
  for (std::uint32_t i = 0; i < skin.triangles.size(); ++i) slicer.slice(i);
  grow_tree(contact);
  measure_box(contact);
  return contact;
}

SlabSlice slice_slab(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane,
                     std::int32_t kerf, const FieldGrid& grid) {
  const Vec2 size_mm(grid.spacing_mm * (grid.u_count - 1), grid.spacing_mm * (grid.v_count - 1));
  return slice_slab(solid, bvh, plane, kerf, grid.origin_mm, grid.origin_mm + size_mm);
}

}  // namespace hallux::simulator
