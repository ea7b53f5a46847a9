// Implants are planned on the bone as it is when they are set: with the fragments where their
// shifts and closed hinges bring them. So an axis is carried back into a fragment's own place
// before it is asked what it meets there. What driving home adds is known to the simulator alone,
// and is small.
#include "scenarios/fixation/plan_fixation.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "scenarios/fixation/bone_pieces.h"
#include "scenarios/geometry/part_path.h"
#include "scenarios/json_node.h"
#include "scenarios/plan.h"
#include "scenarios/steps/step_order.h"
#include "simulator/mesh/bvh.h"

namespace hallux::scenarios {
namespace {

/// Along an implant's axis.
constexpr double sample_mm = 0.25;
/// Less of an implant in a body does not hold it.
constexpr double engaged_least_mm = 1.0;

/// Lays the face of the half that turns on that of the half that stays.
RigidTransform closing_turn(const PlannedHinge& hinge, const Plan& plan) {
  const simulator::HingeLine& line = hinge.bridge.line;
  Vec3 fixed = find_cut(plan, hinge.first_cut)->face.normal;
  Vec3 moved = find_cut(plan, hinge.second_cut)->face.normal;
  // A normal points away from the half that has the face.
  if (glm::dot(moved, hinge.bridge.toward_moved) > 0.0) std::swap(fixed, moved);
  const auto turned = [&](double angle_rad) {
    return turn_about(line.point_in_bone_mm, line.axis, angle_rad);
  };
  const RigidTransform one = turned(hinge.wedge_rad), other = turned(-hinge.wedge_rad);
  const auto apart = [&](const RigidTransform& turn) {
    return glm::dot(transform_direction(turn, moved), fixed);
  };
  return apart(one) <= apart(other) ? one : other;
}

/// A part of a bone as an implant meets it: a fragment where it was shifted to, or the rest.
struct Body {
  std::size_t bone = 0, piece = 0;
  RigidTransform bone_from_rest = {};
};

class FixationPlanner {
 public:
  FixationPlanner(const Scenario& scenario, const Ground& ground, const Plan& plan)
      : scenario_(scenario), ground_(ground), plan_(plan) {
    for (std::size_t bone = 0; bone < ground.bone_count(); ++bone)
      pieces_.emplace_back(ground.bone(bone).outer, walls_of(plan.cuts, bone));
  }

  PlannedFixation planned() {
    for (std::size_t i = 0; i < scenario_.fragments.size(); ++i) plan_fragment(i);
    for (std::size_t i = 0; i < scenario_.shifts.size(); ++i) plan_shift(i);
    move_fragments();
    std::size_t wires = 0, screws = 0;
    for (const Implant& implant : scenario_.implants) {
      const bool is_wire = implant.kind == ImplantKind::Wire;
      std::size_t& index = is_wire ? wires : screws;
      fixation_.implants.push_back(plan_implant(
          implant, part_path(scenario_, is_wire ? "wires" : "screws", index++, implant.name)));
    }
    return std::move(fixation_);
  }

 private:
  /// What is trimmed is trimmed after the shifts, and parts nothing before.
  std::vector<PartingFace> walls_of(std::span<const PlannedCut> cuts, std::size_t bone) const {
    std::vector<PartingFace> walls;
    for (const PlannedCut& cut : cuts) {
      const bool is_trimmed = std::ranges::any_of(scenario_.steps, [&](const OperationStep& step) {
        return step.kind == StepKind::Trim && step.cut == cut.name;
      });
      if (cut.bone == bone && !is_trimmed) walls.push_back({cut.face, cut.window});
    }
    return walls;
  }

