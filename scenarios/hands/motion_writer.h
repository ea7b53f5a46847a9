/// Writes a hand's motion key by key, at a steady rhythm, along straight ways in the blade's plane.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scenarios/hands/hand_skill.h"
#include "simulator/base/random.h"
#include "simulator/device/scripted.h"

namespace hallux::scenarios {

/// The wander of a hand: three slow waves with phases of their own, within +-1.
class Wander {
 public:
  explicit Wander(Random random);
  double at(double time_s) const;

 private:
  struct Wave {
    double rate_rad_s = 0.0, phase_rad = 0.0;
  };
  std::array<Wave, 3> waves_{};
};

/// Feed and place along the tooth line are those of the blade's plane [mm].
class MotionWriter {
 public:
  MotionWriter(const RigidTransform& world_from_blade, const HandSkill& skill, std::uint64_t seed);

  /// The first key.
  void place(double feed_mm, double along_mm);
  /// Into the plane of another cut, straight through the air; without wander and jitter from there on.
  void turn_to(const RigidTransform& world_from_blade, double feed_mm, double along_mm,
               double speed_mm_s);
  void go_to(double feed_mm, double along_mm, double speed_mm_s, double wander_from = 0.0,
             double wander_to = 0.0);
  /// Leads the teeth through their expected feed by the way that stretches the coupling to the push.
  void push_through(const std::vector<FeedMoment>& moments, double coupling_newton_per_mm);
  void wait(double time_s);
  void set_saw(bool runs) { saw_runs_ = runs; }
  void set_jitter(double out_mm, double tilt_rad);
  void say(simulator::CommandKind kind, std::int32_t argument = 0);
  simulator::HandMotion finish() { return std::move(motion_); }

 private:
  RigidTransform pose() const;
  void write_key();

  RigidTransform world_from_blade_;
  HandSkill skill_;
  Wander out_, tilt_x_, tilt_y_;
  simulator::HandMotion motion_;
  std::int64_t tick_ = 0;
  double feed_mm_ = 0.0, along_mm_ = 0.0, wander_ = 0.0;
  double jitter_mm_ = 0.0, jitter_rad_ = 0.0;
  bool saw_runs_ = false;
};

/// How fast a hand builds up its push, or eases the handle along [mm/s].
inline constexpr double lean_mm_s = 6.0;

}  // namespace hallux::scenarios
