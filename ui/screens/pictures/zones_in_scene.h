/// The danger zones of a plan, as a scene shows them.
#pragma once

#include <vector>

#include "scenarios/plan.h"
#include "simulator/tool/saw.h"
#include "ui/render/scene/site.h"

namespace hallux::ui {

/// Nearer than this a blade lights a zone, whether it runs or not.
inline constexpr double zone_near_mm = 2.0;
/// How present a zone is that no blade is near to.
inline constexpr double far_zone_presence = 0.8;

std::vector<ZoneInScene> zones_in_scene(const scenarios::Plan& plan,
                                        const RigidTransform& world_from_bone,
                                        const RigidTransform& world_from_tool,
                                        const simulator::Blade& blade);

}  // namespace hallux::ui
