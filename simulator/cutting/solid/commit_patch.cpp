#include "simulator/cutting/solid/commit_patch.h"

#include "simulator/cutting/solid/mend_solid.h"
#include "simulator/cutting/solid/opened_volume.h"

namespace hallux::simulator {

namespace {

constexpr double nudge_mm = 1.0 / 262144.0;  // 2^-18
constexpr std::uint32_t nudges_at_most = 8;

}  // namespace

CutSolid commit_patch(const CutSolid& solid, const SolidPatch& patch) {
  CutSolid result;
  result.mesh.points_mm = solid.mesh.points_mm;
  result.mesh.points_mm.insert(result.mesh.points_mm.end(), patch.points_in_bone_mm.begin(),
                               patch.points_in_bone_mm.end());
  const std::size_t kept = solid.mesh.triangles.size() - patch.hidden.size();
  result.mesh.triangles.reserve(kept + patch.triangles.size());
  result.sources.reserve(kept + patch.triangles.size());
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    if (next < patch.hidden.size() && patch.hidden[next] == i) {
      ++next;
      continue;
    }
    result.mesh.triangles.push_back(solid.mesh.triangles[i]);
    result.sources.push_back(solid.sources[i]);
  }
  const auto first_new = static_cast<std::uint32_t>(result.mesh.triangles.size());
  result.mesh.triangles.insert(result.mesh.triangles.end(), patch.triangles.begin(),
                               patch.triangles.end());
  result.sources.insert(result.sources.end(), patch.sources.begin(), patch.sources.end());
  separate_repeated_edges(result, first_new);
  drop_unused_points(result.mesh);
  return result;
}

KerfCut cut_kerf(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane, std::int32_t kerf,
                 const FieldGrid& grid, const RegionOutline& region) {
  KerfCut cut;
  KerfPlane tried = plane;
  for (; cut.nudges <= nudges_at_most; ++cut.nudges) {
    const SlabSlice contact = slice_slab(solid, bvh, tried, kerf, grid);
    PatchBuilder builder(contact);
    SolidPatch patch;
    if (builder.build(region, patch)) {
      cut.takes_section = builder.takes_section();
      cut.removed_mm3 = opened_volume_mm3(solid, tried, region);
      cut.solid = commit_patch(solid, patch);
      return cut;
    }
    tried.bone_from_kerf.translation_mm += nudge_mm * contact.axes.z;
  }
  cut.solid = solid;
  return cut;
}

}  // namespace hallux::simulator
