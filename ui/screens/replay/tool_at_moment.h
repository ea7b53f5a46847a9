/// The tool in the hand at a moment of a replay, as it is drawn and as it stands to the plan.
/// Inside this corner only.
#pragma once

#include <optional>

#include "scenarios/plan.h"
#include "simulator/history/bone_moment.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

enum class HeldTool { Saw, Driver, Forceps };

/// What of the tray is in the hand, or that forceps hold a piece.
struct ToolAtMoment {
  HeldTool held = HeldTool::Saw;
  /// A tool of the tray, also below the forceps; borrowed from it.
  const simulator::Tool* tool = nullptr;
  /// Null where nothing is gripped; borrowed from the history.
  const simulator::Grip* grip = nullptr;
};

ToolAtMoment tool_at(const simulator::HandHistory& hand, const simulator::Tray& tray,
                     std::int64_t tick) noexcept;

/// How a tool stands to what is planned for it; not a number where nothing is planned near it.
struct ToPlan {
  /// Of a saw, signed: positive is short of the planned face, on its waste. Of a driver, the way
  /// from its axis to the planned entry. Of a piece, how far it has come.
  double distance_mm;
  /// Between blade and face, between the axes, or the piece's turn.
  double tilt_rad;
  /// Of a driver: of its tip beyond the planned entry, along the planned axis.
  double depth_mm;

  /// Nothing is known.
  ToPlan() noexcept;
};

/// The planned face that the blade fits best: a degree counts as a millimetre.
ToPlan saw_to_plan(const scenarios::Plan& plan, const RigidTransform& bone_from_tool,
                   double kerf_mm) noexcept;
/// The planned wire or screw, as the tool sets or prepares it, that its axis fits best.
ToPlan driver_to_plan(const scenarios::Plan& plan, const RigidTransform& bone_from_tool,
                      const simulator::Tool& tool) noexcept;
/// Against where the piece was cut.
ToPlan piece_moved(const RigidTransform& bone_from_piece, const Vec3& place_mm) noexcept;

/// How a tool is drawn.
struct DrawnTool {
  RigidTransform world_from_tool;
  bool is_running = false;
  /// Of the replay, for what swings and turns while it runs.
  double time_s = 0.0;
};

/// Adds saw, driver, or the forceps that hold a piece: at the place of the piece that was nearest
/// to the hand when it was gripped, and so on with it.
void add_tool(Scene& scene, const ToolAtMoment& tool, const DrawnTool& drawn,
              const simulator::BoneMoment& bone, const simulator::BoneHistory& history);

}  // namespace hallux::ui
