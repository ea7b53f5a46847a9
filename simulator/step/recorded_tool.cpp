#include "simulator/step/recorded_tool.h"

#include <array>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

std::array<std::int32_t, 3> force_mn(const RecordedTick& at, const Vec3& in_bone_newton) noexcept {
  const Vec3 newton = transform_direction(at.world_from_bone, in_bone_newton);
  return {millinewton_from_newton(newton.x), millinewton_from_newton(newton.y),
          millinewton_from_newton(newton.z)};
}

/// Where a tool or a piece is, and what the hand feels of it.
ToolSample sample_at(const RecordedTick& at, const RigidTransform& bone_from_held,
                     const Vec3& force_in_bone_newton, bool is_force_limited) noexcept {
  ToolSample sample;
  sample.tick = at.tick;
  sample.world_from_tool = quantise(at.world_from_bone * bone_from_held);
  sample.force_mn = force_mn(at, force_in_bone_newton);
  mark(sample, ToolStatus::ForceLimited, is_force_limited);
  return sample;
}

}  // namespace

void mark(ToolSample& sample, ToolStatus status, bool is_so) noexcept {
  if (is_so) sample.status |= bit(status);
}

ToolSample sample_of(const RecordedTick& at, const ToolState& tool, const ToolInput& input,
                     const ToolOutcome& outcome, std::int32_t kerf) noexcept {
  ToolSample sample =
      sample_at(at, tool.bone_from_tool, outcome.force_in_bone_newton, outcome.is_force_limited);
  sample.kerf = kerf;
  mark(sample, ToolStatus::SawOn, input.saw_runs);
  mark(sample, ToolStatus::InKerf, tool.stage == ToolStage::InKerf);
  mark(sample, ToolStatus::InContact, outcome.engaged.width_mm() > 0.0);
  mark(sample, ToolStatus::Cutting, outcome.advance_mm > 0.0);
  return sample;
}

ToolSample sample_of(const RecordedTick& at, const BoreToolState& tool, const BoreInput& input,
                     const BoreOutcome& outcome) noexcept {
  ToolSample sample =
      sample_at(at, tool.wound_from_tool, outcome.force_in_wound_newton, outcome.is_force_limited);
  mark(sample, ToolStatus::DriveOn, input.drive_runs);
  mark(sample, ToolStatus::InBore, tool.stage == BoreStage::InBore);
  mark(sample, ToolStatus::InContact, outcome.engaged.width_mm() > 0.0);
  mark(sample, ToolStatus::Boring, outcome.advance_mm > 0.0);
  return sample;
}

ToolSample sample_of(const RecordedTick& at, const RigidTransform& bone_from_piece,
                     const GrippedOutcome& outcome) noexcept {
  ToolSample sample =
      sample_at(at, bone_from_piece, outcome.pull.force_newton, outcome.pull.is_force_limited);
  mark(sample, ToolStatus::InContact, outcome.is_touching);
  return sample;
}

}  // namespace hallux::simulator
