#include "tests/benchmarks/display_buffers/workloads.h"

#include <algorithm>

#include "tests/benchmarks/worlds/bone_like.h"
#include "tests/support/worlds.h"

namespace hallux::benchmarks {

namespace {

constexpr int cut_count = 12;

/// How many triangles have points on both sides of x = at_mm.
std::uint32_t crossed_at(const simulator::IndexedMesh& mesh, double at_mm) {
  std::uint32_t crossed = 0;
  for (const simulator::Triangle& triangle : mesh.triangles) {
    int above = 0;
    for (const std::uint32_t corner : triangle) above += mesh.points_mm[corner].x > at_mm ? 1 : 0;
    crossed += above == 1 || above == 2 ? 1U : 0U;
  }
  return crossed;
}

}  // namespace

std::vector<BufferModel> buffer_models(bool is_quick) {
  return {{"foot", make_foot_like(is_quick ? 30'000 : 120'000)},
          {"sphere", tests::dense_sphere(20.0, 1'000)}};
}

AppendWork cutting_of(const BufferModel& model) {
  double low_mm = 1e300, high_mm = -1e300;
  for (const Vec3& point_mm : model.mesh.points_mm) {
    low_mm = std::min(low_mm, point_mm.x);
    high_mm = std::max(high_mm, point_mm.x);
  }
  AppendWork work{"cutting", {}};
  for (int cut = 1; cut <= cut_count; ++cut) {
    const double at_mm = low_mm + (high_mm - low_mm) * cut / (cut_count + 1);
    const std::uint32_t crossed = crossed_at(model.mesh, at_mm);
    work.steps.insert(work.steps.end(), crossed, {2, 2});
    work.steps.push_back({2, 2 * crossed});
  }
  return work;
}

AppendWork subdividing_of(const BufferModel& model, std::size_t steps_at_most) {
  const std::size_t steps = std::min(model.mesh.triangles.size(), steps_at_most);
  return {"subdividing", std::vector<AppendStep>(steps, {1, 1})};
}

}  // namespace hallux::benchmarks
