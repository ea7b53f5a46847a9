/// Wire driver, drill and screwdriver as triangles in the tool frame: origin at the tip, +x from
/// the handpiece along the axis.
///
///     cable   grip                neck   chuck       held
///     ======(=====================)====[#####]------------------>
///                                      ^ chuck_x_mm              x
#pragma once

#include "simulator/tool/tray.h"
#include "ui/render/scene/tool_mesh.h"

namespace hallux::ui {

/// A smooth wire with a trocar point of three facets; the other end is one that pliers cut.
/// needs   is_made(wire)
ToolMesh wire_mesh(const simulator::Wire& wire);

/// What stands out of the chuck: a wire, a twist bit with two flutes, or a screw on its shaft.
/// needs   any tool but a saw
ToolMesh held_mesh(const simulator::Tool& tool);
/// Around what of a bit is seen as a blur while it turns; of other tools nothing.
ToolMesh blur_mesh(const simulator::Tool& tool);
/// What holds it and turns with it.
/// needs   any tool but a saw
ToolMesh chuck_mesh(const simulator::Tool& tool);
/// Neck, grip and cable.
/// needs   any tool but a saw
ToolMesh driver_body_mesh(const simulator::Tool& tool);

/// Where the chuck's mouth is, on the tool's x axis.
double chuck_x_mm(const simulator::Tool& tool) noexcept;
/// The radius of what stands out of it, the widest.
double held_radius_mm(const simulator::Tool& tool) noexcept;
/// How far what is held reaches into the chuck.
inline constexpr double held_in_chuck_mm = 6.0;
/// From the chuck's mouth to where the cable ends.
inline constexpr double driver_length_mm = 244.0;
/// Across the axis, no point of chuck or body is further from it in y and z.
inline constexpr double driver_half_y_mm = 9.0, driver_half_z_mm = 17.5;

}  // namespace hallux::ui
