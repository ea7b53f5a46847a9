/// What lies in the plane of a blade: bone, what a kerf has opened of it, the blade itself, the
/// plan's limits and the danger zones; plain data, for a picture that looks square onto that plane.
///
///     x  where the saw goes          . . . . . .   planned limit
///     |    _______________          /            .
///     v   /  standing      |=======|  ... the way ahead
///         |____  opened ___|  teeth
///     y  along the teeth
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/plan.h"
#include "simulator/cutting/slice/section.h"
#include "simulator/tool/saw.h"
#include "ui/render/scene/site.h"
#include "ui/screens/pictures/way_ahead.h"

namespace hallux::ui {

/// Where a plane meets a bone, and what a kerf has opened there; in that plane.
struct KerfSection {
  /// x where the saw goes, y along the teeth, z the normal.
  RigidTransform bone_from_plane;
  /// Outlines counter-clockwise, holes (the canal) clockwise.
  std::vector<PlaneLoop> bone_mm;
  std::vector<PlaneLoop> opened_mm;
};

/// Whether a loop runs clockwise, or around nothing.
bool is_hole(const PlaneLoop& loop);

/// The section by the plane of a kerf, or of a blade that has not touched yet (then nothing is
/// opened). Costs what the triangles in the plane cost: a millisecond or two.
/// needs   tree was built over solid.mesh; the solid is the bone without that kerf
/// thread  any
KerfSection kerf_section(const simulator::CutSolid& solid, const simulator::Bvh& tree,
                         const simulator::KerfOpening& kerf);

/// Whether a blade lies so near to a kerf's plane that it belongs to it.
bool is_in_plane(const RigidTransform& bone_from_plane,
                 const RigidTransform& bone_from_tool) noexcept;

enum class PlanTraceKind : std::uint8_t {
  /// Another planned face, where it crosses the plane.
  Face,
  /// The line of a hinge, where the blade is to stop.
  Hinge
};
struct PlanTrace {
  PlanTraceKind kind = PlanTraceKind::Face;
  Vec2 from_mm{0.0, 0.0}, to_mm{0.0, 0.0};
};

struct ZoneInSection {
  std::string name;
  /// What the plane cuts of it, counter-clockwise; empty where it lies beside the plane.
  PlaneLoop outline_mm;
  /// Between the blade and the zone; negative: in it.
  double distance_mm = 0.0;
  bool is_near = false;
};

struct BladeSection {
  KerfSection section;
  /// Ends of the tooth line, and the unit direction of the feed.
  Vec2 teeth_from_mm{0.0, 0.0}, teeth_to_mm{0.0, 0.0}, feed{1.0, 0.0};
  double blade_depth_mm = 20.0;
  /// What lies ahead of the teeth, as whoever shows it knows it; nothing: neither drawn nor told.
  std::optional<WayAhead> way;
  std::vector<PlanTrace> plan;
  std::vector<ZoneInSection> zones;
};

/// The section with the blade where it is now, cheap enough for each frame; without the way ahead.
/// plan    nullptr where people may not see it: then without limits and zones
BladeSection blade_section(const KerfSection& section, const RigidTransform& bone_from_tool,
                           const simulator::Blade& blade, const scenarios::Plan* plan);

/// What stands ahead of the teeth in the section alone: for who has no more than that. Of the way
/// beside the bone it knows nothing.
simulator::BladeAhead ahead_in(const BladeSection& section);

}  // namespace hallux::ui
