#include "tests/assessment/akin_attempt.h"

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
constexpr double first_z_mm = -7.2;
constexpr std::uint32_t segments = 256;

simulator::IndexedMesh oval_prism() {
  simulator::IndexedMesh mesh;
  for (const double x_mm : {0.0, 27.0}) {
    for (std::uint32_t i = 0; i < segments; ++i) {
      const double angle_rad = 2.0 * pi * i / segments;
      mesh.points_mm.emplace_back(x_mm, 6.25 * std::sin(angle_rad), 7.5 * std::cos(angle_rad));
    }
  }
  const std::uint32_t base = 2 * segments, end = base + 1;
  mesh.points_mm.emplace_back(0.0, 0.0, 0.0);
  mesh.points_mm.emplace_back(27.0, 0.0, 0.0);
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t j = (i + 1) % segments;
    mesh.triangles.push_back({base, i, j});
    mesh.triangles.push_back({end, segments + j, segments + i});
    mesh.triangles.push_back({i, segments + i, segments + j});
    mesh.triangles.push_back({i, segments + j, j});
  }
  return mesh;
}

/// The finished face through (x, 0, z), its normal distal.
struct Face {
  Vec3 normal{1.0, 0.0, 0.0}, point_mm{0.0, 0.0, 0.0};

  double x_at(double z_mm) const noexcept {
    return point_mm.x - normal.z / normal.x * (z_mm - point_mm.z);
  }
};

Face face_through(double x_mm, double z_mm, double transverse_deg, double sagittal_deg) {
  const Vec3 normal{1.0, std::tan(radian_from_degree(sagittal_deg)),
                    std::tan(radian_from_degree(transverse_deg))};
  return {glm::normalize(normal), Vec3{x_mm, 0.0, z_mm}};
}

struct Blade {
  Face face;
  double waste = 1.0;  ///< +1 where the waste lies along the normal
  double kerf_mm = 0.5;
};

RigidTransform bone_from_tool(const Blade& blade, double z_mm) {
  const Vec3& normal = blade.face.normal;
  const Vec3 lateral{0.0, 0.0, 1.0};
  const Vec3 feed = glm::normalize(lateral - normal.z * normal);
  const Vec3 middle = blade.face.point_mm + 0.5 * blade.waste * blade.kerf_mm * normal;
  const double x_mm = Face{normal, middle}.x_at(z_mm) - normal.y / normal.x * (0.0 - middle.y);
  return {rotation_from_axes(feed, glm::cross(normal, feed)), Vec3{x_mm, 0.0, z_mm}};
}

void add_stroke(Recording& recording, const Bone& bone, const Blade& blade, double reach_mm) {
  std::int64_t tick = recording.samples.empty() ? 10 : recording.samples.back().tick + 100;
  simulator::CutEvent frozen;
  frozen.tick = tick;
  frozen.kind = CutEventKind::PlaneFrozen;
  frozen.subject = static_cast<std::int32_t>(recording.events.size());
  frozen.pose = simulator::quantise(bone_from_tool(blade, first_z_mm));
  recording.events.push_back(frozen);
  const double steps = std::ceil((reach_mm - first_z_mm) / feed_mm);
  for (double step = 0.0; step <= steps; step += 1.0) {
    const double z_mm = first_z_mm + (reach_mm - first_z_mm) * step / steps;
    simulator::ToolSample sample;
    sample.tick = tick++;
    sample.world_from_tool =
        simulator::quantise(bone.world_from_bone * bone_from_tool(blade, z_mm));
    sample.status = static_cast<std::uint32_t>(ToolStatus::SawOn) |
                    static_cast<std::uint32_t>(ToolStatus::InKerf) |
                    static_cast<std::uint32_t>(ToolStatus::Cutting);
    sample.kerf = frozen.subject;
    const Vec3 force_newton =
        transform_direction(bone.world_from_bone, Vec3{0.0, 0.0, -push_newton});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sample.force_mn[axis] =
          millinewton_from_newton(force_newton[static_cast<glm::length_t>(axis)]);
    }
    recording.samples.push_back(sample);
  }
}

scenarios::RubricItem item(const char* id, const char* metric, int weight, double full,
                           double zero) {
  scenarios::RubricItem made;
  made.id = id;
  made.title = id;
  made.group = "accuracy";
  made.metric = metric;
  made.unit = std::string(metric).ends_with("_deg") ? "deg" : "mm";
  made.weight_milli = weight * 1000;
  made.full = full;
  made.zero = zero;
  return made;
}

scenarios::RubricItem of_cut(scenarios::RubricItem made, const char* cut) {
  made.cut = cut;
  return made;
}

scenarios::RubricItem of_hinge(scenarios::RubricItem made) {
  made.hinge = "lateral";
  return made;
}

