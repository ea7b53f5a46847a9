/// Rounds of split, collapse, flip, relax and projection (Botsch and Kobbelt 2004):
///
///        c        each edge a-b has two triangles with the apexes c and d
///       / \       split      an edge over 4/3 gets a point in its middle: four triangles
///      a---b      collapse   an edge under 4/5: a goes, b moves to the middle
///       \ /       flip       c-d in place of a-b where the four valences come nearer to six
///        d
///
/// OpenMesh carries out all three and says whether the surface stays a surface; the rules here say
/// whether its triangles get better. Edges are taken by handle, so the same surface gives the same
/// bytes. Valences stand in a table, and OpenMesh's check, which walks around both ends, comes
/// last. A first round without splits was tried: an eighth less time for a bone, but the scores of
/// the scripted hands moved by more than a point.
#include "scenarios/foot/remesh.h"

#include <array>
#include <cmath>

#include "scenarios/foot/half_edge_surface.h"
#include "simulator/base/progress.h"

namespace hallux::scenarios {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::TriConnectivity;
using OpenMesh::VertexHandle;

constexpr int rounds = 5;
constexpr double relax_share = 0.8;
/// Least cosine between a triangle before and after a change.
constexpr double collapse_turn = 0.2;
constexpr double flip_turn = 0.4;
/// Neighbours of a point where two have become one.
constexpr int least_neighbours = 3;
constexpr int most_neighbours = 12;

std::size_t row_of(VertexHandle v) { return static_cast<std::size_t>(v.idx()); }

/// The third corner of the half-edge's triangle.
VertexHandle apex_of(const TriConnectivity& mesh, HalfedgeHandle h) {
  return mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
}

/// The corners around an edge from a to b: c is opposite it on the left, d on the right.
struct Diamond {
  VertexHandle a, b, c, d;
};

Diamond diamond_at(const TriConnectivity& mesh, HalfedgeHandle h) {
  return {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h), apex_of(mesh, h),
          apex_of(mesh, mesh.opposite_halfedge_handle(h))};
}

double squared_edge_length(const HalfEdgeSurface& surface, EdgeHandle e) {
  const HalfedgeHandle h = surface.connections.halfedge_handle(e, 0);
  return squared_length(surface.at(surface.connections.to_vertex_handle(h)) -
                        surface.at(surface.connections.from_vertex_handle(h)));
}

Vec3 middle_of(const HalfEdgeSurface& surface, EdgeHandle e) {
  const HalfedgeHandle h = surface.connections.halfedge_handle(e, 0);
  return 0.5 * (surface.at(surface.connections.from_vertex_handle(h)) +
                surface.at(surface.connections.to_vertex_handle(h)));
}

/// Twice the area times the outward normal of the triangle with these corners.
Vec3 area_vector(const HalfEdgeSurface& surface, VertexHandle a, VertexHandle b, VertexHandle c) {
  return glm::cross(surface.at(b) - surface.at(a), surface.at(c) - surface.at(a));
}

void split_long(HalfEdgeSurface& surface, double longest_mm) {
  for (const EdgeHandle e : surface.connections.edges()) {
    if (squared_edge_length(surface, e) <= longest_mm * longest_mm) continue;
    surface.points_mm.push_back(middle_of(surface, e));
    surface.connections.split(e, surface.connections.add_vertex());
  }
}

/// Whether moving `p` to `to_mm` keeps the triangles around it, but those that hold `other`, facing
/// their way and short.
bool may_move(const HalfEdgeSurface& surface, VertexHandle p, VertexHandle other, const Vec3& to_mm,
              double longest_mm) {
  const TriConnectivity& mesh = surface.connections;
  const HalfedgeHandle first = mesh.halfedge_handle(p);
  HalfedgeHandle h = first;
  do {
    const VertexHandle b = mesh.to_vertex_handle(h);
    const VertexHandle c = apex_of(mesh, h);
    h = mesh.cw_rotated_halfedge_handle(h);
    if (b == other || c == other) continue;
    if (squared_length(surface.at(b) - to_mm) > longest_mm * longest_mm) return false;
    const Vec3 before = area_vector(surface, p, b, c);
    const Vec3 after = glm::cross(surface.at(b) - to_mm, surface.at(c) - to_mm);
    const double size = std::sqrt(squared_length(before) * squared_length(after));
    // An empty triangle faces nowhere; marching leaves some, and they may go.
    if (size > 0.0 && glm::dot(before, after) < collapse_turn * size) return false;
  } while (h != first);
  return true;
}

/// The number of neighbours of each vertex.
class Valences {
 public:
  explicit Valences(const TriConnectivity& mesh) : of_(mesh.n_vertices(), 0) {
    for (const EdgeHandle e : mesh.edges()) {
      ++at(mesh.from_vertex_handle(mesh.halfedge_handle(e, 0)));
      ++at(mesh.to_vertex_handle(mesh.halfedge_handle(e, 0)));
    }
  }
  int of(VertexHandle v) const { return of_[row_of(v)]; }
  /// That of b once a is merged into it.
  int merged(const Diamond& d) const { return of(d.a) + of(d.b) - 4; }
  void collapse(const Diamond& d) {
    at(d.b) = merged(d);
    --at(d.c);
    --at(d.d);
  }
  void flip(const Diamond& d) {
    --at(d.a);
    --at(d.b);
    ++at(d.c);
    ++at(d.d);
  }

 private:
  int& at(VertexHandle v) { return of_[row_of(v)]; }
  std::vector<int> of_;
};

