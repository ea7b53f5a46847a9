/// A scenario's plan on one patient: planes and points in that bone's frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/patient.h"
#include "scenarios/planned_joints.h"
#include "scenarios/planned_zones.h"
#include "scenarios/scenario.h"
#include "simulator/cutting/hinge/hinge.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

/// A finished bone face: points p with normal . p = offset; the bone on the side of the normal is
/// waste.
struct ReferenceFace {
  Vec3 normal{0.0, 0.0, -1.0};
  double offset_mm = 0.0;
};

struct PlannedCut {
  std::string name;
  ReferenceFace face;
  /// Unit direction in the face: distal, or dorsal in a face across the bone.
  Vec3 axis{1.0, 0.0, 0.0};
  /// Where depth is measured; the entry in a face across the bone.
  Vec3 depth_point_in_bone_mm{0.0, 0.0, 0.0};
  /// Where the face runs out of the bone; in a face that stops at a hinge, the hinge's point.
  Vec3 exit_point_in_bone_mm{0.0, 0.0, 0.0};
  /// Planned signed distance of the face from the depth point, towards the waste.
  double depth_mm = 0.0;
  FaceKind kind = FaceKind::AlongAxis;
  /// The bone's point of this face that lies furthest on the side of the approach.
  Vec3 entry_point_in_bone_mm{0.0, 0.0, 0.0};
  /// Where the blade is to stop; empty where the cut runs through the bone.
  std::string hinge;
};

/// The bridge on this bone. Bone beyond its line, towards `outward`, is to stay. The faces that it
/// joins are cut only where outward . (p - point) <= 0. A
/// line is straight and a cortex is not, so the planned thickness holds in the row of the line in
/// which the bone reaches furthest outward: the row of `point`.
struct PlannedHinge {
  std::string name;
  std::string first_cut, second_cut;
  /// Its line's axis lies in both faces, dorsal; outward in the first face. The distal half turns.
  simulator::PlannedBridge bridge;
  /// Between the two faces.
  double wedge_rad = 0.0;
  /// The thickest that scores in full.
  double target_high_mm = 2.0;
};

struct Plan {
  std::vector<PlannedCut> cuts;
  std::vector<PlannedHinge> hinges;
  std::vector<PlannedZone> danger_zones;
  std::vector<PlannedJointSurface> joint_surfaces = {};
};

/// Nothing (null) where the plan has none of that name; what is returned lives as long as the plan.
const PlannedCut* find_cut(const Plan& plan, std::string_view name) noexcept;
/// needs   the plan has it
std::size_t index_of_cut(const Plan& plan, std::string_view name) noexcept;
const PlannedHinge* find_hinge(const Plan& plan, std::string_view name) noexcept;

/// The bridges of the plan's hinges, in their order.
simulator::PlannedBridges planned_bridges(const Plan& plan);

/// The face of the plane on this bone.
/// errors  ScenarioError naming the landmark that this bone lacks, the cut whose plane misses the
///         bone, the hinge that has no room in it, or the danger zone that lies nowhere near it
Plan plan_on(const Scenario& scenario, const simulator::Bone& bone);

}  // namespace hallux::scenarios
