#include "tests/scenarios/hands/hand_trace.h"

#include <algorithm>
#include <cmath>

#include "scenarios/simulation_setup.h"
#include "simulator/base/units.h"
#include "simulator/loop/jobs.h"
#include "simulator/record/sample_force.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::tests {

namespace {

using simulator::Simulation;
using simulator::ToolSample;
using simulator::ToolStatus;

double hottest_celsius(const Simulation& simulation) {
  constexpr std::int32_t half = simulator::heat_cells / 2;
  double hottest = simulator::body_celsius;
  for (std::int32_t kerf = 0; kerf < simulation.kerfs().count(); ++kerf) {
    for (std::int32_t u = -half; u < half; ++u) {
      for (std::int32_t v = -half; v < half; ++v) {
        const Vec2 middle_mm = simulator::heat_cell_mm * Vec2(u + 0.5, v + 0.5);
        hottest = std::max(hottest, simulation.effects().heat().celsius_at(kerf, middle_mm));
      }
    }
  }
  return hottest;
}

/// Follows the samples of an attempt in the plane that the hand aimed at first.
class Tracer {
 public:
  explicit Tracer(const RigidTransform& plane_from_world, const simulator::SectionRegion& region)
      : plane_from_world_(plane_from_world), region_(region) {
    trace_.bone_mm = region.max_mm.x - region.min_mm.x;
  }

  void add(const ToolSample& sample, const Simulation& simulation) {
    const RigidTransform plane_from_tool =
        plane_from_world_ * simulator::transform_from(sample.world_from_tool);
    const Vec3 force = simulator::force_newton(sample);
    const double push_newton = std::max(0.0, -transform_direction(plane_from_world_, force).x);
    next_.push_newton = std::max(next_.push_newton, push_newton);
    next_.is_rinsed = next_.is_rinsed || has(sample.status, ToolStatus::Irrigated);
    trace_.peak_newton = std::max(trace_.peak_newton, std::sqrt(glm::dot(force, force)));
    const double depth_mm = plane_from_tool.translation_mm.x - region_.min_mm.x;
    trace_.beyond_mm = std::max(trace_.beyond_mm, depth_mm - trace_.bone_mm);
    if (has(sample.status, ToolStatus::Cutting)) {
      trace_.cut_s += step_s;
      if (!has(sample.status, ToolStatus::Irrigated)) trace_.dry_s += step_s;
    }
    if (sample.tick % ticks_per_moment != 0) return;
    next_.time_s = second_from_tick(sample.tick);
    next_.depth_mm = depth_mm;
    next_.hottest_celsius = hottest_celsius(simulation);
    trace_.moments.push_back(next_);
    next_ = {};
  }

  HandTrace finish(const Simulation& simulation) {
    const simulator::HeatSummary& heat = simulation.effects().heat().summary();
    trace_.hot_s = heat.hot_s;
    trace_.hottest_celsius = heat.hottest_celsius;
    trace_.necrotic_mm3 = heat.necrotic_mm3;
    for (const simulator::DangerTrack& zone : simulation.effects().danger().tracks()) {
      trace_.zone_contacts += zone.contacts;
      trace_.zone_s += zone.contact_s;
    }
    return trace_;
  }

 private:
  RigidTransform plane_from_world_;
  simulator::SectionRegion region_;
  HandMoment next_;
  HandTrace trace_;
};

}  // namespace

/// The attempt is recorded, then stepped through again: heat and zones are not in the record.
HandTrace trace_hand(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                     const scenarios::Plan& plan, scenarios::FeelingHand& hand) {
  const simulator::Recording recording = run_hand(scenario, bone, plan, hand).recording;
  const simulator::TissueMap tissue(bone);
  const simulator::SimulationSetup setup =
      simulation_setup(scenario, bone, plan, simulator::Guidance::None);
  Simulation simulation(tissue, setup);
  simulator::ImmediateJobs jobs(bone, setup.tray, setup.bridges);
  const scenarios::AimedCut& aimed = hand.cuts().at(0);
  Tracer tracer(inverse(bone.world_from_bone * aimed.plane.bone_from_kerf), aimed.region);
  for (const simulator::TapeLine& line : recording.tape) {
    simulator::StepInput input{line, {}};
    for (std::size_t i = 0; i < line.command_count; ++i) {
      if (line.commands[i].kind == simulator::CommandKind::ApplyJob) {
        input.job_results[i] = jobs.take_ready();
      }
    }
    const simulator::StepOutput output = simulation.step(input);
    jobs.apply(output);
    tracer.add(output.sample, simulation);
  }
  return tracer.finish(simulation);
}

}  // namespace hallux::tests
