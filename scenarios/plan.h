/// A scenario's plan on one patient: planes and points in the frame of the bone that each is on.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/faces/reference_face.h"
#include "scenarios/fixation/planned_fixation.h"
#include "scenarios/patient.h"
#include "scenarios/planned_joints.h"
#include "scenarios/planned_zones.h"
#include "scenarios/scenario.h"
#include "simulator/cutting/hinge/hinge.h"
#include "simulator/mesh/bones.h"

namespace hallux::scenarios {

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
  /// It runs along the bone: depth and exit are landmarks; else it lies across the bone.
  bool is_along_bone = true;
  /// Its face was turned about the line of its hinge from the face of the hinge's first cut.
  bool is_turned_about_hinge = false;
  /// False where nothing says where the face is to leave the bone.
  bool has_exit = true;
  /// The bone beyond the kerf is kept as well.
  bool keeps_both = false;
  /// The bone's point of this face that lies furthest on the side of the approach.
  Vec3 entry_point_in_bone_mm{0.0, 0.0, 0.0};
  /// Where the blade is to stop; empty where the cut runs through the bone.
  std::string hinge;
  /// Unit, from the bone to the handpiece.
  Vec3 approach_in_bone{0.0, 1.0, 0.0};
  /// Nothing: the whole face is cut.
  std::optional<FaceWindow> window = {};
  /// Of the patient's bones, in whose frame all of this is said.
  std::size_t bone = 0;
  /// Of the scenario's blades; nothing: any.
  std::optional<std::size_t> blade = {};
  /// Unit direction that the face is planned to contain: of a turned one its own, else `axis`.
  Vec3 contained_in_bone{1.0, 0.0, 0.0};
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
  /// Of the patient's bones.
  std::size_t bone = 0;
};

struct Plan {
  std::vector<PlannedCut> cuts;
  std::vector<PlannedHinge> hinges;
  std::vector<PlannedZone> danger_zones;
  std::vector<PlannedJointSurface> joint_surfaces = {};
  PlannedFixation fixation = {};
};

/// Nothing (null) where the plan has none of that name; what is returned lives as long as the plan.
const PlannedCut* find_cut(const Plan& plan, std::string_view name) noexcept;
/// needs   the plan has it
std::size_t index_of_cut(const Plan& plan, std::string_view name) noexcept;
const PlannedHinge* find_hinge(const Plan& plan, std::string_view name) noexcept;
/// needs   the plan has it
std::size_t index_of_hinge(const Plan& plan, std::string_view name) noexcept;

/// The first other cut of the same bone that is planned to contain the same direction, within 0.1
/// degrees: the other arm of a V, the parallel cut of a slab. Null where there is none.
const PlannedCut* partner_of(const PlannedCut& cut, const Plan& plan) noexcept;

/// The bridges of the plan's hinges, in their order.
simulator::PlannedBridges planned_bridges(const Plan& plan);

/// The plan on these bones, which stand in the order in which the scenario asks for them.
/// errors  ScenarioError naming the landmark that this bone lacks, the cut whose plane misses the
///         bone, the hinge that has no room in it, the danger zone that lies nowhere near it, or
///         the implant that misses what it is to hold; also for another number of bones
Plan plan_on(const Scenario& scenario, simulator::Bones bones);

}  // namespace hallux::scenarios
