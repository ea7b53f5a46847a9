#include "tests/benchmarks/fragments/pieces_cost.h"

#include "simulator/jobs/geometry_job.h"
#include "tests/benchmarks/fragments/driven_operation.h"
#include "tests/benchmarks/worlds/bone_like.h"

namespace hallux::benchmarks {

namespace {

constexpr std::int32_t kerfs = 8;
constexpr int rounds = 9;

simulator::ToolSample blade_at(const simulator::Bone& bone, std::int32_t kerf, const Vec3& tip_mm) {
  simulator::ToolSample sample;
  sample.tick = kerf;
  sample.world_from_tool = simulator::quantise(bone.world_from_bone * tests::blade_down(tip_mm));
  sample.status = bit(simulator::ToolStatus::SawOn);
  sample.kerf = kerf;
  return sample;
}

/// to_y_mm  of the teeth, from the middle of the shaft
double after_kerf_ms(const simulator::Bone& bone, simulator::AttemptGeometry& geometry,
                     std::int32_t kerf, double to_y_mm) {
  const Vec3 above = middle_of(bone.outer) + Vec3{-14.0 + 4.0 * kerf, 10.0, 0.0};
  const Vec3 below = above + Vec3{0.0, to_y_mm - 10.0, 0.0};
  simulator::CutEvent frozen;
  frozen.kind = simulator::CutEventKind::PlaneFrozen;
  frozen.subject = kerf;
  frozen.pose = simulator::quantise(tests::blade_down(above));
  geometry.apply(frozen);
  geometry.run({2 * kerf, simulator::JobKind::Section, kerf, kerf});
  for (const Vec3& tip_mm : {above, below}) geometry.apply(blade_at(bone, kerf, tip_mm));
  const Stopwatch watch;
  const auto result = geometry.run({2 * kerf + 1, simulator::JobKind::Pieces, kerf, kerf});
  return watch.worked_milliseconds();
}

}  // namespace

std::vector<Percentiles> pieces_cost_ms(const simulator::Bone& bone, KerfDepth depth) {
  const simulator::WholeBone whole(solid_of(bone));
  std::vector<std::vector<double>> times_ms(kerfs);
  for (int round = 0; round < rounds; ++round) {
    simulator::AttemptGeometry geometry({whole, bone.world_from_bone}, shaft_tray());
    for (std::int32_t kerf = 0; kerf < kerfs; ++kerf) {
      times_ms[static_cast<std::size_t>(kerf)].push_back(
          after_kerf_ms(bone, geometry, kerf, depth == KerfDepth::Half ? 0.0 : -12.0));
    }
  }
  std::vector<Percentiles> costs;
  for (std::vector<double>& times : times_ms) costs.push_back(percentiles_of(std::move(times)));
  return costs;
}

}  // namespace hallux::benchmarks