  void plan_fragment(std::size_t index) {
    const Fragment& fragment = scenario_.fragments[index];
    const std::string path = part_path(scenario_, "fragments", index, fragment.name);
    PlannedFragment planned{.name = fragment.name, .bone = ground_.bone_index(fragment.bone)};
    planned.holds_in_bone_mm = ground_.point(fragment.holds, planned.bone, path + ".holds");
    planned.foot_dorsal_in_bone = ground_.direction("foot_dorsal", planned.bone, path);
    const BonePieces& pieces = pieces_[planned.bone];
    const std::optional<std::size_t> piece = pieces.near(planned.holds_in_bone_mm);
    const std::string of_bone = " of the bone \"" + ground_.bone(planned.bone).name + "\"";
    if (!piece) {
      throw ScenarioError(path + ": \"" + fragment.holds + "\" lies outside" + of_bone +
                          "; mend holds");
    }
    if (pieces.volumes_mm3().size() == 1) {
      throw ScenarioError(path + ": no cut parts it from the rest" + of_bone +
                          "; mend the cuts or their windows");
    }
    for (const Body& other : bodies_) {
      if (other.bone != planned.bone || other.piece != *piece) continue;
      std::string said = path;
      said += ": another fragment lies in the same piece";
      said += of_bone;
      said += "; mend holds or the cuts";
      throw ScenarioError(said);
    }
    planned.volume_mm3 = pieces.volumes_mm3()[*piece];
    bodies_.push_back({planned.bone, *piece, {}});
    fixation_.fragments.push_back(planned);
  }

  void plan_shift(std::size_t index) {
    const FragmentShift& shift = scenario_.shifts[index];
    const std::string path = part_path(scenario_, "shifts", index, shift.name);
    const std::size_t bone = fixation_.fragments[fragment_index(shift.fragment)].bone;
    PlannedShift planned{shift.name, shift.fragment, bone, {}, {}, shift.is_closed};
    for (const FragmentMove& move : shift.moves) {
      const Vec3 direction = ground_.direction(move.direction, bone, path);
      const RigidTransform next =
          move.is_turn
              ? turn_about(ground_.point(move.through, bone, path), direction, move.turn_rad)
              : RigidTransform{{1.0, 0.0, 0.0, 0.0}, move.slide_mm * direction};
      planned.bone_from_before = next * planned.bone_from_before;
    }
    fixation_.shifts.push_back(planned);
  }

  /// Shifts and hinges in the order of the steps; what two alternatives do is done once.
  void move_fragments() {
    std::set<std::pair<StepKind, std::string>> done;
    for (const std::size_t index : steps_in_order(scenario_)) {
      const OperationStep& step = scenario_.steps[index];
      const bool is_shift = step.kind == StepKind::Shift;
      if (!is_shift && step.kind != StepKind::Close) continue;
      if (!done.emplace(step.kind, is_shift ? step.shift : step.hinge).second) continue;
      if (is_shift) {
        move_by(step.shift);
      } else {
        close(*find_hinge(plan_, step.hinge));
      }
    }
  }

  void move_by(const std::string& name) {
    PlannedShift& shift = *std::ranges::find(fixation_.shifts, name, &PlannedShift::name);
    const std::size_t fragment = fragment_index(shift.fragment);
    shift.before_from_cut = bodies_[fragment].bone_from_rest;
    carry(fragment, shift.bone_from_before);
  }

  void carry(std::size_t fragment, const RigidTransform& bone_from_before) {
    RigidTransform& bone_from_rest = fixation_.fragments[fragment].bone_from_rest;
    bone_from_rest = bone_from_before * bone_from_rest;
    bodies_[fragment].bone_from_rest = bone_from_rest;
  }

  /// What lies on the half that turns lies where the wedge is closed.
  void close(const PlannedHinge& hinge) {
    const simulator::PlannedBridge& bridge = hinge.bridge;
    const RigidTransform turn = closing_turn(hinge, plan_);
    for (std::size_t i = 0; i < fixation_.fragments.size(); ++i) {
      const PlannedFragment& fragment = fixation_.fragments[i];
      const double beyond_mm =
          glm::dot(bridge.toward_moved, fragment.holds_in_bone_mm - bridge.line.point_in_bone_mm);
      if (fragment.bone == hinge.bone && beyond_mm > 0.0) carry(i, turn);
    }
  }

  std::size_t fragment_index(const std::string& name) const {
    const auto found = std::ranges::find(scenario_.fragments, name, &Fragment::name);
    return static_cast<std::size_t>(found - scenario_.fragments.begin());
  }

