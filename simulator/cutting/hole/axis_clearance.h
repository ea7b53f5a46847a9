/// How near an implant comes to a joint surface.
#pragma once

#include <optional>
#include <span>

#include "simulator/base/segment.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

/// The least distance from the axis to the triangles, a joint surface of the mesh: 0 where it goes
/// through one; nothing where there are none [mm].
/// shape   `axis` in the mesh's frame
std::optional<double> axis_clearance_mm(const Segment& axis, const IndexedMesh& mesh,
                                        std::span<const std::uint32_t> triangles) noexcept;

}  // namespace hallux::simulator
