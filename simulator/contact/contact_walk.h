/// A tick's way of a tool that bone holds out: gone in parts of a quarter of a millimetre near
/// bone, with contacts looked for anew in each. For blades and for whatever bores.
/// Inside this room only.
///
/// In one part a fast hand would slide around an edge that it should have met.
#pragma once

#include <algorithm>

#include "simulator/contact/proxy.h"

namespace hallux::simulator {

/// Near bone a tick's way is gone in parts of this, and contacts are looked for anew.
inline constexpr double walk_part_mm = 0.25;
inline constexpr int walk_part_limit = 6;

/// What a tick's way came to: the contacts at its end, and how the teeth stood to the bone.
struct Walk {
  /// Gaps as they are at the end of the way.
  BladeContacts contacts;
  ProxyResult proxy;
  /// By which teeth that stood on bone came away from it.
  double lifted_mm = 0.0;
};

/// The way of a tool's points in a motion, at most, where they reach `lever_mm` from its origin.
double reach_of(const ProxyMotion& motion, double lever_mm) noexcept;
ProxyMotion scaled(const ProxyMotion& motion, double share) noexcept;
/// How far the teeth that stand on bone come away from it, all of them.
double lifted_mm(const BladeContacts& contacts, const ProxyMotion& motion) noexcept;
void move_contacts(BladeContacts& contacts, const ProxyMotion& motion) noexcept;
/// How far a tool may go ahead, at most `wanted_mm`, before what is no tooth would be in bone.
double room_ahead_mm(const BladeContacts& contacts, const Vec3& ahead, double wanted_mm) noexcept;
/// Whether no tooth is near bone any more: a touch is over.
bool teeth_are_clear(const BladeContacts& contacts) noexcept;

/// Moves the tool towards the handle by at most `travel_limit_mm`.
/// find(pose, look_mm)      the contacts within that distance
/// solve(wanted, contacts)  the proxy's motion
template <typename Find, typename Solve>
Walk walk_towards(RigidTransform& bone_from_tool, const RigidTransform& bone_from_handle,
                  double lever_mm, double travel_limit_mm, const Find& find,
                  const Solve& solve) noexcept {
  Walk walked;
  double left_mm = travel_limit_mm;
  for (int part = 0; part < walk_part_limit; ++part) {
    const ProxyMotion wanted = motion_between(bone_from_tool, bone_from_handle);
    const double look_mm = std::max(walk_part_mm, std::min(left_mm, reach_of(wanted, lever_mm)));
    walked.contacts = find(bone_from_tool, look_mm);
    walked.proxy = solve(wanted, walked.contacts);
    const double way_mm = reach_of(walked.proxy.motion, lever_mm);
    const double most_mm = walked.contacts.count == 0 ? left_mm : std::min(left_mm, walk_part_mm);
    if (walked.contacts.count == 0 && way_mm <= most_mm) {
      bone_from_tool = bone_from_handle;
      break;
    }
    const ProxyMotion motion =
        scaled(walked.proxy.motion, way_mm > most_mm ? most_mm / way_mm : 1.0);
    walked.lifted_mm += lifted_mm(walked.contacts, motion);
    bone_from_tool = moved_by(bone_from_tool, motion);
    move_contacts(walked.contacts, motion);
    left_mm -= std::min(way_mm, most_mm);
    if (way_mm <= most_mm || !(left_mm > 0.0)) break;
  }
  return walked;
}

}  // namespace hallux::simulator
