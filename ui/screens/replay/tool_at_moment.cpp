#include "ui/screens/replay/tool_at_moment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/base/units.h"
#include "ui/screens/pictures/fixation_reading.h"
#include "ui/screens/pictures/rotation_vector.h"
#include "ui/screens/pictures/tool_poses.h"

namespace hallux::ui {

namespace {

using simulator::Tool;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
/// Further from all that is planned the hand is on its way; no distance is said.
constexpr double near_plan_mm = 12.0;
/// As they are drawn: the true rates are a blur.
constexpr double swings_per_second = 9.0, turns_per_second = 3.0;

double angle_rad(double cosine) noexcept { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

std::optional<ForcepsInScene> forceps_of(const simulator::Grip& grip,
                                         const simulator::BoneMoment& bone,
                                         const simulator::BoneHistory& history) {
  const auto fragment = static_cast<std::size_t>(grip.fragment);
  if (fragment >= history.fragments.size()) return std::nullopt;
  const simulator::WholeBone* const piece = history.fragments[fragment].whole.get();
  if (piece == nullptr) return std::nullopt;
  const RigidTransform piece_from_hand =
      inverse(history.world_from_fragment(grip.fragment, grip.from_tick)) * grip.world_from_tool;
  const std::optional<RigidTransform> piece_from_jaws = jaws_around(piece->tree, piece_from_hand);
  if (!piece_from_jaws) return std::nullopt;
  return ForcepsInScene{bone.world_from_fragment(grip.fragment) * *piece_from_jaws,
                        jaws_opening_mm};
}

bool is_set_by(const scenarios::PlannedImplant& planned, const Tool& tool) noexcept {
  const bool is_wire = planned.kind == scenarios::ImplantKind::Wire;
  return is_wire == std::holds_alternative<simulator::WireDriver>(tool);
}

ToPlan axis_to_plan(const scenarios::PlannedImplant& planned,
                    const RigidTransform& bone_from_tool) noexcept {
  const ImplantReading reading = read_implant(planned, bone_from_tool);
  ToPlan to;
  to.distance_mm = reading.entry_mm;
  to.tilt_rad = reading.direction_rad;
  to.depth_mm = reading.depth_mm;
  return to;
}

}  // namespace

ToPlan::ToPlan() noexcept : distance_mm(unknown), tilt_rad(unknown), depth_mm(unknown) {}

ToolAtMoment tool_at(const simulator::HandHistory& hand, const simulator::Tray& tray,
                     std::int64_t tick) noexcept {
  const std::int32_t place = hand.tool_at(tick);
  ToolAtMoment at;
  at.tool = &tray[tray.has(place) ? place : 0];
  at.grip = hand.grip_at(tick);
  const bool is_saw = std::holds_alternative<simulator::Saw>(*at.tool);
  at.held = at.grip != nullptr ? HeldTool::Forceps : is_saw ? HeldTool::Saw : HeldTool::Driver;
  return at;
}

ToPlan saw_to_plan(const scenarios::Plan& plan, const RigidTransform& bone_from_tool,
                   double kerf_mm) noexcept {
  ToPlan nearest;
  double least = std::numeric_limits<double>::infinity();
  const Vec3 upwards = transform_direction(bone_from_tool, Vec3(0.0, 0.0, 1.0));
  for (const scenarios::PlannedCut& cut : plan.cuts) {
    const Vec3& normal = cut.face.normal;
    const double off_mm =
        glm::dot(normal, bone_from_tool.translation_mm) - cut.face.offset_mm - 0.5 * kerf_mm;
    const double tilt_rad = angle_rad(std::abs(glm::dot(normal, upwards)));
    const double misfit = std::abs(off_mm) + degree_from_radian(tilt_rad);
    if (misfit >= least) continue;
    least = misfit;
    nearest.distance_mm = off_mm;
    nearest.tilt_rad = tilt_rad;
  }
  return std::abs(nearest.distance_mm) <= near_plan_mm ? nearest : ToPlan{};
}

ToPlan driver_to_plan(const scenarios::Plan& plan, const RigidTransform& bone_from_tool,
                      const Tool& tool) noexcept {
  ToPlan nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const scenarios::PlannedImplant& planned : plan.fixation.implants) {
    if (!is_set_by(planned, tool)) continue;
    const ToPlan to = axis_to_plan(planned, bone_from_tool);
    const double misfit = to.distance_mm + degree_from_radian(to.tilt_rad);
    if (misfit >= least) continue;
    least = misfit;
    nearest = to;
  }
  return nearest.distance_mm <= near_plan_mm ? nearest : ToPlan{};
}

ToPlan piece_moved(const RigidTransform& bone_from_piece, const Vec3& place_mm) noexcept {
  ToPlan moved;
  moved.distance_mm = length_of(transform_point(bone_from_piece, place_mm) - place_mm);
  moved.tilt_rad = length_of(rotation_vector(bone_from_piece.rotation));
  return moved;
}

void add_tool(Scene& scene, const ToolAtMoment& tool, const DrawnTool& drawn,
              const simulator::BoneMoment& bone, const simulator::BoneHistory& history) {
  const auto turned_rad = [&](double per_second) { return 2.0 * pi * per_second * drawn.time_s; };
  switch (tool.held) {
    case HeldTool::Forceps:
      scene.forceps = forceps_of(*tool.grip, bone, history);
      break;
    case HeldTool::Saw:
      scene.saw = SawInScene{drawn.world_from_tool, std::get<simulator::Saw>(*tool.tool).blade,
                             drawn.is_running, std::sin(turned_rad(swings_per_second))};
      break;
    case HeldTool::Driver:
      scene.driver = DriverInScene{drawn.world_from_tool, *tool.tool, drawn.is_running,
                                   drawn.is_running ? turned_rad(turns_per_second) : 0.0};
      break;
  }
}

}  // namespace hallux::ui