scenarios::Rubric akin_rubric() {
  scenarios::Rubric rubric;
  rubric.groups = {{"accuracy", "Accuracy", 50000, ""}, {"safety", "Safety", 50000, ""}};
  scenarios::RubricItem bridge = of_hinge(item("A6", "hinge_mm", 7, 0.0, 0.0));
  bridge.is_band = true;
  bridge.full_low = 0.8;
  bridge.full_high = 2.0;
  bridge.zero_high = 3.5;
  scenarios::RubricItem over_cut = of_hinge(item("H1", "over_cut_mm", 8, 0.0, 3.0));
  over_cut.group = "safety";
  rubric.items = {of_cut(item("A1", "angle_deg", 8, 1.0, 8.0), "cut1"),
                  of_cut(item("A2", "location_mm", 8, 0.5, 3.0), "cut1"),
                  of_cut(item("A3", "angle_deg", 6, 1.0, 8.0), "cut2"),
                  of_hinge(item("A4", "wedge_error_deg", 12, 0.5, 6.0)),
                  of_hinge(item("A5", "wedge_sagittal_deg", 6, 0.5, 6.0)),
                  bridge,
                  of_hinge(item("A7", "flatness_mm", 3, 0.1, 1.0)),
                  over_cut};
  scenarios::Gate lost;
  lost.name = "hinge_lost";
  lost.title = "Lateral cortex cut through";
  lost.metric = "hinge_lost";
  lost.hinge = "lateral";
  lost.cap_milli = 69000;
  scenarios::Gate plunge = lost;
  plunge.name = "plunge";
  plunge.title = "Blade beyond the lateral cortex";
  plunge.metric = "over_cut_mm";
  plunge.unit = "mm";
  plunge.limit = 2.0;
  plunge.cap_milli = 59000;
  rubric.gates = {lost, plunge};
  return rubric;
}

}  // namespace

Bone oval_bone() {
  Bone bone;
  bone.name = "oval";
  bone.outer = oval_prism();
  bone.landmarks = {{"base_centre", Vec3{0.0, 0.0, 0.0}},
                    {"base_med", Vec3{0.0, 0.0, -7.5}},
                    {"base_lat", Vec3{0.0, 0.0, 7.5}},
                    {"ip_centre", Vec3{27.0, 0.0, 0.0}}};
  bone.world_from_bone = {rotation_about(Vec3{0.0, 0.0, 1.0}, radian_from_degree(-12.0)),
                          Vec3{140.0, 30.0, -8.0}};
  return bone;
}

scenarios::Scenario akin_scenario(double kerf_mm) {
  scenarios::Scenario scenario;
  scenario.name = "akin";
  scenario.title = "Akin";
  scenario.saw.blade = {20.0, 40.0, kerf_mm};
  scenario.cuts.resize(2);
  scenarios::ReferenceCut& first = scenario.cuts[0];
  first.name = "cut1";
  first.title = "First cut";
  first.face.through = "base_centre";
  first.face.axis_from = "base_med";
  first.face.axis_to = "base_lat";
  first.face.offset_mm = 6.0;
  first.face.kind = scenarios::FaceKind::Transverse;
  first.waste_side = "distal";
  first.approach = "medial";
  scenarios::ReferenceCut& second = scenario.cuts[1];
  second = first;
  second.name = "cut2";
  second.title = "Second cut";
  second.face = {};
  second.face.through = "lateral";
  second.face.kind = scenarios::FaceKind::ThroughHinge;
  second.face.wedge_rad = radian_from_degree(10.0);
  second.waste_side = "proximal";
  scenarios::ReferenceHinge hinge;
  hinge.name = "lateral";
  hinge.title = "Lateral hinge";
  hinge.first_cut = "cut1";
  hinge.second_cut = "cut2";
  hinge.side = "lateral";
  scenario.hinges = {hinge};
  scenario.rubric = akin_rubric();
  return scenario;
}

Recording akin_recording(const AkinAttempt& attempt, const Bone& bone, double kerf_mm) {
  const Face first =
      face_through(attempt.entry_x_mm, -7.5, attempt.transverse_deg, attempt.sagittal1_deg);
  const Face second =
      face_through(first.x_at(attempt.apex_mm), attempt.apex_mm,
                   attempt.transverse_deg + attempt.wedge_deg, attempt.sagittal2_deg);
  Recording recording;
  const auto add_first = [&] {
    add_stroke(recording, bone, {first, 1.0, kerf_mm}, attempt.reach1_mm);
  };
  if (!attempt.is_second_first) add_first();
  if (attempt.has_second) {
    add_stroke(recording, bone, {second, -1.0, kerf_mm}, attempt.reach2_mm);
  }
  if (attempt.is_second_first) add_first();
  return recording;
}

}  // namespace hallux::assessment::testing
