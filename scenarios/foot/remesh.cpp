#include "scenarios/foot/remesh.h"

#include <algorithm>
#include <cmath>

#include "scenarios/foot/triangle_graph.h"
#include "scenarios/scenario_error.h"
#include "simulator/base/progress.h"

namespace hallux::scenarios {
namespace {

constexpr int rounds = 5;
constexpr double relax_share = 0.8;
/// Least cosine between a triangle before and after a change.
constexpr double collapse_turn = 0.2;
constexpr double flip_turn = 0.4;

double length_of(const Vec3& v) { return std::sqrt(glm::dot(v, v)); }

double edge_length(const TriangleGraph& graph, Side h) {
  return length_of(graph.at(graph.end(h)) - graph.at(graph.start(h)));
}

void split_long(TriangleGraph& graph, double longest_mm) {
  const Side count = graph.side_count();
  for (Side h = 0; h < count; ++h) {
    if (!graph.is_side(h) || h > graph.twin(h)) continue;
    if (edge_length(graph, h) <= longest_mm) continue;
    graph.split(h, 0.5 * (graph.at(graph.start(h)) + graph.at(graph.end(h))));
  }
}

/// Whether moving `p` to `to_mm` keeps the triangles around it, but those that hold `other`, facing their way and short.
bool may_move(const TriangleGraph& graph, PointIndex p, PointIndex other, const Vec3& to_mm,
              double longest_mm) {
  bool is_fine = true;
  graph.for_each_leaving(p, [&](Side h) {
    const PointIndex b = graph.end(h);
    const PointIndex c = graph.apex(h);
    if (!is_fine || b == other || c == other) return;
    if (length_of(graph.at(b) - to_mm) > longest_mm) {
      is_fine = false;
      return;
    }
    const Vec3 before = graph.area_vector(h);
    const Vec3 after = glm::cross(graph.at(b) - to_mm, graph.at(c) - to_mm);
    const double size = length_of(before) * length_of(after);
    // An empty triangle faces nowhere; marching leaves some, and they may go.
    if (size > 0.0 && glm::dot(before, after) < collapse_turn * size) is_fine = false;
  });
  return is_fine;
}

void collapse_short(TriangleGraph& graph, double shortest_mm, double longest_mm) {
  for (Side h = 0; h < graph.side_count(); ++h) {
    if (!graph.is_side(h) || edge_length(graph, h) >= shortest_mm) continue;
    const PointIndex a = graph.start(h);
    const PointIndex b = graph.end(h);
    const Vec3 middle = 0.5 * (graph.at(a) + graph.at(b));
    if (!graph.can_collapse(h) || !may_move(graph, a, b, middle, longest_mm) ||
        !may_move(graph, b, a, middle, longest_mm)) {
      continue;
    }
    graph.collapse(h, middle);
  }
}

int square(int value) { return value * value; }

bool flip_helps(const TriangleGraph& graph, Side h) {
  const auto excess = [&](PointIndex p) { return static_cast<int>(graph.valence(p)) - 6; };
  const int a = excess(graph.start(h));
  const int b = excess(graph.end(h));
  const int c = excess(graph.apex(h));
  const int d = excess(graph.apex(graph.twin(h)));
  return square(a - 1) + square(b - 1) + square(c + 1) + square(d + 1) <
         square(a) + square(b) + square(c) + square(d);
}

bool flip_keeps_facing(const TriangleGraph& graph, Side h) {
  const Vec3& a = graph.at(graph.start(h));
  const Vec3& b = graph.at(graph.end(h));
  const Vec3& c = graph.at(graph.apex(h));
  const Vec3& d = graph.at(graph.apex(graph.twin(h)));
  const Vec3 before = graph.area_vector(h) + graph.area_vector(graph.twin(h));
  const Vec3 first = glm::cross(d - c, b - c);
  const Vec3 second = glm::cross(c - d, a - d);
  const double size = length_of(before);
  return glm::dot(first, before) > flip_turn * size * length_of(first) &&
         glm::dot(second, before) > flip_turn * size * length_of(second);
}

void flip_to_even_valences(TriangleGraph& graph) {
  for (Side h = 0; h < graph.side_count(); ++h) {
    if (!graph.is_side(h) || h > graph.twin(h)) continue;
    if (flip_helps(graph, h) && graph.can_flip(h) && flip_keeps_facing(graph, h)) graph.flip(h);
  }
}

/// The point moved along the surface towards the middle of its neighbours.
Vec3 relaxed(const TriangleGraph& graph, PointIndex p) {
  Vec3 sum{0.0, 0.0, 0.0};
  Vec3 normal{0.0, 0.0, 0.0};
  graph.for_each_leaving(p, [&](Side h) {
    sum += graph.at(graph.end(h));
    normal += graph.area_vector(h);
  });
  const Vec3 shift = sum / static_cast<double>(graph.valence(p)) - graph.at(p);
  const double squared = glm::dot(normal, normal);
  const Vec3 outward = squared > 0.0 ? normal * (glm::dot(shift, normal) / squared) : Vec3{0.0};
  return graph.at(p) + relax_share * (shift - outward);
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

void relax_onto(TriangleGraph& graph, const Field& field, int steps, double longest_step_mm) {
  std::vector<Vec3> moved(graph.point_count(), Vec3{0.0});
  for (PointIndex p = 0; p < graph.point_count(); ++p) {
    if (graph.is_point(p)) moved[p] = projected(field, relaxed(graph, p), steps, longest_step_mm);
  }
  for (PointIndex p = 0; p < graph.point_count(); ++p) {
    if (graph.is_point(p)) graph.move(p, moved[p]);
  }
}

}  // namespace

simulator::IndexedMesh remesh(const simulator::IndexedMesh& raw, const Field& field, double edge_mm,
                              const Progress& progress) {
  TriangleGraph graph(raw);
  const double longest_mm = edge_mm * 4.0 / 3.0;
  const double shortest_mm = edge_mm * 4.0 / 5.0;
  for (int round = 0; round < rounds; ++round) {
    split_long(graph, longest_mm);
    collapse_short(graph, shortest_mm, longest_mm);
    flip_to_even_valences(graph);
    relax_onto(graph, field, round + 1 < rounds ? 1 : 3, 0.3 * edge_mm);
    report(progress, static_cast<double>(round + 1) / rounds);
  }
  return graph.indexed();
}

}  // namespace hallux::scenarios
