#include "tests/assessment/block_attempt.h"

#include <cmath>

#include "simulator/base/units.h"

namespace hallux::assessment::testing {

using simulator::Bone;
using simulator::CutEventKind;
using simulator::Recording;
using simulator::ToolStatus;

namespace {

/// Of the hand, against the feed.
constexpr double push_newton = 9.0;

constexpr double feed_mm = 0.05;
constexpr double first_y_mm = 9.7;

simulator::IndexedMesh block_mesh() {
  simulator::IndexedMesh mesh;
  for (const double x : {0.0, 60.0}) {
    for (const double y : {-10.0, 10.0}) {
      for (const double z : {-12.0, 8.0}) mesh.points_mm.emplace_back(x, y, z);
    }
  }
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return mesh;
}

/// Teeth down, tooth line along the block, blade normal lateral and turned about the feed
/// direction.
RigidTransform bone_from_tool(const Stroke& stroke, double y_mm) {
  const Vec3 along{std::cos(stroke.tilt_rad), 0.0, std::sin(stroke.tilt_rad)};
  const Vec3 blade_normal{-along.z, 0.0, along.x};
  const Vec3 middle_of_face{30.0, y_mm, stroke.face_z_mm};
  return {rotation_from_axes(Vec3{0.0, -1.0, 0.0}, along),
          middle_of_face - 0.5 * kerf_mm * blade_normal};
}

scenarios::RubricItem item(const char* id, const char* metric, const char* unit, int weight,
                           double full, double zero) {
  scenarios::RubricItem made;
  made.id = id;
  made.title = id;
  made.group = "accuracy";
  made.metric = metric;
  made.cut = "eminence";
  made.unit = unit;
  made.weight_milli = weight * 1000;
  made.full = full;
  made.zero = zero;
  return made;
}

scenarios::Gate gate(const char* name, const char* metric, int cap) {
  scenarios::Gate made;
  made.name = name;
  made.title = name;
  made.metric = metric;
  made.cut = "eminence";
  made.unit = "mm";
  made.limit = 1.0;
  made.cap_milli = cap * 1000;
  return made;
}

}  // namespace

Bone block_bone() {
  Bone bone;
  bone.name = "block";
  bone.outer = block_mesh();
  bone.landmarks = {{"axis_proximal", Vec3{0.0, 0.0, 0.0}},
                    {"axis_distal", Vec3{60.0, 0.0, 0.0}},
                    {"sulcus", Vec3{50.0, 10.0, -7.0}},
                    {"exit", Vec3{10.0, 0.0, -8.0}}};
  bone.world_from_bone = {rotation_about(Vec3{0.0, 0.0, 1.0}, radian_from_degree(30.0)),
                          Vec3{100.0, 50.0, -20.0}};
  return bone;
}

scenarios::Scenario block_scenario() {
  scenarios::Scenario scenario;
  scenario.name = "block";
  scenario.title = "Block";
  scenario.saw.blade = {70.0, 40.0, kerf_mm};
  scenario.cuts.resize(1);
  scenarios::ReferenceCut& cut = scenario.cuts.front();
  cut.name = "eminence";
  cut.title = "Eminence";
  cut.face = {"sulcus", "axis_proximal", "axis_distal", 1.0, 0.0};
  cut.waste_side = "medial";
  cut.approach = "dorsal";
  cut.depth_landmark = "sulcus";
  cut.exit_landmark = "exit";
  scenario.steps = {{scenarios::StepKind::Cut, "Cut", "", "eminence", ""},
                    {scenarios::StepKind::Remove, "Remove", "", "eminence", ""}};
  scenario.rubric.groups = {{"accuracy", "Accuracy", 50000, ""}, {"safety", "Safety", 50000, ""}};
  scenario.rubric.items = {
      item("A1", "angle_deg", "deg", 16, 1.0, 8.0), item("A2", "location_mm", "mm", 16, 0.5, 3.0),
      item("A3", "depth_mm", "mm", 10, 0.5, 2.5), item("A4", "step_mm", "mm", 5, 0.2, 1.5),
      item("A5", "flatness_mm", "mm", 3, 0.1, 1.0)};
  scenario.rubric.gates = {gate("past_sulcus", "past_landmark_mm", 59),
                           gate("shaft_notch", "notch_mm", 69)};
  return scenario;
}

void add_stroke(Recording& recording, const Bone& bone, const Stroke& stroke) {
  std::int64_t tick = recording.samples.empty() ? 10 : recording.samples.back().tick + 100;
  std::int32_t kerf = 0;
  for (const simulator::CutEvent& event : recording.events) {
    kerf += event.kind == CutEventKind::PlaneFrozen ? 1 : 0;
  }
  simulator::CutEvent frozen;
  frozen.tick = tick;
  frozen.kind = CutEventKind::PlaneFrozen;
  frozen.subject = kerf;
  frozen.pose = simulator::quantise(bone_from_tool(stroke, first_y_mm));
  recording.events.push_back(frozen);
  for (double y_mm = first_y_mm; y_mm > stroke.last_y_mm; y_mm -= feed_mm) {
    simulator::ToolSample sample;
    sample.tick = tick++;
    sample.world_from_tool =
        simulator::quantise(bone.world_from_bone * bone_from_tool(stroke, y_mm));
    sample.status = static_cast<std::uint32_t>(ToolStatus::SawOn) |
                    static_cast<std::uint32_t>(ToolStatus::InKerf) |
                    static_cast<std::uint32_t>(ToolStatus::Cutting);
    sample.kerf = kerf;
    const Vec3 force_newton =
        transform_direction(bone.world_from_bone, Vec3{0.0, push_newton, 0.0});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sample.force_mn[axis] =
          millinewton_from_newton(force_newton[static_cast<glm::length_t>(axis)]);
    }
    recording.samples.push_back(sample);
  }
}

void add_removal(Recording& recording, const Vec3& inside_mm) {
  simulator::CutEvent removed;
  removed.tick = recording.samples.empty() ? 1 : recording.samples.back().tick + 1;
  removed.kind = CutEventKind::PieceRemoved;
  removed.subject = 1;
  removed.pose = simulator::quantise({Quat{1.0, 0.0, 0.0, 0.0}, inside_mm});
  recording.events.push_back(removed);
}

}  // namespace hallux::assessment::testing
