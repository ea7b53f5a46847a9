/// The marrow as a void: everything deeper than the cortex, with rounded ends in the shaft.
/// Inside this corner only.
#pragma once

#include "scenarios/foot/remesh.h"
#include "simulator/base/progress.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

/// A closed surface that faces inward (towards the marrow), from the true distance to the finished
/// outer surface.
/// ensures nowhere nearer to `outer` than the cortex law, up to the height of an edge's arc
/// errors  ScenarioError where the canal is not one part without handles; Cancelled
/// source  docs/foot.md, section "Cortex and canal"
simulator::IndexedMesh make_canal(const simulator::IndexedMesh& outer,
                                  const simulator::CortexLaw& cortex, double edge_mm,
                                  const Progress& progress);

}  // namespace hallux::scenarios
