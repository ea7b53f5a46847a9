/// Faces come from landmarks of this bone, so a plan is made in an order: cuts that stand alone,
/// the hinge in the first of them, then the cut through the hinge, and last the zones and what
/// holds the fragments. Normals point into the waste. Where a plane misses the bone, or the
/// landmarks of an axis coincide, the cut is refused with its path: a patient that the scenario
/// cannot be done on is no patient of it.
#include "scenarios/plan.h"

#include <algorithm>

#include "scenarios/faces/face_section.h"
#include "scenarios/faces/lay_face.h"
#include "scenarios/fixation/plan_fixation.h"
#include "scenarios/geometry/ground.h"
#include "scenarios/geometry/part_path.h"
#include "simulator/base/check.h"
#include "simulator/base/elementary.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;

template <typename Part>
const Part* find_named(const std::vector<Part>& parts, std::string_view name) noexcept {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

/// Of a face in the bone, within its window.
std::optional<Vec3> furthest(const PlannedCut& planned, const Bone& bone, const Vec3& direction) {
  if (planned.window)
    return furthest_in_window(planned.face, *planned.window, bone.outer, direction);
  return furthest_in_face(planned.face, bone.outer, direction);
}

/// Lays one part after another; what waits for another part is laid in a later round.
class Planner {
 public:
  Planner(const Scenario& scenario, const simulator::Bones& bones)
      : scenario_(scenario),
        ground_(scenario, bones),
        has_cut_(scenario.cuts.size(), false),
        has_hinge_(scenario.hinges.size(), false) {
    plan_.cuts.resize(scenario.cuts.size());
    plan_.hinges.resize(scenario.hinges.size());
  }

  Plan planned() {
    while (plans_cuts() || plans_hinges()) {
    }
    const auto is_true = [](bool is_planned) { return is_planned; };
    CHECK(std::ranges::all_of(has_cut_, is_true) && std::ranges::all_of(has_hinge_, is_true));
    for (const PlannedHinge& hinge : plan_.hinges) join(hinge);
    plan_.danger_zones = plan_zones(scenario_, ground_);
    plan_.joint_surfaces = plan_joint_surfaces(scenario_, ground_);
    plan_.fixation = plan_fixation(scenario_, ground_, plan_);
    return std::move(plan_);
  }

 private:
  /// Of what a face is made from, the names of hinges and cuts are to be planned before.
  bool is_at_hand(const std::string& name) const {
    for (std::size_t i = 0; i < scenario_.hinges.size(); ++i) {
      if (scenario_.hinges[i].name == name && !has_hinge_[i]) return false;
    }
    for (std::size_t i = 0; i < scenario_.cuts.size(); ++i) {
      if (scenario_.cuts[i].name == name && !has_cut_[i]) return false;
    }
    return true;
  }

  bool is_at_hand(const ReferenceCut& cut) const {
    const LandmarkPlane& face = cut.face;
    if (face.kind == FaceKind::ThroughHinge) return is_at_hand(face.through);
    return face.kind != FaceKind::Turned ||
           (is_at_hand(face.through) && is_at_hand(face.contains) && is_at_hand(face.turned_from));
  }

  bool plans_cuts() {
    std::vector<std::size_t> at_hand;
    for (std::size_t i = 0; i < scenario_.cuts.size(); ++i) {
      if (!has_cut_[i] && is_at_hand(scenario_.cuts[i])) at_hand.push_back(i);
    }
    for (const std::size_t i : at_hand) {
      plan_.cuts[i] = plan_cut(i);
      has_cut_[i] = true;
    }
    return !at_hand.empty();
  }

  bool plans_hinges() {
    bool is_any = false;
    for (std::size_t i = 0; i < scenario_.hinges.size(); ++i) {
      if (has_hinge_[i] || !is_at_hand(scenario_.hinges[i].first_cut)) continue;
      plan_.hinges[i] = plan_hinge(i);
      has_hinge_[i] = is_any = true;
      const simulator::HingeLine& line = plan_.hinges[i].bridge.line;
      ground_.add_line(plan_.hinges[i].name, plan_.hinges[i].bone, line.point_in_bone_mm,
                       line.axis);
    }
    return is_any;
  }

  LaidFace lay(const AskedCut& asked) const {
    const LandmarkPlane& face = asked.cut.face;
    if (face.kind == FaceKind::AlongAxis) return lay_along_axis(asked);
    if (face.kind == FaceKind::Transverse) return lay_transverse(asked);
    if (face.kind == FaceKind::ThroughHinge) {
      const PlannedHinge& hinge = *find_hinge(plan_, face.through);
      return lay_through_hinge(asked, hinge.bridge.line, hinge.wedge_rad);
    }
    const PlannedCut* const from = find_cut(plan_, face.turned_from);
    return lay_turned(asked, from == nullptr ? nullptr : &from->face);
  }

  Vec3 contained_in(const AskedCut& asked, const LaidFace& laid) const {
    const LandmarkPlane& face = asked.cut.face;
    if (face.kind != FaceKind::Turned) return laid.axis;
    return ground_.direction(face.contains, asked.bone, asked.path);
  }

  PlannedCut plan_cut(std::size_t index) const {
    const ReferenceCut& cut = scenario_.cuts[index];
    const AskedCut asked{cut, ground_, ground_.bone_index(cut.bone),
                         part_path(scenario_, "cuts", index, cut.name)};
    const LaidFace laid = lay(asked);
    PlannedCut planned;
    planned.name = cut.name;
    planned.face = laid.face;
    planned.axis = laid.axis;
    planned.contained_in_bone = contained_in(asked, laid);
    planned.bone = asked.bone;
    planned.is_along_bone = lies_along_bone(cut);
    planned.is_turned_about_hinge = find_hinge(plan_, cut.face.through) != nullptr;
    planned.keeps_both = cut.keeps_both;
    planned.approach_in_bone = ground_.direction(cut.approach, asked.bone, asked.path);
    planned.window = lay_window(asked, laid.face);
    for (std::size_t i = 0; i < scenario_.blades.size(); ++i) {
      if (!cut.blade.empty() && scenario_.blades[i].name == cut.blade) planned.blade = i;
    }
    place_in_bone(asked, planned);
    return planned;
  }

  /// Entry, depth and exit.
  void place_in_bone(const AskedCut& asked, PlannedCut& planned) const {
    const ReferenceCut& cut = asked.cut;
    const Bone& bone = ground_.bone(asked.bone);
    if (planned.is_along_bone) {
      planned.depth_point_in_bone_mm = ground_.point(cut.depth_landmark, asked.bone, asked.path);
      planned.exit_point_in_bone_mm = ground_.point(cut.exit_landmark, asked.bone, asked.path);
      planned.depth_mm =
          planned.face.offset_mm - glm::dot(planned.face.normal, planned.depth_point_in_bone_mm);
    }
    const std::optional<Vec3> entry = furthest(planned, bone, planned.approach_in_bone);
    if (!entry) {
      const char* const mend = cut.face.kind == FaceKind::Turned
                                   ? "\"; mend face.through, its angles or the window"
                                   : "\"; mend face.offset_mm or face.through";
      throw ScenarioError(asked.path + ": its plane misses the bone \"" + bone.name + mend);
    }
    planned.entry_point_in_bone_mm = *entry;
    if (planned.is_along_bone) return;
    planned.depth_point_in_bone_mm = *entry;
    planned.has_exit = cut.face.kind == FaceKind::Turned;
    if (planned.has_exit)
      planned.exit_point_in_bone_mm = furthest(planned, bone, -planned.approach_in_bone).value();
  }

  /// A line that stays planned_mm inside the bone's furthest point of the face.
  PlannedHinge plan_hinge(std::size_t index) const {
    const ReferenceHinge& hinge = scenario_.hinges[index];
    const std::string path = part_path(scenario_, "hinges", index, hinge.name);
    const PlannedCut& first = *find_cut(plan_, hinge.first_cut);
    const Bone& bone = ground_.bone(first.bone);
    const Vec3 axis =
        hinge.along.empty()
            ? first.axis
            : laid_in(
                  first.face, ground_.direction(hinge.along, first.bone, path), path + ".along",
                  "\"" + hinge.along + "\" is square to the face of \"" + hinge.first_cut + "\"",
                  "name a direction that lies nearer to it");
    const Vec3 across = glm::cross(first.face.normal, axis);
    const Vec3 side = ground_.direction(hinge.side, first.bone, path);
    const Vec3 outward = glm::dot(across, side) < 0.0 ? -across : across;
    const Vec3 far = furthest(first, bone, outward).value();
    const Vec3 point_mm = far - hinge.thickness_mm * outward;
    PlannedHinge planned{hinge.name,
                         hinge.first_cut,
                         hinge.second_cut,
                         {.line = {point_mm, axis, outward, hinge.thickness_mm},
                          .breaks_below_mm = hinge.breaks_below_mm,
                          .bends_up_to_mm = hinge.bends_up_to_mm},
                         0.0,
                         hinge.target_high_mm,
                         first.bone};
    if (!hinge.moves.empty())
      planned.bridge.toward_moved = ground_.direction(hinge.moves, first.bone, path);
    if (glm::dot(outward, point_mm - first.entry_point_in_bone_mm) <= hinge.thickness_mm) {
      throw ScenarioError(path + ": the bone \"" + bone.name +
                          "\" is too thin for it; mend thickness_mm or the face of \"" +
                          hinge.first_cut + "\"");
    }
    for (const ReferenceCut& cut : scenario_.cuts) {
      if (cut.name == hinge.second_cut) planned.wedge_rad = cut.face.wedge_rad;
    }
    return planned;
  }

  /// Both cuts stop at the hinge; between turned faces lies the wedge.
  void join(const PlannedHinge& hinge) {
    for (PlannedCut& cut : plan_.cuts) {
      if (cut.name != hinge.first_cut && cut.name != hinge.second_cut) continue;
      cut.hinge = hinge.name;
      cut.exit_point_in_bone_mm = hinge.bridge.line.point_in_bone_mm;
      cut.has_exit = true;
    }
    if (scenario_.format == 1) return;
    const auto index = static_cast<std::size_t>(&hinge - plan_.hinges.data());
    const Vec3& first = find_cut(plan_, hinge.first_cut)->face.normal;
    const Vec3& second = find_cut(plan_, hinge.second_cut)->face.normal;
    if (glm::dot(first, second) > 0.0) {
      throw ScenarioError(part_path(scenario_, "hinges", index, hinge.name) + ": \"" +
                          hinge.first_cut + "\" and \"" + hinge.second_cut +
                          "\" keep the same side, and no wedge lies between them; mend keep");
    }
    plan_.hinges[index].wedge_rad =
        elementary::atan2(length_of(glm::cross(first, second)), -glm::dot(first, second));
  }

  const Scenario& scenario_;
  Ground ground_;
  Plan plan_;
  std::vector<bool> has_cut_, has_hinge_;
};

}  // namespace

