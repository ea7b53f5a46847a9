#include "scenarios/site/site_watch.h"

#include <algorithm>
#include <utility>

#include "scenarios/faces/windowed_region.h"
#include "scenarios/site/bone_words.h"
#include "scenarios/site/kerf_of_cut.h"
#include "scenarios/site/planned_window.h"
#include "scenarios/steps/step_order.h"

namespace hallux::scenarios {

namespace {

using simulator::Contour;
using simulator::CutEventKind;
using simulator::HeldSection;
using simulator::KerfPlane;
using simulator::PlaneLimit;

/// A middle nearer to the section's own than this share of the section's size is no side.
constexpr double least_lean = 0.12;
/// Crumbs are asked for so finely.
constexpr double crumb_spacing_mm = 0.05;

/// The window in the coordinates of a kerf's plane.
PlaneLimit limit_in(const KerfPlane& plane, const PlannedWindow& window) {
  const RigidTransform& bone_from_kerf = plane.bone_from_kerf;
  return {{glm::dot(window.outward, axis_x(bone_from_kerf)),
           glm::dot(window.outward, axis_y(bone_from_kerf))},
          window.limit_mm - glm::dot(window.outward, bone_from_kerf.translation_mm)};
}

/// A contour as far as it lies within the limit (Sutherland and Hodgman 1974).
Contour within(const Contour& contour, const PlaneLimit& limit) {
  Contour kept;
  const auto beyond = [&](const Vec2& corner) {
    return glm::dot(limit.outward, corner) - limit.limit_mm;
  };
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Vec2 &from = contour[i], &to = contour[(i + 1) % contour.size()];
    const double from_mm = beyond(from), to_mm = beyond(to);
    if (from_mm <= 0.0) kept.push_back(from);
    if ((from_mm <= 0.0) != (to_mm <= 0.0))
      kept.push_back(from + from_mm / (from_mm - to_mm) * (to - from));
  }
  return kept;
}

std::vector<Contour> contours_of(const simulator::Section& section,
                                 const std::vector<std::size_t>& regions,
                                 const std::optional<PlaneLimit>& limit) {
  std::vector<Contour> contours;
  for (const std::size_t region : regions) {
    for (const Contour& contour : section.regions[region].contours) {
      Contour kept = limit ? within(contour, *limit) : contour;
      if (kept.size() > 2) contours.push_back(std::move(kept));
    }
  }
  return contours;
}

double size_mm_of(const std::vector<Contour>& contours) {
  Vec2 low = contours.front().front(), high = low;
  for (const Contour& contour : contours) {
    for (const Vec2& corner : contour) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  return length_of(high - low);
}

/// Around the regions.
void set_extent(HeldCut& held, const simulator::Section& section,
                const std::vector<std::size_t>& regions) {
  if (regions.empty()) return;
  held.low_mm = section.regions[regions.front()].min_mm;
  held.high_mm = section.regions[regions.front()].max_mm;
  for (const std::size_t region : regions) {
    held.low_mm = glm::min(held.low_mm, section.regions[region].min_mm);
    held.high_mm = glm::max(held.high_mm, section.regions[region].max_mm);
  }
}

/// As it lies now.
KerfPlane in_bone(const KerfPlane& plane, const simulator::FragmentPose& pose) {
  return {pose.bone_from_fragment * plane.bone_from_kerf, plane.thickness_mm};
}

std::string side_of(const HeldSection& section, const HeldCut& held) {
  const Vec2 lean_mm = section.middle_mm - section.section_middle_mm;
  if (held.bone_mm.empty() || length_of(lean_mm) < least_lean * size_mm_of(held.bone_mm)) return {};
  const RigidTransform& bone_from_kerf = held.bone_from_kerf;
  return direction_text(transform_direction(bone_from_kerf, Vec3(lean_mm, 0.0)));
}

}  // namespace

SiteWatch::SiteWatch(const Scenario& scenario, const Plan& plan)
    : scenario_(scenario), plan_(plan), is_done_(scenario.steps.size(), false) {}

void SiteWatch::apply(const simulator::CutEvent& event, const simulator::KerfSet& kerfs) {
  const auto subject = static_cast<std::size_t>(event.subject);
  switch (event.kind) {
    case CutEventKind::StepDone:
      if (subject < is_done_.size()) is_done_[subject] = true;
      told_step_.reset();
      if (scenario_.format == 1) told_step_ = subject + 1;
      break;
    case CutEventKind::StepReopened:
      if (subject < is_done_.size()) is_done_[subject] = false;
      told_step_ = subject;
      break;
    case CutEventKind::PlaneFrozen: {
      const simulator::FragmentPose& fragment = kerfs.fragments()[kerfs.fragment_of(event.subject)];
      kerfs_.push_back({cut_of(in_bone(kerfs.plane(event.subject), fragment),
                               static_cast<std::size_t>(fragment.bone))});
      break;
    }
    default:
      break;
  }
}

std::vector<std::size_t> SiteWatch::cuts_at_hand() const {
  std::vector<std::size_t> steps, cuts;
  if (told_step_) {
    if (*told_step_ < scenario_.steps.size()) steps.push_back(*told_step_);
  } else {
    steps = steps_at_hand(scenario_, is_done_);
  }
  for (const std::size_t step : steps) {
    if (is_sawn(scenario_.steps[step]))
      cuts.push_back(index_of_cut(plan_, scenario_.steps[step].cut));
  }
  return cuts;
}

std::size_t SiteWatch::cut_of(const KerfPlane& plane, std::size_t bone) const {
  std::vector<std::size_t> cuts = cuts_at_hand();
  std::erase_if(cuts, [&](std::size_t cut) { return plan_.cuts[cut].bone != bone; });
  if (cuts.empty()) return nearest_cut(plane, plan_, bone);
  return *std::ranges::min_element(cuts, {},
                                   [&](std::size_t cut) { return misfit(plane, plan_.cuts[cut]); });
}

HeldCut SiteWatch::held_of(std::int32_t kerf, const simulator::KerfSet& kerfs,
                           const simulator::SolidWithTree& whole, Crumbs crumbs) {
  KerfOfCut& known = kerfs_[static_cast<std::size_t>(kerf)];
  const KerfPlane& plane = kerfs.plane(kerf);
  const std::int32_t fragment = kerfs.fragment_of(kerf);
  if (!known.section) {
    known.section = slice_section(whole.solid, whole.bvh, plane);
    if (const std::optional<FaceWindow>& window = plan_.cuts[known.cut].window)
      keep_within(*known.section, in_bone(plane, kerfs.fragments()[fragment]), *window);
  }
  std::optional<PlaneLimit> limit;
  if (const PlannedHinge* hinge = find_hinge(plan_, plan_.cuts[known.cut].hinge))
    limit = limit_in(plane, window_before(*hinge, plane.thickness_mm));
  const HeldSection section =
      held_section(*known.section, {kerfs, fragment}, kerf, limit,
                   crumbs == Crumbs::Told ? crumb_spacing_mm : simulator::held_spacing_mm);
  HeldCut held;
  held.kerf = kerf;
  held.fragment = fragment;
  held.bone_from_fragment = kerfs.fragments()[fragment].bone_from_fragment;
  const double least_share = crumbs == Crumbs::Told ? 0.0 : held_share_min;
  held.share = section.share < least_share ? 0.0 : section.share;
  held.bone_from_kerf = plane.bone_from_kerf;
  held.bone_mm = contours_of(*known.section, section.regions, limit);
  set_extent(held, *known.section, section.regions);
  held.side = side_of(section, held);
  held.deepest_in_bone_mm =
      transform_point(held.bone_from_kerf_now(), Vec3(section.deepest_mm, 0.0));
  return held;
}

std::vector<HeldCut> SiteWatch::held(const simulator::KerfSet& kerfs,
                                     std::span<const simulator::SolidWithTree> wholes,
                                     Crumbs crumbs) {
  std::vector<HeldCut> held(plan_.cuts.size());
  for (std::int32_t kerf = 0; kerf < static_cast<std::int32_t>(kerfs_.size()); ++kerf) {
    KerfOfCut& known = kerfs_[static_cast<std::size_t>(kerf)];
    if (known.cut == plan_.cuts.size()) continue;
    const std::int32_t fragment = kerfs.fragment_of(kerf);
    if (kerfs.kerfs_of(fragment).has(kerf))
      known.held = held_of(kerf, kerfs, wholes[static_cast<std::size_t>(fragment)], crumbs);
    HeldCut& of_cut = held[known.cut];
    if (!of_cut.is_begun() || known.held.share < of_cut.share) of_cut = known.held;
  }
  return held;
}

}  // namespace hallux::scenarios
