/// Distances are exact: blade and capsule are a rectangle and a line with thicknesses taken off
/// afterwards, and their nearest points lie at an end, on an edge, or where they cross. A contact
/// begins at once and ends with a margin and a wait, so that a trembling hand tells one contact.
#include "simulator/contact/danger_zone.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/check.h"
#include "simulator/base/segment.h"
#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// The blade's rectangle in the tool frame: x in [-depth, 0], y within half the width, z = 0.
struct Rectangle {
  double depth_mm, half_width_mm;

  Vec3 nearest(const Vec3& point_mm) const noexcept {
    return {std::clamp(point_mm.x, -depth_mm, 0.0),
            std::clamp(point_mm.y, -half_width_mm, half_width_mm), 0.0};
  }
  bool is_crossed_by(const Segment& segment) const noexcept {
    if ((segment.from.z > 0.0) == (segment.to.z > 0.0)) return false;
    const double share = segment.from.z / (segment.from.z - segment.to.z);
    const Vec3 point = segment.from + share * (segment.to - segment.from);
    return point.x >= -depth_mm && point.x <= 0.0 && std::abs(point.y) <= half_width_mm;
  }
};

/// The nearest pair lies at an end of the segment or on an edge of the rectangle, unless they
/// cross.
double distance_mm(const Rectangle& blade, const Segment& segment) noexcept {
  if (blade.is_crossed_by(segment)) return 0.0;
  double least_mm2 = std::min(squared_length(segment.from - blade.nearest(segment.from)),
                              squared_length(segment.to - blade.nearest(segment.to)));
  const Vec3 front_low{0.0, -blade.half_width_mm, 0.0}, front_high{0.0, blade.half_width_mm, 0.0};
  const Vec3 back{-blade.depth_mm, 0.0, 0.0};
  for (const Segment& edge :
       {Segment{front_low, front_high}, Segment{front_low + back, front_high + back},
        Segment{front_low, front_low + back}, Segment{front_high, front_high + back}}) {
    least_mm2 = std::min(least_mm2, squared_distance_mm2(segment, edge));
  }
  return std::sqrt(least_mm2);
}

}  // namespace

double distance_to_capsule_mm(const RigidTransform& bone_from_tool, const Blade& blade,
                              const DangerCapsule& capsule) noexcept {
  const RigidTransform tool_from_bone = inverse(bone_from_tool);
  const Segment line{transform_point(tool_from_bone, capsule.from_in_bone_mm),
                     transform_point(tool_from_bone, capsule.to_in_bone_mm)};
  return distance_mm({blade.depth_mm, 0.5 * blade.width_mm}, line) - capsule.radius_mm -
         0.5 * blade.kerf_mm;
}

double distance_to_capsule_mm(const RigidTransform& bone_from_tool, const DangerShaft& shaft,
                              const DangerCapsule& capsule) noexcept {
  const Vec3 tip_mm = bone_from_tool.translation_mm;
  const Segment axis{tip_mm - shaft.length_mm * axis_x(bone_from_tool), tip_mm};
  const Segment line{capsule.from_in_bone_mm, capsule.to_in_bone_mm};
  return std::sqrt(squared_distance_mm2(axis, line)) - capsule.radius_mm - shaft.radius_mm;
}

DangerWatch::DangerWatch(const RigidTransform& world_from_bone, const Blade& blade,
                         std::span<const DangerCapsule> zones)
    : bone_from_world_(inverse(world_from_bone)),
      blade_(blade),
      zones_(zones),
      tracks_(zones.size()),
      pending_(zones.size()) {
  CHECK(zones.size() <= danger_zone_limit);
}

void DangerWatch::apply(const ToolSample& sample) noexcept {
  const std::int64_t ticks =
      std::clamp<std::int64_t>(sample.tick - last_tick_, 0, ticks_per_line_max);
  last_tick_ = sample.tick;
  const bool is_running =
      has(sample.status, ToolStatus::Running) &&
      (has(sample.status, ToolStatus::SawOn) || has(sample.status, ToolStatus::DriveOn));
  const RigidTransform bone_from_tool = bone_from_world_ * transform_from(sample.world_from_tool);
  for (std::size_t zone = 0; zone < zones_.size(); ++zone) {
    if (is_running) {
      approach(zone, distance_mm(bone_from_tool, zone), ticks);
    } else {
      move_away(zone, ticks);
    }
  }
}

void DangerWatch::approach(std::size_t zone, double distance_mm, std::int64_t ticks) noexcept {
  DangerTrack& track = tracks_[zone];
  Pending& pending = pending_[zone];
  track.least_mm = std::min(track.least_mm, distance_mm);
  if (distance_mm <= 0.0) track.contact_s += static_cast<double>(ticks) * step_s;
  if (track.state == DangerState::Contact) {
    track.contact_least_mm = std::min(track.contact_least_mm, distance_mm);
    if (distance_mm > danger_margin_mm) {
      move_away(zone, ticks);
    } else {
      pending.away_ticks = 0;
    }
    return;
  }
  // The end of the contact before must be taken first, else a zone could have two to tell.
  if (distance_mm <= 0.0 && !pending.has_ended) {
    track.state = DangerState::Contact;
    track.contact_least_mm = distance_mm;
    ++track.contacts;
    pending = {0, distance_mm, true, false};
    ++waiting_;
    return;
  }
  const double near_mm =
      danger_near_mm + (track.state == DangerState::Near ? danger_margin_mm : 0.0);
  track.state = distance_mm <= near_mm ? DangerState::Near : DangerState::Far;
}

void DangerWatch::move_away(std::size_t zone, std::int64_t ticks) noexcept {
  DangerTrack& track = tracks_[zone];
  Pending& pending = pending_[zone];
  if (track.state == DangerState::Contact) {
    pending.away_ticks += ticks;
    if (pending.away_ticks < danger_leave_ticks) return;
    pending.has_ended = true;
    ++waiting_;
  }
  track.state = DangerState::Far;
}

bool DangerWatch::take_news(DangerNews& news) noexcept {
  if (waiting_ == 0) return false;
  for (std::size_t zone = 0; zone < zones_.size(); ++zone) {
    Pending& pending = pending_[zone];
    if (!pending.has_begun && !pending.has_ended) continue;
    news.zone = static_cast<std::int32_t>(zone);
    news.has_begun = pending.has_begun;
    news.distance_mm = pending.has_begun ? pending.began_mm : tracks_[zone].contact_least_mm;
    (pending.has_begun ? pending.has_begun : pending.has_ended) = false;
    --waiting_;
    return true;
  }
  return false;
}

}  // namespace hallux::simulator
