/// How an implant's tip lies to bone and joint: how far it stands out of the far skin, and how near
/// it comes to a joint surface.
#pragma once

#include <optional>
#include <span>

#include "simulator/mesh/bvh.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

/// How far the tip stands out of the far skin along the axis; negative where it is still within the
/// bone: the way left to the far skin [mm]. Nothing where the axis does not meet the bone between
/// head and tip.
/// shape   `skin`: the outer skin, closed, in the same frame as the points
std::optional<double> protrusion_mm(const Bvh& skin, const Vec3& head_mm, const Vec3& tip_mm);

/// The least distance from the tip to the triangles, a joint surface of the mesh; nothing where
/// there are none [mm].
std::optional<double> tip_clearance_mm(const Vec3& tip_mm, const IndexedMesh& mesh,
                                       std::span<const std::uint32_t> triangles) noexcept;

}  // namespace hallux::simulator