  /// A fragment, or the greatest piece of the bone that is none.
  Body body_named(const std::string& name) const {
    const std::size_t fragment = fragment_index(name);
    if (fragment < bodies_.size()) return bodies_[fragment];
    Body rest{.bone = ground_.bone_index(name)};
    double greatest_mm3 = 0.0;
    const std::vector<double>& volumes_mm3 = pieces_[rest.bone].volumes_mm3();
    for (std::size_t piece = 0; piece < volumes_mm3.size(); ++piece) {
      const bool is_fragment = std::ranges::any_of(
          bodies_, [&](const Body& body) { return body.bone == rest.bone && body.piece == piece; });
      if (is_fragment || volumes_mm3[piece] <= greatest_mm3) continue;
      greatest_mm3 = volumes_mm3[piece];
      rest.piece = piece;
    }
    return rest;
  }

  /// A wire that leads the saw is set before anything is cut.
  bool is_guide(const PlannedImplant& implant) const {
    return std::ranges::any_of(scenario_.steps, [&](const OperationStep& step) {
      return step.kind == StepKind::GuideWire &&
             std::ranges::find(step.implants, implant.name) != step.implants.end();
    });
  }

  /// The points of the implant's axis, tip included, as the body has them in its own place.
  std::vector<Vec3> axis_in(const Body& body, const PlannedImplant& implant) const {
    const RigidTransform rest_from_bone =
        is_guide(implant) ? RigidTransform{} : inverse(body.bone_from_rest);
    const auto steps = static_cast<int>(implant.length_mm / sample_mm);
    std::vector<Vec3> points;
    for (int step = 0; step <= steps + 1; ++step) {
      const double along_mm = std::min(step * sample_mm, implant.length_mm);
      const Vec3 point = implant.entry_in_bone_mm + along_mm * implant.direction_in_bone;
      points.push_back(
          transform_point(rest_from_bone, ground_.moved_point(point, implant.bone, body.bone)));
    }
    return points;
  }

  /// The keys that decide where it goes.
  static std::string mend_of(const PlannedImplant& implant) {
    const bool is_screw = implant.kind == ImplantKind::Screw;
    return std::string("mend entry, direction or ") + (is_screw ? "length_mm" : "depth_mm");
  }

  PlannedImplant plan_implant(const Implant& implant, const std::string& path) {
    PlannedImplant planned{.kind = implant.kind,
                           .name = implant.name,
                           .bone = ground_.bone_index(implant.bone),
                           .length_mm = implant.length.middle_mm(),
                           .diameter_mm = implant.diameter.middle_mm(),
                           .lengths = implant.length,
                           .diameters = implant.diameter,
                           .engages = implant.engages,
                           .cortices = implant.cortices,
                           .is_temporary = implant.is_temporary};
    planned.entry_in_bone_mm = ground_.point(implant.entry, planned.bone, path + ".entry");
    planned.direction_in_bone =
        ground_.direction(implant.direction, planned.bone, path + ".direction");
    planned.tip_in_bone_mm =
        planned.entry_in_bone_mm + planned.length_mm * planned.direction_in_bone;
    for (const std::string& name : implant.engages) check_engaged(planned, name, path);
    for (const ImplantClearance& asked : implant.clear_of)
      planned.clear_of.push_back(clearance_of(planned, asked, path));
    return planned;
  }

  void check_engaged(const PlannedImplant& implant, const std::string& name,
                     const std::string& path) const {
    const Body body = body_named(name);
    const BonePieces& pieces = pieces_[body.bone];
    const bool is_whole = is_guide(implant);
    const std::vector<Vec3> axis = axis_in(body, implant);
    const auto within = std::ranges::count_if(axis, [&](const Vec3& point) {
      const std::optional<std::size_t> piece = pieces.at(point);
      return is_whole ? piece.has_value() : piece == body.piece;
    });
    if (static_cast<double>(within) * sample_mm >= engaged_least_mm) return;
    throw ScenarioError(path + ": its axis misses \"" + name + "\", which it must engage; " +
                        mend_of(implant));
  }

