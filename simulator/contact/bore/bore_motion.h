/// How a tool with a point follows the hand: freely in air, held by bone at a touch, along its axis
/// in a bore.
/// Inside this room only.
///
///     Free ------ the point meets bone -----> OnBone --- runs, steep, 0.3 mm deep ---> InBore
///      ^  <------ the point is clear again -----'                                        |
///      |  ------ near an open bore's axis and mouth ---------------------------------->  |
///      '----------------------------- drawn out --------------------------------------- '
///
/// The coupling is the saw's (tool_motion.h, coupling.h). Outside a bore the tool is a proxy: its
/// point and shaft stay out of bone and slide on it. A running point that stands at less than 30
/// degrees to the surface skids, a steeper one bores by the feed law, a resting one bores nothing.
/// In a bore the tool goes along the axis alone: forward by the feed law of its tip's disc, freely
/// where the bore is open already, backward freely; about its axis it spins freely. Where bone
/// gives way the tool comes after the hand gently. A screw goes by its thread.
/// source  docs/haptics.md, section 15
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "simulator/contact/bore/bore_tool.h"
#include "simulator/contact/bore/drilled_tissue.h"
#include "simulator/contact/proxy.h"
#include "simulator/contact/tool_motion.h"
#include "simulator/cutting/hole/bore.h"

namespace hallux::simulator {

/// Flatter than this to the surface (30 degrees) a running point skids. Ours.
inline constexpr double skid_sine = 0.5;
/// Of a point that skids. Ours.
inline constexpr double skid_friction = 0.1;
/// Of a running point that does not: it digs in, also where it slid before, down to 23 degrees.
/// Ours.
inline constexpr double point_grip = 4.0;
/// Near an open bore's axis a point finds its mouth again; as a blade finds its slot (5 degrees,
/// 0.5 mm).
inline constexpr double bore_rejoin_angle_rad = 0.0873;
inline constexpr double bore_rejoin_offset_mm = 0.5;
/// Along the axis, before the mouth and beyond the end.
inline constexpr double bore_rejoin_reach_mm = 0.35;
/// A screw is driven while it is pushed by more than this. Ours.
inline constexpr double screw_push_newton = 2.0;

inline constexpr std::size_t bore_disc_points = 9;
inline constexpr std::size_t bore_shaft_points = 8;
inline constexpr std::size_t bore_shoulder_points = 8;

using BallMemories = std::array<OfFragments<BallMemory>, 1 + bore_shaft_points>;
using DiscMemories = std::array<OfFragments<TissueMemory>, bore_disc_points>;

enum class BoreStage : std::int32_t { Free, OnBone, InBore };

struct BoreToolState {
  BoreStage stage = BoreStage::Free;
  RigidTransform wound_from_tool;
  /// In InBore: of the bores that the caller brings.
  std::int32_t bore = -1;
  /// In OnBone: how far the point went in, now and at most.
  double touch_depth_mm = 0.0, scratch_mm = 0.0;
  /// In OnBone: of the surface that the point met, while it is in it.
  Vec3 touch_normal{0.0, 0.0, 0.0};
  /// In OnBone: there is no bore left, the point stays where it is.
  bool is_refused = false;
  /// In Free: bone stretched the spring, and it is not slack again.
  bool is_held = false;
  /// In InBore: the tip stood in bone, and the tool went on since.
  bool may_break_through = false;
  /// In InBore: since the tip stood in bone last.
  double drawn_back_mm = 0.0;
  /// In InBore: along the axis, while the tip stood in bone last.
  double bone_force_newton = 0.0;
  /// In InBore, of a screw: its thread holds, so that it is turned back, not drawn.
  bool is_threaded = false;
  /// Of the last tick.
  RigidTransform wound_from_handle;
  bool knows_handle = false;
  /// Of the point and of the shaft.
  BallMemories balls{};
  OfFragments<TissueMemory> touch{};
  DiscMemories disc{};
  std::array<OfFragments<TissueMemory>, bore_shoulder_points> shoulder{};
  ProxyLoad load;
};

struct BoreInput {
  /// The tool in the hand.
  const BoreTool& tool;
  RigidTransform wound_from_handle;
  bool drive_runs = false;
  double duration_s = 0.001;
  /// In the wound's frame, open for this tool: none in which an implant stays.
  std::span<const Bore> bores = {};
  /// What all bores have opened, those of `bores` as well.
  HolesOfFragments holes = {};
  /// Implants in the way.
  std::span<const Capsule> metal = {};
};

struct BoreOutcome {
  /// Before the advance: the tip's disc, with the diameter for the width.
  Engagement engaged;
  /// On the hand.
  Vec3 force_in_wound_newton{0.0, 0.0, 0.0};
  /// On the hand, about the tool's tip; none about the axis of a bore.
  Vec3 torque_in_wound_newton_mm{0.0, 0.0, 0.0};
  /// Through bone, along the axis; of a screw also through its pilot hole.
  double advance_mm = 0.0;
  /// Above 0: a touch ended without a bore.
  double scratch_mm = 0.0;
  /// Just before the break-through of this tick, along the axis.
  double broke_at_newton = 0.0;
  /// Of `metal`, the implant that stops the running tool, or -1.
  std::int32_t metal = -1;
  /// The bore that was found again in this tick, or -1. One narrower than the tool is not entered:
  /// the caller begins a wider one (widened) and enters that.
  std::int32_t found_bore = -1;
  bool began_contact = false;
  /// The touch is deep enough for a bore along the tool's axis (begin_bore with touch_depth_mm).
  bool wants_bore = false;
  /// The point slides on bone: too flat.
  bool skids = false;
  /// The tip came out at the far side.
  bool broke_through = false;
  /// A screw's head stands on the bone.
  bool head_seated = false;
  /// A chuck does.
  bool chuck_stopped = false;
  /// A screw that is driven and pushed goes no further.
  bool spins = false;
  bool is_force_limited = false;
};

/// Moves the tool for one tick towards the handle. It opens nothing: the caller opens the bore with
/// the recorded pose (open_bore).
/// needs   0 < duration_s <= 0.003; in InBore `bores` holds the tool's bore, its axis unchanged
/// errors  none: total, allocates nothing
/// thread  haptic
BoreOutcome move_bore(BoreToolState& tool, const BoreInput& input, const Wound& wound,
                      const ContactSettings& settings) noexcept;

/// The bore that a tool at this pose finds again, the one with the nearest axis, or -1.
/// beyond_mm  that its tip may stand beyond the end of what was bored
std::int32_t find_bore_to_join(const RigidTransform& wound_from_tool, std::span<const Bore> bores,
                               double beyond_mm = bore_rejoin_reach_mm) noexcept;

/// The tip's disc, a little ahead of it.
std::array<Vec3, bore_disc_points> tip_disc(const RigidTransform& wound_from_tool,
                                            double radius_mm) noexcept;
/// Whether any of the shaft lies within a fragment's outer surface as it was before its kerfs.
bool shaft_is_in_bone(const RigidTransform& wound_from_tool, const BoreTool& tool,
                      const Wound& wound) noexcept;

/// Holds the tool to a bore's axis from now on; it comes there gently.
void enter_bore(BoreToolState& tool, std::int32_t bore) noexcept;

}  // namespace hallux::simulator
