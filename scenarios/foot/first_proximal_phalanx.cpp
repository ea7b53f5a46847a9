#include "scenarios/foot/first_proximal_phalanx.h"

#include <algorithm>

#include "simulator/base/progress.h"

namespace hallux::scenarios {
namespace {

const Vec3 medial{0.0, 0.0, -1.0};
const Vec3 lateral{0.0, 0.0, 1.0};
const Vec3 dorsal{0.0, 1.0, 0.0};
const Vec3 plantar{0.0, -1.0, 0.0};
const Vec3 distal{1.0, 0.0, 0.0};

/// The facet's rim in the sagittal plane through its centre: where the surface turns from proximal
/// to `side`.
Vec3 base_rim(const LandmarkSources& sources, const Vec3& side) {
  return slice_extreme(sources.outer, 2, sources.table.base.z_mm, side - distal);
}

/// x of the narrowest station.
double waist_mm(const LandmarkSources& sources) {
  const std::vector<Station>& stations = sources.table.stations;
  const auto narrowest = std::min_element(
      stations.begin(), stations.end(),
      [](const Station& a, const Station& b) { return a.half_width_mm < b.half_width_mm; });
  return narrowest->position * sources.length_mm;
}

}  // namespace

std::vector<simulator::Landmark> first_proximal_phalanx_landmarks(const LandmarkSources& sources) {
  const simulator::IndexedMesh& mesh = sources.outer;
  const double length = sources.length_mm;
  const double waist = waist_mm(sources);
  const RestingPoints base = straight_edge(mesh, -1.0, sources.table.base.z_mm);
  const RestingPoints head = straight_edge(mesh, 1.0, sources.table.head.z_mm);
  return {
      {"base_centre", cap_centre(sources, sources.table.base)},
      {"base_med", base.medial},
      {"base_lat", base.lateral},
      {"base_dors", base_rim(sources, dorsal)},
      {"base_plant", base_rim(sources, plantar)},
      {"shaft_proximal", slice_centroid(mesh, length / 3.0)},
      {"shaft_distal", slice_centroid(mesh, length * 2.0 / 3.0)},
      {"waist_med", slice_extreme(mesh, 0, waist, medial)},
      {"waist_lat", slice_extreme(mesh, 0, waist, lateral)},
      {"waist_dors", slice_extreme(mesh, 0, waist, dorsal)},
      {"waist_plant", slice_extreme(mesh, 0, waist, plantar)},
      {"ip_centre", cap_centre(sources, sources.table.head)},
      {"ip_med", head.medial},
      {"ip_lat", head.lateral},
  };
}

simulator::Bone make_first_proximal_phalanx(const BoneTable& table, const BoneRequest& request,
                                            const Progress& progress) {
  return make_bone(table, request, {"first_proximal_phalanx", first_proximal_phalanx_landmarks},
                   progress);
}

BoneTable first_proximal_phalanx_table() {
  return shipped_bone_table("first_proximal_phalanx.txt");
}

}  // namespace hallux::scenarios
