/// The named points of a generated first metatarsal.
#pragma once

#include <vector>

#include "scenarios/foot/bone_field.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

struct LandmarkSources {
  const BoneTable& table;
  const BoneField& field;
  const simulator::IndexedMesh& outer;
  double length_mm = 0.0;
};

/// head_centre, head_apex, med_sulcus, dorsal_cart_edge, plantar_cart_edge, sesamoid_groove_med, sesamoid_groove_lat,
/// crista, tmt_centre, shaft_proximal, shaft_distal, shaft_medial, eminence_apex.
/// errors  ScenarioError where the table lacks a feature that a landmark is named after
/// source  docs/foot.md, section "Landmarks"
std::vector<simulator::Landmark> find_landmarks(const LandmarkSources& sources);

}  // namespace hallux::scenarios