/// Whether a may be merged into b in the middle of their edge.
bool may_merge(const HalfEdgeSurface& surface, const Valences& valences, const Diamond& d,
               const Vec3& middle_mm, double longest_mm) {
  const int neighbours = valences.merged(d);
  return neighbours >= least_neighbours && neighbours <= most_neighbours &&
         may_move(surface, d.a, d.b, middle_mm, longest_mm) &&
         may_move(surface, d.b, d.a, middle_mm, longest_mm);
}

void collapse_short(HalfEdgeSurface& surface, Valences& valences, double shortest_mm,
                    double longest_mm) {
  TriConnectivity& mesh = surface.connections;
  for (const EdgeHandle e : mesh.edges()) {
    if (squared_edge_length(surface, e) >= shortest_mm * shortest_mm) continue;
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    const Diamond d = diamond_at(mesh, h);
    const Vec3 middle_mm = middle_of(surface, e);
    if (!may_merge(surface, valences, d, middle_mm, longest_mm) || !mesh.is_collapse_ok(h)) {
      continue;
    }
    surface.at(d.b) = middle_mm;
    mesh.collapse(h);
    valences.collapse(d);
  }
}

/// Whether the four valences come nearer to six: the sum of their squared excess falls.
bool flip_evens(const Valences& valences, const Diamond& d) {
  return valences.of(d.c) + valences.of(d.d) + 2 < valences.of(d.a) + valences.of(d.b);
}

bool flip_keeps_facing(const HalfEdgeSurface& surface, const Diamond& d) {
  const Vec3 before = area_vector(surface, d.a, d.b, d.c) + area_vector(surface, d.b, d.a, d.d);
  const Vec3 first = area_vector(surface, d.c, d.d, d.b);
  const Vec3 second = area_vector(surface, d.d, d.c, d.a);
  const double size = length_of(before);
  return glm::dot(first, before) > flip_turn * size * length_of(first) &&
         glm::dot(second, before) > flip_turn * size * length_of(second);
}

void flip_to_even_valences(HalfEdgeSurface& surface, Valences& valences) {
  TriConnectivity& mesh = surface.connections;
  for (const EdgeHandle e : mesh.edges()) {
    const Diamond d = diamond_at(mesh, mesh.halfedge_handle(e, 0));
    if (!flip_evens(valences, d) || !mesh.is_flip_ok(e) || !flip_keeps_facing(surface, d)) {
      continue;
    }
    mesh.flip(e);
    valences.flip(d);
  }
}

/// Sums over the triangles around a point.
struct Fan {
  Vec3 neighbours_mm{0.0, 0.0, 0.0};
  Vec3 normal{0.0, 0.0, 0.0};
  int count = 0;
};

std::vector<Fan> fans_of(const HalfEdgeSurface& surface) {
  std::vector<Fan> fans(surface.points_mm.size());
  const TriConnectivity& mesh = surface.connections;
  for (const FaceHandle f : mesh.faces()) {
    const HalfedgeHandle h = mesh.halfedge_handle(f);
    const std::array<VertexHandle, 3> corners{mesh.from_vertex_handle(h), mesh.to_vertex_handle(h),
                                              apex_of(mesh, h)};
    const Vec3 normal = area_vector(surface, corners[0], corners[1], corners[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      Fan& fan = fans[row_of(corners[k])];
      fan.neighbours_mm += surface.at(corners[(k + 1) % 3]);
      fan.normal += normal;
      ++fan.count;
    }
  }
  return fans;
}

/// The point moved along the surface towards the middle of its neighbours.
Vec3 relaxed(const Vec3& point_mm, const Fan& fan) {
  const Vec3 shift = fan.neighbours_mm / static_cast<double>(fan.count) - point_mm;
  const double squared = glm::dot(fan.normal, fan.normal);
  const Vec3 outward =
      squared > 0.0 ? fan.normal * (glm::dot(shift, fan.normal) / squared) : Vec3{0.0};
  return point_mm + relax_share * (shift - outward);
}

Vec3 projected(const Field& field, Vec3 point_mm, int steps, double longest_step_mm) {
  for (int k = 0; k < steps; ++k) {
    const Dual distance = field(point_mm);
    const double squared = glm::dot(distance.slope, distance.slope);
    if (!(squared > 1e-12)) break;
    Vec3 step = distance.slope * (distance.value / squared);
    const double length = length_of(step);
    if (length > longest_step_mm) step *= longest_step_mm / length;
    point_mm -= step;
  }
  return point_mm;
}

void relax_onto(HalfEdgeSurface& surface, const Field& field, int steps, double longest_step_mm) {
  const std::vector<Fan> fans = fans_of(surface);
  for (const VertexHandle v : surface.connections.vertices()) {
    surface.at(v) =
        projected(field, relaxed(surface.at(v), fans[row_of(v)]), steps, longest_step_mm);
  }
}

}  // namespace

simulator::IndexedMesh remesh(const simulator::IndexedMesh& raw, const Field& field, double edge_mm,
                              const Progress& progress) {
  HalfEdgeSurface surface = half_edges_from(raw);
  const double longest_mm = edge_mm * 4.0 / 3.0;
  const double shortest_mm = edge_mm * 4.0 / 5.0;
  for (int round = 0; round < rounds; ++round) {
    split_long(surface, longest_mm);
    Valences valences(surface.connections);
    collapse_short(surface, valences, shortest_mm, longest_mm);
    flip_to_even_valences(surface, valences);
    relax_onto(surface, field, round + 1 < rounds ? 1 : 3, 0.3 * edge_mm);
    report(progress, static_cast<double>(round + 1) / rounds);
  }
  return indexed_from(surface);
}

}  // namespace hallux::scenarios
