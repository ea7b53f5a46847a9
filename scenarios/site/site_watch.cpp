#include "scenarios/site/site_watch.h"

#include <optional>

#include "scenarios/site/bone_words.h"
#include "scenarios/site/kerf_of_cut.h"
#include "scenarios/site/planned_window.h"

namespace hallux::scenarios {

namespace {

using simulator::CutEventKind;
using simulator::HeldSection;
using simulator::KerfPlane;
using simulator::PlaneLimit;

/// A middle nearer to the section's own than this share of the section's size is no side.
constexpr double least_lean = 0.12;

/// The window in the coordinates of a kerf's plane.
PlaneLimit limit_in(const KerfPlane& plane, const PlannedWindow& window) {
  const RigidTransform& bone_from_kerf = plane.bone_from_kerf;
  return {{glm::dot(window.outward, axis_x(bone_from_kerf)),
           glm::dot(window.outward, axis_y(bone_from_kerf))},
          window.limit_mm - glm::dot(window.outward, bone_from_kerf.translation_mm)};
}

std::string side_of(const HeldSection& held, const RigidTransform& bone_from_kerf) {
  const Vec2 lean_mm = held.middle_mm - held.section_middle_mm;
  const Vec2 size_mm = held.grid.spacing_mm * Vec2(held.grid.u_count, held.grid.v_count);
  if (length_of(lean_mm) < least_lean * length_of(size_mm)) return {};
  return direction_text(transform_direction(bone_from_kerf, Vec3(lean_mm, 0.0)));
}

}  // namespace

SiteWatch::SiteWatch(const Scenario& scenario, const Plan& plan)
    : scenario_(scenario), plan_(plan) {}

void SiteWatch::apply(const simulator::CutEvent& event, const simulator::KerfSet& kerfs) {
  if (event.kind == CutEventKind::StepDone) step_ = static_cast<std::size_t>(event.subject + 1);
  if (event.kind == CutEventKind::StepReopened) step_ = static_cast<std::size_t>(event.subject);
  if (event.kind == CutEventKind::PlaneFrozen)
    kerfs_.push_back({cut_of(kerfs.plane(event.subject)), {}, false});
}

std::size_t SiteWatch::cut_of(const KerfPlane& plane) const {
  if (step_ < scenario_.steps.size() && scenario_.steps[step_].kind == StepKind::Cut)
    return index_of_cut(plan_, scenario_.steps[step_].cut);
  return nearest_cut(plane, plan_);
}

HeldCut SiteWatch::held_of(std::int32_t kerf, const simulator::KerfSet& kerfs,
                           const simulator::SolidWithTree& whole) {
  KerfOfCut& known = kerfs_[static_cast<std::size_t>(kerf)];
  const KerfPlane& plane = kerfs.plane(kerf);
  if (!known.has_section) {
    known.section = slice_section(whole.solid, whole.bvh, plane);
    known.has_section = true;
  }
  std::optional<PlaneLimit> limit;
  if (const PlannedHinge* hinge = find_hinge(plan_, plan_.cuts[known.cut].hinge))
    limit = limit_in(plane, window_before(*hinge, plane.thickness_mm));
  HeldSection section = held_section(known.section, kerfs, kerf, limit);
  HeldCut held;
  held.kerf = kerf;
  held.share = section.share < held_share_min ? 0.0 : section.share;
  held.bone_from_kerf = plane.bone_from_kerf;
  held.side = side_of(section, plane.bone_from_kerf);
  held.deepest_in_bone_mm = transform_point(plane.bone_from_kerf, Vec3(section.deepest_mm, 0.0));
  held.grid = std::move(section.grid);
  return held;
}

std::vector<HeldCut> SiteWatch::held(const simulator::KerfSet& kerfs,
                                     const simulator::SolidWithTree& whole) {
  std::vector<HeldCut> held(plan_.cuts.size());
  for (std::size_t kerf = 0; kerf < kerfs_.size(); ++kerf) {
    HeldCut made = held_of(static_cast<std::int32_t>(kerf), kerfs, whole);
    HeldCut& of_cut = held[kerfs_[kerf].cut];
    if (!of_cut.is_begun() || made.share < of_cut.share) of_cut = std::move(made);
  }
  return held;
}

}  // namespace hallux::scenarios
