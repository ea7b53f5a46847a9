#include "ui/screens/pictures/planned_passes_picture.h"

#include <array>
#include <cstdio>

#include "scenarios/tray/laid_out_tools.h"
#include "ui/screens/pictures/blade_section_view.h"

namespace hallux::ui {

namespace {

std::string tenths_text(double value_mm) {
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value_mm);
  std::string said = text.data();
  if (said.ends_with(".0")) said.resize(said.size() - 2);
  return said;
}

/// What a section of one bone is compared with.
scenarios::Plan on_bone(scenarios::Plan plan, std::size_t bone) {
  const auto is_elsewhere = [bone](const auto& part) { return part.bone != bone; };
  std::erase_if(plan.cuts, is_elsewhere);
  std::erase_if(plan.hinges, is_elsewhere);
  std::erase_if(plan.danger_zones, is_elsewhere);
  return plan;
}

}  // namespace

PassesInView passes_in_view(const scenarios::Scenario& scenario, const scenarios::Plan& plan,
                            std::size_t cut, const simulator::CutSolid& whole,
                            const simulator::Bvh& tree) {
  const scenarios::PlannedPasses planned = planned_passes(scenario, plan, cut, whole, tree);
  const scenarios::PlannedCut& face = plan.cuts[cut];
  const simulator::Blade& blade = blade_of(scenario, face);
  // As the passes lie: the middle of the blade, half a kerf from the face, in the waste.
  const simulator::KerfPlane plane{
      {rotation_from_axes(planned.feed_in_bone, planned.along_in_bone),
       face.entry_point_in_bone_mm + 0.5 * blade.kerf_mm * glm::normalize(face.face.normal)},
      blade.kerf_mm};
  const RigidTransform first{Quat(1.0, 0.0, 0.0, 0.0), Vec3(0.0, planned.middles_mm.front(), 0.0)};
  PassesInView passes;
  const scenarios::Plan beside = on_bone(plan, face.bone);
  passes.section = blade_section(kerf_section(whole, tree, {plane, {}}),
                                 plane.bone_from_kerf * first, blade, &beside);
  passes.blade_width_mm = blade.width_mm;
  passes.bone_width_mm = planned.high_mm - planned.low_mm;
  passes.middles_mm = planned.middles_mm;
  return passes;
}

std::string passes_text(const Texts& texts, const PassesInView& passes) {
  // They share the bone evenly, so they may lie in each other by more than they must.
  const double overlap_mm = passes.blade_width_mm - (passes.middles_mm[1] - passes.middles_mm[0]);
  const bool is_narrow = passes.blade_width_mm < passes.bone_width_mm;
  return texts.say(
      "brief.passes",
      {{"blade", tenths_text(passes.blade_width_mm)},
       {"bone", tenths_text(passes.bone_width_mm)},
       {"why", std::string(texts.text(is_narrow ? "brief.passes.narrow" : "brief.passes.hardly"))},
       {"count", std::to_string(passes.middles_mm.size())},
       {"overlap", tenths_text(overlap_mm)}});
}

void draw_passes(Ui& ui, const Rect& rect, const PassesInView& passes) {
  draw_section_with_passes(ui, rect, passes.section, passes.middles_mm, passes.blade_width_mm);
}

}  // namespace hallux::ui
