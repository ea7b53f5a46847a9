#include "tests/simulator/step/simulation_run.h"

#include "simulator/record/sample_force.h"

namespace hallux::tests {

using simulator::Bone;
using simulator::Command;
using simulator::CommandKind;
using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::JobResult;
using simulator::StepInput;
using simulator::StepOutput;
using simulator::TapeLine;

RigidTransform slanted_place() {
  return {rotation_about(Vec3{1.0, 2.0, -2.0} / 3.0, 0.7), Vec3{41.3, -17.9, 23.7}};
}

Bone cortical_bone(simulator::IndexedMesh outer) {
  Bone bone;
  bone.name = "test_bone";
  bone.outer = std::move(outer);
  bone.world_from_bone = slanted_place();
  return bone;
}

Bone cancellous_bone(simulator::IndexedMesh outer) {
  Bone bone = cortical_bone(std::move(outer));
  bone.cortex = simulator::CortexLaw{.mid_mm = 1.0e-6, .floor_mm = 1.0e-6};
  return bone;
}

RigidTransform blade_down(const Vec3& tip_in_bone_mm, double lean_rad) {
  const Quat upright = rotation_from_axes(Vec3{0.0, -1.0, 0.0}, Vec3{0.0, 0.0, 1.0});
  return {upright * rotation_about(Vec3{1.0, 0.0, 0.0}, lean_rad), tip_in_bone_mm};
}

SimulationRun::SimulationRun(const simulator::SimulationSetup& setup,
                             const RigidTransform& bone_from_handle)
    : bone_(setup.bone),
      tissues_(setup.bones()),
      simulation_(tissues_.all(), setup),
      whole_(setup),
      jobs_(whole_.all(), setup.tray, setup.bridges),
      bone_from_handle_(bone_from_handle) {
  step({{CommandKind::Start, 0, 0}});
}

StepOutput SimulationRun::step(std::initializer_list<Command> commands) {
  TapeLine line;
  line.tick = tick_;
  line.ticks = ticks_per_line;
  line.device = {simulator::quantise(bone_.world_from_bone * bone_from_handle_), switches, faults};
  StepInput input{line, {}};
  for (const Command& command : commands) line.commands[line.command_count++] = command;
  while (applies_jobs && line.command_count < simulator::commands_per_tick) {
    JobResult* const result = jobs_.take_ready();
    if (result == nullptr) break;
    input.job_results[line.command_count] = result;
    line.commands[line.command_count++] = {CommandKind::ApplyJob, result->request.id,
                                           result->request.tick};
  }
  const StepOutput output = simulation_.step(input);
  recording_.tape.push_back(line);
  recording_.samples.push_back(output.sample);
  recording_.events.insert(recording_.events.end(), output.events.begin(), output.events.end());
  requests_.insert(requests_.end(), output.requests.begin(), output.requests.end());
  jobs_.apply(output);
  tick_ += line.ticks;
  return output;
}

StepOutput SimulationRun::glide(const RigidTransform& bone_from_handle, std::int64_t lines) {
  const RigidTransform from = bone_from_handle_;
  StepOutput output;
  for (std::int64_t i = 1; i <= lines; ++i) {
    bone_from_handle_ =
        interpolate(from, bone_from_handle, static_cast<double>(i) / static_cast<double>(lines));
    output = step();
  }
  return output;
}

StepOutput SimulationRun::hold(std::int64_t lines) { return glide(bone_from_handle_, lines); }

std::vector<CutEvent> SimulationRun::events(CutEventKind kind) const {
  std::vector<CutEvent> found;
  for (const CutEvent& event : recording_.events) {
    if (event.kind == kind) found.push_back(event);
  }
  return found;
}

RigidTransform SimulationRun::bone_from_tool() const {
  return inverse(bone_.world_from_bone) * transform_from(recording_.samples.back().world_from_tool);
}

Vec3 SimulationRun::force_in_bone_newton() const {
  return transform_direction(inverse(bone_.world_from_bone),
                             simulator::force_newton(recording_.samples.back()));
}

std::vector<CutEventKind> kinds_of(const simulator::Recording& recording) {
  std::vector<CutEventKind> kinds;
  for (const CutEvent& event : recording.events) kinds.push_back(event.kind);
  return kinds;
}

}  // namespace hallux::tests
