/// A region of a kerf as a solid of its own, made without our kernel: what an oracle takes out of a
/// bone.
#pragma once

#include "simulator/cutting/field/kerf.h"
#include "simulator/cutting/field/region_outline.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::oracles {

/// The region times the kerf's thickness, in the bone frame; closed and oriented. Its two ends are
/// filled by CGAL's constrained Delaunay triangulation.
/// needs   the loops are simple and do not touch
simulator::IndexedMesh prism_of(const simulator::RegionOutline& region,
                                const simulator::KerfPlane& plane);

}  // namespace hallux::oracles
