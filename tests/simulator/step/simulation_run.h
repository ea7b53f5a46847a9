/// An operation driven by hand, tick by tick, as the loop drives it in virtual time: for tests.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "simulator/loop/jobs.h"
#include "simulator/mesh/bone.h"
#include "simulator/record/record.h"
#include "simulator/step/simulation.h"

namespace hallux::tests {

/// Turned and far from the origin, so that no product of a test's arithmetic is exact by luck.
RigidTransform slanted_place();

/// Soft bone all through: a cortex thinner than any tooth's depth.
simulator::Bone cancellous_bone(simulator::IndexedMesh outer);
/// Hard bone all through.
simulator::Bone cortical_bone(simulator::IndexedMesh outer);

/// A blade above the bone: feeds towards -y, tooth line along z, plane x = tip.x; `lean_rad` turns
/// it about its feed direction.
RigidTransform blade_down(const Vec3& tip_in_bone_mm, double lean_rad = 0.0);

inline constexpr std::uint32_t saw_runs = static_cast<std::uint32_t>(simulator::Switch::SawRuns);

/// Steps a Simulation and its jobs, and keeps all that came in and out.
class SimulationRun {
 public:
  /// Starts with the blade at `bone_from_handle`. Borrows `bone`.
  SimulationRun(const simulator::Bone& bone, const RigidTransform& bone_from_handle,
                const simulator::Tray& tray = {}, const simulator::ContactSettings& settings = {},
                const std::vector<simulator::DangerCapsule>& danger_zones = {})
      : SimulationRun({bone, tray, settings, {}, danger_zones}, bone_from_handle) {}
  /// Poses are in the first bone's frame. Borrows the bones.
  SimulationRun(const simulator::SimulationSetup& setup, const RigidTransform& bone_from_handle);

  /// One line of the tape with the handle where it was last.
  simulator::StepOutput step(std::initializer_list<simulator::Command> commands = {});
  /// The handle goes straight to the pose in that many lines.
  simulator::StepOutput glide(const RigidTransform& bone_from_handle, std::int64_t lines);
  /// The handle stays for that many lines.
  simulator::StepOutput hold(std::int64_t lines);

  std::uint32_t switches = saw_runs;
  std::uint32_t faults = 0;
  std::uint8_t ticks_per_line = 1;
  bool applies_jobs = true;

  const simulator::Recording& recording() const noexcept { return recording_; }
  const simulator::Simulation& simulation() const noexcept { return simulation_; }
  const simulator::ImmediateJobs& jobs() const noexcept { return jobs_; }
  const std::vector<simulator::JobRequest>& requests() const noexcept { return requests_; }
  std::vector<simulator::CutEvent> events(simulator::CutEventKind kind) const;
  /// The recorded tool of the last line, in the bone frame.
  RigidTransform bone_from_tool() const;
  Vec3 force_in_bone_newton() const;

 private:
  const simulator::Bone& bone_;
  simulator::TissueMaps tissues_;
  simulator::Simulation simulation_;
  simulator::WholeBones whole_;
  simulator::ImmediateJobs jobs_;
  simulator::Recording recording_;
  std::vector<simulator::JobRequest> requests_;
  RigidTransform bone_from_handle_;
  std::int64_t tick_ = 0;
};

/// What happened, in order.
std::vector<simulator::CutEventKind> kinds_of(const simulator::Recording& recording);

}  // namespace hallux::tests
