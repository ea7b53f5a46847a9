/// What a frame shows, as one mesh, and what may be asked about it. Shares no code with the kernel.
#pragma once

#include <cstddef>
#include <vector>

#include "simulator/cutting/solid/solid_patch.h"

namespace hallux::tests {

/// The mesh without its hidden triangles, and the patch behind it.
simulator::IndexedMesh shown_mesh(const simulator::CutSolid& solid,
                                  const simulator::SolidPatch& patch);

/// Whether each directed edge occurs as often as its opposite: the skin has no border.
bool is_closed_as_chain(const simulator::IndexedMesh& mesh);
/// Whether each directed edge occurs once, its opposite once, no triangle names a point twice,
/// every point is used, and all places are finite.
bool is_strictly_closed(const simulator::IndexedMesh& mesh);

/// The volume inside each connected shell, negative for a void [mm3]; by the shells' lowest points.
std::vector<double> shell_volumes_mm3(const simulator::IndexedMesh& mesh);
/// Shells that hold more than debris: the bodies, as voids are no bodies.
std::size_t body_count(const simulator::IndexedMesh& mesh);

/// The area of the patch's triangles [mm2].
double patch_area_mm2(const simulator::CutSolid& solid, const simulator::SolidPatch& patch);
/// By how much a patch's volume may be off: the lattice moves a border by at most one step across
/// the patch's faces.
double balance_limit_mm3(const simulator::CutSolid& solid, const simulator::SolidPatch& patch);

/// Whether two patches are the same to the last bit.
bool are_same(const simulator::SolidPatch& a, const simulator::SolidPatch& b);

}  // namespace hallux::tests