  /// A surface moves with the fragment on which most of it lies; its middle may lie in a cut.
  Body body_of(const PlannedJointSurface& surface) const {
    constexpr std::size_t samples = 200;
    const BonePieces& pieces = pieces_[surface.bone];
    const simulator::IndexedMesh& outer = ground_.bone(surface.bone).outer;
    std::vector<std::size_t> found(pieces.volumes_mm3().size(), 0);
    const std::size_t stride = 1 + surface.triangles.size() / samples;
    for (std::size_t i = 0; i < surface.triangles.size(); i += stride) {
      const Vec3 middle_mm =
          simulator::middle_of(simulator::corners_of(outer, surface.triangles[i]));
      if (const std::optional<std::size_t> piece = pieces.near(middle_mm)) ++found[*piece];
    }
    const auto most = static_cast<std::size_t>(std::ranges::max_element(found) - found.begin());
    for (const Body& body : bodies_) {
      if (body.bone == surface.bone && body.piece == most) return body;
    }
    return {.bone = surface.bone};
  }

  /// Of that bone's outer surface; built for whoever asks first.
  const simulator::Bvh& tree_of(std::size_t bone) {
    if (trees_.size() < ground_.bone_count()) trees_.resize(ground_.bone_count());
    if (!trees_[bone]) trees_[bone].emplace(ground_.bone(bone).outer);
    return *trees_[bone];
  }

  double distance_mm(const Vec3& point_mm, const PlannedJointSurface& surface) {
    double nearest_mm = std::numeric_limits<double>::infinity();
    auto visit = [&](const simulator::NearTriangle& found) noexcept {
      if (std::ranges::binary_search(surface.triangles, found.triangle))
        nearest_mm = std::min(nearest_mm, length_of(found.closest_mm - point_mm));
      return nearest_mm;
    };
    tree_of(surface.bone).visit_near(point_mm, nearest_mm, visit);
    return nearest_mm;
  }

  PlannedClearance clearance_of(const PlannedImplant& implant, const ImplantClearance& asked,
                                const std::string& path) {
    const auto surface =
        std::ranges::find(plan_.joint_surfaces, asked.joint_surface, &PlannedJointSurface::name);
    PlannedClearance clear{asked.joint_surface, asked.least_mm,
                           std::numeric_limits<double>::infinity()};
    for (const Vec3& point : axis_in(body_of(*surface), implant))
      clear.planned_mm = std::min(clear.planned_mm, distance_mm(point, *surface));
    if (clear.planned_mm >= asked.least_mm) return clear;
    throw ScenarioError(path + ": its axis comes within " + text_of_number(asked.least_mm) +
                        " mm of the joint surface \"" + asked.joint_surface + "\"; " +
                        mend_of(implant));
  }

  const Scenario& scenario_;
  const Ground& ground_;
  const Plan& plan_;
  std::vector<BonePieces> pieces_;
  std::vector<std::optional<simulator::Bvh>> trees_;
  /// Of each fragment.
  std::vector<Body> bodies_;
  PlannedFixation fixation_;
};

template <typename Part>
const Part* find_part(const std::vector<Part>& parts, std::string_view name) noexcept {
  const auto found = std::ranges::find(parts, name, &Part::name);
  return found == parts.end() ? nullptr : &*found;
}

}  // namespace

PlannedFixation plan_fixation(const Scenario& scenario, const Ground& ground, const Plan& plan) {
  if (scenario.fragments.empty() && scenario.implants.empty()) return {};
  return FixationPlanner(scenario, ground, plan).planned();
}

const PlannedFragment* find_fragment(const PlannedFixation& fixation,
                                     std::string_view name) noexcept {
  return find_part(fixation.fragments, name);
}

const PlannedShift* find_shift(const PlannedFixation& fixation, std::string_view name) noexcept {
  return find_part(fixation.shifts, name);
}

const PlannedImplant* find_implant(const PlannedFixation& fixation,
                                   std::string_view name) noexcept {
  return find_part(fixation.implants, name);
}

}  // namespace hallux::scenarios
