/// Makes even triangles of a raw surface and lays its points on the field. Inside this corner only.
#pragma once

#include "scenarios/foot/march_tetrahedra.h"
#include "simulator/base/progress.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::scenarios {

/// ensures closed, with the topology of `raw`; edges near edge_mm; points on the field's zero
/// errors  ScenarioError where `raw` is not closed; Cancelled
/// source  isotropic remeshing (Botsch and Kobbelt 2004) with projection; docs/foot.md
simulator::IndexedMesh remesh(const simulator::IndexedMesh& raw, const Field& field, double edge_mm,
                              const Progress& progress);

}  // namespace hallux::scenarios
