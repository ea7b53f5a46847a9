/// Structures that must not be touched, as capsules; and how near a running tool comes to them.
///
///     Far <--- 3 mm, 3.5 mm back ---> Near <--- 0 mm, 0.5 mm back for 0.2 s ---> Contact
///
/// A tool at rest touches nothing: without the saw running each zone is Far. Margins and the wait
/// keep a trembling hand from telling the same contact many times.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "simulator/base/fixed_array.h"
#include "simulator/cutting/field/kerf.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

/// All points within `radius_mm` of the line between two points.
struct DangerCapsule {
  Vec3 from_in_bone_mm{0.0, 0.0, 0.0}, to_in_bone_mm{0.0, 0.0, 0.0};
  double radius_mm = 1.0;
};

/// From the blade (tooth line, faces, edges; half a kerf thick to all sides) to the capsule;
/// negative: how deep it is in, at most radius and half kerf [mm].
double distance_to_capsule_mm(const RigidTransform& bone_from_tool, const Blade& blade,
                              const DangerCapsule& capsule) noexcept;

/// What a tool with a point reaches into the wound: from its tip back.
struct DangerShaft {
  double length_mm = 10.0;
  double radius_mm = 0.5;
};

/// From the shaft to the capsule; negative: how deep it is in [mm].
double distance_to_capsule_mm(const RigidTransform& bone_from_tool, const DangerShaft& shaft,
                              const DangerCapsule& capsule) noexcept;

inline constexpr std::size_t danger_zone_limit = 64;
inline constexpr double danger_near_mm = 3.0;
inline constexpr double danger_margin_mm = 0.5;
inline constexpr std::int64_t danger_leave_ticks = 200;

enum class DangerState : std::uint8_t { Far, Near, Contact };

/// One zone in an attempt so far; all of it with the saw running.
struct DangerTrack {
  DangerState state = DangerState::Far;
  double least_mm = std::numeric_limits<double>::infinity();
  /// Of the contact now, or the last one.
  double contact_least_mm = 0.0;
  /// Time at or below 0 mm.
  double contact_s = 0.0;
  std::int32_t contacts = 0;
};

/// A contact began (with the distance then), or is over (with the least distance in it).
struct DangerNews {
  std::int32_t zone = 0;
  bool has_begun = true;
  double distance_mm = 0.0;
};

class DangerWatch {
 public:
  /// Takes all its memory here.
  /// needs   at most danger_zone_limit zones
  DangerWatch(const RigidTransform& world_from_bone, const Blade& blade,
              std::span<const DangerCapsule> zones);

  /// Another tool is in the hand from now on.
  void hold(const Blade& blade) noexcept {
    blade_ = blade;
    shaft_.reset();
  }
  void hold(const DangerShaft& shaft) noexcept { shaft_ = shaft; }

  /// Follows the record by one sample.
  /// errors  none: total, allocates nothing
  /// thread  haptic (and, on its own copy, assessment)
  void apply(const ToolSample& sample) noexcept;

  /// What happened and was not taken yet; of one zone its beginning before its end.
  bool take_news(DangerNews& news) noexcept;
  std::span<const DangerTrack> tracks() const noexcept { return tracks_; }

 private:
  struct Pending {
    std::int64_t away_ticks = 0;
    double began_mm = 0.0;
    bool has_begun = false, has_ended = false;
  };

  double distance_mm(const RigidTransform& bone_from_tool, std::size_t zone) const noexcept {
    return shaft_ ? distance_to_capsule_mm(bone_from_tool, *shaft_, zones_[zone])
                  : distance_to_capsule_mm(bone_from_tool, blade_, zones_[zone]);
  }
  void approach(std::size_t zone, double distance_mm, std::int64_t ticks) noexcept;
  void move_away(std::size_t zone, std::int64_t ticks) noexcept;

  RigidTransform bone_from_world_;
  Blade blade_;
  /// In place of the blade.
  std::optional<DangerShaft> shaft_;
  FixedArray<DangerCapsule> zones_;
  FixedArray<DangerTrack> tracks_;
  FixedArray<Pending> pending_;
  std::int64_t last_tick_ = -1;
  std::int32_t waiting_ = 0;
};

}  // namespace hallux::simulator
