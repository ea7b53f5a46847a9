/// The sagittal saw as triangles in the tool frame: origin at the middle of the tooth line, +x from
/// handle to teeth, z the blade's normal.
#pragma once

#include "simulator/tool/saw.h"
#include "ui/render/scene/tool_mesh.h"

namespace hallux::ui {

/// A toothed plate, narrower towards the hub, with marks etched every 5 mm (drawn by the shader).
/// needs   sizes above zero, depth_mm at least width_mm / 2
ToolMesh blade_mesh(const simulator::Blade& blade);
/// Hub, neck, grip and cable of a saw with that blade; they begin where the blade's depth ends.
ToolMesh handpiece_mesh(const simulator::Blade& blade);

/// Where the blade turns while it runs, on the tool's x axis.
double pivot_x_mm(const simulator::Blade& blade) noexcept;
/// From the pivot to where the cable ends.
inline constexpr double cable_end_mm = 240.0;
/// How far it turns to each side.
inline constexpr double swing_rad = 0.035;

}  // namespace hallux::ui
