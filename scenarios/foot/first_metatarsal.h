/// The parametric first metatarsal: a bone from a table of stations, closed and the same bytes each time.
#pragma once

#include <functional>
#include <string_view>

#include "scenarios/foot/bone_table.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

struct BoneRequest {
  double length_mm = 0.0;  ///< base facet to head along x; 0 keeps the table's own length
  double eminence_mm =
      0.0;  ///< medial prominence beyond the table's datum; 0 keeps the table's own bump
  double edge_mm = 0.3;  ///< edge length of the outer surface after remeshing
  bool with_canal = true;
};

/// Called with the fraction done [0, 1]; returning false cancels.
using BoneProgress = std::function<bool(double)>;

/// Builds the bone: field, marching tetrahedra, isotropic remesh with projection, canal, landmarks, placement.
/// ensures outer and canal are closed, genus 0, one component each; the same request gives the same bytes
/// errors  ScenarioError where the request is out of range, or the surface came out with another topology (says which);
///         ScenarioError("cancelled") where progress said so
/// source  docs/foot.md; table `tables/first_metatarsal.txt`
simulator::Bone make_first_metatarsal(const BoneTable& table, const BoneRequest& request,
                                      const BoneProgress& progress = {});

/// The shipped table of the first metatarsal (MT1A).
BoneTable first_metatarsal_table();

}  // namespace hallux::scenarios