const PlannedCut* find_cut(const Plan& plan, std::string_view name) noexcept {
  return find_named(plan.cuts, name);
}

std::size_t index_of_cut(const Plan& plan, std::string_view name) noexcept {
  return static_cast<std::size_t>(find_cut(plan, name) - plan.cuts.data());
}

const PlannedHinge* find_hinge(const Plan& plan, std::string_view name) noexcept {
  return find_named(plan.hinges, name);
}

std::size_t index_of_hinge(const Plan& plan, std::string_view name) noexcept {
  return static_cast<std::size_t>(find_hinge(plan, name) - plan.hinges.data());
}

const PlannedCut* partner_of(const PlannedCut& cut, const Plan& plan) noexcept {
  constexpr double same_sine = 1.75e-3;
  const auto found = std::ranges::find_if(plan.cuts, [&](const PlannedCut& other) {
    return &other != &cut && other.bone == cut.bone &&
           length_of(glm::cross(other.contained_in_bone, cut.contained_in_bone)) <= same_sine;
  });
  return found == plan.cuts.end() ? nullptr : &*found;
}

simulator::PlannedBridges planned_bridges(const Plan& plan) {
  simulator::PlannedBridges bridges;
  for (const PlannedHinge& hinge : plan.hinges) {
    bridges.push_back(hinge.bridge);
    bridges.back().bone = static_cast<std::int32_t>(hinge.bone);
  }
  return bridges;
}

Plan plan_on(const Scenario& scenario, simulator::Bones bones) {
  return Planner(scenario, bones).planned();
}

}  // namespace hallux::scenarios
