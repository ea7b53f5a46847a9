#include "scenarios/foot/canal.h"

#include <algorithm>
#include <utility>

#include "scenarios/foot/topology.h"
#include "simulator/base/progress.h"
#include "simulator/mesh/bvh.h"

namespace hallux::scenarios {
namespace {

/// Where the canal ends, as shares of the length, and how it is rounded there.
constexpr double first_share = 0.24;
constexpr double last_share = 0.76;
constexpr double end_slope = 0.55;
constexpr double end_blend_mm = 4.0;
/// Greatest slope of the law's bell exp(-((t - 0.5) / 0.22)^2): sqrt(2 / e) / 0.22.
constexpr double bell_slope = 3.9;

Dual marrow_field(const simulator::Bvh& outer, const simulator::CortexLaw& cortex,
                  const Vec3& point_mm) {
  const double from_base = first_share * cortex.length_mm - point_mm.x;
  const double from_head = point_mm.x - last_share * cortex.length_mm;
  const Dual ends{end_slope * std::max(from_base, from_head),
                  {from_base > from_head ? -end_slope : end_slope, 0.0, 0.0}};
  const auto nearest = outer.nearest(point_mm);
  const double sign = nearest->is_inside ? -1.0 : 1.0;
  const double distance = std::max(nearest->distance_mm, 1e-9);
  const Dual depth{sign * distance, (point_mm - nearest->point_mm) * (sign / distance)};
  // The cortex law's own slope is left out: it is small, and Newton's steps repeat.
  return smooth_max(depth + simulator::cortex_thickness_mm(cortex, point_mm.x), ends, end_blend_mm);
}

SampleBox shaft_box(const simulator::IndexedMesh& outer, const simulator::CortexLaw& cortex,
                    double edge_mm) {
  const double length_mm = cortex.length_mm;
  SampleBox box;
  box.low_mm = outer.points_mm.front();
  box.high_mm = box.low_mm;
  const double low_x = first_share * length_mm - 1.0;
  const double high_x = last_share * length_mm + 1.0;
  for (const Vec3& p : outer.points_mm) {
    if (p.x < low_x || p.x > high_x) continue;
    box.low_mm = glm::min(box.low_mm, p);
    box.high_mm = glm::max(box.high_mm, p);
  }
  box.low_mm.x = low_x;
  box.high_mm.x = high_x;
  box.spacing_mm = std::clamp(1.5 * edge_mm, 0.4, 1.0);
  // The distance's own slope and the cortex law's.
  box.steepest = 1.0 + 0.65 * bell_slope * cortex.mid_mm / length_mm;
  return box;
}

}  // namespace

simulator::IndexedMesh make_canal(const simulator::IndexedMesh& outer,
                                  const simulator::CortexLaw& cortex, double edge_mm,
                                  const Progress& progress) {
  const simulator::Bvh tree(outer);
  const Field field = [&](const Vec3& point_mm) { return marrow_field(tree, cortex, point_mm); };
  const SampledField samples = sample_field(field, shaft_box(outer, cortex, edge_mm));
  const simulator::IndexedMesh raw = march_tetrahedra(samples);
  check_sphere(raw, "canal");
  simulator::IndexedMesh canal = remesh(raw, field, edge_mm, progress);
  check_sphere(canal, "canal");
  for (simulator::Triangle& t : canal.triangles) std::swap(t[1], t[2]);
  return canal;
}

}  // namespace hallux::scenarios
