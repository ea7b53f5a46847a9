/// How the tool follows the hand: freely in air, held by bone at a touch, along the plane in a
/// kerf. Inside this room only.
///
///     Free ------- teeth meet bone ------> Touching ------ 0.3 mm deep ------> InKerf
///      ^  <------- teeth clear again ---------'                                   |
///      |  ------- teeth drop into an open slot, nearly in its plane ------------> |
///      '----------------------- the blade has left the bone -----------------------'
///
/// A spring pulls the tool towards the handle; where bone stops the tool, the stretched spring is
/// the force on the hand. Outside a kerf the tool is a proxy (proxy.h): teeth, faces and edges stay
/// out of the bone and slide on it with friction. Only the tooth line cuts. In a kerf the blade
/// slides along its plane: forward by the feed law, backward freely, sideways and turned only where
/// its edges meet no standing bone, and no deeper than its collar; out of the plane it bends a
/// little. Bone that gives way lets the tool come after the hand gently. A saw started in bone, or
/// laid on with a corner, kicks the hand (kick.h).
#pragma once

#include <array>
#include <cstdint>

#include "simulator/contact/blade_contact.h"
#include "simulator/contact/feed.h"
#include "simulator/contact/guide.h"
#include "simulator/contact/kick.h"
#include "simulator/contact/proxy.h"
#include "simulator/contact/wound.h"
#include "simulator/tool/saw.h"

namespace hallux::simulator {

/// Constants of the coupling and of a blade in its slot, the patient's bone, and the guide.
/// source  docs/haptics.md
struct ContactSettings {
  /// Of the patient: the force that a rate needs, as a share of usual.
  double bone_quality = 1.0;
  double coupling_newton_per_mm = 2.0;
  double force_limit_newton = 30.0;
  /// Between hand and tool, as the coupling.
  double torsion_newton_mm_per_rad = 4000.0;
  double torque_limit_newton_mm = 500.0;
  /// Blade on bone, from rest.
  double friction = 0.3;
  /// Of it while the blade slides.
  double kinetic_ratio = 0.6;
  /// As friction, of running teeth that are not in a kerf yet.
  double tooth_friction = 2.0;
  /// Faster than the hand, the tool comes after it where bone gives way.
  double release_speed_mm_s = 200.0;
  /// A shallower touch is a scratch.
  double freeze_depth_mm = 0.3;
  /// Out of the plane, before the slot holds the blade.
  double slot_play_mm = 0.1;
  double slot_stiffness_newton_per_mm = 10.0;
  double slot_play_rad = 0.0087;
  /// Share of a tilt beyond the play that bends the blade.
  double slot_compliance = 0.1;
  /// Half a degree and 0.1 mm: the same plane again.
  double rejoin_angle_rad = 0.0087;
  double rejoin_offset_mm = 0.1;
  /// A thin blade bends into an open slot within 5 degrees and 0.5 mm.
  double capture_angle_rad = 0.0873;
  double capture_offset_mm = 0.5;
  /// Teeth over the slot that it takes.
  std::int32_t capture_teeth = 2;
  GuidePlan guide = {};
};

inline constexpr std::size_t tooth_count = 21;
/// A tooth takes its kerf's whole thickness: it is asked for bone in its middle and near both
/// sides.
inline constexpr std::size_t tooth_layers = 3;
/// Where the outer layers lie, as a share of the kerf: a little inside, so that they do not feel
/// the kerf's own walls.
inline constexpr double tooth_layer_share = 0.45;
using TeethMemory = std::array<TissueMemory, tooth_count * tooth_layers>;
/// Of the collar's middle and its two ends.
using CollarMemory = std::array<SurfaceMemory, 3>;

enum class ToolStage : std::int32_t { Free, Touching, InKerf };

struct ToolState {
  ToolStage stage = ToolStage::Free;
  RigidTransform bone_from_tool;
  /// In InKerf.
  std::int32_t kerf = -1;
  /// In Touching: how far the teeth went in.
  double touch_depth_mm = 0.0;
  /// In Touching: the deepest so far.
  double scratch_mm = 0.0;
  /// In InKerf: teeth stood in bone, and the blade went on since.
  bool may_break_through = false;
  /// In InKerf: since teeth stood in bone last.
  double drawn_back_mm = 0.0;
  /// In Touching: there is no kerf left, the teeth stay where they are.
  bool is_refused = false;
  /// In Free: bone stretched the spring, and it is not slack again.
  bool is_held = false;
  /// In InKerf: along the walls.
  bool slides = false;
  /// Of the last tick.
  RigidTransform bone_from_handle;
  bool knows_handle = false;
  OfFragments<TeethMemory> teeth{};
  OfFragments<BladeMemory> points{};
  OfFragments<CollarMemory> collar{};
  ProxyLoad load;
  KickState kick;
  /// How long the guide at hand has led it.
  double guided_s = 0.0;
};

struct ToolInput {
  /// The tool in the hand.
  const Saw& saw;
  RigidTransform bone_from_handle;
  bool saw_runs = false;
  double duration_s = 0.001;
  /// Of the step at hand; nothing where none leads.
  const GuidePlane* guide = nullptr;
  /// Teeth stand on metal: they rub, and cut nothing.
  bool is_on_metal = false;

  bool cuts() const noexcept { return saw_runs && !is_on_metal; }
};

struct ToolOutcome {
  /// Before the advance.
  Engagement engaged;
  /// On the hand.
  Vec3 force_in_bone_newton{0.0, 0.0, 0.0};
  /// On the hand, about the tool's origin.
  Vec3 torque_in_bone_newton_mm{0.0, 0.0, 0.0};
  /// Through bone, along the feed direction.
  double advance_mm = 0.0;
  /// Above 0: a touch ended without a kerf.
  double scratch_mm = 0.0;
  bool began_contact = false;
  /// The touch is deep enough for a kerf in the tool's plane.
  bool wants_freeze = false;
  /// The teeth left bone at the far side.
  bool broke_through = false;
  bool is_force_limited = false;
  /// A kick began.
  KickCause kicked = KickCause::None;
};

/// Moves the tool for one tick towards the handle.
/// needs   0 < duration_s <= 0.003
/// errors  none: total, allocates nothing
/// thread  haptic
ToolOutcome move_tool(ToolState& tool, const ToolInput& input, const Wound& bone,
                      const ContactSettings& settings) noexcept;

/// The kerf whose plane this pose may use again, or -1: the same plane within rejoin limits, or
/// enough teeth over what was swept there within capture limits.
std::int32_t find_kerf_to_join(const RigidTransform& bone_from_tool, const Wound& bone,
                               const ContactSettings& settings) noexcept;

/// Holds the tool to a kerf's plane from now on; it comes there gently.
void enter_kerf(ToolState& tool, std::int32_t kerf) noexcept;
/// No kerf holds the tool any more; outside of one nothing changes.
void leave_kerf(ToolState& tool) noexcept;

}  // namespace hallux::simulator
