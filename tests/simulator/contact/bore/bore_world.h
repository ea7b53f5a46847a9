/// A bone, a tool with a point and the bores that it makes, driven tick by tick as a step would:
/// for tests.
#pragma once

#include <utility>
#include <vector>

#include "simulator/contact/bore/bore_motion.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/mesh/bone.h"

namespace hallux::tests {

inline constexpr double coupling_newton_per_mm = 2.0;

/// The tool's pose with its tip at a point and its axis along a direction of length 1.
inline RigidTransform pointing(const Vec3& tip_mm, const Vec3& ahead) {
  const Vec3 hint = ahead.z * ahead.z < 0.5 ? Vec3{0.0, 0.0, 1.0} : Vec3{1.0, 0.0, 0.0};
  return {rotation_from_axes(ahead, hint), tip_mm};
}

class BoreWorld {
 public:
  explicit BoreWorld(simulator::Bone bone, const simulator::BoreTool& held = {})
      : tool(held), bone_(std::move(bone)) {}

  /// One tick with the handle at a pose; then what a step does with its outcome.
  simulator::BoreOutcome tick(const RigidTransform& wound_from_handle, bool drive_runs,
                              double duration_s = 0.001) {
    const simulator::BoreOutcome outcome = simulator::move_bore(
        state, {tool, wound_from_handle, drive_runs, duration_s, bores, {holes}, metal}, standing(),
        settings);
    if (outcome.found_bore >= 0 && state.stage != simulator::BoreStage::InBore)
      begin(
          simulator::widened(bores[static_cast<std::size_t>(outcome.found_bore)], tool.radius_mm));
    if (outcome.wants_bore)
      begin(simulator::begin_bore(state.wound_from_tool, state.touch_depth_mm, tool.radius_mm));
    if (state.stage == simulator::BoreStage::InBore) {
      const auto bore = static_cast<std::size_t>(state.bore);
      simulator::open_bore(bores[bore], state.wound_from_tool);
      holes[bore] = simulator::capsule_of(bores[bore]);
    }
    return outcome;
  }
  simulator::BoreOutcome hold(const RigidTransform& handle, bool drive_runs, int ticks) {
    simulator::BoreOutcome outcome;
    for (int i = 0; i < ticks; ++i) outcome = tick(handle, drive_runs);
    return outcome;
  }
  /// The handle goes straight from where it is to a pose.
  simulator::BoreOutcome glide(const RigidTransform& handle, bool drive_runs, int ticks) {
    const RigidTransform from =
        state.knows_handle ? state.wound_from_handle : state.wound_from_tool;
    simulator::BoreOutcome outcome;
    for (int i = 1; i <= ticks; ++i)
      outcome = tick(interpolate(from, handle, static_cast<double>(i) / ticks), drive_runs);
    return outcome;
  }
  /// A hand that keeps its push: the handle leads the tip by the stretch along the tool's axis.
  simulator::BoreOutcome push(double force_newton, bool drive_runs) {
    RigidTransform handle = state.wound_from_tool;
    handle.translation_mm += force_newton / coupling_newton_per_mm * axis_x(handle);
    return tick(handle, drive_runs);
  }

  /// Opens a kerf: the blade at a pose, fed along its x.
  void saw(const RigidTransform& wound_from_blade, double feed_mm) {
    const simulator::QuantisedPose frozen = simulator::quantise(wound_from_blade);
    simulator::ToolSample sample;
    sample.kerf = kerfs_.freeze(frozen);
    sample.status = static_cast<std::uint32_t>(simulator::ToolStatus::SawOn);
    for (const double fed_mm : {0.0, feed_mm}) {
      const RigidTransform fed{Quat{1.0, 0.0, 0.0, 0.0}, Vec3{fed_mm, 0.0, 0.0}};
      sample.world_from_tool =
          simulator::quantise(bone_.world_from_bone * simulator::transform_from(frozen) * fed);
      kerfs_.apply(sample);
    }
  }
  simulator::RemainingTissue standing() const { return {tissue_, kerfs_, {}}; }
  Vec3 tip_mm() const { return state.wound_from_tool.translation_mm; }

  simulator::BoreTool tool;
  simulator::BoreToolState state;
  simulator::ContactSettings settings;
  std::vector<simulator::Bore> bores;
  std::vector<simulator::Capsule> holes, metal;

 private:
  void begin(const simulator::Bore& bore) {
    bores.push_back(bore);
    holes.push_back(simulator::capsule_of(bore));
    simulator::enter_bore(state, static_cast<std::int32_t>(bores.size()) - 1);
  }

  simulator::Bone bone_;
  simulator::TissueMap tissue_{bone_};
  simulator::KerfSet kerfs_{{}, bone_.world_from_bone};
};

}  // namespace hallux::tests
