/// A bone screw as triangles in its tool frame: origin at the tip, +x from the head to it.
#pragma once

#include "simulator/tool/tray.h"
#include "ui/render/scene/tool_mesh.h"

namespace hallux::ui {

/// Thread, tip and head with a hexagon for the driver; right-handed, turns by its pitch. A thread
/// of many turns ends short of the head, as those of long screws do.
/// needs   is_made(screw)
ToolMesh screw_mesh(const simulator::Screw& screw);
/// Adds the same to what is being built.
void add_screw(ToolBuilder& builder, const simulator::Screw& screw);

/// Across the flats of the hexagon, and how deep it is; 0 where there is no head to hold it.
struct HexagonSize {
  double across_mm = 0.0, depth_mm = 0.0;
};
HexagonSize hexagon_of(const simulator::Screw& screw) noexcept;

/// A hexagon's outline by so many points, a multiple of six; its corners are among them.
std::vector<Vec2> hexagon_mm(double across_mm, std::uint32_t count);

}  // namespace hallux::ui
